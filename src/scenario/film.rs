//! A match computed ahead of whoever looks at it: a frame for every tick, and every moment of it on demand.

use super::{Run, ScenarioError, Timeline};
use crate::soccer::{FRAME, Moment, World};
use serde_json::Value;

/// Ticks between keyframes.
const STRIDE: u32 = 64;

/// A match that is filmed up to its front.
#[derive(Clone, Debug)]
pub struct Film {
    timeline: Timeline,
    /// The tick up to which frames were taken.
    front: u32,
    over: bool,
    frames: Vec<f32>,
}

impl Film {
    /// Begins to film a match at tick 0, whose frame is taken at once.
    ///
    /// - `keyframes`: bytes that keyframes may take.
    ///
    /// # Errors
    /// The run is of another world.
    pub fn new(run: Run, keyframes: usize) -> Result<Self, ScenarioError> {
        if run.soccer().is_none() {
            let message = format!("expected \"soccer\", found \"{}\"", run.scenario().world.name());
            return Err(ScenarioError { path: "world".to_owned(), message });
        }
        let front = run.tick();
        let mut film = Self { timeline: Timeline::new(run, keyframes), front, over: false, frames: Vec::new() };
        film.take();
        Ok(film)
    }

    /// The run, at the moment that was looked at or computed last.
    #[must_use]
    pub fn run(&self) -> &Run {
        self.timeline.run()
    }

    /// The tick up to which it was filmed.
    #[must_use]
    pub fn front(&self) -> u32 {
        self.front
    }

    /// The frames taken since [`Film::clear`], see [`FRAME`].
    #[must_use]
    pub fn frames(&self) -> &[f32] {
        &self.frames
    }

    /// Forgets the frames, which somebody has fetched.
    pub fn clear(&mut self) {
        self.frames.clear();
    }

    /// Films up to `ticks` further; returns whether there is more to film.
    pub fn ahead(&mut self, ticks: u32) -> bool {
        self.return_to_front();
        self.frames.reserve(ticks.min(4096) as usize * FRAME);
        for _ in 0..ticks {
            if self.over || self.timeline.run_mut().advance(1) == 0 {
                self.over = true;
                return false;
            }
            self.front += 1;
            if self.front.is_multiple_of(STRIDE) {
                self.timeline.keyframe();
            }
            self.take();
        }
        self.over = self.run().finished().is_some();
        !self.over
    }

    /// Goes on as [`Film::ahead`] does, but takes no frames and leaves no keyframes: for who wants the result only.
    pub fn skip(&mut self, ticks: u32) -> bool {
        self.return_to_front();
        self.front += self.timeline.run_mut().advance(ticks);
        self.over = self.run().finished().is_some();
        !self.over
    }

    /// Everything that there is to see at a tick; of the first one, what stands before any frame.
    ///
    /// - `tick`: one beyond the front counts as the front.
    pub fn look(&mut self, tick: u32) -> Option<Moment> {
        let tick = tick.min(self.front);
        if tick == 0 {
            self.seek(0);
            return self.run().soccer().map(World::first_moment);
        }
        self.seek(tick - 1);
        self.run().clone().step_watched()
    }

    /// The fingerprint at a tick.
    pub fn fingerprint(&mut self, tick: u32) -> u64 {
        self.seek(tick.min(self.front));
        self.run().fingerprint()
    }

    /// Does something to the match at a tick: what was filmed after it is cut off, and its own frame is taken anew.
    ///
    /// # Errors
    /// As [`Run::set`]; nothing changes then.
    pub fn set(&mut self, tick: u32, key: &str, value: &Value) -> Result<(), ScenarioError> {
        self.seek(tick.min(self.front));
        self.timeline.set(key, value)?;
        self.front = self.run().tick();
        self.over = self.run().finished().is_some();
        self.clear();
        self.take();
        Ok(())
    }

    /// The arrangement at a tick as the value of an event `soccer.arrangement`, velocity of the ball included.
    pub fn arrangement(&mut self, tick: u32) -> Value {
        self.seek(tick.min(self.front));
        let mut now = self.run().clone();
        now.apply_events();
        now.soccer().map_or(Value::Null, World::arrangement)
    }

    /// Takes the frame of the present tick, with what the events of this tick do to it.
    fn take(&mut self) {
        let run = self.timeline.run();
        let tick = run.tick();
        let events = &run.scenario().events;
        let touched = events[events.partition_point(|event| event.tick < tick)..].first();
        if touched.is_some_and(|event| event.tick == tick) {
            let mut changed = run.clone();
            changed.apply_events();
            changed.soccer().into_iter().for_each(|world| world.film(&mut self.frames));
        } else if let Some(world) = run.soccer() {
            world.film(&mut self.frames);
        }
    }

    fn return_to_front(&mut self) {
        if self.run().tick() != self.front {
            self.seek(self.front);
        }
    }

    fn seek(&mut self, tick: u32) {
        if self.run().tick() != tick {
            self.timeline.seek(tick, u32::MAX);
        }
    }
}
