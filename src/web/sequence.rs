//! Behaviour sequencing. The page drives a search in slices and draws it as it grows; trajectories and the frontier
//! cross as flat buffers of `f32` in wasm memory, of which the page makes a view after each call.

use super::{answer, error};
use crate::random::Seed;
use crate::scenario::{Scenario, WorldParams, schema};
use crate::sequencing::{
    Cells, Collision, Form, Goal, Kernel, Params, Replay, STEPS_PER_SECOND, Search, Solution, Task, Touched,
    first_interval, follow, jittered,
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
    visits: Vec<u32>,
}

/// A cell that nobody visits.
const NEVER: u32 = u32::MAX;

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
        Ok(Sequence { params, seed: scenario.seed, task, search, kernel, buffer: Vec::new(), visits: Vec::new() })
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

    /// Goes on for up to `budget` integrations; returns whether there is more to do.
    pub fn advance(&mut self, budget: u32) -> bool {
        self.search.advance(u64::from(budget)).outcome.is_none()
    }

    /// The cost of the best plan; infinite without one.
    #[must_use]
    pub fn cost(&self) -> f64 {
        self.search.best().map_or(f64::INFINITY, |plan| plan.cost)
    }

    /// Lets a search that gave up or was stopped go on with so many integrations and megabytes more.
    pub fn extend(&mut self, integrations: u32, megabytes: u32) {
        self.search.extend(u64::from(integrations), (megabytes as usize).saturating_mul(1 << 20));
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

    /// Fills the buffer with the poses of a sequence carried out, every so many steps: per frame x, y and heading of
    /// each robot; fewer than asked for after a collision, whose moment is the last. The task is the one without margins.
    ///
    /// Returns how many frames there are, the costs and visited cells of each interval, charges, whether the goal is
    /// reached, and the first collision, as JSON.
    ///
    /// - `run`: `undefined` for the task's own start, otherwise the number of a start moved by `jitter` metres.
    ///
    /// # Errors
    /// A letter that no behaviour has.
    pub fn trajectory(&mut self, letters: &str, every: u32, jitter: f64, run: Option<u32>) -> Result<String, JsError> {
        let sequence = self.sequence(letters)?;
        let (task, buffer, visits) = (&self.task, &mut self.buffer, &mut self.visits);
        let start = run.map_or_else(|| task.start().to_vec(), |run| jittered(task, jitter.max(0.0), self.seed, run));
        let robots = task.robots();
        let every = every.max(1);
        let cells = match task.goal() {
            Goal::Reach { .. } => 0,
            Goal::Cover { cells, .. } => cells.columns as usize * cells.rows as usize,
        };
        buffer.clear();
        visits.clear();
        visits.resize(cells, NEVER);
        let mut known = vec![0; task.words()];
        let (mut frames, mut last) = (0, 0);
        let mut take = |state: &[f64]| {
            buffer.extend((0..robots).flat_map(|robot| [0, 1, 2].map(|part| state[part * robots + robot] as f32)));
            frames += 1;
        };
        let done = follow(task, &sequence, &start, &mut self.kernel, |step, state, marks| {
            last = step;
            for (word, (known, &marks)) in known.iter_mut().zip(marks).enumerate() {
                let mut new = marks & !*known;
                *known = marks;
                while new != 0 {
                    if let Some(visit) = visits.get_mut(64 * word + new.trailing_zeros() as usize) {
                        *visit = step;
                    }
                    new &= new - 1;
                }
            }
            if step % every == 0 {
                take(state);
            }
        });
        if done.collision.is_some() && last % every != 0 {
            take(&done.state);
        }
        let charges = self.search.options().costs.of(&sequence, task.stop(), task.interval());
        let Replay { costs, visited, collision, goal, .. } = &done;
        let collision = collision.map(|(interval, Collision { step, robot, touched })| {
            let obstacle = match touched {
                Touched::Obstacle(at) => Some(at),
                Touched::Edge => None,
            };
            json!({ "interval": interval, "step": step, "robot": robot, "obstacle": obstacle })
        });
        Ok(answer(Some(json!({
            "frames": frames,
            "costs": costs,
            "charges": charges,
            "total": done.cost() + charges,
            "visited": visited,
            "goal": goal,
            "feasible": done.is_feasible(),
            "collision": collision,
        }))))
    }

    /// Replays a sequence from starts moved by `jitter` metres, so many from number `first` on. Returns a JSON list of
    /// whether each stayed feasible, its path length, where its first collision was, and how many frames it has in the
    /// buffer: x and y of the swarm's middle every second, one replay after the other.
    ///
    /// # Errors
    /// A letter that no behaviour has.
    pub fn fan(&mut self, letters: &str, jitter: f64, first: u32, count: u32) -> Result<String, JsError> {
        let sequence = self.sequence(letters)?;
        let (task, buffer) = (&self.task, &mut self.buffer);
        let robots = task.robots();
        buffer.clear();
        let mut found = Vec::new();
        for run in first..first.saturating_add(count) {
            let start = jittered(task, jitter.max(0.0), self.seed, run);
            let blocked = !task.is_free(&start);
            let mut frames = 0;
            let done = follow(task, &sequence, &start, &mut self.kernel, |step, state, _| {
                if step % STEPS_PER_SECOND == 0 {
                    let middle = |axis: &[f64]| (axis.iter().sum::<f64>() / robots as f64) as f32;
                    buffer.extend([middle(&state[..robots]), middle(&state[robots..2 * robots])]);
                    frames += 1;
                }
            });
            let place = |robot: u32| [done.state[robot as usize], done.state[robots + robot as usize]];
            found.push(json!({
                "feasible": !blocked && done.is_feasible(),
                "cost": done.cost(),
                "frames": frames,
                "hit": done.collision.map(|(_, Collision { robot, .. })| place(robot)),
            }));
        }
        Ok(Value::from(found).to_string())
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

    /// The step after which each cell counts as visited in the last trajectory, row by row from the lower left: 0 at the
    /// start, 4294967295 never.
    #[must_use]
    pub fn visits(&self) -> Vec<u32> {
        self.visits.clone()
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
}

impl Sequence {
    fn sequence(&self, letters: &str) -> Result<Vec<u8>, JsError> {
        self.task
            .sequence(letters)
            .map_err(|letter| JsError::new(&format!("expected letters of the library, found {letter:?}")))
    }
}
