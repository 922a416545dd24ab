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
    follow(task, sequence, start, kernel, |_, _, _| {})
}

/// Carries out a sequence and shows every step of it.
///
/// - `sequence`, `start`, `kernel`: as for [`replay`].
/// - `each`: told of the start as step 0 and of every step made, the one that collided included: its number, the state
///   and the marks of visited cells.
pub fn follow(
    task: &Task,
    sequence: &[u8],
    start: &[f64],
    kernel: &mut Kernel,
    mut each: impl FnMut(u32, &[f64], &[u64]),
) -> Replay {
    let mut state = start.to_vec();
    let mut marks = vec![0; task.words()];
    let mut visited = vec![task.mark_start(&state, &mut marks)];
    let mut costs = Vec::with_capacity(sequence.len());
    let mut collision = None;
    let mut made = 0;
    each(made, &state, &marks);
    'sequence: for (interval, &behaviour) in (0..).zip(sequence) {
        kernel.start();
        let stands = task.stop() == Some(behaviour); // the state stays as it is, bit for bit
        let mut new = 0;
        for step in 1..=task.steps() {
            let acted = if stands { Ok(0) } else { task.step(behaviour, &mut state, &mut marks, kernel) };
            made += 1;
            each(made, &state, &marks);
            match acted {
                Ok(more) => new += more,
                Err((robot, touched)) => {
                    collision = Some((interval, Collision { step, robot, touched }));
                    break 'sequence;
                }
            }
        }
        costs.push(kernel.lengths().iter().sum());
        visited.push(visited.last().map_or(0, |before| before + new));
    }
    let goal = task.is_goal(&state, visited.last().copied().unwrap_or(0));
    Replay { costs, visited, state, marks, collision, goal }
}

#[cfg(test)]
mod tests {
    use super::super::params::Params;
    use super::*;
    use crate::random::Seed;

    #[test]
    fn a_sequence_followed_step_by_step_is_the_one_of_whole_intervals() {
        let params = Params { robots: 4, decisions: 4, ..Params::default() };
        let seed = Seed::new(3).expect("3 is a seed");
        let (task, _) = params.tasks(seed).expect("there is room for four robots");
        let mut kernel = Kernel::new(4);
        for letters in ["NE.R", "SSSS", "AAXY"] {
            let sequence = task.sequence(letters).expect("letters of the library");
            let mut steps = Vec::new();
            let done = follow(&task, &sequence, task.start(), &mut kernel, |step, state, _| {
                assert_eq!(state.len(), 12);
                steps.push(step);
            });
            let (mut state, mut marks) = (task.start().to_vec(), Vec::new());
            let mut costs = Vec::new();
            let mut collision = None;
            for (at, &behaviour) in (0..).zip(&sequence) {
                match task.act(behaviour, &mut state, &mut marks, &mut kernel) {
                    Ok((cost, _)) => costs.push(cost),
                    Err(touch) => {
                        collision = Some((at, touch));
                        break;
                    }
                }
            }
            assert_eq!(done.state, state, "{letters}");
            assert_eq!(done.costs, costs, "{letters}");
            assert_eq!(done.collision, collision, "{letters}");
            let whole = collision.map_or(400, |(at, collision)| 100 * at + collision.step);
            assert_eq!(steps, (0..=whole).collect::<Vec<_>>(), "{letters}");
        }
    }
}
