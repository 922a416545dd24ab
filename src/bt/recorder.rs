//! Seeing what a tick did, at no cost when nobody looks.

use super::{NodeId, Status};

/// Told of every node that returned or was halted, in the order in which it happened.
///
/// The engine asks `RECORDING` before each call, so a recorder that says false is compiled away.
pub trait Recorder {
    /// Whether the calls below are made at all.
    const RECORDING: bool = true;

    /// `node` was ticked and returned `status` (never IDLE).
    fn returned(&mut self, node: NodeId, status: Status);

    /// `node` was halted while RUNNING.
    fn halted(&mut self, _node: NodeId) {}
}

/// The recorder of headless runs: sees nothing, costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Recorder for Silent {
    const RECORDING: bool = false;

    fn returned(&mut self, _node: NodeId, _status: Status) {}
}

/// Every return in order: for tests and for showing one tick.
impl Recorder for Vec<(NodeId, Status)> {
    fn returned(&mut self, node: NodeId, status: Status) {
        self.push((node, status));
    }
}
