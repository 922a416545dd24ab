//! Leaves that answer as the script says.

use super::setup::Answer;
use crate::bt::{Host, HostLeaf, Kind, NodeId, Ports, Status, Tree, Value};

/// The instance names of a tree's scripted leaves, and which name each node has.
#[derive(Clone, Debug, Default)]
pub struct LeafNames {
    /// In the order of their first appearance.
    pub names: Vec<String>,
    of_node: Vec<Option<u32>>,
}

impl LeafNames {
    pub fn of(tree: &Tree<HostLeaf>) -> Self {
        let mut found = Self::default();
        for node in tree.nodes() {
            let name = match &node.kind {
                Kind::Leaf(leaf) => Some(found.find(&leaf.name).unwrap_or_else(|| {
                    found.names.push(leaf.name.clone());
                    found.names.len() - 1
                })),
                _ => None,
            };
            found.of_node.push(name.map(|name| name as u32));
        }
        found
    }

    pub fn find(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|other| other == name)
    }
}

/// The leaves of one tree during its ticks.
#[derive(Debug)]
pub struct Leaves<'a> {
    pub names: &'a LeafNames,
    /// By name.
    pub answers: &'a [Answer],
    /// For each node how often it has returned RUNNING since it started; `None` when it is not under way.
    pub progress: &'a mut [Option<u32>],
    /// The first output that could not be written: the node and why.
    pub fault: Option<(NodeId, String)>,
}

impl Host<HostLeaf> for Leaves<'_> {
    fn tick(&mut self, node: NodeId, _leaf: &HostLeaf, ports: &mut Ports) -> Status {
        let Some(answer) = self.names.of_node[node.index()].map(|name| &self.answers[name as usize]) else {
            return Status::Success;
        };
        let progress = &mut self.progress[node.index()];
        let made = progress.unwrap_or(0);
        if made < answer.running || answer.then == Status::Running {
            *progress = Some(made.saturating_add(1));
            return Status::Running;
        }
        *progress = None;
        if answer.then.is_completed() {
            for (port, value) in &answer.writes {
                if let Err(fault) = ports.set(port, Value::literal(value)) {
                    self.fault.get_or_insert((node, fault));
                }
            }
        }
        answer.then
    }

    fn halt(&mut self, node: NodeId, _leaf: &HostLeaf) {
        self.progress[node.index()] = None;
    }
}
