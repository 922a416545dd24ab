//! The swarm model and the planner against values that two independent programs agree on.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use swarm_playground::sequencing::Cases;

fn cases() -> Cases {
    Cases::read(include_str!("cases/sequencing.json")).expect("the file is valid")
}

#[test]
fn every_case_of_the_model_passes() {
    let verdicts = cases().run_model();
    assert_eq!(verdicts.len(), 4 + 18);
    for verdict in verdicts {
        assert_eq!(verdict.fault, None, "{}", verdict.id);
    }
    assert_eq!(cases().skipped().len(), 5);
}

/// Some minutes in WebAssembly, where the cases of the model and the golden fingerprints of searches stand for it.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn every_case_passes() {
    for verdict in cases().run() {
        assert_eq!(verdict.fault, None, "{}", verdict.id);
    }
}

#[test]
fn a_wrong_file_is_refused_with_its_place() {
    let refused = |text: &str| Cases::read(text).expect_err("it is refused");
    assert_eq!(refused("{"), "EOF while parsing an object at line 1 column 1");
    assert_eq!(
        refused("{\"conventions\": {},\n \"controls\": 3}"),
        "invalid type: integer `3`, expected a sequence at line 2 column 14"
    );
}

#[test]
fn a_wrong_value_is_found() {
    let text = include_str!("cases/sequencing.json");
    let changed = text.replacen("1.8706702971321882", "1.8706703971321882", 1);
    assert_ne!(changed, text);
    let verdicts = Cases::read(&changed).expect("the file is valid").run_model();
    let faults: Vec<String> = verdicts.into_iter().filter_map(|verdict| verdict.fault).collect();
    assert_eq!(faults.len(), 1);
    assert!(
        faults[0].contains("expected 1.87067039713218") && faults[0].contains("found 1.87067029713218"),
        "{faults:?}"
    );
}
