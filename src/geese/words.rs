//! The words of the language of state machines ([`super::rules`]).

use super::language::LanguageError;
use super::leaf::{Name, Object};
use crate::evolution::RuleId;
use crate::nearest::nearest;
use crate::place::Place;

/// What a number is, for messages.
pub const PROBABILITY: &str = "a probability from 0 to 1";

/// A word, number or sign of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Token {
    /// The name of a part of a rule, with its bracket.
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
    /// A variable, by its number.
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

/// Every word; a section's has a bracket behind it.
const WORDS: [(&str, Token); 29] = {
    use Name as N;
    use Object as O;
    [
        ("From", Token::Open(Section::From)),
        ("If", Token::Open(Section::If)),
        ("Goto", Token::Open(Section::Goto)),
        ("Set", Token::Open(Section::Set)),
        ("equals", Token::Equals),
        ("true", Token::Bool(true)),
        ("false", Token::Bool(false)),
        ("not", Token::Not),
        ("X", Token::Variable(0)),
        ("Y", Token::Variable(1)),
        ("NeighbourObjects", Token::Name(N::NeighbourObjects)),
        ("IsVisitedBefore", Token::Name(N::IsVisitedBefore)),
        ("IsCarrying", Token::Name(N::IsCarrying)),
        ("IsCarryable", Token::Name(N::IsCarryable)),
        ("IsDropable", Token::Name(N::IsDropable)),
        ("CanMove", Token::Name(N::CanMove)),
        ("DummyNode", Token::Name(N::DummyNode)),
        ("MoveTowards", Token::Name(N::MoveTowards)),
        ("MoveAway", Token::Name(N::MoveAway)),
        ("Explore", Token::Name(N::Explore)),
        ("CompositeSingleCarry", Token::Name(N::CompositeSingleCarry)),
        ("CompositeDrop", Token::Name(N::CompositeDrop)),
        ("Hub", Token::Object(O::Hub)),
        ("Sites", Token::Object(O::Sites)),
        ("Food", Token::Object(O::Food)),
        ("Boundary", Token::Object(O::Boundary)),
        ("Debris", Token::Object(O::Debris)),
        ("Obstacles", Token::Object(O::Obstacles)),
        ("Trap", Token::Object(O::Trap)),
    ]
};

/// In one.
pub const MILLION: u32 = 1_000_000;

/// A symbol, or a word of a text, as the check reads it.
pub struct Item {
    /// What it is.
    pub what: What,
    /// Where it stands.
    pub place: Place,
    /// As it is written.
    pub text: String,
}

/// What an [`Item`] is.
pub enum What {
    /// A word, number or sign.
    Token(Token),
    /// A symbol.
    Rule(RuleId),
}

/// Reads literal text that begins at `place` and adds what it holds to `items`.
///
/// # Errors
/// The first word that is none of the language, with its place.
pub fn read_tokens(text: &str, place: Place, items: &mut Vec<Item>) -> Result<(), LanguageError> {
    let characters: Vec<char> = text.chars().collect();
    let mut index = 0;
    while index < characters.len() {
        let from = index;
        let is_word = |c: &char| c.is_ascii_alphanumeric() || *c == '.';
        while characters.get(index).is_some_and(is_word) {
            index += 1;
        }
        // A sign is a word of its own, and a bracket belongs to the name of a part before it.
        index += usize::from(index == from || characters.get(index) == Some(&'('));
        let word: String = characters[from..index].iter().collect();
        if word.trim().is_empty() {
            continue;
        }
        let place = Place { line: place.line, column: place.column + from as u32 };
        let token = read_word(&word).map_err(|message| LanguageError { place, message })?;
        items.push(Item { what: What::Token(token), place, text: word });
    }
    Ok(())
}

fn read_word(word: &str) -> Result<Token, String> {
    let name = word.strip_suffix('(').unwrap_or(word);
    if let Some((_, token)) = WORDS.iter().find(|known| known.0 == name) {
        return match (token, name == word) {
            (Token::Open(_), true) => Err(format!("expected ( after {word}")),
            (Token::Open(_), false) | (_, true) => Ok(*token),
            (_, false) => Err(format!("expected From(, If(, Goto( or Set(, found {word}")),
        };
    }
    match word {
        ")" => return Ok(Token::Close),
        "," => return Ok(Token::Comma),
        "-" => return Ok(Token::Any),
        _ => {}
    }
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        let fault = || format!("expected {PROBABILITY} with at most six decimals, found {word}");
        return read_millionths(word).map(Token::Millionths).ok_or_else(fault);
    }
    Err(match nearest(name, WORDS.iter().map(|known| known.0)) {
        Some(near) => format!("unknown word \"{name}\", did you mean \"{near}\"?"),
        None => {
            format!("unknown word \"{name}\", expected a part such as From(, a condition, an action or an argument")
        }
    })
}

/// A decimal number from 0 to 1 with at most six digits behind the point, in millionths.
fn read_millionths(word: &str) -> Option<u32> {
    let (mut number, mut unit) = (0, None);
    for byte in word.bytes() {
        let digit = u32::from(byte.wrapping_sub(b'0'));
        match (digit, unit) {
            (0..=9, None) => number = number * 10 + digit * MILLION,
            (0..=9, Some(above)) if above > 1 => {
                number += digit * (above / 10);
                unit = Some(above / 10);
            }
            _ if byte == b'.' && unit.is_none() => unit = Some(MILLION),
            _ => return None,
        }
        if number > MILLION {
            return None;
        }
    }
    Some(number).filter(|_| !word.ends_with('.'))
}
