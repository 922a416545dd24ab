//! The genotype-to-phenotype mapping: leftmost, depth first, codon mod number of alternatives.

use super::grammar::{AlternativeId, Grammar, RuleId, Symbol, TerminalId};
use super::operators::Mutating;

/// When a mapping gives up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// How many times the codons may be read again from the first; 0 means not at all.
    pub max_wraps: u32,
    /// The deepest any symbol may stand, terminals included; the start symbol has depth 1.
    pub max_depth: u32,
}

impl Limits {
    /// No limit of depth.
    pub const ANY_DEPTH: u32 = u32::MAX;
}

/// A mapping that ended with no non-terminal left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mapped {
    /// Non-terminals expanded, each of which took one codon; with wraps it may exceed the number of codons.
    pub used: u32,
    /// The largest depth of any symbol, terminals included.
    pub depth: u32,
}

/// Why codons map to no program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Invalid {
    /// A non-terminal was left when the codons and all wraps were used up.
    CodonsUsedUp,
    /// A symbol would stand deeper than allowed.
    TooDeep,
}

/// Told of a derivation while it happens; the calls come in reading order.
pub trait Derivation {
    /// Whether `terminal` is called; a mapper that need not stop at terminals is faster.
    const TERMINALS: bool;

    /// `rule`, at `depth`, was replaced by `alternative`, chosen by a codon of value `codon`.
    fn expand(&mut self, rule: RuleId, alternative: AlternativeId, codon: u16, depth: u32);

    /// Literal text was emitted.
    fn terminal(&mut self, _terminal: TerminalId) {}
}

/// Where a mapping reads its codons.
pub trait Codons {
    /// How many there are.
    fn count(&self) -> usize;

    /// The codon at `index`. A mapping reads from 0 on without gaps; `first` says that it reads this one for the
    /// first time, which is false only after a wrap.
    fn read(&mut self, index: usize, first: bool) -> u16;
}

impl Codons for &[u16] {
    fn count(&self) -> usize {
        self.len()
    }

    #[inline]
    fn read(&mut self, index: usize, _first: bool) -> u16 {
        self[index]
    }
}

/// Codons that mutate when they are read for the first time, so that exactly the used part of a genome mutates.
impl Codons for (&mut [u16], Mutating<'_>) {
    fn count(&self) -> usize {
        self.0.len()
    }

    #[expect(
        clippy::inline_always,
        reason = "once for each codon; a call takes a quarter more instructions of the mapping"
    )]
    #[inline(always)]
    fn read(&mut self, index: usize, first: bool) -> u16 {
        let codon = &mut self.0[index];
        if first {
            self.1.pass(codon);
        }
        *codon
    }
}

/// A grammar compiled for mapping, with the memory the mapping needs: [`Mapper::map`] allocates only for a
/// derivation with more pending symbols than any before.
#[derive(Clone, Debug)]
pub struct Mapper {
    rules: Vec<Choice>,
    /// For each alternative its range in `all` and in `inner`.
    alternatives: Vec<[u32; 4]>,
    /// The symbols of each alternative.
    all: Vec<u32>,
    /// The same without terminals.
    inner: Vec<u32>,
    stack: Vec<Rest>,
}

#[derive(Clone, Copy, Debug)]
struct Choice {
    first: u16,
    count: u16,
    /// 2^32 / count, rounded up: `codon / count` as one multiplication, exact for 16-bit numbers.
    reciprocal: u64,
}

/// The symbols of an alternative that are still to be expanded: a range, never empty, and their depth.
#[derive(Clone, Copy, Debug)]
struct Rest {
    next: u32,
    end: u32,
    depth: u32,
}

/// Set in a symbol's number when it is a terminal.
const TERMINAL: u32 = 1 << 31;

impl Mapper {
    /// Compiles `grammar`.
    #[must_use]
    pub fn new(grammar: &Grammar) -> Self {
        let mut mapper = Self { rules: vec![], alternatives: vec![], all: vec![], inner: vec![], stack: vec![] };
        for rule in (0..grammar.rule_count()).map(RuleId) {
            let first = mapper.alternatives.len() as u16;
            for alternative in grammar.alternatives(rule) {
                let from = [mapper.all.len() as u32, mapper.inner.len() as u32];
                for (symbol, _) in grammar.symbols(alternative) {
                    match symbol {
                        Symbol::NonTerminal(rule) => {
                            mapper.all.push(u32::from(rule.0));
                            mapper.inner.push(u32::from(rule.0));
                        }
                        Symbol::Terminal(terminal) => mapper.all.push(TERMINAL | u32::from(terminal.0)),
                    }
                }
                mapper.alternatives.push([from[0], mapper.all.len() as u32, from[1], mapper.inner.len() as u32]);
            }
            let count = mapper.alternatives.len() as u16 - first;
            mapper.rules.push(Choice { first, count, reciprocal: (1_u64 << 32).div_ceil(u64::from(count)) });
        }
        mapper
    }

    /// Maps `codons` and tells `derivation` each step.
    ///
    /// Every non-terminal takes one codon, also when its rule has a single alternative; alternative =
    /// codon mod number of alternatives. On an error `derivation` has seen the steps up to it.
    ///
    /// # Errors
    /// [`Invalid`]: the codons and their wraps were used up, or a symbol would stand too deep.
    ///
    /// Source: BeTr-GEESE, section 3; the order, the single choices and the count of the depth are those of
    /// `PonyGE2`, which the paper used.
    pub fn map<C: Codons, D: Derivation>(
        &mut self,
        mut codons: C,
        limits: Limits,
        derivation: &mut D,
    ) -> Result<Mapped, Invalid> {
        let count = codons.count();
        let allowed = (count as u64).saturating_mul(u64::from(limits.max_wraps) + 1);
        let Self { rules, alternatives, all, inner, stack } = self;
        let symbols: &[u32] = if D::TERMINALS { all } else { inner };
        let (mut used, mut next_codon, mut deepest) = (0_u32, 0, 0);
        stack.clear();
        // The alternative being read; what is left of those around it waits on the stack.
        let mut rest = Rest { next: 0, end: 0, depth: 1 };
        let mut symbol = 0;
        loop {
            let depth = rest.depth;
            if D::TERMINALS && symbol & TERMINAL != 0 {
                derivation.terminal(TerminalId((symbol & !TERMINAL) as u16));
            } else {
                if u64::from(used) == allowed {
                    return Err(Invalid::CodonsUsedUp);
                }
                // Every alternative has a symbol, and each stands one deeper.
                if depth >= limits.max_depth {
                    return Err(Invalid::TooDeep);
                }
                deepest = deepest.max(depth + 1);
                let codon = codons.read(next_codon, (used as usize) < count);
                next_codon = if next_codon + 1 == count { 0 } else { next_codon + 1 };
                used += 1;
                let choice = rules[symbol as usize];
                let quotient = (u64::from(codon) * choice.reciprocal) >> 32;
                let alternative = choice.first + (codon - quotient as u16 * choice.count);
                derivation.expand(RuleId(symbol as u16), AlternativeId(alternative), codon, depth);
                let [from, to, inner_from, inner_to] = alternatives[usize::from(alternative)];
                let (from, to) = if D::TERMINALS { (from, to) } else { (inner_from, inner_to) };
                if from < to {
                    if rest.next < rest.end {
                        stack.push(rest);
                    }
                    rest = Rest { next: from, end: to, depth: depth + 1 };
                }
            }
            if rest.next == rest.end {
                match stack.pop() {
                    Some(outer) => rest = outer,
                    None => return Ok(Mapped { used, depth: deepest }),
                }
            }
            symbol = symbols[rest.next as usize];
            rest.next += 1;
        }
    }
}

/// The derivation as text: the terminals in order, nothing between them.
#[derive(Clone, Debug)]
pub struct Phenotype<'a> {
    terminals: &'a [String],
    /// The text so far.
    pub text: String,
}

impl<'a> Phenotype<'a> {
    /// An empty text over the terminals of `grammar`.
    #[must_use]
    pub fn new(grammar: &'a Grammar) -> Self {
        Self { terminals: grammar.terminals(), text: String::new() }
    }
}

impl Derivation for Phenotype<'_> {
    const TERMINALS: bool = true;

    fn expand(&mut self, _rule: RuleId, _alternative: AlternativeId, _codon: u16, _depth: u32) {}

    fn terminal(&mut self, terminal: TerminalId) {
        self.text.push_str(&self.terminals[usize::from(terminal.0)]);
    }
}
