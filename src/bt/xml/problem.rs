//! Places in the text as the user typed it, and the problems that stand there.

use crate::place::Place;
use std::fmt;

/// One fault of a document, or one thing to know about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// What kind of problem, such as `unknown-node`; stable, for tests and for links to help.
    pub code: &'static str,
    /// Where it stands.
    pub place: Place,
    /// What was found and what is allowed, in one sentence without the place.
    pub message: String,
    /// True when the document is accepted all the same.
    pub warning: bool,
}

impl fmt::Display for Problem {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.place, self.message)
    }
}

impl std::error::Error for Problem {}

impl Problem {
    pub(super) fn fault(code: &'static str, place: Place, message: impl Into<String>) -> Self {
        Self { code, place, message: clipped(message.into()), warning: false }
    }

    pub(super) fn warning(code: &'static str, place: Place, message: impl Into<String>) -> Self {
        Self { warning: true, ..Self::fault(code, place, message) }
    }
}

/// The longest message, in characters: names in a text may be as long as the text.
const LONGEST: usize = 600;

fn clipped(message: String) -> String {
    match message.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &message[..end]),
        None => message,
    }
}

/// Bytes between two remembered counts: one line of 2 MB must not make every place cost 2 MB of counting.
const BLOCK: usize = 256;

/// A text that finds line and column of a byte quickly.
pub(super) struct Source<'a> {
    pub text: &'a str,
    /// Where each line begins, in bytes.
    lines: Vec<usize>,
    /// How many characters begin before each block.
    before: Vec<u32>,
}

impl<'a> Source<'a> {
    pub fn new(text: &'a str) -> Self {
        let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        let mut before = vec![0];
        let mut count = 0;
        for block in text.as_bytes().chunks(BLOCK) {
            count += characters(block);
            before.push(count);
        }
        Self { text, lines, before }
    }

    /// The place of the character at a byte; past the end is the end.
    pub fn place(&self, byte: usize) -> Place {
        let line = self.lines.partition_point(|start| *start <= byte).max(1);
        let start = self.lines[line - 1];
        Place { line: line as u32, column: self.characters_before(byte) - self.characters_before(start) + 1 }
    }

    fn characters_before(&self, byte: usize) -> u32 {
        let byte = byte.min(self.text.len());
        let block = byte / BLOCK;
        self.before[block] + characters(&self.text.as_bytes()[block * BLOCK..byte])
    }

    /// The place of one character of an attribute's value, counted after entities were replaced.
    ///
    /// - `start`: the byte behind the opening quote; `index`: the character, from 0; its length is the end.
    pub fn inside_value(&self, start: usize, index: usize) -> Place {
        let quote = self.text.get(..start).and_then(|before| before.chars().next_back()).unwrap_or('"');
        let mut rest = self.text.get(start..).unwrap_or_default();
        for _ in 0..index {
            let step = match rest.as_bytes() {
                [] => break,
                [b'&', ..] => rest.find(';').map_or(1, |at| at + 1),
                [b'\r', b'\n', ..] => 2,
                _ if rest.starts_with(quote) => break,
                _ => rest.chars().next().map_or(1, char::len_utf8),
            };
            rest = rest.get(step..).unwrap_or_default();
        }
        self.place(self.text.len() - rest.len())
    }
}

/// The number of characters that begin in these bytes of UTF-8.
fn characters(bytes: &[u8]) -> u32 {
    bytes.iter().filter(|byte| (**byte & 0xC0) != 0x80).count() as u32
}
