//! Studies of behaviour sequencing: what is measured, in slices or at once, and what is refused.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use swarm_playground::study::{Results, Size, Study, report};

/// A study of one cell and one seed on a map without obstacles.
fn study(changes: &Value, metrics: &[&str]) -> Value {
    let mut scenario = json!({"world": "sequencing", "robots": 3, "obstacles": 0, "decisions": 4, "interval": 10,
        "start-list": [[0, 0, 0], [1, 2, 0.5], [2, -1, -0.5]], "target-x": 0, "target-y": 0, "target-radius": 10,
        "jitter-runs": 0});
    for (name, value) in changes.as_object().expect("changes are an object") {
        scenario[name] = value.clone();
    }
    json!({"study": "one", "scenario": scenario, "seeds": {"count": 1}, "metrics": metrics})
}

fn measured(changes: &Value, metrics: &[&str]) -> Vec<Option<f64>> {
    let row = Study::from_value(&study(changes, metrics), &[]).expect("it is a study").make(0);
    assert!(row.end.is_ok(), "{:?}", row.end);
    row.metrics
}

const KINDS: [&str; 4] = ["solved", "proved_infeasible", "gave_up", "has_plan"];

#[test]
fn every_end_of_a_search_is_a_metric_of_its_own() {
    // Whoever is there already has a plan of Stops alone.
    assert_eq!(measured(&json!({}), &KINDS), [1.0, 0.0, 0.0, 1.0].map(Some));
    // At 2 m/s nobody goes 500 m in 40 s, which Algorithm 1 does not look at: it comes to its budget.
    let far = json!({"map": [-600, 600, -600, 600], "target-x": 500});
    assert_eq!(measured(&far, &KINDS), [0.0, 1.0, 0.0, 0.0].map(Some));
    let mut literal = far;
    literal["method"] = json!("literal");
    literal["budget"] = json!(20);
    assert_eq!(measured(&literal, &KINDS), [0.0, 0.0, 1.0, 0.0].map(Some));
}

#[test]
fn a_plan_is_measured_without_its_stops() {
    let metrics =
        ["cost", "proven_ratio", "moving_intervals", "distinct_behaviours", "changes", "idle_stops", "flock_share"];
    // Nothing moves: no cost, and no share of nothing.
    let still = [Some(0.0), Some(1.0), Some(0.0), Some(0.0), Some(0.0), Some(0.0), None];
    assert_eq!(measured(&json!({}), &metrics), still);
    // The beginning is fixed: north, a Stop, south, and a last interval in which the cheapest is to stay.
    let fixed = json!({"prefix": "N.S", "target-radius": 40, "library": "NS.R"});
    let found = measured(&fixed, &metrics);
    assert_eq!(found[2..], [2.0, 2.0, 1.0, 1.0, 1.0].map(Some));
    let fixed = json!({"prefix": "NNR.", "target-radius": 40, "library": "NS.R"});
    let metrics = ["moving_intervals", "distinct_behaviours", "changes", "idle_stops", "flock_share", "gathers_last"];
    assert_eq!(measured(&fixed, &metrics), [3.0, 2.0, 1.0, 0.0, 2.0 / 3.0, 1.0].map(Some));
}

#[test]
fn what_no_plan_has_is_empty_and_counts_are_not() {
    let far = json!({"map": [-600, 600, -600, 600], "target-x": 500});
    let plan = ["cost", "lower_bound", "proven_ratio", "moving_intervals", "gathers_last", "robust_share"];
    assert_eq!(measured(&far, &plan), [None; 6]);
    // Ten behaviours but for Stop; from each of their ends somebody cannot arrive in time any more, so none is extended.
    let counts = ["integrations", "expanded", "frontier_peak"];
    assert_eq!(measured(&far, &counts), [0.0, 0.0, 0.0].map(Some), "the start is too far away itself");
    assert_eq!(measured(&json!({"jitter-runs": 5}), &["robust_share"]), [Some(1.0)], "who stays put stays in");
}

#[test]
fn a_search_in_slices_gives_the_row_of_one_made_at_once() {
    let changes = json!({"start-list": [[-30, -30, 0], [-28, -29, 0.5], [-31, -27, 1]], "decisions": 8});
    let metrics = ["solved", "cost", "integrations", "expanded", "frontier_peak", "moving_intervals"];
    let study = Study::from_value(&study(&changes, &metrics), &[]).expect("it is a study");
    let whole = study.make(0);
    assert_eq!(whole.metrics[0], Some(1.0));
    for slice in [1, 7, 1000] {
        let mut job = study.start(0);
        while !job.advance(slice) {}
        assert_eq!(job.row(), whole, "in slices of {slice}");
    }
    let job = study.start(0);
    assert_eq!(job.row().end, Err("the search is not over".to_owned()));
}

#[test]
fn the_report_speaks_of_plans() {
    let study = Study::from_value(&study(&json!({}), &["solved", "cost"]), &[]).expect("it is a study");
    let mut results = Results::new(study.clone());
    results.add(study.make(0));
    let text = report(&results);
    assert!(text.contains("## Solved\n") && text.contains("## Cost, metres\n"), "{text}");
    assert!(text.contains("| one | 1 | 1 | 100.0 % |") && !text.contains("delivered"), "{text}");
}

#[test]
fn metrics_and_cells_of_another_world_are_refused() {
    let error = |value: &Value| Study::from_value(value, &[]).expect_err("it is refused").to_string();
    let mixed = error(&study(&json!({}), &["solved", "share"]));
    let known = mixed.strip_prefix("metrics[1]: expected a metric of the world \"sequencing\", one of \"solved\", ");
    assert!(known.is_some_and(|known| known.ends_with(", found \"share\" of the world \"geese\"")), "{mixed}");
    let mut geese = study(&json!({}), &["cost"]);
    geese["scenario"] = json!({"world": "geese"});
    assert!(error(&geese).ends_with("found \"cost\" of the world \"sequencing\""), "{}", error(&geese));
    let misspelt = study(&json!({}), &["integration"]);
    assert_eq!(error(&misspelt), "metrics[0]: unknown name \"integration\", did you mean \"integrations\"?");
    let mut two = study(&json!({}), &["cost"]);
    two["cells"] = json!([{"name": "a"}, {"name": "b", "scenario": {"world": "geese"}}]);
    assert_eq!(error(&two), "cells[1]: expected the world \"sequencing\" of the first cell, found \"geese\"");
    let mut share = study(&json!({}), &["cost"]);
    share["figure"] = json!({"kind": "proportion", "metric": "cost"});
    let flags = "\"solved\" or \"proved_infeasible\" or \"gave_up\" or \"has_plan\" or \"gathers_last\"";
    assert_eq!(error(&share), format!("figure.metric: expected {flags}, which is 0 or 1, found \"cost\""));
}

#[test]
fn a_size_may_have_a_smaller_budget_where_something_is_planned() {
    let mut value = study(&json!({}), &["cost"]);
    value["sizes"] = json!({"glance": {"budget": 7}});
    let glance = Study::from_value(&value, &[]).expect("it is a study").sized(Size::Glance).expect("the file has one");
    assert_eq!(glance.cells[0].scenario.to_value()["budget"], 7);
    value["scenario"] = json!({"world": "geese"});
    value["metrics"] = json!(["share"]);
    let error = Study::from_value(&value, &[]).expect_err("geese plan nothing").to_string();
    assert!(error.starts_with("sizes.glance.budget: unknown field"), "{error}");
}

#[test]
fn seconds_of_the_paper_survive_writing_and_change_no_result() {
    let plain = study(&json!({}), &["cost"]);
    let mut value = plain.clone();
    value["seconds"] = json!({"machine": "a machine", "cells": {"one": 24.5}});
    let read = Study::from_value(&value, &[]).expect("it is a study");
    assert_eq!(Study::from_value(&read.to_value(), &[]).expect("it needs nothing else").seconds, read.seconds);
    assert_eq!(read.hash(), Study::from_value(&plain, &[]).expect("it is a study").hash());
    value["seconds"]["cells"] = json!({"two": 1});
    let error = Study::from_value(&value, &[]).expect_err("no such cell").to_string();
    assert_eq!(error, "seconds.cells.two: expected a cell's name such as \"one\", found \"two\"");
}
