//! Ticking and halting a tree.
//!
//! The rules are those of `BehaviorTree.CPP` 4.10: a node that starts marks itself RUNNING before it ticks a
//! child; a node that completes resets its children (RUNNING ones are halted); SKIPPED is told to the parent
//! but not remembered; the root is reset after it completes, so the next tick starts afresh.

use super::{Kind, NodeId, Recorder, Status, Tree};
use std::fmt;

/// Runs the leaves of a world.
pub trait Host<L> {
    /// Ticks one leaf and returns its status, which is never IDLE.
    fn tick(&mut self, node: NodeId, leaf: &L) -> Status;

    /// Stops a leaf that had returned RUNNING; worlds without RUNNING leaves need nothing here.
    fn halt(&mut self, _node: NodeId, _leaf: &L) {}
}

/// What a tree remembers between ticks: one slot for each node.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    slots: Vec<Slot>,
    /// Raised by nodes that give the control back between children that were done at once.
    wake_up: bool,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Slot {
    status: Status,
    /// The child to continue with; 0 means the first (no node is its own child). Parallel: failures so far.
    cursor: u32,
    /// Children skipped since the node started. Parallel: successes so far.
    count: u32,
}

impl Memory {
    /// Fresh memory for `tree`: every node IDLE.
    #[must_use]
    pub fn for_tree<L>(tree: &Tree<L>) -> Self {
        let mut memory = Self::default();
        memory.fit(tree);
        memory
    }

    /// Forgets everything and takes the size of `tree`; allocates only for a larger tree than ever before.
    pub fn fit<L>(&mut self, tree: &Tree<L>) {
        self.slots.clear();
        self.slots.resize(tree.nodes().len(), Slot::default());
        self.wake_up = false;
    }

    /// The remembered status of `node`: IDLE unless it or a parent of it is RUNNING.
    #[must_use]
    pub fn status(&self, node: NodeId) -> Status {
        self.slots[node.index()].status
    }
}

/// Why a tick ended without a status.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TickError {
    /// A Parallel asks for more successes or failures than it has children: node, threshold, children.
    Threshold(NodeId, u32, u32),
}

impl fmt::Display for TickError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Threshold(node, threshold, children) => write!(
                out,
                "node {}: expected a threshold of at most {children}, the number of children, found {threshold}",
                node.0
            ),
        }
    }
}

impl std::error::Error for TickError {}

/// Makes one pass from the root and returns the root's status; SKIPPED leaves the root IDLE.
///
/// - `memory` must have been made for `tree` ([`Memory::for_tree`] or [`Memory::fit`]).
/// - `recorder` sees each node that returns.
///
/// # Errors
/// The node's place and the cause; the tree is then halted.
pub fn tick_exactly_once<L, H: Host<L>, R: Recorder>(
    tree: &Tree<L>,
    memory: &mut Memory,
    host: &mut H,
    recorder: &mut R,
) -> Result<Status, TickError> {
    debug_assert_eq!(memory.slots.len(), tree.nodes().len(), "memory of another tree");
    let mut ticking = Ticking { tree, memory, host, recorder };
    let result = ticking.tick(NodeId(0));
    match result {
        Ok(status) if status.is_completed() => ticking.slot(NodeId(0)).status = Status::Idle,
        Ok(_) => {}
        Err(_) => ticking.halt_child(NodeId(0)),
    }
    result
}

/// As [`tick_exactly_once`], and again while the root is RUNNING and a node has given the control back on purpose.
///
/// # Errors
/// As [`tick_exactly_once`].
pub fn tick_once<L, H: Host<L>, R: Recorder>(
    tree: &Tree<L>,
    memory: &mut Memory,
    host: &mut H,
    recorder: &mut R,
) -> Result<Status, TickError> {
    loop {
        let status = tick_exactly_once(tree, memory, host, recorder)?;
        if status != Status::Running || !std::mem::take(&mut memory.wake_up) {
            return Ok(status);
        }
    }
}

/// Halts the whole tree: RUNNING leaves are told, every node becomes IDLE.
pub fn halt_tree<L, H: Host<L>, R: Recorder>(tree: &Tree<L>, memory: &mut Memory, host: &mut H, recorder: &mut R) {
    Ticking { tree, memory, host, recorder }.halt_child(NodeId(0));
}

struct Ticking<'a, L, H, R> {
    tree: &'a Tree<L>,
    memory: &'a mut Memory,
    host: &'a mut H,
    recorder: &'a mut R,
}

impl<L, H: Host<L>, R: Recorder> Ticking<'_, L, H, R> {
    fn slot(&mut self, node: NodeId) -> &mut Slot {
        &mut self.memory.slots[node.index()]
    }

    fn tick(&mut self, node: NodeId) -> Result<Status, TickError> {
        let tree = self.tree;
        let kind = &tree.nodes()[node.index()].kind;
        let starts = self.slot(node).status != Status::Running;
        if starts && !matches!(kind, Kind::Leaf(_)) {
            let slot = self.slot(node);
            slot.status = Status::Running;
            slot.count = 0;
        }
        let status = match kind {
            Kind::Leaf(leaf) => self.host.tick(node, leaf),
            Kind::Sequence => self.in_order(node, Status::Failure)?,
            Kind::Fallback => self.in_order(node, Status::Success)?,
            Kind::SequenceWithMemory => self.sequence_with_memory(node)?,
            Kind::ReactiveSequence => self.reactive(node, Status::Failure)?,
            Kind::ReactiveFallback => self.reactive(node, Status::Success)?,
            Kind::Parallel { success_count, failure_count } => self.parallel(node, *success_count, *failure_count)?,
            Kind::Inverter => match self.only_child(node)? {
                Status::Success => Status::Failure,
                Status::Failure => Status::Success,
                other => other,
            },
            Kind::ForceSuccess => Self::forced(self.only_child(node)?, Status::Success),
            Kind::ForceFailure => Self::forced(self.only_child(node)?, Status::Failure),
        };
        self.slot(node).status = if status == Status::Skipped { Status::Idle } else { status };
        if R::RECORDING {
            self.recorder.returned(node, status);
        }
        Ok(status)
    }

    fn forced(status: Status, to: Status) -> Status {
        if status.is_completed() { to } else { status }
    }

    fn only_child(&mut self, node: NodeId) -> Result<Status, TickError> {
        let child = NodeId(node.0 + 1);
        let status = self.tick(child)?;
        if status.is_completed() {
            self.halt_child(child);
        }
        Ok(status)
    }

    /// Sequence (`decisive` FAILURE) and Fallback (`decisive` SUCCESS): mirror images of each other.
    fn in_order(&mut self, node: NodeId, decisive: Status) -> Result<Status, TickError> {
        let end = self.tree.nodes()[node.index()].end;
        let mut child = self.resume(node);
        while child.0 < end {
            let status = self.tick(child)?;
            match status {
                Status::Running => {
                    self.slot(node).cursor = child.0;
                    return Ok(Status::Running);
                }
                Status::Skipped => self.slot(node).count += 1,
                Status::Success | Status::Failure => {
                    if status == decisive {
                        self.slot(node).cursor = 0;
                        self.reset_children(node);
                        return Ok(decisive);
                    }
                }
                Status::Idle => debug_assert!(false, "no node returns IDLE"),
            }
            child = self.next_sibling(child);
        }
        self.slot(node).cursor = 0;
        Ok(self.end_of_list(node, decisive))
    }

    fn sequence_with_memory(&mut self, node: NodeId) -> Result<Status, TickError> {
        let end = self.tree.nodes()[node.index()].end;
        let mut child = self.resume(node);
        while child.0 < end {
            let was_idle = self.slot(child).status == Status::Idle;
            let status = self.tick(child)?;
            match status {
                Status::Running => {
                    self.slot(node).cursor = child.0;
                    return Ok(Status::Running);
                }
                Status::Failure => {
                    // The place is kept; this child and the later ones are reset, the earlier ones stay done.
                    self.slot(node).cursor = child.0;
                    let mut later = child;
                    while later.0 < end {
                        self.halt_child(later);
                        later = self.next_sibling(later);
                    }
                    return Ok(Status::Failure);
                }
                Status::Success => {
                    let next = self.next_sibling(child);
                    if was_idle && next.0 < end {
                        self.slot(node).cursor = next.0;
                        self.memory.wake_up = true;
                        return Ok(Status::Running);
                    }
                }
                Status::Skipped => self.slot(node).count += 1,
                Status::Idle => debug_assert!(false, "no node returns IDLE"),
            }
            child = self.next_sibling(child);
        }
        self.slot(node).cursor = 0;
        Ok(self.end_of_list(node, Status::Failure))
    }

    fn reactive(&mut self, node: NodeId, decisive: Status) -> Result<Status, TickError> {
        let end = self.tree.nodes()[node.index()].end;
        let mut all_skipped = true;
        let mut child = NodeId(node.0 + 1);
        while child.0 < end {
            let status = self.tick(child)?;
            all_skipped &= status == Status::Skipped;
            match status {
                Status::Running => {
                    let tree = self.tree;
                    for other in tree.children(node).filter(|&other| other != child) {
                        self.halt_child(other);
                    }
                    return Ok(Status::Running);
                }
                Status::Skipped => self.halt_child(child),
                Status::Success | Status::Failure => {
                    if status == decisive {
                        self.reset_children(node);
                        return Ok(decisive);
                    }
                }
                Status::Idle => debug_assert!(false, "no node returns IDLE"),
            }
            child = self.next_sibling(child);
        }
        self.reset_children(node);
        Ok(if all_skipped { Status::Skipped } else { Self::opposite(decisive) })
    }

    fn parallel(&mut self, node: NodeId, success_count: i32, failure_count: i32) -> Result<Status, TickError> {
        let tree = self.tree;
        let children = tree.children(node).count() as u32;
        let threshold = |count: i32| {
            let from_end = i64::from(children) + 1 + i64::from(count);
            let wanted = if count < 0 { from_end.max(0) } else { i64::from(count) } as u32;
            if wanted > children { Err(TickError::Threshold(node, wanted, children)) } else { Ok(wanted) }
        };
        let (wanted, fatal) = (threshold(success_count)?, threshold(failure_count)?);
        let mut skipped = 0;
        for child in tree.children(node) {
            if !self.slot(child).status.is_completed() {
                match self.tick(child)? {
                    Status::Success => self.slot(node).count += 1,
                    Status::Failure => self.slot(node).cursor += 1,
                    Status::Skipped => skipped += 1,
                    Status::Running => {}
                    Status::Idle => debug_assert!(false, "no node returns IDLE"),
                }
            }
            let Slot { count: successes, cursor: failures, .. } = *self.slot(node);
            let verdict = if successes >= wanted || (success_count < 0 && successes + skipped >= wanted) {
                Some(Status::Success)
            } else if children - failures < wanted || failures == fatal {
                Some(Status::Failure)
            } else {
                None
            };
            if let Some(status) = verdict {
                self.slot(node).cursor = 0;
                self.reset_children(node);
                return Ok(status);
            }
        }
        Ok(if skipped == children { Status::Skipped } else { Status::Running })
    }

    /// The child to continue with.
    fn resume(&mut self, node: NodeId) -> NodeId {
        match self.slot(node).cursor {
            0 => NodeId(node.0 + 1),
            child => NodeId(child),
        }
    }

    fn next_sibling(&self, child: NodeId) -> NodeId {
        NodeId(self.tree.nodes()[child.index()].end)
    }

    /// No child was decisive: the opposite status, or SKIPPED when every child was skipped.
    fn end_of_list(&mut self, node: NodeId, decisive: Status) -> Status {
        let tree = self.tree;
        let skipped = self.slot(node).count;
        self.reset_children(node);
        if skipped > 0 && skipped as usize == tree.children(node).count() {
            return Status::Skipped;
        }
        Self::opposite(decisive)
    }

    fn opposite(decisive: Status) -> Status {
        if decisive == Status::Success { Status::Failure } else { Status::Success }
    }

    fn reset_children(&mut self, node: NodeId) {
        let tree = self.tree;
        for child in tree.children(node) {
            self.halt_child(child);
        }
    }

    /// Halts `node` if it is RUNNING, children first, and makes it IDLE. A completed node has no live children,
    /// except that SequenceWithMemory keeps its earlier ones done after a failure.
    fn halt_child(&mut self, node: NodeId) {
        let tree = self.tree;
        let kind = &tree.nodes()[node.index()].kind;
        if self.slot(node).status == Status::Running {
            self.reset_children(node);
            match kind {
                Kind::Leaf(leaf) => self.host.halt(node, leaf),
                Kind::SequenceWithMemory => {}
                _ => self.slot(node).cursor = 0,
            }
            if R::RECORDING {
                self.recorder.halted(node);
            }
        }
        self.slot(node).status = Status::Idle;
    }
}
