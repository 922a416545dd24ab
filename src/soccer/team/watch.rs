//! Seeing what the trees of a team do, at no cost when nobody looks.

use crate::bt::{NodeId, Recorder, Status};
use crate::soccer::view::ROBOTS;

/// What somebody sees of a frame: a recorder for the coach tree and one for each robot's.
#[derive(Clone, Debug, Default)]
pub struct Watch<R> {
    /// The coach tree; sees nothing of other coaches.
    pub coach: R,
    /// The coach tree while it answers a call, which happens before the frame it plays next.
    pub call: R,
    /// The tree of each robot's role.
    pub roles: [R; ROBOTS],
}

/// The last status of each node in preorder; IDLE for those that were not ticked.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Statuses(Vec<Status>);

impl Statuses {
    /// The statuses in preorder, up to the last node that was ticked.
    #[must_use]
    pub fn list(&self) -> &[Status] {
        &self.0
    }
}

impl Recorder for Statuses {
    fn returned(&mut self, node: NodeId, status: Status) {
        if self.0.len() <= node.index() {
            self.0.resize(node.index() + 1, Status::Idle);
        }
        self.0[node.index()] = status;
    }
}

impl Watch<Statuses> {
    /// Forgets the last frame; to be called before the next one.
    pub fn clear(&mut self) {
        self.coach.0.clear();
        self.call.0.clear();
        self.roles.iter_mut().for_each(|statuses| statuses.0.clear());
    }
}
