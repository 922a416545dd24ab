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

/// Carries out a sequence step by step; returns the interval that was cut short, from 0, and why.
///
/// - `sequence`: indices of the library. `start`: 3 M reals; the task's own or others.
/// - `each`: told of the start as step 0 and of every step made, the one that collided included: its number, the state
///   and the marks of visited cells.
pub fn follow(
    task: &Task,
    sequence: &[u8],
    start: &[f64],
    kernel: &mut Kernel,
    mut each: impl FnMut(u32, &[f64], &[u64]),
) -> Option<(u32, Collision)> {
    let mut state = start.to_vec();
    let mut marks = vec![0; task.words()];
    task.mark_start(&state, &mut marks);
    each(0, &state, &marks);
    let mut made = 0;
    for (interval, &behaviour) in (0..).zip(sequence) {
        for step in 1..=task.steps() {
            made += 1;
            let stands = task.stop() == Some(behaviour); // the state stays as it is, bit for bit
            let acted = if stands { Ok(0) } else { task.step(behaviour, &mut state, &mut marks, kernel) };
            each(made, &state, &marks);
            if let Err((robot, touched)) = acted {
                return Some((interval, Collision { step, robot, touched }));
            }
        }
    }
    None
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

#[cfg(test)]
mod tests {
    use super::super::params::Params;
    use super::*;
    use crate::random::Seed;

    #[test]
    fn followed_step_by_step_a_sequence_ends_where_its_replay_ends() {
        let params = Params { robots: 4, decisions: 4, ..Params::default() };
        let seed = Seed::new(3).expect("3 is a seed");
        let (task, _) = params.tasks(seed).expect("there is room for four robots");
        let mut kernel = Kernel::new(4);
        for letters in ["NE.R", "SSSS", "AAXY"] {
            let sequence = task.sequence(letters).expect("letters of the library");
            let (mut last, mut steps) = (Vec::new(), 0);
            let cut = follow(&task, &sequence, task.start(), &mut kernel, |step, state, _| {
                last.clear();
                last.extend_from_slice(state);
                steps = step;
            });
            let done = replay(&task, &sequence, task.start(), &mut kernel);
            assert_eq!(cut, done.collision, "{letters}");
            assert_eq!(last, done.state, "{letters}");
            let whole = cut.map_or(400, |(interval, collision)| 100 * interval + collision.step);
            assert_eq!(steps, whole, "{letters}");
        }
    }
}
