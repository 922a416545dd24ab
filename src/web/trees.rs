//! The tree workbench.

use super::{answer, error};
use crate::bt::xml::Problem;
use crate::place::Place;
use crate::workbench;
use serde_json::Value;
use wasm_bindgen::prelude::*;

/// The 42 built-in nodes with their ports, as JSON.
#[wasm_bindgen]
#[must_use]
pub fn models() -> String {
    workbench::models().to_string()
}

/// The document in each form of the sequence or fallback at a place, as JSON.
#[wasm_bindgen]
#[must_use]
pub fn variants(xml: &str, line: u32, column: u32) -> String {
    answer(Some(workbench::variants(xml, Place { line, column })))
}

/// The canonical form of a document, with models of all its custom nodes.
///
/// # Errors
/// The first fault of the text with its place.
#[wasm_bindgen]
pub fn format(xml: &str) -> Result<String, JsError> {
    workbench::format(xml).map_err(|problems| first_fault(&problems))
}

/// Ticks the tree of a setup and keeps nothing, for measuring; returns the fingerprint as 16 hex digits.
///
/// # Errors
/// The setup is not valid, or its document has faults.
#[wasm_bindgen]
pub fn tick_headless(setup: &str, ticks: u32) -> Result<String, JsError> {
    let done = workbench::tick_headless(&read(setup)?, ticks).map_err(|problems| first_fault(&problems))?;
    Ok(format!("{:016x}", done.fingerprint))
}

fn read(setup: &str) -> Result<workbench::Setup, JsError> {
    let setup: Value = serde_json::from_str(setup).map_err(|fault| error(&fault))?;
    workbench::Setup::from_value(&setup).map_err(|fault| error(&fault))
}

fn first_fault(problems: &[Problem]) -> JsError {
    let first = problems.iter().find(|problem| !problem.warning);
    error(&first.map(ToString::to_string).unwrap_or_default())
}

/// A tree on the bench.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Bench {
    bench: workbench::Bench,
}

#[wasm_bindgen]
impl Bench {
    /// An empty bench.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Opens a setup, given as JSON; returns what there is to show, as JSON.
    ///
    /// # Errors
    /// The setup is not valid; faults of its document are part of the answer.
    pub fn open(&mut self, setup: &str) -> Result<String, JsError> {
        Ok(answer(Some(self.bench.open(&read(setup)?))))
    }

    /// Goes up to `ticks` further, or to the next breakpoint; returns the moment as JSON.
    pub fn advance(&mut self, ticks: u32) -> String {
        answer(self.bench.advance(ticks))
    }

    /// Shows the state after `tick` ticks; returns the moment as JSON.
    pub fn seek(&mut self, tick: u32) -> String {
        answer(self.bench.seek(tick))
    }

    /// What every node did in a stretch of ticks, as JSON.
    #[must_use]
    pub fn timeline(&self, from: u32, to: u32) -> String {
        answer(Some(self.bench.timeline(from, to)))
    }

    /// Sets where `advance` stops: a JSON list of nodes with letters.
    ///
    /// # Errors
    /// It is no list of pairs of a number and a text.
    pub fn breakpoints(&mut self, list: &str) -> Result<(), JsError> {
        self.bench.breakpoints(serde_json::from_str(list).map_err(|fault| error(&fault))?);
        Ok(())
    }
}
