//! A sequence of behaviours carried out from a start.

use super::dynamics::Kernel;
use super::tasks::{Collision, Task};

/// What came of a sequence.
#[derive(Clone, Debug)]
pub struct Replay {
    /// Metres gone by all robots together, per interval that was carried out to its end.
    pub costs: Vec<f64>,
    /// Visited cells at the start and after each of these intervals; zeros without a grid.
    pub visited: Vec<u32>,
    /// The last state, 3 M reals.
    pub state: Vec<f64>,
    /// The last marks of visited cells.
    pub marks: Vec<u64>,
    /// The interval that was cut short, from 0, and why.
    pub collision: Option<(u32, Collision)>,
    /// Whether the last state is in the goal set.
    pub goal: bool,
}

impl Replay {
    /// Whether the sequence was carried out to its end and did what was asked.
    #[must_use]
    pub fn is_feasible(&self) -> bool {
        self.collision.is_none() && self.goal
    }

    /// The path length, eq. (17).
    #[must_use]
    pub fn cost(&self) -> f64 {
        self.costs.iter().sum()
    }
}

/// Carries out a sequence, with the step that the search takes.
///
/// - `sequence`: indices of the library. `start`: 3 M reals; the task's own or others.
#[must_use]
pub fn replay(task: &Task, sequence: &[u8], start: &[f64], kernel: &mut Kernel) -> Replay {
    let mut state = start.to_vec();
    let mut marks = vec![0; task.words()];
    let mut visited = vec![task.mark_start(&state, &mut marks)];
    let mut costs = Vec::with_capacity(sequence.len());
    let mut collision = None;
    for (at, &behaviour) in sequence.iter().enumerate() {
        match task.act(behaviour, &mut state, &mut marks, kernel) {
            Ok((cost, new)) => {
                costs.push(cost);
                visited.push(visited[at] + new);
            }
            Err(touch) => {
                collision = Some((at as u32, touch));
                break;
            }
        }
    }
    let goal = task.is_goal(&state, visited.last().copied().unwrap_or(0));
    Replay { costs, visited, state, marks, collision, goal }
}
