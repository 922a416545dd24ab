//! The worlds. Frames cross as a flat buffer of `f32` in wasm memory, of which the page makes a view after each call.

use super::{answer, error};
use crate::geese::{
    Derived, Detail, Layout, Query, SAMPLE_EVERY, Task, World as Geese, export_query, fill_frame, grammar_text,
};
use crate::scenario::{Run, Scenario, Timeline};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// Bytes that keyframes may take where the page does not say.
const KEYFRAME_BYTES: usize = 32 << 20;

/// The scenario as JSON with every field present.
///
/// # Errors
/// The scenario is not valid; the message says where and why.
#[wasm_bindgen]
pub fn complete(scenario: &str) -> Result<String, JsError> {
    Ok(Scenario::read(scenario).map_err(|fault| error(&fault))?.to_value().to_string())
}

/// The rules that a scenario's grammar stands for: those of the task (`forage` or `nest`) for `ppa` and `nominal`,
/// otherwise the text itself.
#[wasm_bindgen]
#[must_use]
pub fn rules(grammar: &str, task: &str) -> String {
    let task = if task == "nest" { Task::Nest } else { Task::Forage };
    grammar_text(grammar, task).into_owned()
}

/// A world on its way through a scenario, with its keyframes.
#[wasm_bindgen]
#[derive(Debug)]
pub struct World {
    timeline: Timeline,
    frame: Vec<f32>,
}

#[wasm_bindgen]
impl World {
    /// Builds the world of a scenario, given as JSON.
    ///
    /// - `keyframes`: bytes that keyframes may take.
    ///
    /// # Errors
    /// The scenario is not valid, or its world cannot be built.
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str, keyframes: Option<usize>) -> Result<World, JsError> {
        let run = Scenario::read(scenario).and_then(Run::new).map_err(|fault| error(&fault))?;
        Ok(World { timeline: Timeline::new(run, keyframes.unwrap_or(KEYFRAME_BYTES)), frame: Vec::new() })
    }

    /// Steps made so far.
    #[must_use]
    pub fn tick(&self) -> u32 {
        self.timeline.run().tick()
    }

    /// The fingerprint of the whole state, as 16 hex digits.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        format!("{:016x}", self.timeline.run().fingerprint())
    }

    /// Why the run ended, or `undefined`.
    #[must_use]
    pub fn finished(&self) -> Option<String> {
        self.timeline.run().finished().map(str::to_owned)
    }

    /// Makes up to `ticks` steps; returns how many.
    pub fn advance(&mut self, ticks: u32) -> u32 {
        self.timeline.run_mut().advance(ticks)
    }

    /// Stores the present state for going back.
    pub fn keyframe(&mut self) {
        self.timeline.keyframe();
    }

    /// Goes towards `tick` in at most `budget` steps; returns the tick reached.
    pub fn seek(&mut self, tick: u32, budget: u32) -> u32 {
        self.timeline.seek(tick, budget)
    }

    /// Changes a live parameter now; `value` is JSON.
    ///
    /// # Errors
    /// The key is unknown or needs a restart, or the value is not allowed.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), JsError> {
        let value: Value = serde_json::from_str(value).map_err(|fault| error(&fault))?;
        self.timeline.set(key, &value).map_err(|fault| error(&fault))
    }

    /// The scenario with the changes made so far, as JSON.
    #[must_use]
    pub fn scenario(&self) -> String {
        self.timeline.run().scenario().to_value().to_string()
    }

    /// The programs of this moment as a population file, or `undefined`.
    #[must_use]
    pub fn population(&self) -> Option<String> {
        self.timeline.run().population()
    }

    /// What stands where in a frame, as JSON.
    #[must_use]
    pub fn layout(&self) -> String {
        answer(self.timeline.run().geese().map(Layout::of))
    }

    /// Fills the frame and returns where it stands in memory; the next call of any method may move it.
    pub fn frame_pointer(&mut self) -> *const f32 {
        if let Some(world) = self.timeline.run().geese() {
            fill_frame(world, &mut self.frame);
        }
        self.frame.as_ptr()
    }

    /// Reals in the frame filled last.
    #[must_use]
    pub fn frame_length(&self) -> usize {
        self.frame.len()
    }

    /// What the inspector shows: a query as JSON, an answer as JSON.
    ///
    /// # Errors
    /// The query is not valid.
    pub fn inspect(&mut self, query: &str) -> Result<String, JsError> {
        let query: Value = serde_json::from_str(query).map_err(|fault| error(&fault))?;
        let query = Query::from_value(&query);
        Ok(answer(self.timeline.run_mut().geese_mut().map(|world| Detail::of(world, &query))))
    }

    /// The program that a query asks for as a document of BehaviorTree.CPP, or `undefined`.
    ///
    /// # Errors
    /// The query is not valid.
    pub fn export(&self, query: &str) -> Result<Option<String>, JsError> {
        let query: Value = serde_json::from_str(query).map_err(|fault| error(&fault))?;
        let query = Query::from_value(&query);
        Ok(self.timeline.run().geese().and_then(|world| export_query(world, &query)))
    }

    /// The derivation of codons, given as a JSON list, as JSON.
    ///
    /// # Errors
    /// It is no list of whole numbers from 0 to 65535.
    pub fn derive(&mut self, codons: &str) -> Result<String, JsError> {
        let codons: Value = serde_json::from_str(codons).map_err(|fault| error(&fault))?;
        let codons = codons.as_array().and_then(|codons| codons.iter().map(as_codon).collect::<Option<Vec<u16>>>());
        let codons = codons.ok_or_else(|| JsError::new("expected a list of whole numbers from 0 to 65535"))?;
        let compiler = self.timeline.run_mut().geese_mut().map(Geese::compiler);
        Ok(answer(compiler.map(|compiler| Derived::of(compiler, &codons))))
    }

    /// The samples of the history from number `from` on, as JSON columns.
    #[must_use]
    pub fn history(&self, from: u32) -> String {
        let samples = self.timeline.run().geese().map_or(&[][..], |world| world.state().history());
        let samples = &samples[samples.len().min(from as usize)..];
        json!({
            "every": SAMPLE_EVERY,
            "from": from,
            "delivered": samples.iter().map(|sample| sample.delivered).collect::<Vec<_>>(),
            "carrying": samples.iter().map(|sample| sample.carrying).collect::<Vec<_>>(),
            "programs": samples.iter().map(|sample| sample.programs).collect::<Vec<_>>(),
            "swaps": samples.iter().map(|sample| sample.swaps).collect::<Vec<_>>(),
        })
        .to_string()
    }
}

fn as_codon(value: &Value) -> Option<u16> {
    value.as_u64().and_then(|codon| u16::try_from(codon).ok())
}
