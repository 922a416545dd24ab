//! What a coach tree must be besides well-formed: it names roles that exist, changes them as the organisation allows, and
//! always has somebody keep the goal.

use super::leaf::Leaf;
use crate::bt::xml::{Attribute, Document, Element, NodeKind, Problem, reference};
use crate::bt::{Extra, HostLeaf, Source, Value};
use crate::nearest::nearest;
use crate::place::Place;
use crate::soccer::team::conditions::Condition;
use crate::soccer::team::duties::{Pair, Role};
use crate::soccer::team::organisation::{Checker, Scope, Violation};
use crate::soccer::view::ROBOTS;
use std::collections::BTreeSet;

/// Checks a document that the reader accepted.
///
/// # Errors
/// Every fault with its place.
pub(super) fn check(document: &Document) -> Result<(), Vec<Problem>> {
    let mut problems = Vec::new();
    document.each(&mut |element| check_element(element, &mut problems));
    if !starts(document) {
        let place = document.main_tree().map_or(Place { line: 1, column: 1 }, |tree| tree.place);
        let message = "expected AssignStartRoles in the main tree or a tree below it, found none: nobody would ever be \
                       made goalkeeper";
        problems.push(fault("no-goalkeeper", place, message.to_owned()));
    }
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

fn fault(code: &'static str, place: Place, message: String) -> Problem {
    Problem { code, place, message, warning: false }
}

/// Whether the main tree, subtrees included, gives out the roles of a start.
fn starts(document: &Document) -> bool {
    let mut open: Vec<usize> = vec![document.main];
    let mut known: BTreeSet<usize> = open.iter().copied().collect();
    while let Some(index) = open.pop() {
        let Some(tree) = document.trees.get(index) else { continue };
        let mut found = false;
        tree.root.each(&mut |element| {
            found |= element.type_name == "AssignStartRoles";
            if element.kind == NodeKind::SubTree
                && let Some(next) = element.tree.as_deref().and_then(|id| document.tree(id))
                && known.insert(next)
            {
                open.push(next);
            }
        });
        if found {
            return true;
        }
    }
    false
}

fn check_element(element: &Element, problems: &mut Vec<Problem>) {
    match element.type_name.as_str() {
        name @ ("ShouldSwap" | "Swap") => {
            let [first, second] = ["first", "second"].map(|port| role(element, port, problems));
            if let (Some(first), Some(second)) = (first, second)
                && Pair::of(first, second).is_none()
            {
                let pairs = Pair::ALL.map(|pair| pair.roles().map(Role::text).join(" and "));
                let (first, second, pairs) = (first.text(), second.text(), pairs.join(", "));
                let message = format!("expected one of the pairs {pairs} for {name}, found {first} and {second}");
                problems.push(fault("no-pair", element.place, message));
            }
        }
        "Become" => {
            let [from, to] = ["role", "into"].map(|port| role(element, port, problems));
            if let (Some(from), Some(to)) = (from, to)
                && !Checker::built_in().allows(from, to, Scope::IntraGroup)
            {
                let (from, to) = (from.text(), to.text());
                let message = format!("no compatibility within a group leads from {from} to {to}");
                problems.push(fault("no-link", element.place, message));
            }
        }
        "AssignStartRoles" => {
            if let Some(given) = element.port("roles") {
                check_start(given, problems);
            }
        }
        _ => {}
    }
}

/// The role that a port names.
fn role(element: &Element, port: &str, problems: &mut Vec<Problem>) -> Option<Role> {
    let Some(given) = element.port(port) else {
        let message = format!("expected the port {port:?} of {} to name a role, found none", element.type_name);
        problems.push(fault("missing-port", element.place, message));
        return None;
    };
    named(&given.value, given, problems)
}

fn named(name: &str, given: &Attribute, problems: &mut Vec<Problem>) -> Option<Role> {
    let found = Role::from_text(name);
    if found.is_none() {
        let message = if reference(name).is_some() {
            format!("expected the name of a role for port {:?}, found the entry {name}", given.name)
        } else {
            let near = nearest(name, Role::ALL.into_iter().map(Role::text));
            let near = near.map_or(String::new(), |near| format!(", did you mean {near:?}?"));
            format!("unknown role {name:?}{near}")
        };
        problems.push(fault("unknown-role", given.value_place, message));
    }
    found
}

fn check_start(given: &Attribute, problems: &mut Vec<Problem>) {
    let before = problems.len();
    let roles: Vec<Role> = given.value.split(';').filter_map(|name| named(name.trim(), given, problems)).collect();
    if problems.len() > before {
        return;
    }
    let Ok(roles) = <[Role; ROBOTS]>::try_from(roles.as_slice()) else {
        let message = format!("expected {ROBOTS} roles with ; between them, found {}", roles.len());
        problems.push(fault("bad-value", given.value_place, message));
        return;
    };
    if let Err(violation) = Checker::built_in().formation(roles) {
        let code = match violation {
            Violation::NoFormation { roles } if !roles.iter().any(|role| role.keeps_goal()) => "no-goalkeeper",
            _ => "no-formation",
        };
        problems.push(fault(code, given.value_place, violation.to_string()));
    } else if !roles[0].keeps_goal() {
        let message = format!("expected the goalkeeper first, found {}", roles[0].text());
        problems.push(fault("bad-value", given.value_place, message));
    }
}

/// The leaf of a node that was checked.
pub(super) fn leaf(leaf: &HostLeaf, extra: Option<&Extra>) -> Leaf {
    let text = |port: &str| {
        let given = extra.and_then(|extra| extra.ports.iter().find(|(name, _)| name == port));
        match given {
            Some((_, Source::Literal(Value::Text(text)))) => text.as_str(),
            _ => "",
        }
    };
    let role = |port: &str| Role::from_text(text(port)).unwrap_or(Role::Goalkeeper);
    let pair = || Pair::of(role("first"), role("second")).unwrap_or(Pair::StrikerAssistant);
    match leaf.type_name.as_str() {
        "RefereeEventPending" => Leaf::RefereeEventPending,
        "AssignStartRoles" => {
            let roles: Vec<Role> = text("roles").split(';').filter_map(|name| Role::from_text(name.trim())).collect();
            Leaf::AssignStartRoles(<[Role; ROBOTS]>::try_from(roles.as_slice()).ok())
        }
        "LostBall" => Leaf::Holds(Condition::LostBall),
        "WonBall" => Leaf::Holds(Condition::WonBall),
        "TwoStrikersOver" => Leaf::Holds(Condition::TwoStrikersOver),
        "KickOver" => Leaf::Holds(Condition::KickOver),
        "PenaltyOver" => Leaf::Holds(Condition::PenaltyOver),
        "ShouldSwap" => Leaf::ShouldSwap(pair()),
        "Swap" => Leaf::Swap(pair()),
        "ChangeGroup" => Leaf::ChangeGroup,
        "Become" => Leaf::Become(role("role"), role("into")),
        _ => Leaf::ConsumeEvent,
    }
}
