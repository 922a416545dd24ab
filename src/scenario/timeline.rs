//! Going back in a run: keyframes, and stepping forward from the nearest one.

use super::run::State;
use super::{Run, ScenarioError};
use serde_json::Value;

/// A run with keyframes. Keyframes change how fast a tick is reached, never what is found there.
#[derive(Clone, Debug)]
pub struct Timeline {
    run: Run,
    /// In the order of their ticks; the first is tick 0 and stays.
    keyframes: Vec<(u32, State)>,
    bytes: usize,
    budget: usize,
    /// Ticks between keyframes at least; grows each time the memory is used up.
    spacing: u32,
}

/// Ticks between the keyframes that seeking leaves behind.
const STRIDE: u32 = 64;

impl Timeline {
    /// Takes a run at tick 0.
    ///
    /// - `budget`: bytes that keyframes may take, about; two are always kept.
    #[must_use]
    pub fn new(run: Run, budget: usize) -> Self {
        let first = run.state();
        let bytes = first.bytes();
        Self { keyframes: vec![(run.tick(), first)], run, bytes, budget, spacing: 1 }
    }

    /// The run.
    #[must_use]
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// The run, to ask what needs it exclusively.
    pub fn run_mut(&mut self) -> &mut Run {
        &mut self.run
    }

    /// Stores the present state. When the memory is used up, every second keyframe is dropped, and from then on a
    /// call does nothing when the last keyframe is nearer than those that are left are to each other.
    pub fn keyframe(&mut self) {
        let tick = self.run.tick();
        let at = self.keyframes.partition_point(|frame| frame.0 <= tick);
        if at < self.keyframes.len() || tick - self.keyframes[at - 1].0 < self.spacing {
            return;
        }
        let state = self.run.state();
        self.bytes += state.bytes();
        self.keyframes.push((tick, state));
        while self.bytes > self.budget && self.keyframes.len() > 2 {
            let mut index = 0;
            self.keyframes.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.bytes = self.keyframes.iter().map(|frame| frame.1.bytes()).sum();
            let gaps = self.keyframes.windows(2).map(|pair| pair[1].0 - pair[0].0);
            self.spacing = gaps.min().unwrap_or(self.spacing);
        }
    }

    /// Goes towards `tick`, making at most `budget` steps; returns the tick reached. Call again until it is `tick`,
    /// or until it stays the same: then the run ends before `tick`.
    pub fn seek(&mut self, tick: u32, budget: u32) -> u32 {
        let now = self.run.tick();
        let at = self.keyframes.partition_point(|frame| frame.0 <= tick).max(1) - 1;
        let (nearest, state) = &self.keyframes[at];
        if tick < now || *nearest > now {
            self.run.restore(state);
        }
        let missing = tick.saturating_sub(self.run.tick());
        let mut left = missing.min(budget);
        while left > 0 {
            let done = self.run.advance(left.min(STRIDE));
            self.keyframe();
            if done == 0 {
                break;
            }
            left -= done;
        }
        self.run.tick()
    }

    /// Changes a live parameter now; drops what was later.
    ///
    /// # Errors
    /// As [`Run::set`].
    pub fn set(&mut self, key: &str, value: &Value) -> Result<(), ScenarioError> {
        self.run.set(key, value)?;
        let tick = self.run.tick();
        self.keyframes.retain(|frame| frame.0 <= tick);
        self.bytes = self.keyframes.iter().map(|frame| frame.1.bytes()).sum();
        Ok(())
    }
}
