//! The trees of coaches and roles: the shipped files, and what is refused of a user's.

use swarm_playground::bt::xml::{Manifest, read, write};
use swarm_playground::soccer::team::Role;
use swarm_playground::soccer::team::coach::{self, Program};
use swarm_playground::soccer::team::roles::{self, MOST_NUMBERS, Roles, What};

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn shipped() -> [(&'static str, &'static str, Manifest); 4] {
    [
        ("coach", coach::BUILT_IN, coach::manifest()),
        ("coach-without-swaps", coach::WITHOUT_SWAPS, coach::manifest()),
        ("roles", roles::BUILT_IN, roles::manifest()),
        ("chase", roles::CHASE, roles::manifest()),
    ]
}

#[test]
fn every_shipped_file_is_as_it_would_be_written_again() {
    for (name, text, manifest) in shipped() {
        let (document, warnings) = read(text, &manifest).unwrap_or_else(|faults| panic!("{name}: {}", faults[0]));
        assert_eq!(warnings, [], "{name}");
        let written = write(&document, &manifest);
        let (again, _) = read(&written, &manifest).unwrap_or_else(|faults| panic!("{name}: {}", faults[0]));
        assert_eq!(again.without_places(), document.without_places(), "{name}");
        assert_eq!(written, text, "{name}");
    }
}

#[test]
fn role_tables_register_and_fit_into_a_leaf() {
    for what in What::ALL {
        assert!(what.numbers().len() <= MOST_NUMBERS, "{}", what.name());
    }
    for role in Role::ALL {
        let read = Roles::read(roles::BUILT_IN).unwrap();
        assert!(!read.tree(role).nodes().is_empty());
    }
    assert!(Roles::read(roles::CHASE).is_ok());
    assert!(Program::read(coach::BUILT_IN).is_ok());
    assert!(Program::read(coach::WITHOUT_SWAPS).is_ok());
}

fn coach_faults(old: &str, new: &str) -> Vec<String> {
    faults(coach::BUILT_IN, old, new, |text| Program::read(text).map(|_| ()))
}

fn role_faults(old: &str, new: &str) -> Vec<String> {
    faults(roles::BUILT_IN, old, new, |text| Roles::read(text).map(|_| ()))
}

fn faults(
    text: &str,
    old: &str,
    new: &str,
    read: impl Fn(&str) -> Result<(), Vec<swarm_playground::bt::xml::Problem>>,
) -> Vec<String> {
    let changed = text.replacen(old, new, 1);
    assert_ne!(changed, text, "{old} is there");
    let problems = read(&changed).expect_err("it is refused");
    problems.iter().filter(|problem| !problem.warning).map(ToString::to_string).collect()
}

#[test]
fn coach_trees_name_roles_that_exist() {
    assert_eq!(
        coach_faults("<Swap first=\"striker\"", "<Swap first=\"strker\""),
        ["line 59, column 22: unknown role \"strker\", did you mean \"striker\"?"]
    );
    assert_eq!(
        coach_faults("<Swap first=\"striker\"", "<Swap first=\"{who}\""),
        ["line 59, column 22: expected the name of a role for port \"first\", found the entry {who}"]
    );
    assert_eq!(
        coach_faults("<Swap first=\"striker\" second=\"assistant\"/>", "<Swap first=\"striker\"/>"),
        ["line 59, column 9: expected the port \"second\" of Swap to name a role, found none"]
    );
    assert_eq!(
        coach_faults("<LostBall/>", "<LostBal/>"),
        ["line 18, column 15: unknown node \"LostBal\", did you mean \"LostBall\"?"]
    );
}

#[test]
fn coach_trees_change_roles_as_the_organisation_allows() {
    assert_eq!(
        coach_faults("<Swap first=\"striker\" second=\"assistant\"/>", "<Swap first=\"striker\" second=\"fullback\"/>"),
        ["line 59, column 9: expected one of the pairs striker and assistant, fullback and wingback, goalkeeper and \
          wingback for Swap, found striker and fullback"]
    );
    assert_eq!(
        coach_faults("into=\"striker\"", "into=\"goalkeeper\""),
        ["line 53, column 13: no compatibility within a group leads from penalty_kicker to goalkeeper"]
    );
}

#[test]
fn coach_trees_have_somebody_keep_the_goal() {
    assert_eq!(
        coach_faults("<AssignStartRoles/>", "<AlwaysSuccess/>"),
        [
            "line 4, column 3: expected AssignStartRoles in the main tree or a tree below it, found none: nobody would ever \
          be made goalkeeper"
        ]
    );
    assert_eq!(
        coach_faults("<AssignStartRoles/>", "<AssignStartRoles roles=\"striker;striker;assistant\"/>"),
        [
            "line 8, column 34: expected a formation of the organisation, found striker, striker, assistant: nobody keeps \
          the goal"
        ]
    );
    assert_eq!(
        coach_faults("<AssignStartRoles/>", "<AssignStartRoles roles=\"goalkeeper;striker\"/>"),
        ["line 8, column 34: expected 3 roles with ; between them, found 2"]
    );
    assert_eq!(
        coach_faults("<AssignStartRoles/>", "<AssignStartRoles roles=\"goalkeeper;goalkeeper;striker\"/>"),
        ["line 8, column 34: expected a formation of the organisation, found goalkeeper, goalkeeper, striker"]
    );
    assert_eq!(
        coach_faults("<AssignStartRoles/>", "<AssignStartRoles roles=\"striker;goalkeeper;assistant\"/>"),
        ["line 8, column 34: expected the goalkeeper first, found striker"]
    );
    // An initializer that stands in a tree of its own is found.
    let moved = coach::BUILT_IN
        .replacen("<AssignStartRoles/>", "<SubTree ID=\"Start\" _autoremap=\"true\"/>", 1)
        .replacen("  <BehaviorTree ID=\"AttackSwapper\">", "  <BehaviorTree ID=\"Start\"><AssignStartRoles roles=\"goalkeeper; striker; assistant\"/></BehaviorTree>\n  <BehaviorTree ID=\"AttackSwapper\">", 1);
    assert!(Program::read(&moved).is_ok());
}

#[test]
fn every_role_has_a_tree_with_numbers_as_they_stand() {
    assert_eq!(
        role_faults("<BehaviorTree ID=\"Wingback\">", "<BehaviorTree ID=\"Wingbak\">"),
        ["line 4, column 3: expected a tree named \"Wingback\" for the role wingback, found \"Wingbak\""]
    );
    assert_eq!(
        role_faults("on=\"0.165\"", "on=\"{far}\""),
        ["line 7, column 45: expected a number for port \"on\", found the entry {far}"]
    );
    assert_eq!(
        role_faults("on=\"0.165\"", "on=\"far\""),
        ["line 7, column 45: expected a number for port \"on\", found \"far\""]
    );
    assert_eq!(
        role_faults("<ReturnToLine x", "<ReturnToLine z=\"1\" x"),
        ["line 8, column 23: unknown port \"z\", ReturnToLine has ports x, reach"]
    );
    assert!(role_faults("</root>", "<root>")[0].starts_with("line "), "a text that is no XML is refused");
}

#[test]
fn defaults_of_the_leaves_are_the_numbers_of_the_shipped_goalkeeper() {
    // What an editor offers first is what the built-in role uses where the leaf first appears.
    let bare =
        roles::BUILT_IN.replacen("<OffLine x=\"-0.69\" reach=\"0.20\" on=\"0.165\" off=\"0.10\"/>", "<OffLine/>", 1);
    assert_eq!(
        Roles::read(&bare).unwrap().tree(Role::Goalkeeper),
        Roles::read(roles::BUILT_IN).unwrap().tree(Role::Goalkeeper)
    );
}
