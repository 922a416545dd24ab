//! Behaviour sequencing. The page drives a search in slices and draws it as it grows; trajectories and the frontier
//! cross as flat buffers of `f32` in wasm memory, of which the page makes a view after each call.

use super::{answer, error};
use crate::random::Seed;
use crate::scenario::{Scenario, WorldParams, schema};
use crate::sequencing::{
    Cells, Form, Goal, Kernel, Params, Replay, Search, Solution, Task, first_interval, jittered, replay, robustness,
};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// Every parameter of sequencing scenarios as JSON.
#[wasm_bindgen]
#[must_use]
pub fn sequence_schema() -> String {
    let own = |entry: &&Value| {
        let key = entry["key"].as_str().unwrap_or_default();
        key == "seed" || key.starts_with("sequencing.")
    };
    let entries = schema();
    answer(entries.as_array().map(|entries| entries.iter().filter(own).collect::<Vec<_>>()))
}

/// The scenario as JSON with every field present.
///
/// # Errors
/// The scenario is not valid; the message says where and why.
#[wasm_bindgen]
pub fn sequence_complete(scenario: &str) -> Result<String, JsError> {
    Ok(Scenario::read(scenario).map_err(|fault| error(&fault))?.to_value().to_string())
}

/// A task, its search, and plans carried out on it.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Sequence {
    params: Params,
    seed: Seed,
    task: Task,
    search: Search,
    kernel: Kernel,
    buffer: Vec<f32>,
    marks: Vec<u8>,
}

#[wasm_bindgen]
impl Sequence {
    /// Builds the task of a scenario, given as JSON, and begins its search.
    ///
    /// # Errors
    /// The scenario is not valid or not of sequencing, or its task cannot be built.
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str) -> Result<Sequence, JsError> {
        let scenario = Scenario::read(scenario).map_err(|fault| error(&fault))?;
        let WorldParams::Sequencing(params) = scenario.world else {
            return Err(JsError::new("world: expected \"sequencing\""));
        };
        let fault = |(field, message): (&str, String)| JsError::new(&format!("{field}: {message}"));
        let (task, wide) = params.tasks(scenario.seed).map_err(fault)?;
        let search = params.search(&wide, true).map_err(fault)?;
        let kernel = Kernel::new(task.robots());
        Ok(Sequence { params, seed: scenario.seed, task, search, kernel, buffer: Vec::new(), marks: Vec::new() })
    }

    /// Map, obstacles, goal, behaviours, starts and times, as JSON.
    #[must_use]
    pub fn task(&self) -> String {
        let parts = self.task.parts();
        let form = |form: &Form| match form {
            Form::Disc(disc) => json!({"disc": disc}),
            Form::Box(sides) => json!({"box": sides}),
            Form::Polygon(corners) => json!({"polygon": corners}),
        };
        let goal = match parts.goal {
            Goal::Reach { centre, radius } => json!({"target": [centre[0], centre[1], radius]}),
            Goal::Cover { cells: Cells { origin, side, columns, rows }, ratio } => {
                json!({"cells": {"origin": origin, "side": side, "columns": columns, "rows": rows}, "ratio": ratio})
            }
        };
        let bounds = parts.bounds;
        let library = parts.library.iter();
        let library: Vec<Value> =
            library.map(|behaviour| json!({"letter": behaviour.letter, "name": behaviour.name})).collect();
        let task = json!({
            "map": [bounds.left, bounds.right, bounds.bottom, bounds.top],
            "obstacles": parts.obstacles.iter().map(form).collect::<Vec<_>>(),
            "goal": goal,
            "library": library,
            "start": parts.start,
            "decisions": parts.decisions,
            "interval": parts.interval,
            "steps": self.task.steps(),
        });
        task.to_string()
    }

    /// Goes on for up to `budget` integrations; returns where the search stands, as [`Sequence::progress`].
    pub fn advance(&mut self, budget: u32) -> String {
        self.search.advance(u64::from(budget));
        self.progress()
    }

    /// Stops the search; its best plan and bound stay.
    pub fn cancel(&mut self) {
        self.search.cancel();
    }

    /// Outcome (null while it goes on), plan, cost, lower bound, ratio, weights and counts, as JSON.
    #[must_use]
    pub fn progress(&self) -> String {
        let progress = self.search.progress();
        let counts = progress.counts;
        let plan = self.search.best();
        answer(Some(json!({
            "outcome": progress.outcome.map(crate::sequencing::SearchOutcome::text),
            "plan": plan.map(|plan| self.task.letters(&plan.sequence)),
            "cost": progress.cost,
            "lower_bound": self.search.lower_bound().filter(|bound| bound.is_finite()),
            "proven_ratio": self.search.proven_ratio(),
            "weight": progress.weight,
            "proven_weight": Some(progress.proven_weight).filter(|weight| weight.is_finite()),
            "stop_last": self.search.stop_last(),
            "expanded": counts.expanded,
            "integrated": counts.integrated,
            "collided": counts.collided,
            "late": counts.late,
            "missed": counts.missed,
            "alike": counts.alike,
            "open": progress.open,
            "nodes": progress.nodes,
            "bytes": progress.bytes,
        })))
    }

    /// What the search came to, with the robustness of its plan, as the command line prints it.
    #[must_use]
    pub fn solution(&self) -> String {
        answer(Some(Solution::of(&self.search, &self.task, &self.params, self.seed)))
    }

    /// What each behaviour runs into when it is the first, as a JSON list of sentences.
    #[must_use]
    pub fn first_interval(&self) -> String {
        answer(Some(first_interval(self.search.task())))
    }

    /// Carries out a sequence of letters on the task without margins; returns costs, visited cells, charges, whether the
    /// goal is reached, and the first collision, as JSON.
    ///
    /// # Errors
    /// A letter that no behaviour has.
    pub fn replay(&mut self, letters: &str) -> Result<String, JsError> {
        let sequence = self.sequence(letters)?;
        let done = replay(&self.task, &sequence, self.task.start(), &mut self.kernel);
        let charges = self.search.options().costs.of(&sequence, self.task.stop(), self.task.interval());
        let Replay { costs, visited, collision, goal, .. } = &done;
        let collision = collision.map(|(interval, collision)| {
            json!({
                "interval": interval,
                "step": collision.step,
                "robot": collision.robot,
                "obstacle": match collision.touched {
                    crate::sequencing::Touched::Obstacle(at) => Some(at),
                    crate::sequencing::Touched::Edge => None,
                },
            })
        });
        Ok(answer(Some(json!({
            "costs": costs,
            "charges": charges,
            "total": done.cost() + charges,
            "visited": visited,
            "goal": goal,
            "feasible": done.is_feasible(),
            "collision": collision,
        }))))
    }

    /// Fills the buffer with the poses of a sequence carried out, every so many steps: per frame x, y and heading of
    /// each robot. Returns how many frames there are; fewer than asked for after a collision, whose moment is the last.
    ///
    /// - `run`: `undefined` for the task's own start, otherwise the number of a start moved by `jitter` metres.
    ///
    /// # Errors
    /// A letter that no behaviour has.
    pub fn trajectory(&mut self, letters: &str, every: u32, jitter: f64, run: Option<u32>) -> Result<u32, JsError> {
        let sequence = self.sequence(letters)?;
        let (task, buffer) = (&self.task, &mut self.buffer);
        let mut state =
            run.map_or_else(|| task.start().to_vec(), |run| jittered(task, jitter.max(0.0), self.seed, run));
        let mut marks = vec![0; task.words()];
        task.mark_start(&state, &mut marks);
        let robots = task.robots();
        let every = every.max(1);
        buffer.clear();
        let mut frames = 0;
        let mut take = |state: &[f64]| {
            buffer.extend((0..robots).flat_map(|robot| [0, 1, 2].map(|part| state[part * robots + robot] as f32)));
            frames += 1;
        };
        take(&state);
        let steps = sequence.iter().flat_map(|&behaviour| std::iter::repeat_n(behaviour, task.steps() as usize));
        for (step, behaviour) in (1..).zip(steps) {
            let is_stop = task.stop() == Some(behaviour);
            let touched = !is_stop && task.step(behaviour, &mut state, &mut marks, &mut self.kernel).is_err();
            if touched || step % every == 0 {
                take(&state);
            }
            if touched {
                break;
            }
        }
        let cells = match task.goal() {
            Goal::Reach { .. } => 0,
            Goal::Cover { cells, .. } => cells.columns as usize * cells.rows as usize,
        };
        self.marks = (0..cells).map(|cell| u8::from(Cells::is_marked(&marks, cell))).collect();
        Ok(frames)
    }

    /// Where the poses stand in memory.
    #[must_use]
    pub fn trajectory_pointer(&self) -> *const f32 {
        self.buffer.as_ptr()
    }

    /// Reals of the poses.
    #[must_use]
    pub fn trajectory_length(&self) -> usize {
        self.buffer.len()
    }

    /// The cells visited at the end of the last trajectory, a byte each, row by row from the lower left.
    #[must_use]
    pub fn visited(&self) -> Vec<u8> {
        self.marks.clone()
    }

    /// Where the frontier's rows stand in memory, see [`Search::drawn`].
    #[must_use]
    pub fn frontier_pointer(&self) -> *const f32 {
        self.search.drawn().as_ptr()
    }

    /// Reals of the frontier's rows, six a row.
    #[must_use]
    pub fn frontier_length(&self) -> usize {
        self.search.drawn().len()
    }

    /// Replays a sequence from starts moved by `jitter` metres; returns how many stayed feasible, as JSON.
    ///
    /// # Errors
    /// A letter that no behaviour has.
    pub fn robustness(&self, letters: &str, jitter: f64, runs: u32) -> Result<String, JsError> {
        let sequence = self.sequence(letters)?;
        let found = robustness(&self.task, &sequence, jitter.max(0.0), runs, self.seed);
        Ok(answer(Some(json!({
            "runs": found.runs,
            "feasible": found.feasible,
            "blocked": found.blocked,
            "mean_cost": found.mean_cost,
        }))))
    }
}

impl Sequence {
    fn sequence(&self, letters: &str) -> Result<Vec<u8>, JsError> {
        self.task
            .sequence(letters)
            .map_err(|letter| JsError::new(&format!("expected letters of the library, found {letter:?}")))
    }
}
