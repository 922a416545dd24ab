//! A document as the page draws it: the main tree with every subtree expanded.

use super::Moment;
use crate::bt::xml::{
    Direction, Document, Element, Manifest, Model, ModelPort, NodeKind, Problem, Role, builtin_nodes, reference,
};
use serde::Serialize;
use serde_json::{Value, json};

/// The answer to opening a setup.
#[derive(Clone, Debug, Serialize)]
pub struct Opened {
    /// Faults and warnings in the order in which they stand.
    pub problems: Vec<ShownProblem>,
    /// `None` when the text has a fault.
    pub tree: Option<ShownTree>,
    /// `None` without a tree that can run.
    pub moment: Option<Moment>,
}

/// A problem with its place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ShownProblem {
    /// Such as `unknown-node`.
    pub code: &'static str,
    /// From 1.
    pub line: u32,
    /// From 1, in characters.
    pub column: u32,
    /// Without the place.
    pub message: String,
    /// True when the document is accepted all the same.
    pub warning: bool,
}

impl From<&Problem> for ShownProblem {
    fn from(problem: &Problem) -> Self {
        let (line, column) = (problem.place.line, problem.place.column);
        Self { code: problem.code, line, column, message: problem.message.clone(), warning: problem.warning }
    }
}

/// A tree to draw.
#[derive(Clone, Debug, Serialize)]
pub struct ShownTree {
    /// In preorder; the index is the id.
    pub nodes: Vec<ShownNode>,
    /// The main tree's name; empty when it has none.
    pub main: String,
    /// False when it can be shown only.
    pub runnable: bool,
}

/// A node to draw.
#[derive(Clone, Debug, Serialize)]
pub struct ShownNode {
    id: u32,
    parent: Option<u32>,
    /// One past the last descendant.
    end: u32,
    /// The registered name.
    #[serde(rename = "type")]
    pub type_name: String,
    /// The instance name.
    pub name: String,
    category: &'static str,
    /// True for a leaf that answers as the script says.
    pub scripted: bool,
    ports: Vec<(String, String)>,
    conditions: Vec<(String, String)>,
    /// Output ports of a scripted leaf that name an entry.
    outputs: Vec<String>,
    line: u32,
    column: u32,
    definition: String,
}

/// The nodes of the main tree, and the names of its blackboards in the order in which the engine numbers them.
pub fn shown(document: &Document, manifest: &Manifest, runnable: bool) -> (ShownTree, Vec<String>) {
    let main = document.main_tree().and_then(|tree| tree.id.clone()).unwrap_or_default();
    let board = if main.is_empty() { "main".to_owned() } else { main.clone() };
    let mut expansion =
        Expansion { document, manifest, nodes: Vec::new(), boards: vec!["@".to_owned(), board.clone()] };
    if let Some(tree) = document.main_tree() {
        expansion.visit(&tree.root, None, &main, &board);
    }
    (ShownTree { nodes: expansion.nodes, main, runnable }, expansion.boards)
}

struct Expansion<'a> {
    document: &'a Document,
    manifest: &'a Manifest,
    nodes: Vec<ShownNode>,
    boards: Vec<String>,
}

impl<'a> Expansion<'a> {
    fn visit(&mut self, element: &'a Element, parent: Option<u32>, definition: &str, board: &str) {
        let id = self.nodes.len() as u32;
        let scripted = matches!(element.kind, NodeKind::Action | NodeKind::Condition)
            && !self.manifest.is_builtin(&element.type_name);
        let pairs = |wanted: fn(Role) -> bool| {
            let given = element.attributes.iter().filter(|attribute| wanted(attribute.role));
            given.map(|attribute| (attribute.name.clone(), attribute.value.clone())).collect()
        };
        self.nodes.push(ShownNode {
            id,
            parent,
            end: id + 1,
            type_name: element.type_name.clone(),
            name: element.name().to_owned(),
            category: category(element.kind),
            scripted,
            ports: pairs(|role| matches!(role, Role::Port | Role::AutoRemap)),
            conditions: pairs(|role| matches!(role, Role::Condition(_))),
            outputs: if scripted { self.outputs(element) } else { Vec::new() },
            line: element.place.line,
            column: element.place.column,
            definition: definition.to_owned(),
        });
        if element.kind == NodeKind::SubTree {
            let inner = format!("{board}/{}", element.name());
            self.boards.push(inner.clone());
            let tree = element.tree.as_deref().and_then(|id| self.document.tree(id));
            if let Some(tree) = tree.and_then(|index| self.document.trees.get(index)) {
                self.visit(&tree.root, Some(id), tree.id.as_deref().unwrap_or_default(), &inner);
            }
        }
        for child in &element.children {
            self.visit(child, Some(id), definition, board);
        }
        self.nodes[id as usize].end = self.nodes.len() as u32;
    }

    fn outputs(&self, element: &Element) -> Vec<String> {
        let Some(node) = self.manifest.find(&element.type_name) else { return Vec::new() };
        let written = node.ports.iter().filter(|port| port.direction != Direction::In);
        let named = written.filter(|port| {
            let given = element.port(&port.name).map(|attribute| attribute.value.as_str());
            given.or(port.default.as_deref()).is_some_and(|value| reference(value).is_some())
        });
        named.map(|port| port.name.clone()).collect()
    }
}

fn category(kind: NodeKind) -> &'static str {
    match kind {
        NodeKind::Action => "action",
        NodeKind::Condition => "condition",
        NodeKind::Control => "control",
        NodeKind::Decorator => "decorator",
        NodeKind::SubTree => "subtree",
    }
}

/// The 42 built-in nodes with their ports, as JSON.
#[must_use]
pub fn models() -> Value {
    let port = |port: &ModelPort| {
        json!({
            "name": port.name,
            "direction": match port.direction {
                Direction::In => "in",
                Direction::Out => "out",
                Direction::InOut => "inout",
            },
            "type": port.type_name,
            "default": port.default,
            "description": port.description,
        })
    };
    let nodes = builtin_nodes().into_iter().map(|node| {
        let ports: Vec<Value> = Model::of(&node).ports().map(port).collect();
        json!({"name": node.name, "category": category(node.kind), "ports": ports})
    });
    nodes.collect()
}
