//! Ticks of trees that remember nothing: every leaf completes at once.

use super::{Kind, NodeId, Recorder, Status, Tree};

/// Makes one pass from the root of a tree whose leaves all complete at once, and returns the root's status: SUCCESS or
/// FAILURE.
///
/// When no leaf is ever RUNNING or skipped, every Sequence and Fallback starts from its first child in each tick, so there is
/// nothing to keep between ticks: the statuses are those of [`super::tick_once`], found without a [`super::Memory`], whose
/// reading and resetting would take most of the time.
///
/// - `act`: runs a leaf; true is SUCCESS, false FAILURE.
/// - `recorder` sees each node that returns.
///
/// # Errors
/// A node that was reached and is not of these kinds: leaves, the plain and the reactive Sequence and Fallback, Inverter,
/// `ForceSuccess`, `ForceFailure`.
pub fn tick_instant<L, R: Recorder>(
    tree: &Tree<L>,
    act: impl FnMut(&L) -> bool,
    recorder: &mut R,
) -> Result<Status, NodeId> {
    let mut pass = Pass { tree, act, recorder, refused: None };
    let success = pass.tick(NodeId(0));
    pass.refused.map_or(Ok(Status::completed(success)), Err)
}

struct Pass<'a, L, A, R> {
    tree: &'a Tree<L>,
    act: A,
    recorder: &'a mut R,
    /// The first node that needs a memory.
    refused: Option<NodeId>,
}

impl<L, A: FnMut(&L) -> bool, R: Recorder> Pass<'_, L, A, R> {
    fn tick(&mut self, node: NodeId) -> bool {
        let tree = self.tree;
        let child = NodeId(node.0 + 1);
        let success = match &tree.nodes()[node.index()].kind {
            Kind::Leaf(leaf) => (self.act)(leaf),
            Kind::Sequence | Kind::ReactiveSequence => tree.children(node).all(|child| self.tick(child)),
            Kind::Fallback | Kind::ReactiveFallback => tree.children(node).any(|child| self.tick(child)),
            Kind::Inverter => !self.tick(child),
            Kind::ForceSuccess => {
                self.tick(child);
                true
            }
            Kind::ForceFailure => {
                self.tick(child);
                false
            }
            Kind::SequenceWithMemory | Kind::Builtin(_) => {
                self.refused.get_or_insert(node);
                false
            }
        };
        if R::RECORDING {
            self.recorder.returned(node, Status::completed(success));
        }
        success
    }
}
