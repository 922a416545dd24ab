//! The rules that need the whole document: names, children, ports, scripts and subtrees.

use super::document::{Attribute, Element, Role};
use super::literal::PortType;
use super::manifest::{Direction, NodeKind, NodeType};
use super::problem::{Problem, Source};
use super::read::{Draft, Known, is_literal};
use super::recursion;
use crate::bt::script::Script;
use crate::nearest::nearest;
use crate::place::Place;
use std::collections::{BTreeMap, BTreeSet};

/// Reports everything that is wrong with a draft, and what is only doubtful as warnings.
pub(super) fn check(draft: &Draft, known: &Known, source: &Source, problems: &mut Vec<Problem>) {
    let mut checker = Checker { trees: BTreeMap::new(), known, source, problems };
    checker.tree_ids(draft);
    checker.main_tree(draft);
    for tree in &draft.trees {
        let mut names = BTreeMap::new();
        for root in &tree.roots {
            checker.element(root, &mut names);
        }
    }
    recursion::check(draft, checker.problems);
}

/// The most ports that one message lists, and the most missing ports that are reported for one element.
const MOST_LISTED: usize = 20;
/// With so many problems no more near names are looked for, as that compares each name with all others.
const MOST_SUGGESTIONS: usize = 200;
/// The longest name for which, and among which, a near name is looked for.
const LONGEST_NAME: usize = 64;

struct Checker<'a> {
    /// The trees that are defined, and where.
    trees: BTreeMap<&'a str, Place>,
    known: &'a Known<'a>,
    source: &'a Source<'a>,
    problems: &'a mut Vec<Problem>,
}

impl<'a> Checker<'a> {
    fn fault(&mut self, code: &'static str, place: Place, message: impl Into<String>) {
        self.problems.push(Problem::fault(code, place, message));
    }

    fn warning(&mut self, code: &'static str, place: Place, message: impl Into<String>) {
        self.problems.push(Problem::warning(code, place, message));
    }

    fn tree_ids(&mut self, draft: &'a Draft) {
        for tree in &draft.trees {
            let Some(id) = &tree.id else {
                if draft.trees.len() > 1 {
                    let message = "expected the attribute ID in a BehaviorTree beside others, found none";
                    self.fault("tree-id", tree.place, message);
                }
                continue;
            };
            if let Some(fault) = name_fault("tree", &id.value) {
                self.fault("bad-name", id.place, fault);
            }
            if self.known.manifest.find(&id.value).is_some() {
                let message = format!("expected a tree name of its own, found {:?}, which is a node", id.value);
                self.fault("tree-id", id.place, message);
            }
            if let Some(first) = self.trees.get(id.value.as_str()) {
                let message = format!("expected each tree once, found {:?} again (first: {first})", id.value);
                self.fault("tree-id", id.place, message);
            } else {
                self.trees.insert(&id.value, id.place);
            }
        }
    }

    fn main_tree(&mut self, draft: &Draft) {
        let root = draft.root;
        match (draft.trees.len(), &draft.main) {
            (0, _) => self.fault("no-tree", root, "expected at least one BehaviorTree, found none"),
            (_, Some(main)) if draft.main_index().is_none() => {
                let near = self.near_tree(&main.value);
                self.fault("main-tree", main.place, format!("unknown main tree {:?}{near}", main.value));
            }
            (count, None) if count > 1 => {
                let message = format!("expected main_tree_to_execute to name one of {count} trees, found none");
                self.fault("main-tree", root, message);
            }
            _ => {}
        }
    }

    fn did_you_mean<'n>(&self, name: &str, candidates: impl Iterator<Item = &'n str>) -> String {
        if name.len() > LONGEST_NAME || self.problems.len() > MOST_SUGGESTIONS {
            return String::new();
        }
        let near = nearest(name, candidates.filter(|candidate| candidate.len() <= LONGEST_NAME));
        near.map_or(String::new(), |near| format!(", did you mean {near:?}?"))
    }

    fn near_tree(&self, name: &str) -> String {
        self.did_you_mean(name, self.trees.keys().copied())
    }

    fn element(&mut self, element: &'a Element, names: &mut BTreeMap<&'a str, Place>) {
        let node = self.known.find(&element.type_name);
        for attribute in &element.attributes {
            self.attribute(element, node, attribute);
        }
        if let Some(node) = node {
            if !element.is_runnable {
                let message = format!("{} is only declared in a model: it can be shown and edited, not run", node.name);
                self.warning("unknown-node", element.place, message);
            }
            self.children(element, node);
            self.missing_ports(element, node);
            self.threshold(element);
        } else if !element.type_name.is_empty() {
            self.unknown_node(element);
        } else if element.id_place != Place::default() {
            self.fault("bad-name", element.id_place, name_fault("node", "").unwrap_or_default());
        }
        if element.kind == NodeKind::SubTree {
            self.subtree(element, names);
        }
        for child in &element.children {
            self.element(child, names);
        }
    }

    fn unknown_node(&mut self, element: &Element) {
        let name = &element.type_name;
        if let (true, Some(fault)) = (element.explicit, name_fault("node", name)) {
            self.fault("bad-name", element.id_place, fault);
            return;
        }
        let message = if self.trees.contains_key(name.as_str()) {
            format!("unknown node {name:?}, did you mean <SubTree ID={name:?}/>?")
        } else {
            let models = self.known.models.values().filter(|model| model.kind != NodeKind::SubTree);
            let all = self.known.manifest.nodes().chain(models).map(|node| node.name.as_str());
            format!("unknown node {name:?}{}", self.did_you_mean(name, all))
        };
        self.fault("unknown-node", element.place, message);
    }

    fn children(&mut self, element: &Element, node: &NodeType) {
        let (count, name) = (element.children.len() as u32, &node.name);
        match node.kind {
            NodeKind::Action | NodeKind::Condition | NodeKind::SubTree => {
                for child in &element.children {
                    let message = format!("expected no child of {name}, found {}", child.type_name);
                    self.fault("leaf-child", child.place, message);
                }
            }
            NodeKind::Decorator => one_child(name, element.place, &element.children, self.problems),
            NodeKind::Control => {
                let least = if node.arity.strict { node.arity.least } else { 1 };
                let wrong = count < node.arity.least || node.arity.most.is_some_and(|most| count > most);
                if count < least {
                    let found = if count == 0 { "none".to_owned() } else { count.to_string() };
                    let noun = if least == 1 { "child" } else { "children" };
                    let message = format!("expected at least {least} {noun} of {name}, found {found}");
                    self.fault("no-child", element.place, message);
                } else if wrong {
                    let wanted = match node.arity.most {
                        Some(most) if most == node.arity.least => most.to_string(),
                        Some(most) => format!("{} to {most}", node.arity.least),
                        None => format!("at least {}", node.arity.least),
                    };
                    self.warning(
                        "children",
                        element.place,
                        format!("expected {wanted} children of {name}, found {count}"),
                    );
                }
            }
        }
    }

    fn attribute(&mut self, element: &Element, node: Option<&NodeType>, attribute: &Attribute) {
        let Attribute { name, value, .. } = attribute;
        match attribute.role {
            Role::Name => {
                if let Some(fault) = name_fault("instance", value) {
                    self.fault("bad-name", attribute.place, fault);
                }
            }
            Role::Condition(_) => self.script(attribute),
            Role::AutoRemap => {
                if !PortType::Bool.fits(value) {
                    let message = format!("expected true or false for {name}, found {value:?}");
                    self.fault("bad-value", attribute.value_place, message);
                }
            }
            Role::Port if element.kind == NodeKind::SubTree => {
                if let Some(fault) = name_fault("port", name) {
                    self.fault("bad-name", attribute.place, fault);
                }
                let model = element.tree.as_deref().and_then(|tree| self.known.models.get(tree));
                if let Some(model) = model.filter(|model| model.kind == NodeKind::SubTree) {
                    self.value(model, attribute, false);
                }
            }
            Role::Port => {
                let Some(node) = node else { return };
                if node.port(name).is_some() {
                    self.value(node, attribute, element.is_runnable);
                } else {
                    let near = self.did_you_mean(name, node.ports.iter().map(|port| port.name.as_str()));
                    let declared: Vec<&str> =
                        node.ports.iter().take(MOST_LISTED).map(|port| port.name.as_str()).collect();
                    let declared = if declared.is_empty() {
                        "no ports".to_owned()
                    } else {
                        format!("ports {}", declared.join(", "))
                    };
                    let message = format!("unknown port {name:?}, {} has {declared}{near}", node.name);
                    self.fault("unknown-port", attribute.place, message);
                }
            }
            Role::Metadata => {}
        }
    }

    /// Checks a literal; what a model says about types is only a hint, as the reference does not look at it.
    fn value(&mut self, node: &NodeType, attribute: &Attribute, registered: bool) {
        let Some(port) = node.port(&attribute.name).filter(|_| is_literal(&attribute.value)) else { return };
        if port.port_type == PortType::Script {
            self.script(attribute);
        } else if port.direction != Direction::Out && !port.port_type.fits(&attribute.value) {
            let (wanted, value) = (port.port_type.wanted(), &attribute.value);
            let message = format!("expected {wanted} for port {:?}, found {value:?}", port.name);
            let place = attribute.value_place;
            if registered {
                self.fault("bad-value", place, message);
            } else {
                self.warning("bad-value", place, message);
            }
        }
    }

    fn script(&mut self, attribute: &Attribute) {
        if attribute.value.trim().is_empty() {
            let message = format!("the script of {} is empty and does nothing", attribute.name);
            self.warning("bad-script", attribute.value_place, message);
        } else if let Err(error) = Script::parse(&attribute.value) {
            let place = self.source.inside_value(attribute.value_start, error.at);
            self.fault("bad-script", place, error.message);
        }
    }

    fn missing_ports(&mut self, element: &Element, node: &NodeType) {
        for port in node.ports.iter().filter(|port| port.mandatory && element.port(&port.name).is_none()) {
            // A model cannot say whether a leaf can do without a port.
            if element.is_runnable {
                let message = format!("expected the port {:?} of {}, found none", port.name, node.name);
                self.warning("missing-port", element.place, message);
            }
        }
    }

    fn threshold(&mut self, element: &Element) {
        let count = element.children.len();
        for name in ["success_count", "failure_count"].into_iter().filter(|_| element.type_name == "Parallel") {
            let Some(port) = element.port(name) else { continue };
            if port.value.parse::<i32>().is_ok_and(|value| value > 0 && value as usize > count) {
                let message =
                    format!("expected at most {count} for port {name:?}, the number of children, found {}", port.value);
                self.warning("threshold", port.value_place, message);
            }
        }
    }

    fn subtree(&mut self, element: &'a Element, names: &mut BTreeMap<&'a str, Place>) {
        let Some(tree) = element.tree.as_deref() else { return };
        if !self.trees.contains_key(tree) {
            let near = self.near_tree(tree);
            self.fault("unknown-subtree", element.place, format!("unknown tree {tree:?} in SubTree{near}"));
        }
        let model = self.known.models.get(tree).filter(|model| model.kind == NodeKind::SubTree);
        if let Some(model) = model.filter(|_| !element.autoremap()) {
            let missing: BTreeSet<&str> =
                model.ports.iter().filter(|port| port.mandatory).map(|port| port.name.as_str()).collect();
            for port in missing.into_iter().filter(|port| element.port(port).is_none()).take(MOST_LISTED) {
                self.fault(
                    "missing-port",
                    element.place,
                    format!("expected the port {port:?} of SubTree {tree}, found none"),
                );
            }
        }
        if let Some(given) = element.attributes.iter().find(|attribute| attribute.role == Role::Name) {
            if let Some(first) = names.get(given.value.as_str()) {
                let message =
                    format!("expected another name for this SubTree, found {:?} again (first: {first})", given.value);
                self.fault("subtree-name", element.place, message);
            } else {
                names.insert(&given.value, element.place);
            }
        }
    }
}

/// Reports a decorator or a tree that has not exactly one child.
pub(super) fn one_child(parent: &str, place: Place, children: &[Element], problems: &mut Vec<Problem>) {
    let message = match children {
        [_] => return,
        [] => format!("expected exactly 1 child of {parent}, found none"),
        [_, surplus, ..] => {
            let (count, name, place) = (children.len(), &surplus.type_name, surplus.place);
            format!("expected exactly 1 child of {parent}, found {count}: {name} in {place} is one too many")
        }
    };
    problems.push(Problem::fault("one-child", place, message));
}

/// What is wrong with a name, if anything.
///
/// - `what`: `node`, `tree`, `instance` or `port`.
///
/// Source: the reference's list of forbidden characters; names appear in paths, files and attributes.
pub(super) fn name_fault(what: &str, name: &str) -> Option<String> {
    let forbidden = |c: &char| c.is_control() || " <>&\"'/\\:*?.|".contains(*c);
    let article = if what == "instance" { "an" } else { "a" };
    if name.is_empty() {
        Some(format!("expected {article} {what} name, found an empty one"))
    } else if let Some(character) = name.chars().find(forbidden) {
        Some(format!("expected {article} {what} name without {character:?}, found {name:?}"))
    } else if what == "port" && name.starts_with(|c: char| c.is_ascii_digit()) {
        Some(format!("expected a port name that does not start with a digit, found {name:?}"))
    } else if what == "port" && is_reserved(name) {
        Some(format!("expected a port name that is not reserved, found {name:?}"))
    } else if what != "port" && what != "instance" && name == "Root" {
        Some(format!("expected a {what} name other than \"Root\", which is reserved"))
    } else {
        None
    }
}

fn is_reserved(port: &str) -> bool {
    use super::document::When;
    matches!(port, "name" | "ID" | "_autoremap") || When::ALL.iter().any(|when| when.attribute() == port)
}
