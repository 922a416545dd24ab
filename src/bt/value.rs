//! The values that blackboard entries, ports and scripts hold.

use crate::fingerprint::Fingerprint;
use std::fmt;

/// A value of a blackboard entry.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A whole number or a real; booleans are 1 and 0. Scripts calculate with reals throughout.
    Number(f64),
    /// A text.
    Text(String),
    /// Values waiting for one of the loop decorators, first in first out.
    Queue(Vec<Value>),
}

impl Value {
    /// Reads a literal the way a port without a type does: a number where it is one, otherwise text.
    #[must_use]
    pub fn literal(text: &str) -> Self {
        text.trim()
            .parse::<f64>()
            .ok()
            .filter(|number| number.is_finite())
            .map_or_else(|| Self::Text(text.to_owned()), Self::Number)
    }

    /// Takes the value into a fingerprint.
    pub(super) fn hash_into(&self, hash: &mut Fingerprint) {
        match self {
            Self::Number(number) => hash.f64(*number),
            Self::Text(text) => {
                hash.u64(text.len() as u64);
                text.bytes().for_each(|byte| hash.u32(u32::from(byte)));
            }
            Self::Queue(values) => {
                hash.u64(values.len() as u64);
                for value in values {
                    value.hash_into(hash);
                }
            }
        }
    }
}

impl fmt::Display for Value {
    /// Whole numbers without a fraction, texts as they are, queues with semicolons between the values.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(out, "{number}"),
            Self::Text(text) => out.write_str(text),
            Self::Queue(values) => {
                for (index, value) in values.iter().enumerate() {
                    if index > 0 {
                        out.write_str(";")?;
                    }
                    write!(out, "{value}")?;
                }
                Ok(())
            }
        }
    }
}
