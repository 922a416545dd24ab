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

#[test]
fn every_case_passes() {
    for verdict in cases().run() {
        assert_eq!(verdict.fault, None, "{}", verdict.id);
    }
}
