//! From a genome to an agent's program: the survey of a child, and the tree or the machine of a winner.

use super::controller::Controller;
use super::language::{Language, LanguageError, Token};
use super::leaf::{Leaf, Manner, Name, Object, Tag};
use super::rules::{Rules, writes_machines};
use super::switches::DiversityRule;
use super::variety::most_names;
use super::words;
use crate::bt::{Builder, Kind, Tree};
use crate::evolution::{
    AlternativeId, Derivation, Genome, Grammar, GrammarError, Invalid, Limits, Mapped, Mapper, Mutating, RuleId,
    Symbol, TerminalId,
};
use crate::fingerprint::Fingerprint;
use std::fmt;

/// Why a text is no grammar of agent programs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CompilerError {
    /// It is no grammar.
    Grammar(GrammarError),
    /// Its sentences are neither trees nor machines.
    Language(LanguageError),
}

impl fmt::Display for CompilerError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Grammar(error) => error.fmt(out),
            Self::Language(error) => error.fmt(out),
        }
    }
}

impl std::error::Error for CompilerError {}

/// Turns genomes into programs of one grammar. Reuses its memory: surveys and compiles allocate nothing once warm.
#[derive(Clone, Debug)]
pub struct Compiler {
    grammar: Grammar,
    sentences: Sentences,
    mapper: Mapper,
    limits: Limits,
    /// For each alternative, what its own text brings: the names as bits, and the number of leaves above them.
    brought: Vec<u64>,
    /// The set of names that an alternative's text brings, without `DummyNode`.
    names: Vec<u16>,
    /// All names of the grammar.
    vocabulary: u16,
    /// The names in each terminal.
    names_of: Vec<Vec<Name>>,
    rule: DiversityRule,
    greatest_diversity: f64,
    terminals: Vec<TerminalId>,
}

/// What the sentences of a grammar are.
#[derive(Clone, Debug)]
pub enum Sentences {
    /// Trees, built in memory that is used again.
    Trees(Language, Box<(Vec<Token>, Builder<Leaf>)>),
    /// State machines.
    Machines(Rules),
}

impl Sentences {
    fn of(grammar: &Grammar) -> Result<Self, LanguageError> {
        if writes_machines(grammar) {
            return Rules::of(grammar).map(Self::Machines);
        }
        Ok(Self::Trees(Language::of(grammar)?, Box::default()))
    }

    /// The names in each terminal.
    fn names(&self) -> Vec<Vec<Name>> {
        let of_tree = |token: &Token| if let Token::Name(name) = token { Some(*name) } else { None };
        let of_machine = |token: &words::Token| if let words::Token::Name(name) = token { Some(*name) } else { None };
        match self {
            Self::Trees(language, _) => {
                language.tokens.iter().map(|tokens| tokens.iter().filter_map(of_tree).collect()).collect()
            }
            Self::Machines(rules) => {
                rules.tokens.iter().map(|tokens| tokens.iter().filter_map(of_machine).collect()).collect()
            }
        }
    }
}

/// What a child is judged by, found without building its tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Survey {
    /// The set of leaf names, as bits of [`Name::bit`].
    pub names: u16,
    /// Diversity D, as the compiler was told to count it.
    pub diversity: f64,
}

/// One leaf, above the bits of the names.
const LEAF: u64 = 1 << 32;
/// The bit of `DummyNode`, which is in no set of names that counts.
const DUMMY: u32 = 1 << Name::DummyNode as u32;

/// The names that count for [`DiversityRule::Leaves`].
const LISTED: [Name; 9] = [
    Name::MoveTowards,
    Name::Explore,
    Name::CompositeSingleCarry,
    Name::CompositeDrop,
    Name::MoveAway,
    Name::NeighbourObjects,
    Name::IsDropable,
    Name::IsCarrying,
    Name::IsVisitedBefore,
];

fn listed() -> u16 {
    LISTED.iter().fold(0, |set, name| set | name.bit())
}

/// The authors' diversity of `names` names of the list among `leaves` leaves.
fn by_leaves(names: u32, leaves: u32) -> f64 {
    four_decimals(f64::from(25 * names) / (9.0 * f64::from(leaves.max(1).div_ceil(9))))
}

fn four_decimals(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

impl Compiler {
    /// Reads a grammar and its language.
    ///
    /// - `limits`: of every mapping.
    ///
    /// # Errors
    /// The first fault of the text, with line and column.
    pub fn new(text: &str, limits: Limits) -> Result<Self, CompilerError> {
        let grammar = Grammar::parse(text).map_err(CompilerError::Grammar)?;
        let sentences = Sentences::of(&grammar).map_err(CompilerError::Language)?;
        let names_of = sentences.names();
        let (mut brought, mut names) = (Vec::new(), Vec::new());
        for rule in (0..grammar.rule_count()).map(RuleId) {
            for alternative in grammar.alternatives(rule) {
                let mut leaves = 0_u64;
                for (symbol, _) in grammar.symbols(alternative) {
                    let Symbol::Terminal(terminal) = symbol else { continue };
                    for name in &names_of[usize::from(terminal.0)] {
                        leaves = (leaves | 1 << *name as u64) + LEAF;
                    }
                }
                brought.push(leaves);
                names.push((leaves as u32 & !DUMMY) as u16);
            }
        }
        let vocabulary = names.iter().fold(0, |set, bits| set | bits);
        let mapper = Mapper::new(&grammar);
        let rule = DiversityRule::Names;
        let mut compiler = Self {
            grammar,
            sentences,
            mapper,
            limits,
            brought,
            names,
            vocabulary,
            names_of,
            rule,
            greatest_diversity: 0.0,
            terminals: Vec::new(),
        };
        compiler.count_by(rule);
        Ok(compiler)
    }

    /// Counts diversity by `rule` from now on; a new compiler counts by [`DiversityRule::Names`].
    pub fn count_by(&mut self, rule: DiversityRule) {
        let most = |names: &[u16]| most_names(&self.grammar, names, self.limits.max_depth);
        self.greatest_diversity = match rule {
            DiversityRule::Names => f64::from(most(&self.names)) / f64::from(self.vocabulary.count_ones().max(1)),
            DiversityRule::Leaves => {
                let listed: Vec<u16> = self.names.iter().map(|names| names & listed()).collect();
                by_leaves(most(&listed), 1)
            }
        };
        self.rule = rule;
    }

    /// The grammar.
    #[must_use]
    pub fn grammar(&self) -> &Grammar {
        &self.grammar
    }

    /// What the grammar's sentences are.
    #[must_use]
    pub fn sentences(&self) -> &Sentences {
        &self.sentences
    }

    /// The limits of every mapping.
    #[must_use]
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// The leaf names of the grammar, in the order of [`Name::ALL`]; `DummyNode` is not among them.
    pub fn vocabulary(&self) -> impl Iterator<Item = Name> + use<> {
        let vocabulary = self.vocabulary;
        Name::ALL.into_iter().filter(move |name| name.bit() & vocabulary != 0)
    }

    /// Diversity D of a program: distinct leaf names over the names of the grammar, in [0, 1]; or the authors' formula,
    /// in [0, 25].
    ///
    /// Source: BeTr-GEESE, section 4.1, "the total number of unique behaviors nodes divided by the total behaviors
    /// defined in the grammar". `DummyNode` does nothing and is not counted. In a machine the names are those of its states
    /// and of the conditions that it tests (our choice); variables and probabilities have none. The authors' code has
    /// 25 m / (9 ceil(T / 9)) with m names of nine (`CanMove`, `IsCarryable` and `DummyNode` are none of them) and T leaves
    /// of any name.
    ///
    /// - `set`: the names, `DummyNode` among them; `leaves`: how many leaves there are.
    fn diversity(&mut self, codons: &[u16], set: u32, leaves: u32) -> f64 {
        let names = (set & !DUMMY) as u16;
        match self.rule {
            DiversityRule::Names => f64::from(names.count_ones()) / f64::from(self.vocabulary.count_ones().max(1)),
            DiversityRule::Leaves if set == u32::from(listed()) => self.balance(codons),
            DiversityRule::Leaves => by_leaves((names & listed()).count_ones(), leaves),
        }
    }

    /// Diversity of a program whose names are exactly the nine of the list: 25 when all are equally frequent, else
    /// 25 (1 - j v / 100) with j names above the smallest count, and v the second of the counts from the largest down.
    ///
    /// Source: the authors' code.
    fn balance(&mut self, codons: &[u16]) -> f64 {
        self.terminals.clear();
        if self.mapper.map(codons, self.limits, &mut Writer(&mut self.terminals)).is_err() {
            return 0.0;
        }
        let mut counts = [0_usize; LISTED.len()];
        for name in self.terminals.iter().flat_map(|terminal| &self.names_of[usize::from(terminal.0)]) {
            if let Some(place) = LISTED.iter().position(|listed| listed == name) {
                counts[place] += 1;
            }
        }
        counts.sort_unstable();
        let above = counts.iter().filter(|count| **count > counts[0]).count();
        four_decimals(25.0 * (1.0 - (above * counts[7]) as f64 / 100.0))
    }

    /// Maps without building, and notes the used codons in the genome: 0 when it maps to no program.
    ///
    /// - `mutation`: changes the codons while they are read, that is, within the used part.
    pub fn survey(&mut self, genome: &mut Genome, mutation: Option<Mutating>) -> Option<Survey> {
        let (mapped, names) = match self.rule {
            DiversityRule::Names => self.collect::<false>(genome, mutation),
            DiversityRule::Leaves => self.collect::<true>(genome, mutation),
        };
        // More than 65,535 codons can only be used through wraps; the count then only says "all of them".
        genome.used = mapped.map_or(0, |mapped| u16::try_from(mapped.used).unwrap_or(u16::MAX));
        let (set, leaves) = (names[0] as u32, (names[1] / LEAF) as u32);
        mapped.ok()?;
        Some(Survey { names: (set & !DUMMY) as u16, diversity: self.diversity(&genome.codons, set, leaves) })
    }

    /// Maps a genome; returns what [`NameSet::found`] holds then.
    fn collect<const LEAVES: bool>(
        &mut self,
        genome: &mut Genome,
        mutation: Option<Mutating>,
    ) -> (Result<Mapped, Invalid>, [u64; 2]) {
        let mut names = NameSet::<LEAVES> { brought: &self.brought, found: [0; 2] };
        let mapped = match mutation {
            Some(mutation) => self.mapper.map((genome.codons.as_mut_slice(), mutation), self.limits, &mut names),
            None => self.mapper.map(genome.codons.as_slice(), self.limits, &mut names),
        };
        (mapped, names.found)
    }

    /// The greatest diversity that a program within the depth limit can have.
    #[must_use]
    pub fn greatest_diversity(&self) -> f64 {
        self.greatest_diversity
    }

    /// Builds the tree or the machine of a genome into `controller`, whose memory is used again.
    ///
    /// # Errors
    /// The genome maps to no program; `controller` stays as it was.
    pub fn compile(&mut self, codons: &[u16], controller: &mut Controller) -> Result<(), Invalid> {
        let Self { sentences, mapper, limits, terminals, .. } = self;
        terminals.clear();
        mapper.map(codons, *limits, &mut Writer(terminals))?;
        match sentences {
            Sentences::Trees(language, memory) => {
                let (tokens, builder) = &mut **memory;
                tokens.clear();
                for token in terminals.iter().flat_map(|terminal| &language.tokens[usize::from(terminal.0)]) {
                    // One by one: a copy of a few tokens is a call, which WebAssembly feels.
                    tokens.push(*token);
                }
                build(tokens, builder, controller.tree_mut());
            }
            Sentences::Machines(rules) => rules.build(terminals, controller.machine_mut()),
        }
        Ok(())
    }
}

/// What the alternatives of a derivation bring.
struct NameSet<'a, const LEAVES: bool> {
    brought: &'a [u64],
    /// All united, whose lower half is the set of names; and (with `LEAVES`, which takes time) all added, whose upper half
    /// is the number of leaves, out of reach of the names below.
    found: [u64; 2],
}

impl<const LEAVES: bool> Derivation for NameSet<'_, LEAVES> {
    const TERMINALS: bool = false;

    fn expand(&mut self, _rule: RuleId, alternative: AlternativeId, _codon: u16, _depth: u32) {
        let brought = self.brought[usize::from(alternative.0)];
        self.found[0] |= brought;
        if LEAVES {
            self.found[1] = self.found[1].wrapping_add(brought);
        }
    }
}

struct Writer<'a>(&'a mut Vec<TerminalId>);

impl Derivation for Writer<'_> {
    const TERMINALS: bool = true;

    fn expand(&mut self, _rule: RuleId, _alternative: AlternativeId, _codon: u16, _depth: u32) {}

    fn terminal(&mut self, terminal: TerminalId) {
        self.0.push(terminal);
    }
}

/// Whether `tokens` write several nodes at the top, which then stand under a Sequence.
#[must_use]
pub fn needs_root(tokens: &[Token]) -> bool {
    let (mut tops, mut nested) = (0, 0);
    for token in tokens {
        match token {
            Token::Sequence | Token::Selector | Token::OpenTag(_) => {
                tops += u32::from(nested == 0);
                nested += 1;
            }
            Token::Name(_) => tops += u32::from(nested == 0),
            Token::CloseNode | Token::CloseTag => nested -= 1,
            Token::Not | Token::Object(_) | Token::Manner(_) => {}
        }
    }
    tops > 1
}

/// A leaf that does nothing.
pub const NO_LEAF: Leaf =
    Leaf { name: Name::DummyNode, object: Object::Nothing, tag: Tag::None, negated: false, manner: Manner::Avoid };

/// A tree of one leaf that does nothing, to be overwritten.
#[must_use]
pub fn placeholder() -> Tree<Leaf> {
    let mut builder = Builder::default();
    builder.leaf(NO_LEAF);
    builder.finish().expect("a single leaf is a tree")
}

/// Builds the tree that `tokens` write. The language check made sure that they write one.
fn build(tokens: &[Token], builder: &mut Builder<Leaf>, tree: &mut Tree<Leaf>) {
    let root = needs_root(tokens);
    if root {
        builder.open(Kind::Sequence);
    }
    let mut leaf = NO_LEAF;
    for (index, token) in tokens.iter().enumerate() {
        match *token {
            Token::Sequence => builder.open(Kind::Sequence),
            Token::Selector => builder.open(Kind::Fallback),
            Token::CloseNode => builder.close(),
            Token::OpenTag(tag) => leaf.tag = tag,
            Token::Not => leaf.negated = true,
            Token::Name(name) => {
                leaf.name = name;
                for after in &tokens[index + 1..] {
                    match *after {
                        Token::Object(object) => leaf.object = object,
                        Token::Manner(manner) => leaf.manner = manner,
                        _ => break,
                    }
                }
                builder.leaf(leaf);
                leaf = Leaf { tag: leaf.tag, ..NO_LEAF };
            }
            Token::Object(_) | Token::Manner(_) => {}
            Token::CloseTag => leaf.tag = Tag::None,
        }
    }
    if root {
        builder.close();
    }
    let built = builder.finish_into(tree);
    debug_assert!(built.is_ok(), "the language check lets only trees through");
}

/// The program as one line, such as `Sel[Post(IsCarrying Food) Act(Explore)]`.
#[must_use]
pub fn program_text(tree: &Tree<Leaf>) -> String {
    fn write(tree: &Tree<Leaf>, node: crate::bt::NodeId, text: &mut String) {
        let open = match &tree.nodes()[node.index()].kind {
            Kind::Leaf(leaf) if leaf.tag == Tag::None => return text.push_str(&leaf.to_string()),
            Kind::Leaf(leaf) => {
                text.extend([leaf.tag.text(), "(", &leaf.to_string(), ")"]);
                return;
            }
            Kind::Sequence => "Seq[",
            Kind::Fallback => "Sel[",
            Kind::ForceSuccess => "ForceSuccess[",
            _ => tree.kind_name(node),
        };
        text.push_str(open);
        for (index, child) in tree.children(node).enumerate() {
            text.push_str(if index == 0 { "" } else { " " });
            write(tree, child, text);
        }
        text.push(']');
    }
    let mut text = String::new();
    write(tree, crate::bt::NodeId(0), &mut text);
    text
}

/// A number that equal programs share and different ones, for all practical purposes, do not.
#[must_use]
pub fn program_id(tree: &Tree<Leaf>) -> u64 {
    let mut hash = Fingerprint::default();
    for node in tree.nodes() {
        let kind = match &node.kind {
            Kind::Leaf(leaf) => 1 << 32 | leaf.number(),
            Kind::Sequence => 2 << 32,
            Kind::Fallback => 3 << 32,
            _ => 4 << 32,
        };
        hash.u64(kind | u64::from(node.end) << 40);
    }
    hash.finish()
}
