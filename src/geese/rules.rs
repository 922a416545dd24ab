//! The language in which a grammar writes state machines, and the check that every sentence of a grammar is one.
//!
//! ```text
//! machine := rule rule ...
//! rule    := From(state state ...) If(test test ... equals BOOL) Goto(PROBABILITY, state) [Set(VARIABLE, BOOL, PROBABILITY)]
//! state   := ACTION [argument]
//! test    := [not] CONDITION [argument]  |  [not] VARIABLE  |  -
//! ```
//! `-` tests nothing; VARIABLE is X or Y; a condition always has its argument. The check goes down from the first rule of
//! the grammar: each symbol must write what is wanted where it stands. So a mapping that ends always gives a machine.

use super::language::{LanguageError, of_place};
use super::leaf::{Leaf, Name, Takes};
use super::machine::{Machine, Rule, Setting, variable_bit};
use super::program::NO_LEAF;
use super::words::{Item, MILLION, PROBABILITY, Section, Token, What, read_tokens};
use crate::evolution::{Grammar, RuleId, Symbol, TerminalId};
use crate::place::Place;

/// What a symbol is to write where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Rules,
    State,
    Test,
    Bool,
    Probability,
    Variable,
    Place,
    Item,
    Object,
}

impl Part {
    fn text(self) -> &'static str {
        match self {
            Self::Rules => "a rule that begins with From(",
            Self::State => "an action",
            Self::Test => "a condition, X, Y or -",
            Self::Bool => "true or false",
            Self::Probability => PROBABILITY,
            Self::Variable => "X or Y",
            Self::Place => "a place",
            Self::Item => "an item",
            Self::Object => "a place or an item",
        }
    }
}

/// Whether a grammar means to write machines: one of its texts says From or Goto. Both, so that a slip in one of them is
/// still told as what it is.
#[must_use]
pub fn writes_machines(grammar: &Grammar) -> bool {
    let names_part = |word: &str| matches!(word, "From" | "Goto");
    grammar.terminals().iter().any(|text| text.split(|c: char| !c.is_ascii_alphanumeric()).any(names_part))
}

/// The tokens of each terminal of a grammar whose every sentence is a machine.
#[derive(Clone, Debug)]
pub struct Rules {
    /// Indexed by `TerminalId`.
    pub tokens: Vec<Vec<Token>>,
}

impl Rules {
    /// Reads the terminals of `grammar` and checks that its start symbol writes rules.
    ///
    /// # Errors
    /// The first fault with its line and column: an unknown word or sign, or something else than the language wants there.
    pub fn of(grammar: &Grammar) -> Result<Self, LanguageError> {
        let mut tokens = vec![Vec::new(); grammar.terminals().len()];
        // By alternative.
        let mut read = Vec::new();
        for rule in (0..grammar.rule_count()).map(RuleId) {
            for alternative in grammar.alternatives(rule) {
                let mut items = Vec::new();
                for (symbol, place) in grammar.symbols(alternative) {
                    match symbol {
                        Symbol::NonTerminal(rule) => {
                            let text = format!("<{}>", grammar.rule_name(*rule));
                            items.push(Item { what: What::Rule(*rule), place: *place, text });
                        }
                        Symbol::Terminal(TerminalId(id)) => {
                            let from = items.len();
                            read_tokens(&grammar.terminals()[usize::from(*id)], *place, &mut items)?;
                            let tokens = &mut tokens[usize::from(*id)];
                            tokens.clear();
                            for item in &items[from..] {
                                if let What::Token(token) = item.what {
                                    tokens.push(token);
                                }
                            }
                        }
                    }
                }
                read.push(items);
            }
        }
        let mut wanted = Wanted { parts: vec![0; usize::from(grammar.rule_count())], list: Vec::new() };
        wanted.add(RuleId(0), Part::Rules);
        let mut next = 0;
        while let Some(&(rule, part)) = wanted.list.get(next) {
            for alternative in grammar.alternatives(rule) {
                let items = &read[usize::from(alternative.0)];
                let mut checker = Checker { items, next: 0, wanted: &mut wanted };
                if part == Part::Rules {
                    checker.rules()?;
                } else {
                    checker.part(part)?;
                }
                if checker.next < items.len() {
                    return checker.fault("the end of the alternative");
                }
            }
            next += 1;
        }
        Ok(Self { tokens })
    }

    /// Builds the machine that a derivation writes, into `machine`, whose memory is used again.
    pub fn build(&self, terminals: &[TerminalId], machine: &mut Machine) {
        machine.clear();
        let (mut section, mut negated, mut rule) = (Section::From, false, Rule::EMPTY);
        let mut tokens = terminals.iter().flat_map(|terminal| &self.tokens[usize::from(terminal.0)]).peekable();
        while let Some(token) = tokens.next() {
            match (*token, section) {
                (Token::Open(opened), _) => {
                    section = opened;
                    match section {
                        Section::From => rule = Rule::EMPTY,
                        Section::Set => rule.set = Some(Setting::default()),
                        Section::If | Section::Goto => {}
                    }
                }
                (Token::Not, _) => negated = true,
                (Token::Name(name), _) => {
                    let mut leaf = Leaf { name, ..NO_LEAF };
                    if let Some(Token::Object(object)) = tokens.peek() {
                        leaf.object = *object;
                    }
                    match section {
                        Section::From => rule.from |= 1 << machine.state_of(leaf),
                        Section::If => rule.want(1 << machine.test_of(leaf), std::mem::take(&mut negated)),
                        Section::Goto | Section::Set => rule.goto = machine.state_of(leaf),
                    }
                }
                (Token::Variable(variable), Section::If) => {
                    rule.want(variable_bit(variable), std::mem::take(&mut negated));
                }
                (Token::Bool(value), Section::If) => rule.equals = value,
                (Token::Millionths(number), Section::Goto) => rule.goto_probability = probability(number),
                (token, Section::Set) => {
                    if let Some(set) = &mut rule.set {
                        match token {
                            Token::Variable(variable) => set.variable = variable,
                            Token::Bool(value) => set.value = value,
                            Token::Millionths(number) => set.probability = probability(number),
                            _ => {}
                        }
                    }
                }
                _ => {}
            }
            if *token == Token::Close {
                match section {
                    Section::Goto => machine.rules.push(rule),
                    Section::Set => {
                        if let Some(last) = machine.rules.last_mut() {
                            *last = rule;
                        }
                    }
                    Section::From | Section::If => {}
                }
            }
        }
        machine.restart();
    }
}

impl Rule {
    fn want(&mut self, bit: u32, negated: bool) {
        if negated {
            self.failing |= bit;
        } else {
            self.holding |= bit;
        }
    }
}

fn probability(millionths: u32) -> f64 {
    f64::from(millionths) / f64::from(MILLION)
}

/// What each rule of a grammar has to write; grows while it is walked through.
struct Wanted {
    /// A bit for each part, by rule.
    parts: Vec<u16>,
    list: Vec<(RuleId, Part)>,
}

impl Wanted {
    fn add(&mut self, rule: RuleId, part: Part) {
        let parts = &mut self.parts[usize::from(rule.0)];
        if *parts >> part as u16 & 1 == 0 {
            *parts |= 1 << part as u16;
            self.list.push((rule, part));
        }
    }
}

struct Checker<'a> {
    items: &'a [Item],
    next: usize,
    wanted: &'a mut Wanted,
}

impl Checker<'_> {
    fn peek(&self) -> Option<Token> {
        match self.items.get(self.next)?.what {
            What::Token(token) => Some(token),
            What::Rule(_) => None,
        }
    }

    /// Takes the next token if it is that one.
    fn take(&mut self, token: Token) -> bool {
        let found = self.peek() == Some(token);
        self.next += usize::from(found);
        found
    }

    fn expect(&mut self, token: Token, text: &str) -> Result<(), LanguageError> {
        if self.take(token) { Ok(()) } else { self.fault(text) }
    }

    /// Reads one part; a symbol that stands for it is noted, to be checked on its own.
    fn part(&mut self, part: Part) -> Result<(), LanguageError> {
        if let Some(Item { what: What::Rule(rule), .. }) = self.items.get(self.next) {
            self.wanted.add(*rule, part);
            self.next += 1;
            return Ok(());
        }
        let fits = match (part, self.peek()) {
            (Part::Rules, _) => return self.rule(),
            (Part::Test, Some(Token::Not)) => {
                self.next += 1;
                match self.peek() {
                    Some(Token::Variable(_)) => true,
                    Some(Token::Name(name)) if !name.is_action() => return self.call(name),
                    _ => return self.fault("a condition, X or Y"),
                }
            }
            (Part::Test, Some(Token::Name(name))) if !name.is_action() => return self.call(name),
            (Part::State, Some(Token::Name(name))) if name.is_action() => return self.call(name),
            (Part::Test, Some(Token::Any | Token::Variable(_)))
            | (Part::Bool, Some(Token::Bool(_)))
            | (Part::Variable, Some(Token::Variable(_)))
            | (Part::Object, Some(Token::Object(_))) => true,
            (Part::Probability, Some(Token::Millionths(number))) => number <= MILLION,
            (Part::Place, Some(Token::Object(object))) => of_place(object),
            (Part::Item, Some(Token::Object(object))) => !of_place(object),
            _ => false,
        };
        if !fits {
            return self.fault(part.text());
        }
        self.next += 1;
        Ok(())
    }

    /// One or more rules, up to the end.
    fn rules(&mut self) -> Result<(), LanguageError> {
        self.part(Part::Rules)?;
        while self.next < self.items.len() {
            self.part(Part::Rules)?;
        }
        Ok(())
    }

    fn rule(&mut self) -> Result<(), LanguageError> {
        self.expect(Token::Open(Section::From), Part::Rules.text())?;
        self.part(Part::State)?;
        while !self.take(Token::Close) {
            self.part(Part::State)?;
        }
        self.expect(Token::Open(Section::If), "If(")?;
        while !self.take(Token::Equals) {
            self.part(Part::Test)?;
        }
        self.part(Part::Bool)?;
        self.expect(Token::Close, ")")?;
        self.expect(Token::Open(Section::Goto), "Goto(")?;
        self.part(Part::Probability)?;
        self.expect(Token::Comma, "a comma")?;
        self.part(Part::State)?;
        self.expect(Token::Close, ")")?;
        if self.take(Token::Open(Section::Set)) {
            self.part(Part::Variable)?;
            self.expect(Token::Comma, "a comma")?;
            self.part(Part::Bool)?;
            self.expect(Token::Comma, "a comma")?;
            self.part(Part::Probability)?;
            self.expect(Token::Close, ")")?;
        }
        Ok(())
    }

    fn call(&mut self, name: Name) -> Result<(), LanguageError> {
        self.next += 1;
        match name.takes() {
            Takes::Nothing => Ok(()),
            Takes::Place => self.part(Part::Place),
            Takes::Item => self.part(Part::Item),
            Takes::Object => self.part(Part::Object),
        }
    }

    fn fault<T>(&self, expected: &str) -> Result<T, LanguageError> {
        let item = self.items.get(self.next);
        let found = item.map_or("the end of the alternative", |item| &item.text);
        let place = item.or(self.items.last()).map_or(Place::default(), |item| item.place);
        Err(LanguageError { place, message: format!("expected {expected}, found {found}") })
    }
}
