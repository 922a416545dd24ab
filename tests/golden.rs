//! Golden fingerprints: the same states natively, under Node and in browsers. The browser tests read the same file.
//!
//! A change of any value here is a change of every result that was ever published with this engine: explain it in the
//! commit, name it in the CHANGELOG and raise the minor version.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::Value;
use swarm_playground::scenario::{Run, Scenario};

fn preset(name: &str) -> &'static str {
    match name {
        "foraging" => include_str!("../scenarios/foraging.json"),
        "foraging-paper" => include_str!("../scenarios/foraging-paper.json"),
        "geese" => include_str!("../scenarios/geese.json"),
        "geese-nest" => include_str!("../scenarios/geese-nest.json"),
        "hand-machine" => include_str!("../scenarios/hand-machine.json"),
        "hand-tree" => include_str!("../scenarios/hand-tree.json"),
        "geese-bt" => include_str!("../scenarios/geese-bt.json"),
        "nest" => include_str!("../scenarios/nest.json"),
        "published" => include_str!("../scenarios/published.json"),
        "published-nest" => include_str!("../scenarios/published-nest.json"),
        "obstacles" => include_str!("../scenarios/obstacles.json"),
        other => panic!("no preset {other}"),
    }
}

#[test]
fn every_golden_fingerprint_is_reached() {
    let golden: Value = serde_json::from_str(include_str!("cases/golden.json")).expect("the file is JSON");
    let cases = golden["cases"].as_array().expect("the file has cases");
    assert!(cases.len() >= 6);
    for case in cases {
        let name = case["scenario"].as_str().expect("a case has a scenario");
        let scenario = Scenario::read(preset(name)).expect("presets are valid");
        let scenario = scenario.with("seed", &case["seed"]).expect("golden seeds are valid");
        let mut run = Run::new(scenario).expect("presets build");
        let tick = case["tick"].as_u64().expect("a case has a tick") as u32;
        assert_eq!(run.advance(tick), tick);
        assert_eq!(
            format!("{:016x}", run.fingerprint()),
            case["fingerprint"].as_str().expect("and a fingerprint"),
            "{case}"
        );
    }
}
