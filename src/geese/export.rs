//! An agent's program as a document: a tree as one of BehaviorTree.CPP, format 4, a state machine as a grammar of one
//! sentence.
//!
//! The text is written directly: the page's first load has no room for the general writer ([`crate::bt::xml`]), whose
//! canonical form this is.

use super::controller::Controller;
use super::inspect::Query;
use super::leaf::{Leaf, Manner, Name, Object, Tag, Takes};
use super::machine::Machine;
use super::world::World;
use crate::bt::{Kind, NodeId, Tree};

/// The program that an agent ran in the last step, as [`write_xml`] or [`write_rules`] writes it; `None` when there is no
/// such agent.
#[must_use]
pub fn export_agent(world: &World, agent: u32) -> Option<String> {
    let state = world.state();
    state.minds.get(agent as usize)?;
    Some(match &state.ran(agent).controller {
        Controller::Tree(planted) => write_xml(&planted.tree, &format!("Agent_{agent}")),
        Controller::Machine(machine) => write_rules(machine),
    })
}

/// A machine as a grammar whose only sentence it is, a line for each rule: as the grammar of a scenario it gives every
/// agent this machine.
#[must_use]
pub fn write_rules(machine: &Machine) -> String {
    let names: Vec<String> = (1..=machine.rules.len()).map(|number| format!("<rule{number}>")).collect();
    let rules = names.iter().zip(&machine.rules);
    let rules: Vec<String> = rules.map(|(name, rule)| format!("{name} ::= {}\n", machine.rule_text(rule))).collect();
    format!("<S> ::= {}\n{}", names.join(" "), rules.concat())
}

/// The program that a query asks for, as [`export_agent`] writes it: the agent's, or the one of that id. `None` when there
/// is no such agent or nobody runs such a program.
#[must_use]
pub fn export_query(world: &World, query: &Query) -> Option<String> {
    let state = world.state();
    let holds = |id: u64| (0..state.minds.len() as u32).find(|&agent| state.ran(agent).id == id);
    let agent = match (query.agent, &query.program) {
        (Some(agent), _) => agent,
        (None, Some(program)) => holds(u64::from_str_radix(program, 16).ok()?)?,
        (None, None) => return None,
    };
    export_agent(world, agent)
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
    let nodes = element(tree, NodeId(0), "    ");
    let mut models = String::new();
    for name in Name::ALL {
        if tree.nodes().iter().any(|node| matches!(&node.kind, Kind::Leaf(leaf) if leaf.name == name)) {
            let is_plain = |leaf: &Leaf| leaf.name == name && leaf.manner == Manner::Normal;
            let plain = tree.nodes().iter().any(|node| matches!(&node.kind, Kind::Leaf(leaf) if is_plain(leaf)));
            models.push_str(&model(name, plain));
        }
    }
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root BTCPP_format=\"4\" main_tree_to_execute=\"{id}\">\n  \
         <BehaviorTree ID=\"{id}\">\n{nodes}  </BehaviorTree>\n  \
         <TreeNodesModel>\n{models}  </TreeNodesModel>\n</root>\n"
    )
}

fn element(tree: &Tree<Leaf>, node: NodeId, indent: &str) -> String {
    if let Kind::Leaf(leaf) = &tree.nodes()[node.index()].kind {
        return leaf_element(*leaf, indent);
    }
    let (deeper, mut children) = (format!("{indent}  "), String::new());
    for child in tree.children(node) {
        children.push_str(&element(tree, child, &deeper));
    }
    format!("{indent}<{0}>\n{children}{indent}</{0}>\n", tree.kind_name(node))
}

fn leaf_element(leaf: Leaf, indent: &str) -> String {
    let (name, object, port) = (leaf.name.text(), leaf.object.text(), port(leaf.name));
    let tag = if leaf.tag == Tag::None { String::new() } else { format!(" _tag=\"{}\"", leaf.tag.text()) };
    let how = if leaf.manner == Manner::Normal { "_Normal" } else { "" };
    let argument = match leaf.object {
        Object::Nothing => String::new(),
        _ => format!(" name=\"{name}_{object}{how}\" {port}=\"{object}\""),
    };
    let argument = match (leaf.manner, leaf.object) {
        (Manner::Avoid, _) => argument,
        (Manner::Normal, Object::Nothing) => format!(" name=\"{name}{how}\" manner=\"Normal\""),
        (Manner::Normal, _) => format!("{argument} manner=\"Normal\""),
    };
    if leaf.negated {
        format!("{indent}<Inverter{tag}>\n{indent}  <{name}{argument}/>\n{indent}</Inverter>\n")
    } else {
        format!("{indent}<{name}{argument}{tag}/>\n")
    }
}

/// The input port that holds the argument; empty when there is none.
fn port(name: Name) -> &'static str {
    match name.takes() {
        Takes::Nothing => "",
        Takes::Place => "place",
        Takes::Item => "item",
        Takes::Object => "object",
    }
}

/// - `plain`: whether a leaf of that name moves without looking; its model then has a port for the manner.
fn model(name: Name, plain: bool) -> String {
    let (id, port) = (name.text(), port(name));
    let kind = if name.is_action() { "Action" } else { "Condition" };
    let default = if name.takes() == Takes::Object { " default=\"\"" } else { "" };
    let mut ports = String::new();
    if !port.is_empty() {
        ports = format!("      <input_port name=\"{port}\" type=\"std::string\"{default}/>\n");
    }
    if plain {
        ports.push_str("      <input_port name=\"manner\" type=\"std::string\" default=\"\"/>\n");
    }
    if ports.is_empty() {
        return format!("    <{kind} ID=\"{id}\"/>\n");
    }
    format!("    <{kind} ID=\"{id}\">\n{ports}    </{kind}>\n")
}
