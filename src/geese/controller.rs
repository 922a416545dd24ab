//! What runs an agent: a behaviour tree, or a state machine.

use super::leaf::Leaf;
use super::machine::Machine;
use super::mind::Trace;
use super::program::{placeholder, program_id, program_text};
use crate::bt::Tree;

/// The one or the other, by what the grammar writes.
#[derive(Clone, Debug)]
pub enum Controller {
    /// A behaviour tree (GEESE-BT, BeTr-GEESE).
    Tree(Planted),
    /// A state machine (GEESE); apart, so that the trees of a crowd lie closer together.
    Machine(Box<Machine>),
}

/// A tree with the trace of its nodes. Its leaves complete at once, so there is nothing else to remember.
#[derive(Clone, Debug)]
pub struct Planted {
    /// The tree.
    pub tree: Tree<Leaf>,
    /// One trace for each node.
    pub trace: Vec<Trace>,
}

impl Default for Controller {
    /// A tree that does nothing, to be overwritten.
    fn default() -> Self {
        Self::from(placeholder())
    }
}

impl From<Tree<Leaf>> for Controller {
    fn from(tree: Tree<Leaf>) -> Self {
        Self::Tree(Planted { tree, trace: Vec::new() })
    }
}

impl Controller {
    /// The tree, to be overwritten; a machine becomes one first.
    pub fn tree_mut(&mut self) -> &mut Tree<Leaf> {
        if let Self::Machine(_) = self {
            *self = Self::default();
        }
        match self {
            Self::Tree(planted) => &mut planted.tree,
            Self::Machine(_) => unreachable!("it was just made a tree"),
        }
    }

    /// The machine, to be overwritten; a tree becomes one first.
    pub fn machine_mut(&mut self) -> &mut Machine {
        if let Self::Tree(_) = self {
            *self = Self::Machine(Box::default());
        }
        match self {
            Self::Machine(machine) => machine,
            Self::Tree(_) => unreachable!("it was just made a machine"),
        }
    }

    /// The tree, if it is one.
    #[must_use]
    pub fn tree(&self) -> Option<&Tree<Leaf>> {
        match self {
            Self::Tree(planted) => Some(&planted.tree),
            Self::Machine(_) => None,
        }
    }

    /// Fits the trace to what was just built.
    pub fn renew(&mut self) {
        match self {
            Self::Tree(Planted { tree, trace }) => {
                trace.clear();
                trace.resize(tree.nodes().len(), Trace::default());
            }
            Self::Machine(machine) => machine.restart(),
        }
    }

    /// A number that equal controllers share and different ones, for all practical purposes, do not.
    #[must_use]
    pub fn id(&self) -> u64 {
        match self {
            Self::Tree(planted) => program_id(&planted.tree),
            Self::Machine(machine) => machine.id(),
        }
    }

    /// The program as one line.
    #[must_use]
    pub fn text(&self) -> String {
        match self {
            Self::Tree(planted) => program_text(&planted.tree),
            Self::Machine(machine) => machine.to_string(),
        }
    }

    /// About how many bytes a copy takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        match self {
            Self::Tree(planted) => planted.trace.len() * 64,
            Self::Machine(machine) => machine.rules.len() * 64 + (machine.states.len() + machine.tests.len()) * 8,
        }
    }
}
