//! The tree as a flat arena: nodes in preorder, so a node's index is the id that is shown and saved.

use super::blackboard::Boards;
use super::builtin::{Builtin, Extra, Scripts};
use std::fmt;
use std::sync::Arc;

/// A node's place in preorder; the root is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

impl NodeId {
    /// The place as an index into [`Tree::nodes`].
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The number of a built-in node with ports among those of its tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltinId(u32);

/// What a node does with its children, or the leaf that the host runs.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind<L> {
    /// Ticks children in order from the one that was RUNNING; fails with the first that fails.
    Sequence,
    /// A Sequence that keeps its place after a failure and after a halt.
    SequenceWithMemory,
    /// A Sequence that starts from the first child in every tick.
    ReactiveSequence,
    /// Ticks children in order from the one that was RUNNING; succeeds with the first that succeeds (a selector).
    Fallback,
    /// A Fallback that starts from the first child in every tick.
    ReactiveFallback,
    /// Exchanges SUCCESS and FAILURE.
    Inverter,
    /// Any completion becomes SUCCESS.
    ForceSuccess,
    /// Any completion becomes FAILURE.
    ForceFailure,
    /// Any other built-in node, by its number ([`Builder::builtin`]): nodes stay small, which crowds of trees feel.
    Builtin(BuiltinId),
    /// A condition or an action of the world.
    Leaf(L),
}

/// One node of the arena.
#[derive(Clone, Debug, PartialEq)]
pub struct Node<L> {
    /// What it does.
    pub kind: Kind<L>,
    /// One past its last descendant: where its next sibling would stand.
    pub end: u32,
}

/// A well-formed tree: at least one node, every kind with the number of children it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree<L> {
    nodes: Vec<Node<L>>,
    /// One past the last node that has scripts, so that the ticks of a tree without any look at no node's extras.
    scripts_end: u32,
    /// What only some trees have; shared by copies.
    rest: Option<Arc<Rest>>,
}

/// What a tree has besides its nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Rest {
    builtins: Vec<Builtin>,
    /// What nodes have besides their kind, up to the last node that has anything.
    extras: Vec<Option<Extra>>,
    boards: Option<Boards>,
}

impl Rest {
    /// What a node has besides its kind.
    pub fn extra(&self, node: NodeId) -> Option<&Extra> {
        self.extras.get(node.index())?.as_ref()
    }

    fn is_empty(&self) -> bool {
        self.builtins.is_empty() && self.extras.is_empty() && self.boards.is_none()
    }
}

/// The name in `BehaviorTree.CPP` and how many children a kind takes: least and most (`None`: no bound).
///
/// - `builtins`: those of the tree.
fn describe<L>(kind: &Kind<L>, builtins: &[Builtin]) -> (&'static str, (usize, Option<usize>)) {
    let (many, one) = ((1, None), (1, Some(1)));
    match kind {
        Kind::Sequence => ("Sequence", many),
        Kind::SequenceWithMemory => ("SequenceWithMemory", many),
        Kind::ReactiveSequence => ("ReactiveSequence", many),
        Kind::Fallback => ("Fallback", many),
        Kind::ReactiveFallback => ("ReactiveFallback", many),
        Kind::Inverter => ("Inverter", one),
        Kind::ForceSuccess => ("ForceSuccess", one),
        Kind::ForceFailure => ("ForceFailure", one),
        Kind::Leaf(_) => ("Leaf", (0, Some(0))),
        Kind::Builtin(id) => {
            builtins.get(id.0 as usize).map_or(("", many), |builtin| (builtin.name(), builtin.arity()))
        }
    }
}

impl<L> Tree<L> {
    /// All nodes in preorder; the root is first.
    #[must_use]
    pub fn nodes(&self) -> &[Node<L>] {
        &self.nodes
    }

    /// The registered name of a node's kind in `BehaviorTree.CPP`; `Leaf` for leaves, whose names belong to the world.
    #[must_use]
    pub fn kind_name(&self, node: NodeId) -> &'static str {
        let kind = &self.nodes[node.index()].kind;
        let builtins = self.rest.as_ref().map_or(&[][..], |rest| &rest.builtins);
        describe(kind, builtins).0
    }

    /// A built-in node with its ports; `None` for one of another tree.
    #[inline]
    pub(super) fn builtin(&self, id: BuiltinId) -> Option<&Builtin> {
        self.rest.as_ref()?.builtins.get(id.0 as usize)
    }

    /// Name, conditions and ports of a node, if it was given any.
    #[must_use]
    #[inline]
    pub fn extra(&self, node: NodeId) -> Option<&Extra> {
        self.rest.as_ref()?.extra(node)
    }

    /// The scripts around a node's tick.
    #[inline]
    pub(super) fn scripts(&self, node: NodeId) -> Option<&Scripts> {
        if node.0 >= self.scripts_end {
            return None;
        }
        self.extra(node).and_then(|extra| extra.scripts.as_deref())
    }

    /// What the tree has besides its nodes.
    #[inline]
    pub(super) fn rest(&self) -> Option<&Rest> {
        self.rest.as_deref()
    }

    /// The blackboards; `None` for a tree that uses none.
    #[must_use]
    pub fn boards(&self) -> Option<&Boards> {
        self.rest.as_ref()?.boards.as_ref()
    }

    /// The same tree with other leaves, so that a world can look at names and ports once instead of in every tick.
    ///
    /// - `leaf`: makes the new leaf from the old one and from what its node has besides.
    #[must_use]
    pub fn map_leaves<M>(self, mut leaf: impl FnMut(L, Option<&Extra>) -> M) -> Tree<M> {
        let Self { nodes, scripts_end, rest } = self;
        let nodes = nodes.into_iter().enumerate().map(|(index, node)| {
            let kind = match node.kind {
                Kind::Sequence => Kind::Sequence,
                Kind::SequenceWithMemory => Kind::SequenceWithMemory,
                Kind::ReactiveSequence => Kind::ReactiveSequence,
                Kind::Fallback => Kind::Fallback,
                Kind::ReactiveFallback => Kind::ReactiveFallback,
                Kind::Inverter => Kind::Inverter,
                Kind::ForceSuccess => Kind::ForceSuccess,
                Kind::ForceFailure => Kind::ForceFailure,
                Kind::Builtin(id) => Kind::Builtin(id),
                Kind::Leaf(old) => {
                    Kind::Leaf(leaf(old, rest.as_ref().and_then(|rest| rest.extra(NodeId(index as u32)))))
                }
            };
            Node { kind, end: node.end }
        });
        Tree { nodes: nodes.collect(), scripts_end, rest }
    }

    /// The ids of the children of `node`, left to right.
    #[must_use]
    pub fn children(&self, node: NodeId) -> Children<'_, L> {
        Children { nodes: &self.nodes, next: node.0 + 1, end: self.nodes[node.index()].end }
    }

    /// The parent of each node; `None` for the root.
    #[must_use]
    pub fn parents(&self) -> Vec<Option<NodeId>> {
        let mut parents = vec![None; self.nodes.len()];
        for id in (0..self.nodes.len() as u32).map(NodeId) {
            for child in self.children(id) {
                parents[child.index()] = Some(id);
            }
        }
        parents
    }
}

/// The children of a node, left to right.
#[derive(Clone, Debug)]
pub struct Children<'a, L> {
    nodes: &'a [Node<L>],
    next: u32,
    end: u32,
}

impl<L> Iterator for Children<'_, L> {
    type Item = NodeId;

    fn next(&mut self) -> Option<NodeId> {
        (self.next < self.end).then(|| {
            let child = NodeId(self.next);
            self.next = self.nodes[child.index()].end;
            child
        })
    }
}

/// Why a builder's nodes are no tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BuildError {
    /// No node was given.
    Empty,
    /// A second root begins at this node.
    SecondRoot(NodeId),
    /// `close` was called more or fewer times than `open`.
    Unbalanced,
    /// The node, its kind's name with what it takes, and how many children it has.
    Children(NodeId, (&'static str, &'static str), usize),
}

impl fmt::Display for BuildError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(out, "expected a tree of at least one node, found none"),
            Self::SecondRoot(node) => write!(out, "expected one root, found a second one at node {}", node.0),
            Self::Unbalanced => write!(out, "expected as many closed nodes as opened ones"),
            Self::Children(node, kind, found) => {
                write!(out, "node {}: expected {} for {}, found {found}", node.0, kind.1, kind.0)
            }
        }
    }
}

impl std::error::Error for BuildError {}

/// Builds a tree in preorder: `open` a node, add what belongs inside it, `close` it.
///
/// Holds its memory for the next tree: [`Builder::finish_into`] allocates nothing once it has seen trees as large.
#[derive(Clone, Debug)]
pub struct Builder<L> {
    nodes: Vec<Node<L>>,
    scripts_end: u32,
    rest: Rest,
    open: Vec<NodeId>,
    /// The first fault; later calls are ignored.
    fault: Option<BuildError>,
}

impl<L> Default for Builder<L> {
    fn default() -> Self {
        Self { nodes: Vec::new(), scripts_end: 0, rest: Rest::default(), open: Vec::new(), fault: None }
    }
}

impl<L> Builder<L> {
    /// Begins a node whose children follow.
    pub fn open(&mut self, kind: Kind<L>) {
        let id = NodeId(self.nodes.len() as u32);
        if id.0 > 0 && self.open.is_empty() && self.fault.is_none() {
            self.fault = Some(BuildError::SecondRoot(id));
        }
        self.nodes.push(Node { kind, end: id.0 + 1 });
        self.open.push(id);
    }

    /// Gives the node opened last a name, conditions or ports.
    pub fn extra(&mut self, extra: Extra) {
        if let Some(id) = self.open.last() {
            if extra.scripts.is_some() {
                self.scripts_end = self.scripts_end.max(id.0 + 1);
            }
            self.rest.extras.resize_with(id.index(), || None);
            self.rest.extras.push(Some(extra));
        }
    }

    /// Keeps a built-in node with its ports; returns the kind of a node that is one, for [`Builder::open`].
    pub fn builtin(&mut self, builtin: Builtin) -> Kind<L> {
        let id = BuiltinId(self.rest.builtins.len() as u32);
        self.rest.builtins.push(builtin);
        Kind::Builtin(id)
    }

    /// The blackboards of the tree being built; asking for them makes them.
    pub fn boards(&mut self) -> &mut Boards {
        self.rest.boards.get_or_insert_default()
    }

    /// Adds a leaf.
    pub fn leaf(&mut self, leaf: L) {
        self.open(Kind::Leaf(leaf));
        self.close();
    }

    /// Ends the node opened last.
    pub fn close(&mut self) {
        let end = self.nodes.len() as u32;
        let Some(id) = self.open.pop() else {
            self.fault = self.fault.take().or(Some(BuildError::Unbalanced));
            return;
        };
        self.nodes[id.index()].end = end;
        let (name, (least, most)) = describe(&self.nodes[id.index()].kind, &self.rest.builtins);
        let found = Children { nodes: &self.nodes, next: id.0 + 1, end }.count();
        if (found < least || most.is_some_and(|most| found > most)) && self.fault.is_none() {
            let takes = match (least, most) {
                (_, Some(0)) => "no child",
                (_, Some(_)) => "exactly 1 child",
                (2, None) => "at least 2 children",
                (_, None) => "at least 1 child",
            };
            self.fault = Some(BuildError::Children(id, (name, takes), found));
        }
    }

    /// Returns the tree and starts afresh.
    ///
    /// # Errors
    /// The first fault: no node, a second root, unbalanced nodes, a wrong number of children.
    pub fn finish(&mut self) -> Result<Tree<L>, BuildError> {
        let mut tree = Tree { nodes: Vec::new(), scripts_end: 0, rest: None };
        self.finish_into(&mut tree)?;
        Ok(tree)
    }

    /// As [`Builder::finish`], into a tree whose memory is used again; on an error `tree` stays as it was.
    ///
    /// # Errors
    /// As [`Builder::finish`].
    pub fn finish_into(&mut self, tree: &mut Tree<L>) -> Result<(), BuildError> {
        let fault = match (self.fault.take(), self.nodes.is_empty(), self.open.is_empty()) {
            (Some(fault), ..) => Some(fault),
            (None, true, _) => Some(BuildError::Empty),
            (None, _, false) => Some(BuildError::Unbalanced),
            (None, false, true) => None,
        };
        if fault.is_none() {
            std::mem::swap(&mut tree.nodes, &mut self.nodes);
            tree.scripts_end = self.scripts_end;
            tree.rest = (!self.rest.is_empty()).then(|| Arc::new(std::mem::take(&mut self.rest)));
        }
        self.scripts_end = 0;
        if !self.rest.is_empty() {
            self.rest = Rest::default();
        }
        self.nodes.clear();
        self.open.clear();
        fault.map_or(Ok(()), Err)
    }
}
