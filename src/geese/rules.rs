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
use super::leaf::{Leaf, Name, Object, Tag, Takes};
use super::machine::{Machine, Rule, Setting, VARIABLES, variable_bit};
use crate::evolution::{AlternativeId, Grammar, RuleId, Symbol, TerminalId};
use crate::nearest::nearest;
use crate::place::Place;

/// A word, number or sign of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token {
    /// One of [`SECTIONS`] with its bracket.
    Open(Section),
    /// `)`
    Close,
    /// `,`
    Comma,
    /// `equals`
    Equals,
    /// `true` or `false`
    Bool(bool),
    /// A probability, in millionths.
    Millionths(u32),
    /// A variable, by place in [`VARIABLES`].
    Variable(u8),
    /// `-`
    Any,
    /// `not`
    Not,
    /// A condition or an action.
    Name(Name),
    /// An argument.
    Object(Object),
}

/// A part of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// The states in which it can fire.
    From,
    /// The tests.
    If,
    /// The next state.
    Goto,
    /// The variable.
    Set,
}

const SECTIONS: [(&str, Section); 4] =
    [("From", Section::From), ("If", Section::If), ("Goto", Section::Goto), ("Set", Section::Set)];

const MILLION: u32 = 1_000_000;

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
            Self::Probability => "a probability from 0 to 1",
            Self::Variable => "X or Y",
            Self::Place => "a place",
            Self::Item => "an item",
            Self::Object => "a place or an item",
        }
    }
}

/// Whether a grammar means to write machines: one of its texts begins a part of a rule.
#[must_use]
pub fn writes_machines(grammar: &Grammar) -> bool {
    let begins = |text: &String| SECTIONS.iter().any(|(name, _)| text.contains(&format!("{name}(")));
    grammar.terminals().iter().any(begins)
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
        for rule in (0..grammar.rule_count()).map(RuleId) {
            for alternative in grammar.alternatives(rule) {
                for (symbol, place) in grammar.symbols(alternative) {
                    if let Symbol::Terminal(TerminalId(id)) = symbol {
                        let read = read_tokens(&grammar.terminals()[usize::from(*id)], *place)?;
                        tokens[usize::from(*id)] = read.into_iter().map(|(token, _)| token).collect();
                    }
                }
            }
        }
        let mut wanted = Wanted { parts: vec![0; usize::from(grammar.rule_count())], list: Vec::new() };
        wanted.add(RuleId(0), Part::Rules);
        let mut next = 0;
        while let Some(&(rule, part)) = wanted.list.get(next) {
            for alternative in grammar.alternatives(rule) {
                let items = items(grammar, alternative)?;
                let mut checker = Checker { grammar, items: &items, next: 0, wanted: &mut wanted };
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
                    let mut leaf = Leaf { name, object: Object::Nothing, tag: Tag::None, negated: false };
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

/// A symbol of an alternative as the check reads it.
#[derive(Clone, Copy)]
enum Item {
    Token(Token),
    Rule(RuleId),
}

fn items(grammar: &Grammar, alternative: AlternativeId) -> Result<Vec<(Item, Place)>, LanguageError> {
    let mut items = Vec::new();
    for (symbol, place) in grammar.symbols(alternative) {
        match symbol {
            Symbol::NonTerminal(rule) => items.push((Item::Rule(*rule), *place)),
            Symbol::Terminal(TerminalId(id)) => {
                let read = read_tokens(&grammar.terminals()[usize::from(*id)], *place)?;
                items.extend(read.into_iter().map(|(token, at)| (Item::Token(token), at)));
            }
        }
    }
    Ok(items)
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
    grammar: &'a Grammar,
    items: &'a [(Item, Place)],
    next: usize,
    wanted: &'a mut Wanted,
}

impl Checker<'_> {
    fn peek(&self) -> Option<Token> {
        match self.items.get(self.next) {
            Some((Item::Token(token), _)) => Some(*token),
            Some((Item::Rule(_), _)) | None => None,
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
        if let Some((Item::Rule(rule), _)) = self.items.get(self.next) {
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
        let (found, place) = match self.items.get(self.next) {
            None => {
                ("the end of the alternative".to_owned(), self.items.last().map_or(Place::default(), |item| item.1))
            }
            Some((Item::Token(token), place)) => (token_text(*token), *place),
            Some((Item::Rule(rule), place)) => (format!("<{}>", self.grammar.rule_name(*rule)), *place),
        };
        Err(LanguageError { place, message: format!("expected {expected}, found {found}") })
    }
}

fn token_text(token: Token) -> String {
    match token {
        Token::Open(section) => {
            let name = SECTIONS.iter().find(|known| known.1 == section).map_or("", |known| known.0);
            format!("{name}(")
        }
        Token::Close => ")".to_owned(),
        Token::Comma => "a comma".to_owned(),
        Token::Equals => "equals".to_owned(),
        Token::Bool(value) => value.to_string(),
        Token::Millionths(number) => probability(number).to_string(),
        Token::Variable(variable) => VARIABLES[usize::from(variable)].to_owned(),
        Token::Any => "-".to_owned(),
        Token::Not => "not".to_owned(),
        Token::Name(name) => name.text().to_owned(),
        Token::Object(object) => object.text().to_owned(),
    }
}

/// Reads literal text that begins at `place`.
fn read_tokens(text: &str, place: Place) -> Result<Vec<(Token, Place)>, LanguageError> {
    let characters: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut index = 0;
    while index < characters.len() {
        let at = Place { line: place.line, column: place.column + index as u32 };
        let sign = characters[index];
        index += 1;
        let token = match sign {
            sign if sign.is_whitespace() => continue,
            ')' => Token::Close,
            ',' => Token::Comma,
            '-' => Token::Any,
            sign if sign.is_ascii_alphanumeric() => {
                let more = characters[index..].iter().take_while(|c| c.is_ascii_alphanumeric() || **c == '.').count();
                let word: String = characters[index - 1..index + more].iter().collect();
                index += more;
                let bracket = characters.get(index) == Some(&'(');
                let token = read_word(&word, bracket).map_err(|message| LanguageError { place: at, message })?;
                index += usize::from(matches!(token, Token::Open(_)));
                token
            }
            sign => {
                let message = format!("expected a word, a number, ), - or a comma, found '{sign}'");
                return Err(LanguageError { place: at, message });
            }
        };
        tokens.push((token, at));
    }
    Ok(tokens)
}

fn read_word(word: &str, bracket: bool) -> Result<Token, String> {
    if let Some((_, section)) = SECTIONS.into_iter().find(|known| known.0 == word) {
        return if bracket { Ok(Token::Open(section)) } else { Err(format!("expected ( after {word}")) };
    }
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        return read_number(word);
    }
    let fixed =
        [("equals", Token::Equals), ("true", Token::Bool(true)), ("false", Token::Bool(false)), ("not", Token::Not)];
    let fixed = fixed.into_iter().find(|known| known.0 == word).map(|known| known.1);
    let variable = VARIABLES.iter().zip(0..).find(|known| *known.0 == word).map(|known| Token::Variable(known.1));
    let name = Name::ALL.into_iter().find(|name| name.text() == word).map(Token::Name);
    let object = Object::ALL.into_iter().find(|object| object.text() == word).map(Token::Object);
    fixed.or(variable).or(name).or(object).ok_or_else(|| {
        let words = Name::ALL.iter().map(|name| name.text()).chain(Object::ALL.iter().map(|object| object.text()));
        let words = words.chain(SECTIONS.iter().map(|known| known.0)).chain(["equals", "true", "false", "not"]);
        match nearest(word, words) {
            Some(near) => format!("unknown word \"{word}\", did you mean \"{near}\"?"),
            None => {
                format!("unknown word \"{word}\", expected a part such as From(, a condition, an action or an argument")
            }
        }
    })
}

/// A decimal number from 0 to 1 with at most six digits behind the point.
fn read_number(word: &str) -> Result<Token, String> {
    let fault = || format!("expected {} with at most six decimals, found {word}", Part::Probability.text());
    let (whole, decimals) = word.split_once('.').unwrap_or((word, "0"));
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !digits(decimals) || decimals.len() > 6 {
        return Err(fault());
    }
    let millionths = format!("{decimals:0<6}").parse::<u32>().ok();
    let sum = whole.parse::<u32>().ok().filter(|whole| *whole <= 1).zip(millionths);
    let number = sum.map(|(whole, part)| whole * MILLION + part).filter(|number| *number <= MILLION);
    number.map(Token::Millionths).ok_or_else(fault)
}
