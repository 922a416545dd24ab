//! BNF text, read into flat tables: one rule a line, `<name> ::= alternatives separated by |`.
//!
//! The first rule is the start symbol. Blanks around an alternative are dropped; every other character outside
//! `<name>` is literal text. A line that begins with `|` continues the rule above; a line that begins with `#`
//! is a comment.

use crate::nearest::nearest;
use crate::place::Place;
use std::fmt;

/// A rule, that is a non-terminal; 0 is the start symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct RuleId(pub u16);

/// A piece of literal text of one alternative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TerminalId(pub u16);

/// One alternative of one rule, counted through the whole grammar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct AlternativeId(pub u16);

/// What an alternative is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// Replaced by one of the rule's alternatives.
    NonTerminal(RuleId),
    /// Emitted as it stands.
    Terminal(TerminalId),
}

/// A grammar whose start symbol derives at least one finite text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grammar {
    rules: Vec<Rule>,
    alternatives: Vec<Alternative>,
    symbols: Vec<(Symbol, Place)>,
    terminals: Vec<String>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Rule {
    name: String,
    place: Place,
    first: u16,
    count: u16,
    /// The least depth of a derivation of this rule, the rule itself counted as 1; 0 while unknown.
    least_depth: u32,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Alternative {
    first: u32,
    count: u32,
    place: Place,
}

/// Why a text is no grammar, with the place of the fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GrammarError {
    place: Place,
    kind: ErrorKind,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum ErrorKind {
    NoRule,
    ExpectedRule(String),
    ExpectedDefinition(String),
    UnclosedName,
    EmptyName,
    EmptyAlternative,
    RepeatedRule(String, u32),
    UndefinedRule(String, Option<String>),
    Endless(String),
    TooLarge(&'static str, usize),
}

impl GrammarError {
    /// Where the fault stands.
    #[must_use]
    pub fn place(&self) -> Place {
        self.place
    }
}

impl fmt::Display for GrammarError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: ", self.place)?;
        match &self.kind {
            ErrorKind::NoRule => write!(out, "expected at least one rule such as <start> ::= text, found none"),
            ErrorKind::ExpectedRule(found) => write!(out, "expected a rule that begins with <name>, found {found}"),
            ErrorKind::ExpectedDefinition(found) => write!(out, "expected ::= after the rule's name, found {found}"),
            ErrorKind::UnclosedName => {
                write!(out, "expected > to end the name that begins here, found the end of the line")
            }
            ErrorKind::EmptyName => write!(out, "expected a name between < and >, found none"),
            ErrorKind::EmptyAlternative => write!(out, "expected an alternative, found nothing"),
            ErrorKind::RepeatedRule(name, line) => {
                write!(out, "expected each rule once, found <{name}> again (first in line {line})")
            }
            ErrorKind::UndefinedRule(name, None) => write!(out, "expected a defined rule, found <{name}>"),
            ErrorKind::UndefinedRule(name, Some(near)) => {
                write!(out, "expected a defined rule, found <{name}>, did you mean <{near}>?")
            }
            ErrorKind::Endless(name) => {
                write!(out, "expected a rule that can end, found <{name}>, which always needs itself again")
            }
            ErrorKind::TooLarge(what, most) => write!(out, "expected at most {most} {what}, found more"),
        }
    }
}

impl std::error::Error for GrammarError {}

/// The most rules, alternatives and different texts; names are looked up one by one.
const MOST: usize = 2000;

impl Grammar {
    /// Reads BNF text.
    ///
    /// # Errors
    /// The first fault with its line and column: no rule, a line that is no rule, an unclosed or empty name, an
    /// empty alternative, a rule defined twice or not at all, a start symbol that can never end.
    ///
    /// ```
    /// use swarm_playground::evolution::Grammar;
    /// assert!(Grammar::parse("<e> ::= <e>+<v> | <v>\n<v> ::= x | y").is_ok());
    /// let error = Grammar::parse("<e> ::= <f> | x").unwrap_err();
    /// assert_eq!(error.to_string(), "line 1, column 9: expected a defined rule, found <f>");
    /// ```
    pub fn parse(text: &str) -> Result<Self, GrammarError> {
        let mut reader = Reader::default();
        for (number, line) in text.lines().enumerate() {
            reader.line(number as u32 + 1, line)?;
        }
        reader.finish()
    }

    /// The number of rules.
    #[must_use]
    pub fn rule_count(&self) -> u16 {
        self.rules.len() as u16
    }

    /// The name of a rule, without `<` and `>`.
    #[must_use]
    pub fn rule_name(&self, rule: RuleId) -> &str {
        &self.rules[usize::from(rule.0)].name
    }

    /// The alternatives of a rule, in the order written.
    pub fn alternatives(&self, rule: RuleId) -> impl ExactSizeIterator<Item = AlternativeId> + Clone + use<> {
        let Rule { first, count, .. } = self.rules[usize::from(rule.0)];
        (first..first + count).map(AlternativeId)
    }

    /// Where a rule begins in the text.
    #[must_use]
    pub fn rule_place(&self, rule: RuleId) -> Place {
        self.rules[usize::from(rule.0)].place
    }

    /// Where an alternative begins in the text.
    #[must_use]
    pub fn alternative_place(&self, alternative: AlternativeId) -> Place {
        self.alternatives[usize::from(alternative.0)].place
    }

    /// The symbols of an alternative with their places, left to right; at least one.
    #[must_use]
    pub fn symbols(&self, alternative: AlternativeId) -> &[(Symbol, Place)] {
        let Alternative { first, count, .. } = self.alternatives[usize::from(alternative.0)];
        &self.symbols[first as usize..(first + count) as usize]
    }

    /// All literal texts by [`TerminalId`]; equal texts share one.
    #[must_use]
    pub fn terminals(&self) -> &[String] {
        &self.terminals
    }

    /// The depth of the flattest derivation: the start symbol has depth 1, each symbol of an alternative,
    /// terminals included, is one deeper than its parent.
    #[must_use]
    pub fn least_depth(&self) -> u32 {
        self.rules[0].least_depth
    }

    /// The least depth of a derivation of `rule`, counted as if it were the start symbol; 0 when it can never end.
    #[must_use]
    pub fn least_depth_of(&self, rule: RuleId) -> u32 {
        self.rules[usize::from(rule.0)].least_depth
    }

    /// An alternative as it would be written.
    #[must_use]
    pub fn alternative_text(&self, alternative: AlternativeId) -> String {
        let mut text = String::new();
        for (symbol, _) in self.symbols(alternative) {
            match symbol {
                Symbol::NonTerminal(rule) => text.extend(["<", self.rule_name(*rule), ">"]),
                Symbol::Terminal(terminal) => text.push_str(&self.terminals[usize::from(terminal.0)]),
            }
        }
        text
    }

    /// Fills in the least depth of every rule that can end; returns false when the start symbol cannot.
    fn find_least_depths(&mut self) -> bool {
        loop {
            let mut changed = false;
            for rule in (0..self.rule_count()).map(RuleId) {
                let least = self.alternatives(rule).filter_map(|alternative| {
                    self.symbols(alternative).iter().try_fold(1, |deepest: u32, (symbol, _)| match symbol {
                        Symbol::Terminal(_) => Some(deepest),
                        Symbol::NonTerminal(inner) => match self.rules[usize::from(inner.0)].least_depth {
                            0 => None,
                            depth => Some(deepest.max(depth)),
                        },
                    })
                });
                if let Some(least) = least.min().map(|depth| depth + 1) {
                    let known = &mut self.rules[usize::from(rule.0)].least_depth;
                    if *known == 0 || least < *known {
                        *known = least;
                        changed = true;
                    }
                }
            }
            if !changed {
                return self.rules[0].least_depth > 0;
            }
        }
    }
}

/// A symbol as read, before the names are known.
enum Raw {
    Name(String),
    Text(String),
}

/// The symbols of an alternative, each with its place.
type RawSymbols = Vec<(Raw, Place)>;

/// A rule as read: its name and place, and its alternatives with theirs.
type RawRule = (String, Place, Vec<(Place, RawSymbols)>);

#[derive(Default)]
struct Reader {
    rules: Vec<RawRule>,
    alternatives: usize,
    last_line: u32,
}

impl Reader {
    fn line(&mut self, number: u32, line: &str) -> Result<(), GrammarError> {
        self.last_line = number;
        let characters: Vec<char> = line.chars().collect();
        let at = |index: usize| Place { line: number, column: index as u32 + 1 };
        let fault = |index: usize, kind: ErrorKind| Err(GrammarError { place: at(index), kind });
        let found = |index: usize| characters.get(index).map_or("the end of the line".to_owned(), |c| format!("'{c}'"));
        let skip_blanks = |mut index: usize| {
            while characters.get(index).is_some_and(|c| c.is_whitespace()) {
                index += 1;
            }
            index
        };

        let start = skip_blanks(0);
        match characters.get(start) {
            None | Some('#') => return Ok(()),
            Some('|') if !self.rules.is_empty() => return self.alternatives(number, &characters, start + 1),
            Some('<') => {}
            Some(_) => return fault(start, ErrorKind::ExpectedRule(found(start))),
        }
        let (name, after) = read_name(number, &characters, start)?;
        let define = skip_blanks(after);
        if characters.get(define..define + 3) != Some(&[':', ':', '=']) {
            return fault(define, ErrorKind::ExpectedDefinition(found(define)));
        }
        if let Some((_, first, _)) = self.rules.iter().find(|rule| rule.0 == name) {
            return fault(start, ErrorKind::RepeatedRule(name, first.line));
        }
        if self.rules.len() == MOST {
            return fault(start, ErrorKind::TooLarge("rules", MOST));
        }
        self.rules.push((name, at(start), Vec::new()));
        self.alternatives(number, &characters, define + 3)
    }

    /// Reads alternatives from `start` to the end of the line into the last rule.
    fn alternatives(&mut self, line: u32, characters: &[char], start: usize) -> Result<(), GrammarError> {
        let Some((_, _, alternatives)) = self.rules.last_mut() else { return Ok(()) };
        let mut from = start;
        loop {
            let bar = (from..characters.len()).find(|&index| characters[index] == '|').unwrap_or(characters.len());
            let first = (from..bar).find(|&index| !characters[index].is_whitespace());
            let Some(first) = first else {
                let place = Place { line, column: bar.min(characters.len()) as u32 + 1 };
                return Err(GrammarError { place, kind: ErrorKind::EmptyAlternative });
            };
            let last = (first..bar).rfind(|&index| !characters[index].is_whitespace()).unwrap_or(first);
            let place = Place { line, column: first as u32 + 1 };
            self.alternatives += 1;
            if self.alternatives > MOST {
                return Err(GrammarError { place, kind: ErrorKind::TooLarge("alternatives", MOST) });
            }
            alternatives.push((place, read_symbols(line, &characters[..=last], first)?));
            if bar == characters.len() {
                return Ok(());
            }
            from = bar + 1;
        }
    }

    fn finish(self) -> Result<Grammar, GrammarError> {
        if self.rules.is_empty() {
            let place = Place { line: self.last_line.max(1), column: 1 };
            return Err(GrammarError { place, kind: ErrorKind::NoRule });
        }
        let names: Vec<String> = self.rules.iter().map(|rule| rule.0.clone()).collect();
        let mut grammar = Grammar { rules: vec![], alternatives: vec![], symbols: vec![], terminals: vec![] };
        for (name, place, alternatives) in self.rules {
            let (first, count) = (grammar.alternatives.len() as u16, alternatives.len() as u16);
            grammar.rules.push(Rule { name, place, first, count, least_depth: 0 });
            for (place, symbols) in alternatives {
                let (first, count) = (grammar.symbols.len() as u32, symbols.len() as u32);
                grammar.alternatives.push(Alternative { first, count, place });
                for (raw, place) in symbols {
                    let symbol = match raw {
                        Raw::Name(name) => {
                            let Some(rule) = names.iter().position(|other| *other == name) else {
                                let near = nearest(&name, names.iter().map(String::as_str)).map(str::to_owned);
                                return Err(GrammarError { place, kind: ErrorKind::UndefinedRule(name, near) });
                            };
                            Symbol::NonTerminal(RuleId(rule as u16))
                        }
                        Raw::Text(text) => {
                            let known = grammar.terminals.iter().position(|other| *other == text);
                            let id = known.unwrap_or(grammar.terminals.len());
                            if id == MOST {
                                return Err(GrammarError { place, kind: ErrorKind::TooLarge("texts", MOST) });
                            }
                            if known.is_none() {
                                grammar.terminals.push(text);
                            }
                            Symbol::Terminal(TerminalId(id as u16))
                        }
                    };
                    grammar.symbols.push((symbol, place));
                }
            }
        }
        if grammar.find_least_depths() {
            return Ok(grammar);
        }
        let Rule { name, place, .. } = grammar.rules.swap_remove(0);
        Err(GrammarError { place, kind: ErrorKind::Endless(name) })
    }
}

/// Reads `<name>` at `start`; returns the name and the index after `>`.
fn read_name(line: u32, characters: &[char], start: usize) -> Result<(String, usize), GrammarError> {
    let fault = |kind| Err(GrammarError { place: Place { line, column: start as u32 + 1 }, kind });
    let inner = &characters[start + 1..];
    match inner.iter().position(|&c| c == '>' || c == '<') {
        Some(0) if inner[0] == '>' => fault(ErrorKind::EmptyName),
        Some(length) if inner[length] == '>' => Ok((inner[..length].iter().collect(), start + length + 2)),
        _ => fault(ErrorKind::UnclosedName),
    }
}

fn read_symbols(line: u32, characters: &[char], start: usize) -> Result<RawSymbols, GrammarError> {
    let mut symbols = Vec::new();
    let mut index = start;
    while index < characters.len() {
        let place = Place { line, column: index as u32 + 1 };
        if characters[index] == '<' {
            let (name, after) = read_name(line, characters, index)?;
            symbols.push((Raw::Name(name), place));
            index = after;
        } else {
            let end = (index..characters.len()).find(|&at| characters[at] == '<').unwrap_or(characters.len());
            symbols.push((Raw::Text(characters[index..end].iter().collect()), place));
            index = end;
        }
    }
    Ok(symbols)
}
