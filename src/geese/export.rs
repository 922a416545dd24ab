//! An agent's program as a document of BehaviorTree.CPP, format 4.
//!
//! The text is written directly: the page's first load has no room for the general writer ([`crate::bt::xml`]), whose
//! canonical form this is.

use super::leaf::{Leaf, Name, Object, Tag, Takes};
use super::world::World;
use crate::bt::{Kind, NodeId, Tree};

/// The program that an agent ran in the last step, as [`write_xml`] writes it; `None` when there is no such agent.
#[must_use]
pub fn export_agent(world: &World, agent: u32) -> Option<String> {
    let state = world.state();
    let mind = state.minds.get(agent as usize)?;
    Some(write_xml(&mind.ran(state.tick).tree, &format!("Agent_{agent}")))
}

/// The document of one tree, in the canonical form, with a model for each leaf that it uses.
///
/// A leaf `IsCarrying Food` is `<IsCarrying name="IsCarrying_Food" item="Food"/>`, so equal leaves have one name;
/// "not" is an Inverter around it; the part that a leaf or its Inverter plays is the metadata `_tag`.
///
/// - `tree`: has no other nodes than sequences, fallbacks and leaves, like all that a grammar writes.
/// - `id`: of ASCII letters, digits and `_`, and not the name of a node.
#[must_use]
pub fn write_xml(tree: &Tree<Leaf>, id: &str) -> String {
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root BTCPP_format=\"4\"");
    text.extend([" main_tree_to_execute=\"", id, "\">\n  <BehaviorTree ID=\"", id, "\">\n"]);
    let mut used = [false; Name::ALL.len()];
    write_node(tree, NodeId(0), "    ", &mut text, &mut used);
    text.push_str("  </BehaviorTree>\n  <TreeNodesModel>\n");
    for name in Name::ALL.into_iter().filter(|name| used[*name as usize]) {
        write_model(name, &mut text);
    }
    text.push_str("  </TreeNodesModel>\n</root>\n");
    text
}

fn write_node(tree: &Tree<Leaf>, node: NodeId, indent: &str, text: &mut String, used: &mut [bool]) {
    match &tree.nodes()[node.index()].kind {
        Kind::Leaf(leaf) => {
            used[leaf.name as usize] = true;
            write_leaf(*leaf, indent, text);
        }
        kind => {
            text.extend([indent, "<", kind.name(), ">\n"]);
            let deeper = format!("{indent}  ");
            for child in tree.children(node) {
                write_node(tree, child, &deeper, text, used);
            }
            text.extend([indent, "</", kind.name(), ">\n"]);
        }
    }
}

fn write_leaf(leaf: Leaf, indent: &str, text: &mut String) {
    let (name, object) = (leaf.name.text(), leaf.object.text());
    let tag = |text: &mut String| {
        if leaf.tag != Tag::None {
            text.extend([" _tag=\"", leaf.tag.text(), "\""]);
        }
    };
    if leaf.negated {
        text.extend([indent, "<Inverter"]);
        tag(text);
        text.push_str(">\n  ");
    }
    text.extend([indent, "<", name]);
    if let (Some(port), true) = (port(leaf.name), leaf.object != Object::Nothing) {
        text.extend([" name=\"", name, "_", object, "\" ", port, "=\"", object, "\""]);
    }
    if leaf.negated {
        text.extend(["/>\n", indent, "</Inverter"]);
    } else {
        tag(text);
        text.push('/');
    }
    text.push_str(">\n");
}

/// The input port that holds the argument.
fn port(name: Name) -> Option<&'static str> {
    match name.takes() {
        Takes::Nothing => None,
        Takes::Place => Some("place"),
        Takes::Item => Some("item"),
        Takes::Object => Some("object"),
    }
}

fn write_model(name: Name, text: &mut String) {
    let kind = if name.is_action() { "Action" } else { "Condition" };
    text.extend(["    <", kind, " ID=\"", name.text()]);
    let Some(port) = port(name) else { return text.push_str("\"/>\n") };
    text.extend(["\">\n      <input_port name=\"", port, "\" type=\"std::string\""]);
    if name.takes() == Takes::Object {
        text.push_str(" default=\"\"");
    }
    text.extend(["/>\n    </", kind, ">\n"]);
}
