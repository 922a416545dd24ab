//! The language in which a grammar writes trees, and the check that every sentence of a grammar is one.
//!
//! ```text
//! node := Seq[ nodes ]  |  Sel[ nodes ]  |  TAG( call )  |  call
//! call := [not] NAME [argument] [Avoid | Normal]
//! TAG  := Cond | Pre | Con | Post | Act
//! ```
//! The check works rule by rule: each rule stands for nodes, a call, a place, an item, or an object (either), and
//! each alternative must read as that. So a mapping that ends always gives a tree.

use super::leaf::{Manner, Name, Object, Tag, Takes};
use crate::evolution::{AlternativeId, Grammar, RuleId, Symbol};
use crate::nearest::nearest;
use crate::place::Place;
use std::fmt;

/// A word or bracket of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token {
    /// `Seq[`
    Sequence,
    /// `Sel[`
    Selector,
    /// `]`
    CloseNode,
    /// A tag with its bracket, such as `Post(`.
    OpenTag(Tag),
    /// `)`
    CloseTag,
    /// `not`
    Not,
    /// The name of a leaf.
    Name(Name),
    /// An argument.
    Object(Object),
    /// How to move.
    Manner(Manner),
}

/// What a rule stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Category {
    Nodes,
    Call,
    Place,
    Item,
    Object,
    Manner,
}

impl Category {
    /// The least category that covers both, if there is one.
    fn join(self, other: Self) -> Option<Self> {
        use Category::{Call, Item, Nodes, Object, Place};
        match (self, other) {
            (a, b) if a == b => Some(a),
            (Nodes, Call) | (Call, Nodes) => Some(Nodes),
            (Place | Item | Object, Place | Item | Object) => Some(Object),
            _ => None,
        }
    }

    fn of_object(object: Object) -> Self {
        match object {
            Object::Food | Object::Debris => Self::Item,
            Object::Hub | Object::Sites | Object::Boundary | Object::Obstacles | Object::Trap | Object::Nothing => {
                Self::Place
            }
        }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Nodes => "nodes",
            Self::Call => "a condition or action",
            Self::Place => "a place",
            Self::Item => "an item",
            Self::Object => "a place or an item",
            Self::Manner => "Avoid or Normal",
        }
    }
}

/// Why a grammar writes neither trees nor machines, with the place of the fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LanguageError {
    pub(super) place: Place,
    pub(super) message: String,
}

impl fmt::Display for LanguageError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.place, self.message)
    }
}

impl std::error::Error for LanguageError {}

/// Brackets an alternative may nest; with the depth limit of a mapping this bounds the depth of every tree.
const MOST_NESTED: usize = 16;

/// The tokens of each terminal of a grammar whose every sentence is a tree.
#[derive(Clone, Debug)]
pub struct Language {
    /// Indexed by `TerminalId`.
    pub tokens: Vec<Vec<Token>>,
}

impl Language {
    /// Reads the terminals of `grammar` and checks that its start symbol stands for nodes.
    ///
    /// # Errors
    /// The first fault with its line and column: an unknown word, an argument of the wrong kind, brackets that do
    /// not match within an alternative, a rule whose alternatives are of different kinds.
    pub fn of(grammar: &Grammar) -> Result<Self, LanguageError> {
        let mut tokens = vec![Vec::new(); grammar.terminals().len()];
        for rule in (0..grammar.rule_count()).map(RuleId) {
            for alternative in grammar.alternatives(rule) {
                for (symbol, place) in grammar.symbols(alternative) {
                    if let Symbol::Terminal(terminal) = symbol {
                        let id = usize::from(terminal.0);
                        if tokens[id].is_empty() {
                            tokens[id] =
                                read_tokens(&grammar.terminals()[id], *place)?.into_iter().map(|t| t.0).collect();
                        }
                    }
                }
            }
        }
        let categories = infer(grammar)?;
        let start = categories[0];
        if matches!(start, Category::Nodes | Category::Call) {
            return Ok(Self { tokens });
        }
        let place = grammar.rule_place(RuleId(0));
        Err(LanguageError {
            place,
            message: format!("expected the first rule to stand for nodes, found {}", start.text()),
        })
    }
}

/// The category of every rule: the least that covers all its alternatives.
fn infer(grammar: &Grammar) -> Result<Vec<Category>, LanguageError> {
    let mut known: Vec<Option<Category>> = vec![None; usize::from(grammar.rule_count())];
    loop {
        let before = known.clone();
        for rule in (0..grammar.rule_count()).map(RuleId) {
            for alternative in grammar.alternatives(rule) {
                let Some(found) = guess(grammar, alternative, &known) else { continue };
                let category = &mut known[usize::from(rule.0)];
                *category = Some(match *category {
                    None => found,
                    Some(other) => other.join(found).ok_or_else(|| LanguageError {
                        place: grammar.alternative_place(alternative),
                        message: format!(
                            "expected {} like the other alternatives of <{}>, found {}",
                            other.text(),
                            grammar.rule_name(rule),
                            found.text()
                        ),
                    })?,
                });
            }
        }
        if known == before {
            break;
        }
    }
    // A rule that stays unknown only ever leads to itself; nothing that ends uses it.
    let categories: Vec<Category> = known.into_iter().map(|category| category.unwrap_or(Category::Nodes)).collect();
    for rule in (0..grammar.rule_count()).map(RuleId) {
        for alternative in grammar.alternatives(rule) {
            check(grammar, alternative, &categories)?;
        }
    }
    Ok(categories)
}

/// What an alternative looks like, by its first symbols; `None` while that depends on an unknown rule.
fn guess(grammar: &Grammar, alternative: AlternativeId, known: &[Option<Category>]) -> Option<Category> {
    let symbols = grammar.symbols(alternative);
    match symbols {
        [(Symbol::NonTerminal(rule), _)] => known[usize::from(rule.0)],
        [(Symbol::NonTerminal(_), _), ..] => Some(Category::Nodes),
        [(Symbol::Terminal(terminal), place), rest @ ..] => {
            let tokens = read_tokens(&grammar.terminals()[usize::from(terminal.0)], *place).ok()?;
            let tokens: Vec<Token> = tokens.into_iter().map(|(token, _)| token).collect();
            match tokens.as_slice() {
                [Token::Object(object)] if rest.is_empty() => Some(Category::of_object(*object)),
                [Token::Manner(_)] if rest.is_empty() => Some(Category::Manner),
                [Token::Not, Token::Name(name), after @ ..] | [Token::Name(name), after @ ..] => {
                    let is_node =
                        |rule: &RuleId| matches!(known[usize::from(rule.0)], Some(Category::Nodes | Category::Call));
                    let argument = match rest {
                        [(Symbol::NonTerminal(rule), _), ..] if is_node(rule) => 0,
                        _ => usize::from(name.takes() != Takes::Nothing),
                    };
                    let says_how = match rest.last() {
                        Some((Symbol::NonTerminal(rule), _)) if name.moves() => {
                            known[usize::from(rule.0)]? == Category::Manner
                        }
                        _ => matches!(after.last(), Some(Token::Manner(_))),
                    };
                    let argument = argument + usize::from(name.moves() && says_how);
                    // Between two arguments stands a blank.
                    let is_blank = |(symbol, _): &&(Symbol, Place)| match symbol {
                        Symbol::Terminal(id) => grammar.terminals()[usize::from(id.0)].trim().is_empty(),
                        Symbol::NonTerminal(_) => false,
                    };
                    let words = rest.len() - rest.iter().filter(is_blank).count();
                    Some(if after.len() + words <= argument { Category::Call } else { Category::Nodes })
                }
                _ => Some(Category::Nodes),
            }
        }
        [] => None,
    }
}

/// A symbol of an alternative as the check reads it.
#[derive(Clone, Copy)]
enum Item {
    Token(Token),
    Rule(RuleId, Category),
}

fn check(grammar: &Grammar, alternative: AlternativeId, categories: &[Category]) -> Result<(), LanguageError> {
    let mut items = Vec::new();
    for (symbol, place) in grammar.symbols(alternative) {
        match symbol {
            Symbol::NonTerminal(rule) => items.push((Item::Rule(*rule, categories[usize::from(rule.0)]), *place)),
            Symbol::Terminal(terminal) => {
                let text = &grammar.terminals()[usize::from(terminal.0)];
                items.extend(read_tokens(text, *place)?.into_iter().map(|(token, at)| (Item::Token(token), at)));
            }
        }
    }
    if let [(Item::Rule(..) | Item::Token(Token::Object(_) | Token::Manner(_)), _)] = items.as_slice() {
        return Ok(()); // the rule's category covers it
    }
    let mut checker = Checker { grammar, items: &items, next: 0, end: end_place(&items) };
    checker.nodes(0)?;
    match items.get(checker.next) {
        None => Ok(()),
        Some(_) => checker.fault("a node"),
    }
}

/// Whether an argument is a place, not an item.
pub(super) fn of_place(object: Object) -> bool {
    Category::of_object(object) == Category::Place
}

/// The place of the last item, where a message about a missing end points.
fn end_place(items: &[(Item, Place)]) -> Place {
    items.last().map(|(_, place)| *place).unwrap_or_default()
}

struct Checker<'a> {
    grammar: &'a Grammar,
    items: &'a [(Item, Place)],
    next: usize,
    end: Place,
}

impl Checker<'_> {
    fn peek(&self) -> Option<Item> {
        self.items.get(self.next).map(|(item, _)| *item)
    }

    /// One or more nodes, up to something that cannot begin one.
    fn nodes(&mut self, nested: usize) -> Result<(), LanguageError> {
        self.node(nested)?;
        while matches!(
            self.peek(),
            Some(
                Item::Rule(_, Category::Nodes | Category::Call)
                    | Item::Token(Token::Sequence | Token::Selector | Token::OpenTag(_) | Token::Not | Token::Name(_))
            )
        ) {
            self.node(nested)?;
        }
        Ok(())
    }

    fn node(&mut self, nested: usize) -> Result<(), LanguageError> {
        if nested > MOST_NESTED {
            return self.fault(&format!("at most {MOST_NESTED} nested brackets"));
        }
        match self.peek() {
            Some(Item::Token(Token::Sequence | Token::Selector)) => {
                self.next += 1;
                self.nodes(nested + 1)?;
                self.expect(Token::CloseNode, "]")
            }
            Some(Item::Token(Token::OpenTag(_))) => {
                self.next += 1;
                if let Some(Item::Rule(_, Category::Call)) = self.peek() {
                    self.next += 1;
                } else {
                    self.call()?;
                }
                self.expect(Token::CloseTag, ")")
            }
            Some(Item::Rule(_, Category::Nodes | Category::Call)) => {
                self.next += 1;
                Ok(())
            }
            _ => self.call(),
        }
    }

    fn call(&mut self) -> Result<(), LanguageError> {
        let moves = self.name_and_argument()?.moves();
        let says_how = matches!(self.peek(), Some(Item::Token(Token::Manner(_)) | Item::Rule(_, Category::Manner)));
        self.next += usize::from(moves && says_how);
        Ok(())
    }

    fn name_and_argument(&mut self) -> Result<Name, LanguageError> {
        if let Some(Item::Token(Token::Not)) = self.peek() {
            self.next += 1;
        }
        let Some(Item::Token(Token::Name(name))) = self.peek() else { return Err(self.error("a condition or action")) };
        self.next += 1;
        let wanted = match name.takes() {
            Takes::Nothing => return Ok(name),
            Takes::Place => Category::Place,
            Takes::Item => Category::Item,
            Takes::Object => Category::Object,
        };
        let found = match self.peek() {
            Some(Item::Token(Token::Object(object))) => Some(Category::of_object(object)),
            Some(Item::Rule(_, category)) => Some(category),
            _ => None,
        };
        if found.is_some_and(|found| found.join(wanted) == Some(wanted)) {
            self.next += 1;
            return Ok(name);
        }
        if wanted == Category::Object {
            return Ok(name); // without an argument it means any object
        }
        Err(self.error(&format!("{} after {}", wanted.text(), name.text())))
    }

    fn expect(&mut self, token: Token, text: &str) -> Result<(), LanguageError> {
        match self.peek() {
            Some(Item::Token(found)) if found == token => {
                self.next += 1;
                Ok(())
            }
            _ => self.fault(text),
        }
    }

    fn fault(&self, expected: &str) -> Result<(), LanguageError> {
        Err(self.error(expected))
    }

    fn error(&self, expected: &str) -> LanguageError {
        let (found, place) = match self.items.get(self.next) {
            None => ("the end of the alternative".to_owned(), self.end),
            Some((Item::Token(token), place)) => (token_text(*token), *place),
            Some((Item::Rule(rule, category), place)) => {
                (format!("<{}>, {}", self.grammar.rule_name(*rule), category.text()), *place)
            }
        };
        LanguageError { place, message: format!("expected {expected}, found {found}") }
    }
}

fn token_text(token: Token) -> String {
    match token {
        Token::Sequence => "Seq[".to_owned(),
        Token::Selector => "Sel[".to_owned(),
        Token::CloseNode => "]".to_owned(),
        Token::OpenTag(tag) => format!("{}(", tag.text()),
        Token::CloseTag => ")".to_owned(),
        Token::Not => "not".to_owned(),
        Token::Name(name) => name.text().to_owned(),
        Token::Object(object) => object.text().to_owned(),
        Token::Manner(manner) => manner.text().to_owned(),
    }
}

/// Reads literal text that begins at `place`.
fn read_tokens(text: &str, place: Place) -> Result<Vec<(Token, Place)>, LanguageError> {
    let characters: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut index = 0;
    while index < characters.len() {
        let at = Place { line: place.line, column: place.column + index as u32 };
        let fault = |message| LanguageError { place: at, message };
        match characters[index] {
            c if c.is_whitespace() => index += 1,
            ']' => {
                tokens.push((Token::CloseNode, at));
                index += 1;
            }
            ')' => {
                tokens.push((Token::CloseTag, at));
                index += 1;
            }
            c if c.is_ascii_alphanumeric() || c == '_' => {
                let end = (index..characters.len())
                    .find(|&i| !(characters[i].is_ascii_alphanumeric() || characters[i] == '_'))
                    .unwrap_or(characters.len());
                let word: String = characters[index..end].iter().collect();
                let (token, length) = read_word(&word, characters.get(end).copied()).map_err(fault)?;
                tokens.push((token, at));
                index = end + length;
            }
            c => {
                let expected = "a word, Seq[, Sel[, a tag such as Post(, ] or )";
                return Err(fault(format!("expected {expected}, found '{c}'")));
            }
        }
    }
    Ok(tokens)
}

/// The token of a word and whether the bracket after it belongs to it (1) or not (0).
fn read_word(word: &str, next: Option<char>) -> Result<(Token, usize), String> {
    if let Some(tag) = Tag::ALL.into_iter().find(|tag| tag.text() == word) {
        return match next {
            Some('(') => Ok((Token::OpenTag(tag), 1)),
            _ => Err(format!("expected ( after {word}")),
        };
    }
    if let Some(token) = [("Seq", Token::Sequence), ("Sel", Token::Selector)].into_iter().find(|t| t.0 == word) {
        return match next {
            Some('[') => Ok((token.1, 1)),
            _ => Err(format!("expected [ after {word}")),
        };
    }
    if word == "not" {
        return Ok((Token::Not, 0));
    }
    let name = Name::ALL.into_iter().find(|name| name.text() == word).map(Token::Name);
    let object = Object::ALL.into_iter().find(|object| object.text() == word).map(Token::Object);
    let manner = Manner::ALL.into_iter().find(|manner| manner.text() == word).map(Token::Manner);
    name.or(object).or(manner).map(|token| (token, 0)).ok_or_else(|| {
        let words = Name::ALL.iter().map(|name| name.text());
        let words = words.chain(Object::ALL.iter().map(|object| object.text()));
        let words = words.chain(Tag::ALL.iter().map(|tag| tag.text()));
        let words = words.chain(Manner::ALL.iter().map(|manner| manner.text())).chain(["Seq", "Sel", "not"]);
        match nearest(word, words) {
            Some(near) => format!("unknown word \"{word}\", did you mean \"{near}\"?"),
            None => format!(
                "unknown word \"{word}\", expected Seq[, Sel[, a tag such as Post(, a condition, an action or an argument"
            ),
        }
    })
}
