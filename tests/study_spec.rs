//! Study files: what is read and refused, and the order of runs.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use swarm_playground::study::{Metric, Presets, Size, Study};

const PRESETS: &Presets = &[
    ("small", r#"{"world": "geese", "agents": 8, "steps": 30}"#),
    ("crowded", r#"{"world": "geese", "agents": 12, "steps": 30}"#),
];

fn small() -> Value {
    serde_json::from_str(include_str!("cases/small_study.json")).expect("it is JSON")
}

fn with(pointer: &str, field: &str, value: Value) -> Value {
    let mut study = small();
    study.pointer_mut(pointer).expect("it is there")[field] = value;
    study
}

fn read(value: &Value) -> Study {
    Study::from_value(value, PRESETS).expect("it is a study")
}

#[test]
fn cells_come_with_every_combination_and_runs_round_robin() {
    let study = read(&small());
    let names: Vec<&str> = study.cells.iter().map(|cell| cell.name.as_str()).collect();
    let expected = [
        "a, mutation-mode bit",
        "a, mutation-mode codon",
        "b, \"quoted\", mutation-mode bit",
        "b, \"quoted\", mutation-mode codon",
    ];
    assert_eq!(names, expected);
    assert_eq!(study.factors(), ["kind", "geese.children", "geese.mutation-mode"]);
    let jobs: Vec<(usize, u64)> = (0..study.run_count()).map(|run| study.job(run)).collect();
    let rounds = (5..8).flat_map(|seed| (0..4).map(move |cell| (cell, seed)));
    assert_eq!(jobs, rounds.collect::<Vec<_>>());
    let glance = study.sized(Size::Glance).expect("the file has one");
    assert_eq!((glance.run_count(), glance.cells[0].scenario.world.steps()), (8, 10));
    assert_ne!(glance.hash(), study.hash(), "fewer steps are another study");
    assert_eq!(study.with_seeds(9).expect("valid").hash(), study.hash(), "more seeds continue the same");
    let error = study.sized(Size::Class).expect_err("the file has none").to_string();
    assert_eq!(error, "sizes.class: expected seeds and steps of this size, found no such field");
}

#[test]
fn words_tests_and_figures_leave_the_hash_alone_and_all_else_changes_it() {
    let hash = |value: &Value| read(value).hash();
    let plain = hash(&small());
    let figure = json!({"kind": "box", "metric": "share", "x": "geese.mutation-mode"});
    for (field, value) in
        [("title", json!("T")), ("figure", figure), ("paper", json!({"a, mutation-mode bit": {"share": 0.5}}))]
    {
        assert_eq!(hash(&with("", field, value)), plain, "{field}");
    }
    let changes = [
        ("", "study", json!("other")),
        ("", "metrics", json!(["share"])),
        ("", "steps", json!(31)),
        ("/seeds", "first", json!(6)),
        ("/scenario", "set", json!({"geese.agents": 9})),
        ("/cells/0", "name", json!("c")),
        ("/cells/1/labels", "kind", json!("many")),
    ];
    for (pointer, field, value) in changes {
        assert_ne!(hash(&with(pointer, field, value)), plain, "{pointer}/{field}");
    }
}

#[test]
fn a_study_survives_writing_without_its_presets() {
    let mut value = small();
    value["tests"] = json!([
        {"kind": "mann-whitney", "metric": "share", "compare": ["a, mutation-mode bit", "a, mutation-mode codon"]},
        {"kind": "one-sample-t", "metric": "share", "compare": ["a, mutation-mode bit"], "against": 0.25},
    ]);
    value["figure"] = json!({"kind": "proportion", "metric": "success", "x": "geese.mutation-mode", "group": "kind"});
    value["paper"] = json!({"a, mutation-mode codon": {"success": 0.75}});
    let study = read(&value);
    let again = Study::from_value(&study.to_value(), &[]).expect("it needs nothing else");
    assert_eq!(again.hash(), study.hash());
    assert_eq!((again.tests, again.figure, again.paper), (study.tests, study.figure, study.paper));
}

fn are_refused(cases: &[(Value, &str)]) {
    for (study, message) in cases {
        assert_eq!(Study::from_value(study, PRESETS).expect_err(message).to_string(), *message);
    }
}

#[test]
fn a_refusal_names_the_path_what_was_found_and_what_is_allowed() {
    let cases = [
        (
            json!([]),
            "expected an object with \"study\", \"title\", \"about\", \"scenario\", \"cells\", \"grid\", \"seeds\", \"steps\", \"metrics\", \"sizes\", \"tests\", \"figure\", \"paper\", \"seconds\", \"matches\", found a list",
        ),
        (with("", "metric", json!(1)), "metric: unknown field, did you mean \"metrics\"?"),
        (
            with("", "study", json!("Big Study")),
            "study: expected 1 to 60 small letters, digits and hyphens, found \"Big Study\"",
        ),
        (with("", "seeds", json!({"first": 1})), "seeds.count: expected a whole number, found no such field"),
        (with("/seeds", "count", json!(0)), "seeds.count: expected a whole number from 1 to 10000, found 0"),
        (
            with("/seeds", "first", json!(9_007_199_254_740_990_u64)),
            "seeds.first: expected a whole number from 0 to 9007199254740989, found 9007199254740990",
        ),
        (with("/scenario", "preset", json!("smal")), "scenario.preset: unknown name \"smal\", did you mean \"small\"?"),
        (
            with("/scenario", "preset", json!("large")),
            "scenario.preset: unknown name \"large\", expected one of \"small\", \"crowded\"",
        ),
        (
            with("", "scenario", json!({"world": "geese", "agents": 0})),
            "scenario.agents: expected a whole number from 1 to 10000 robots, found 0",
        ),
        (
            with("/cells/0", "nmae", json!("x")),
            "cells[0].nmae: unknown field, expected one of \"name\", \"preset\", \"scenario\", \"set\", \"labels\"",
        ),
        (
            with("/cells/0", "name", json!("x\ny")),
            "cells[0].name: expected 1 to 100 characters in one line, found \"x\\ny\"",
        ),
        (
            with("/cells/0", "name", json!("b, \"quoted\"")),
            "cells[1]: expected a name of its own, found \"b, \"quoted\", mutation-mode bit\" twice",
        ),
        (
            with("/cells/1/set", "geese.childern", json!(1)),
            "cells[1].set.geese.childern: unknown name \"geese.childern\", did you mean \"geese.children\"?",
        ),
        (
            with("/cells/1/set", "geese.children", json!(0)),
            "cells[1].set.geese.children: expected a whole number from 1 to 1000 genomes, found 0",
        ),
        (
            with("/cells/1/labels", "share", json!("x")),
            "cells[1].labels.share: expected a label that is no column of the results and has no point in it",
        ),
        (
            with("/grid", "geese.children", json!([])),
            "grid.geese.children: expected a list of 1 to 1000, found one of 0",
        ),
        (
            with("/grid", "geese.children", json!([3, "x"])),
            "grid.geese.children[1]: expected a whole number from 1 to 1000 genomes, found \"x\"",
        ),
        (
            with("/grid", "geese.codon-max", json!([200])),
            "grid.geese.codon-max[0]: expected one less than a power of two (1, 3, 7 ... 65535) while mutation flips bits, found 200",
        ),
        (
            with("/cells/1/set", "geese.arena-size", json!(60)),
            "cells[1]: site-distance: expected at most 20, so that a site of radius 10 lies inside the arena, found 30",
        ),
        (with("", "steps", json!(0)), "steps: expected a whole number from 1 to 10000000 steps, found 0"),
        (
            with("/sizes/glance", "steps", json!(0)),
            "sizes.glance.steps: expected a whole number from 1 to 4294967295, found 0",
        ),
        (with("/sizes", "huge", json!({})), "sizes.huge: unknown field, expected one of \"glance\", \"class\""),
    ];
    are_refused(&cases);
}

#[test]
fn metrics_tests_figures_and_paper_values_must_fit_the_study() {
    let cases = [
        (with("", "metrics", json!(["shre"])), "metrics[0]: unknown name \"shre\", did you mean \"share\"?"),
        (
            with("", "metrics", json!(["share", "share"])),
            "metrics[1]: expected each metric once, found \"share\" twice",
        ),
        (
            with(
                "",
                "tests",
                json!([{"kind": "proportions", "metric": "share", "compare": ["a, mutation-mode bit", "a, mutation-mode codon"]}]),
            ),
            "tests[0].metric: expected \"success\", which is 0 or 1, found \"share\"",
        ),
        (
            with("", "tests", json!([{"kind": "welch-t", "metric": "share", "compare": ["a, mutation-mode bit"]}])),
            "tests[0].compare: expected 2 of the cells, found 1",
        ),
        (
            with(
                "",
                "tests",
                json!([{"kind": "welch-t", "metric": "share", "compare": ["a, mutation-mode bit", "c"]}]),
            ),
            "tests[0].compare[1]: expected a cell's name such as \"a, mutation-mode bit\", found \"c\"",
        ),
        (
            with("", "figure", json!({"kind": "box", "metric": "steps"})),
            "figure.metric: unknown name \"steps\", expected one of \"share\", \"success\", \"steps_to_50\", \"mean_diversity\"",
        ),
        (
            with("", "figure", json!({"kind": "curve", "metric": "share", "x": "geese.mutation-mode"})),
            "figure.x: expected a factor whose values are numbers, found \"geese.mutation-mode\"",
        ),
        (
            with("", "paper", json!({"a, mutation-mode bit": {"share": "x"}})),
            "paper.a, mutation-mode bit.share: expected a number, found \"x\"",
        ),
    ];
    are_refused(&cases);
    let error = Study::read("{\"study\": }", PRESETS).expect_err("no JSON").to_string();
    assert_eq!(error, "expected a study as JSON: expected value at line 1 column 11");
}

#[test]
fn every_metric_has_its_name_and_words() {
    for (name, metric) in Metric::all() {
        assert_eq!(metric.name(), name);
        assert!(!metric.label().is_empty() && metric.help().ends_with('.'));
    }
}
