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
