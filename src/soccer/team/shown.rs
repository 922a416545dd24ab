//! The trees of a team as they are drawn: nodes in preorder, subtrees expanded, as the compiled tree numbers them.

use super::coach;
use super::duties::Role;
use super::roles;
use crate::bt::xml::{self, Document, Element, Manifest, NodeKind, Problem};
use serde::Serialize;

/// A node to draw.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ShownNode {
    id: u32,
    parent: Option<u32>,
    /// One past the last descendant.
    end: u32,
    /// `Sequence`, `Fallback` or `Parallel` for control nodes of these families, otherwise the registered name.
    kind: String,
    label: String,
    /// The registered name where the node has a name of its own, or is of a variant of its family.
    tag: Option<String>,
    line: u32,
    column: u32,
}

/// The coach tree of a document.
///
/// # Errors
/// What the reader of coach trees refuses.
pub fn coach_nodes(text: &str) -> Result<Vec<ShownNode>, Vec<Problem>> {
    coach::Program::read(text)?;
    let (document, _) = xml::read(text, &coach::manifest())?;
    Ok(nodes(&document, document.main))
}

/// The trees of a document of roles, with the role that each is for.
///
/// # Errors
/// What the reader of role trees refuses.
pub fn role_nodes(text: &str) -> Result<Vec<(Role, Vec<ShownNode>)>, Vec<Problem>> {
    roles::Roles::read(text)?;
    let (document, _) = xml::read(text, &roles::manifest())?;
    let tree = |role: Role| document.tree(role.tree()).map(|index| (role, nodes(&document, index)));
    Ok(Role::ALL.into_iter().filter_map(tree).collect())
}

/// Faults and warnings of a coach tree, in the order in which they stand.
#[must_use]
pub fn coach_problems(text: &str) -> Vec<Problem> {
    problems(text, &coach::manifest(), coach::Program::read(text).err())
}

/// Faults and warnings of role trees, in the order in which they stand.
#[must_use]
pub fn role_problems(text: &str) -> Vec<Problem> {
    problems(text, &roles::manifest(), roles::Roles::read(text).err())
}

fn problems(text: &str, manifest: &Manifest, refused: Option<Vec<Problem>>) -> Vec<Problem> {
    let mut all = refused.unwrap_or_default();
    if let Ok((_, warnings)) = xml::read(text, manifest) {
        all.extend(warnings);
    }
    all.sort_by_key(|problem| (problem.place.line, problem.place.column));
    all
}

fn nodes(document: &Document, tree: usize) -> Vec<ShownNode> {
    let mut nodes = Vec::new();
    if let Some(tree) = document.trees.get(tree) {
        visit(document, &tree.root, None, &mut nodes);
    }
    nodes
}

/// Adds an element and all below it. The document was compiled, so that no subtree holds itself.
fn visit(document: &Document, element: &Element, parent: Option<u32>, nodes: &mut Vec<ShownNode>) {
    let id = nodes.len() as u32;
    let type_name = element.type_name.as_str();
    let family = match type_name {
        "ReactiveSequence" | "SequenceWithMemory" | "AsyncSequence" => "Sequence",
        "ReactiveFallback" | "AsyncFallback" => "Fallback",
        "ParallelAll" => "Parallel",
        other => other,
    };
    let named = element.name() != type_name;
    let label = if named { element.name().to_owned() } else { plain(element) };
    nodes.push(ShownNode {
        id,
        parent,
        end: id + 1,
        kind: family.to_owned(),
        label,
        tag: (named || family != type_name).then(|| type_name.to_owned()).filter(|tag| *tag != element.name()),
        line: element.place.line,
        column: element.place.column,
    });
    if element.kind == NodeKind::SubTree {
        let below = element.tree.as_deref().and_then(|name| document.tree(name));
        if let Some(below) = below.and_then(|index| document.trees.get(index)) {
            visit(document, &below.root, Some(id), nodes);
        }
    }
    for child in &element.children {
        visit(document, child, Some(id), nodes);
    }
    nodes[id as usize].end = nodes.len() as u32;
}

/// What a node without a name of its own is called: scripts by their text, leaves with the values of their ports.
fn plain(element: &Element) -> String {
    match element.port("code") {
        Some(code) => code.value.clone(),
        None if element.children.is_empty() => {
            let values = element.ports().map(|port| port.value.as_str());
            std::iter::once(element.type_name.as_str()).chain(values).collect::<Vec<_>>().join(" ")
        }
        None => element.type_name.clone(),
    }
}
