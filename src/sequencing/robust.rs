//! How a plan fares when robots do not start exactly where it was made for.
//!
//! Trajectories over 150 s part from each other soon: neighbours change, angles wrap. A plan and its proof hold for the
//! model and its start; this says what a small change of the start does to them.

use super::dynamics::Kernel;
use super::replay::replay;
use super::tasks::Task;
use crate::random::{Purpose, Seed, direction, stream};

/// What became of a plan from changed starts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Robustness {
    /// Replays that were made.
    pub runs: u32,
    /// Of these, those without a collision that ended in the goal set.
    pub feasible: u32,
    /// Starts that were off the map or in an obstacle; they count as runs that are not feasible.
    pub blocked: u32,
    /// The mean path length of the feasible ones; 0 without any.
    pub mean_cost: f64,
}

/// Replays a sequence from starts at which each robot stands `jitter` metres away in a direction of its own.
///
/// - `sequence`: indices of the library. `jitter`: metres, at least 0.
#[must_use]
pub fn robustness(task: &Task, sequence: &[u8], jitter: f64, runs: u32, seed: Seed) -> Robustness {
    let mut kernel = Kernel::new(task.robots());
    let mut found = Robustness::default();
    for run in 0..runs {
        let start = jittered(task, jitter, seed, run);
        found.runs += 1;
        if !task.is_free(&start) {
            found.blocked += 1;
            continue;
        }
        let done = replay(task, sequence, &start, &mut kernel);
        if done.is_feasible() {
            found.feasible += 1;
            found.mean_cost += done.cost();
        }
    }
    if found.feasible > 0 {
        found.mean_cost /= f64::from(found.feasible);
    }
    found
}

/// The start of one such replay, 3 M reals.
#[must_use]
pub fn jittered(task: &Task, jitter: f64, seed: Seed, run: u32) -> Vec<f64> {
    let mut rng = stream(seed, Purpose::Jitter, run);
    let mut start = task.start().to_vec();
    let robots = task.robots();
    for robot in 0..robots {
        let [x, y] = direction(&mut rng);
        start[robot] += jitter * x;
        start[robots + robot] += jitter * y;
    }
    start
}
