//! Sequences that were simulated: their states in flat storage.

use super::super::costs::Past;

/// A simulated sequence.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// What it costs so far.
    pub cost: f64,
    /// The lower bound on what is still to pay.
    pub rest: f64,
    /// The node it extends; its own number at the root.
    pub parent: u32,
    /// Visited cells.
    pub visited: u32,
    /// Behaviours in it.
    pub depth: u16,
    /// The last one.
    pub behaviour: u8,
    /// What later charges depend on.
    pub past: Past,
}

/// All nodes: 24 M bytes of state each, marks of cells where there is a grid, and the above.
#[derive(Clone, Debug)]
pub struct Nodes {
    all: Vec<Node>,
    states: Vec<f64>,
    marks: Vec<u64>,
    reals: usize,
    words: usize,
}

impl Nodes {
    /// None yet.
    ///
    /// - `reals`: of one state. `words`: of the marks of one state.
    #[must_use]
    pub fn new(reals: usize, words: usize) -> Self {
        Self { all: Vec::new(), states: Vec::new(), marks: Vec::new(), reals, words }
    }

    /// Stores a node; returns its number.
    pub fn push(&mut self, node: Node, state: &[f64], marks: &[u64]) -> u32 {
        self.all.push(node);
        self.states.extend_from_slice(state);
        self.marks.extend_from_slice(marks);
        self.all.len() as u32 - 1
    }

    /// A node.
    #[must_use]
    pub fn get(&self, node: u32) -> &Node {
        &self.all[node as usize]
    }

    /// Its state.
    #[must_use]
    pub fn state(&self, node: u32) -> &[f64] {
        &self.states[node as usize * self.reals..][..self.reals]
    }

    /// Its marks of visited cells.
    #[must_use]
    pub fn marks(&self, node: u32) -> &[u64] {
        &self.marks[node as usize * self.words..][..self.words]
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Bytes taken by one.
    #[must_use]
    pub fn bytes_each(&self) -> usize {
        8 * (self.reals + self.words) + size_of::<Node>()
    }

    /// Appends the behaviours from the root to a node.
    pub fn sequence(&self, node: u32, sequence: &mut Vec<u8>) {
        let from = sequence.len();
        let mut at = self.get(node);
        let mut number = node;
        while at.parent != number {
            sequence.push(at.behaviour);
            number = at.parent;
            at = self.get(number);
        }
        sequence[from..].reverse();
    }
}
