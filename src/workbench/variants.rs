//! One tree in several forms, to see side by side what the kind of a control node changes.

use crate::bt::xml::{Document, Element, Manifest, NodeKind, Place, Problem, read, write};
use serde::Serialize;
use std::collections::BTreeSet;

/// Kinds that take the same children and differ in what they remember.
const FAMILIES: [&[&str]; 2] =
    [&["Sequence", "ReactiveSequence", "SequenceWithMemory"], &["Fallback", "ReactiveFallback", "AsyncFallback"]];

/// One form of a tree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Variant {
    /// The kind that stands at the place.
    #[serde(rename = "type")]
    pub type_name: &'static str,
    /// The document with that kind there.
    pub xml: String,
}

/// The document in each form of the sequence or fallback at `place`; empty when none stands there.
///
/// - `place`: of the element's `<`, as [`read`] reports it.
#[must_use]
pub fn variants(xml: &str, place: Place) -> Vec<Variant> {
    let manifest = Manifest::default();
    let Ok((document, _)) = read(xml, &manifest) else { return Vec::new() };
    let mut found = None;
    document.each(&mut |element| {
        if element.place == place {
            found = Some(element.type_name.clone());
        }
    });
    let Some(found) = found else { return Vec::new() };
    let family = FAMILIES.iter().find(|family| family.contains(&found.as_str()) || is_async(&found, family));
    let exchanged = family.into_iter().flat_map(|family| family.iter()).map(|&type_name| {
        let mut document = document.clone();
        for tree in &mut document.trees {
            exchange(&mut tree.root, place, type_name);
        }
        Variant { type_name, xml: write(&document, &manifest) }
    });
    exchanged.collect()
}

/// `AsyncSequence` is of the sequences although it is not shown beside them.
fn is_async(type_name: &str, family: &[&str]) -> bool {
    type_name.strip_prefix("Async").is_some_and(|rest| family.contains(&rest))
}

fn exchange(element: &mut Element, place: Place, type_name: &str) {
    if element.place == place {
        type_name.clone_into(&mut element.type_name);
    }
    for child in &mut element.children {
        exchange(child, place, type_name);
    }
}

/// The canonical form of a document, with models of all its custom nodes.
///
/// # Errors
/// The faults of the text.
pub fn format(xml: &str) -> Result<String, Vec<Problem>> {
    let (document, manifest, _) = understand(xml)?;
    Ok(write(&document, &manifest))
}

/// Reads a document in which the leaves that its models declare can run; the last part are warnings.
pub fn understand(xml: &str) -> Result<(Document, Manifest, Vec<Problem>), Vec<Problem>> {
    let is_note = |problem: &Problem| problem.warning && problem.code == "unknown-node";
    let mut manifest = Manifest::default();
    let (document, mut warnings) = read(xml, &manifest).map_err(|mut problems| {
        problems.retain(|problem| !is_note(problem));
        problems
    })?;
    for model in &document.models {
        let node = model.node_type();
        // Names that cannot be registered (controls, subtrees, a name twice) stay as the document has them.
        let _ = manifest.register(&model.id, node.kind, node.ports);
    }
    // Such leaves answer as the script says: nothing to warn of.
    let mut scripted = BTreeSet::new();
    document.each(&mut |element| {
        if matches!(element.kind, NodeKind::Action | NodeKind::Condition) {
            scripted.insert(element.place);
        }
    });
    warnings.retain(|warning| !(is_note(warning) && scripted.contains(&warning.place)));
    Ok((document, manifest, warnings))
}
