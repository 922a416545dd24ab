//! One integration: a state, a behaviour, and what came of it. Slots are filled, worked off and used again.

use super::super::dynamics::Kernel;
use super::super::tasks::{Collision, Task};

/// An integration to be made or made.
#[derive(Clone, Debug)]
pub struct Slot {
    /// The node it starts from.
    pub(super) node: u32,
    pub(super) behaviour: u8,
    /// Never more than what a completion through it costs.
    pub(super) bound: f64,
    pub(super) state: Vec<f64>,
    pub(super) marks: Vec<u64>,
    pub(super) result: Result<(f64, u32), Collision>,
    kernel: Kernel,
}

impl Slot {
    pub(super) fn new(task: &Task) -> Self {
        Self {
            node: 0,
            behaviour: 0,
            bound: 0.0,
            state: vec![0.0; 3 * task.robots()],
            marks: vec![0; task.words()],
            result: Ok((0.0, 0)),
            kernel: Kernel::new(task.robots()),
        }
    }

    /// Makes the integration. Slots know nothing of each other: any thread may work off any of them, in any order.
    pub fn integrate(&mut self, task: &Task) {
        self.result = task.act(self.behaviour, &mut self.state, &mut self.marks, &mut self.kernel);
    }
}
