//! What a task is made of, and what is wrong with what cannot be one.

use super::behaviours::Behaviour;
use super::cover::Cells;
use super::map::{Bounds, Form};
use std::fmt;

/// What the swarm is to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// Every robot strictly nearer than `radius` to `centre`. Source: eq. (16).
    Reach {
        /// a_target, metres.
        centre: [f64; 2],
        /// R_target, metres.
        radius: f64,
    },
    /// At least this share of the cells visited. Source: eq. (19).
    Cover {
        /// The grid.
        cells: Cells,
        /// R_target, of G_x G_y.
        ratio: f64,
    },
}

/// Why something is no task: the field it concerns, and what was found and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TaskError {
    /// One of `robots`, `map`, `obstacles`, `library`, `start`, `target`, `cells`.
    pub field: &'static str,
    /// One sentence.
    pub message: String,
}

impl fmt::Display for TaskError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.field, self.message)
    }
}

impl std::error::Error for TaskError {}

/// A fault of a field.
pub fn fault<T>(field: &'static str, message: String) -> Result<T, TaskError> {
    Err(TaskError { field, message })
}

/// The parts a task is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Parts {
    /// Where robots may be.
    pub bounds: Bounds,
    /// What stands in the way.
    pub obstacles: Vec<Form>,
    /// What is to be done.
    pub goal: Goal,
    /// The behaviours, in the order in which the search tries them.
    pub library: Vec<Behaviour>,
    /// x, y and heading of each robot.
    pub start: Vec<[f64; 3]>,
    /// Decision points, n.
    pub decisions: u16,
    /// Seconds between two of them.
    pub interval: u32,
}

/// The most cells a grid may have.
pub const MOST_CELLS: u64 = 1 << 20;
/// The most behaviours a library may have.
const MOST_BEHAVIOURS: usize = 64;

/// Checks a library.
///
/// # Errors
/// None, or too many, behaviours; two of one letter; two that stop.
pub fn check_library(library: &[Behaviour]) -> Result<(), TaskError> {
    if library.is_empty() || library.len() > MOST_BEHAVIOURS {
        return fault("library", format!("expected 1 to {MOST_BEHAVIOURS} behaviours, found {}", library.len()));
    }
    for (at, behaviour) in library.iter().enumerate() {
        if library[..at].iter().any(|other| other.letter == behaviour.letter) {
            return fault(
                "library",
                format!("expected a letter for each behaviour, found {:?} twice", behaviour.letter),
            );
        }
    }
    let stops: Vec<char> = library.iter().filter(|behaviour| behaviour.is_stop()).map(|stop| stop.letter).collect();
    match stops[..] {
        [first, second, ..] => {
            fault("library", format!("expected at most one behaviour that stops, found {first:?} and {second:?}"))
        }
        _ => Ok(()),
    }
}
