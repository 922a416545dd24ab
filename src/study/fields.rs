//! Strict reading of JSON objects: every fault names the path of its field.

use crate::nearest::nearest;
use crate::parameter::shown;
use serde_json::{Map, Value};
use std::fmt;
use std::ops::RangeInclusive;

/// Why a text is no study: one sentence with the field's path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudyError {
    /// The path of the field, such as `cells[2].set.geese.agents`; empty where the text is no JSON.
    pub path: String,
    /// What was found and what is allowed.
    pub message: String,
}

impl fmt::Display for StudyError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            write!(out, "{}", self.message)
        } else {
            write!(out, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for StudyError {}

pub(super) fn fault<T>(path: impl Into<String>, message: impl Into<String>) -> Result<T, StudyError> {
    Err(StudyError { path: path.into(), message: message.into() })
}

/// An object whose fields are all known.
pub(super) struct Fields<'a> {
    map: &'a Map<String, Value>,
    path: String,
}

impl<'a> Fields<'a> {
    /// Takes an object at `path`; refuses fields that are not among `known`.
    pub fn of(value: &'a Value, path: &str, known: &[&str]) -> Result<Self, StudyError> {
        let Value::Object(map) = value else {
            return fault(path, format!("expected an object with {}, found {}", listed(known), shown(value)));
        };
        let fields = Self { map, path: path.to_owned() };
        match map.keys().find(|name| !known.contains(&name.as_str())) {
            None => Ok(fields),
            Some(name) => fault(fields.at(name), format!("unknown field, {}", instead(name, known))),
        }
    }

    /// The path of a field.
    pub fn at(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }

    pub fn get(&self, name: &str) -> Option<&'a Value> {
        self.map.get(name)
    }

    /// A field that must be there; `expected` says what, for the message.
    pub fn need(&self, name: &str, expected: &str) -> Result<&'a Value, StudyError> {
        self.get(name).map_or_else(|| fault(self.at(name), format!("expected {expected}, found no such field")), Ok)
    }

    /// A text; empty when the field is not there.
    pub fn text(&self, name: &str) -> Result<String, StudyError> {
        self.get(name).map_or_else(|| Ok(String::new()), |value| text(value, &self.at(name)))
    }

    /// A whole number within bounds, if the field is there.
    pub fn whole(&self, name: &str, range: RangeInclusive<u64>) -> Result<Option<u64>, StudyError> {
        let Some(value) = self.get(name) else { return Ok(None) };
        if let Some(whole) = value.as_u64().filter(|whole| range.contains(whole)) {
            return Ok(Some(whole));
        }
        let (least, most) = (range.start(), range.end());
        fault(self.at(name), format!("expected a whole number from {least} to {most}, found {}", shown(value)))
    }

    /// The elements of a list with their paths; none when the field is not there.
    pub fn each(&self, name: &str, most: usize) -> Result<Vec<(String, &'a Value)>, StudyError> {
        let path = self.at(name);
        match self.get(name) {
            None => Ok(Vec::new()),
            Some(value) => elements(value, &path, most),
        }
    }
}

/// The elements of a list with their paths.
pub(super) fn elements<'a>(value: &'a Value, path: &str, most: usize) -> Result<Vec<(String, &'a Value)>, StudyError> {
    let Value::Array(list) = value else {
        return fault(path, format!("expected a list, found {}", shown(value)));
    };
    if list.is_empty() || list.len() > most {
        return fault(path, format!("expected a list of 1 to {most}, found one of {}", list.len()));
    }
    Ok(list.iter().enumerate().map(|(at, value)| (format!("{path}[{at}]"), value)).collect())
}

/// The fields of an object, in the order of their names.
pub(super) fn entries<'a>(value: &'a Value, path: &str) -> Result<Vec<(&'a str, &'a Value)>, StudyError> {
    match value {
        Value::Object(map) => Ok(map.iter().map(|(name, value)| (name.as_str(), value)).collect()),
        _ => fault(path, format!("expected an object, found {}", shown(value))),
    }
}

/// Bytes of a title or an about text, as in scenarios.
const LONGEST_TEXT: usize = 2000;

pub(super) fn text(value: &Value, path: &str) -> Result<String, StudyError> {
    match value {
        Value::String(text) if text.len() <= LONGEST_TEXT => Ok(text.clone()),
        Value::String(_) => fault(path, format!("expected at most {LONGEST_TEXT} bytes of text, found more")),
        other => fault(path, format!("expected text, found {}", shown(other))),
    }
}

/// A name that fits into one line of a table: 1 to 100 characters, none of them a control character.
pub(super) fn name(value: &Value, path: &str) -> Result<String, StudyError> {
    let text = text(value, path)?;
    if text.trim().is_empty() || text.chars().count() > 100 || text.contains(char::is_control) {
        let expected = "expected 1 to 100 characters in one line";
        return fault(path, format!("{expected}, found {}", shown(value)));
    }
    Ok(text)
}

/// The one of `choices` whose name is written.
pub(super) fn one_of<'c, T>(value: &Value, path: &str, choices: &'c [(&str, T)]) -> Result<&'c T, StudyError> {
    let found = value.as_str().and_then(|word| choices.iter().find(|choice| choice.0 == word));
    let names: Vec<&str> = choices.iter().map(|choice| choice.0).collect();
    match (found, value.as_str()) {
        (Some(choice), _) => Ok(&choice.1),
        (None, Some(word)) => fault(path, format!("unknown name {}, {}", shown(value), instead(word, &names))),
        (None, None) => fault(path, format!("expected one of {}, found {}", listed(&names), shown(value))),
    }
}

/// What to write in place of an unknown name.
fn instead(found: &str, known: &[&str]) -> String {
    nearest(found, known.iter().copied())
        .map_or_else(|| format!("expected one of {}", listed(known)), |near| format!("did you mean \"{near}\"?"))
}

fn listed(names: &[&str]) -> String {
    const MOST: usize = 24;
    let mut quoted: Vec<String> = names.iter().take(MOST).map(|name| format!("\"{name}\"")).collect();
    if names.len() > MOST {
        quoted.push(format!("and {} more", names.len() - MOST));
    }
    if quoted.is_empty() { "nothing".to_owned() } else { quoted.join(", ") }
}
