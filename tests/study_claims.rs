//! The document on what of a paper is reproduced.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::BTreeMap;
use swarm_playground::study::{Claims, Results, Study};

/// Two cells with 16 runs each: `high` always succeeds, `low` never does.
fn results(seeds: u32) -> BTreeMap<String, Results> {
    let text = format!(
        r#"{{"study": "small", "cells": [
            {{"name": "high", "scenario": {{"world": "geese", "agents": 4}}}},
            {{"name": "low", "scenario": {{"world": "geese", "agents": 5}}}}],
          "seeds": {{"first": 1, "count": {seeds}}}, "steps": 40, "metrics": ["share", "success"]}}"#
    );
    let study = Study::read(&text, &[]).expect("a study");
    let columns = Results::new(study.clone()).header();
    let (hash, mut lines) = (study.hash(), columns.clone());
    for run in 0..study.run_count() {
        let (cell, seed) = study.job(run);
        let (name, agents) = [("high", 4), ("low", 5)][cell];
        // Shares of 0.90 to 0.93 against 0.10 to 0.13.
        let share = [0.9, 0.1][cell] + f64::from(run % 8 / 2) / 100.0;
        let success = 1 - cell;
        let line = [
            format!("{run},{name},{agents},{seed},{share},{success}"),
            format!("0.1.0,{hash:016x},0000000000000000,\n"),
        ];
        lines.push_str(&line.join(","));
    }
    let (results, whole) = Results::read(study, lines.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{columns}"));
    assert_eq!(whole, lines.len());
    BTreeMap::from([("small".to_owned(), results)])
}

fn claims(evidence: &str) -> Claims {
    let text = format!(
        r#"{{"title": "T", "about": "", "claims": [{{"id": "C1", "claim": "High beats low.", "source": "here",
            "evidence": [{evidence}]}}]}}"#
    );
    Claims::read(&text).unwrap_or_else(|error| panic!("{error}"))
}

fn verdict(evidence: &str, seeds: u32) -> String {
    let document = claims(evidence).document(&results(seeds), "claims.json").unwrap_or_else(|error| panic!("{error}"));
    let row = document.lines().rev().find(|line| line.starts_with("| paper |")).expect("the row of the evidence");
    row.split(" | ").nth(6).expect("seven columns").to_owned()
}

#[test]
fn a_contrast_is_reproduced_not_shown_or_reversed() {
    let contrast = |first: &str, second: &str, metric: &str| {
        let evidence = format!(
            r#"{{"study": "small", "profile": "paper", "metric": "{metric}", "greater": ["{first}", "{second}"]}}"#
        );
        verdict(&evidence, 16)
    };
    assert_eq!(contrast("high", "low", "success"), "reproduced");
    assert_eq!(contrast("low", "high", "success"), "reversed");
    assert_eq!(contrast("low", "high", "share"), "reversed");
    assert_eq!(contrast("high", "high", "share"), "not reproduced");
}

#[test]
fn a_value_is_reproduced_within_the_interval_of_enough_runs() {
    let value = |value: f64, seeds: u32| {
        let evidence =
            format!(r#"{{"study": "small", "profile": "paper", "metric": "success", "equals": {{"high": {value}}}}}"#);
        verdict(&evidence, seeds)
    };
    // 16 of 16: Wilson's interval is 80.6 to 100 %.
    assert_eq!(value(0.81, 16), "reproduced");
    assert_eq!(value(0.8, 16), "not reproduced");
    assert_eq!(value(0.81, 15), "open");
}

#[test]
fn a_bound_holds_with_the_whole_interval() {
    let bound = |kind: &str, value: f64| {
        let evidence =
            format!(r#"{{"study": "small", "profile": "paper", "metric": "success", "{kind}": {{"low": {value}}}}}"#);
        verdict(&evidence, 16)
    };
    // 0 of 16: 0 to 19.4 %.
    assert_eq!(bound("below", 0.2), "reproduced");
    assert_eq!(bound("below", 0.1), "open");
    assert_eq!(bound("above", 0.1), "open");
    assert_eq!(bound("above", 0.2), "not reproduced");
}

#[test]
fn a_promise_holds_when_no_run_breaks_it() {
    let promise = |most: f64, seeds: u32| {
        let evidence =
            format!(r#"{{"study": "small", "profile": "paper", "metric": "share", "never_above": {{"low": {most}}}}}"#);
        verdict(&evidence, seeds)
    };
    // Shares of 0.10 to 0.13.
    assert_eq!(promise(0.13, 16), "reproduced");
    assert_eq!(promise(0.129, 16), "not reproduced");
    assert_eq!(promise(0.13, 15), "open");
    assert_eq!(promise(0.11, 15), "not reproduced");
}

#[test]
fn a_study_without_results_is_not_run() {
    let evidence = r#"{"study": "other", "profile": "paper", "metric": "share", "above": {"x": 0.5}}"#;
    let document = claims(evidence).document(&results(16), "claims.json").expect("a document");
    assert!(document.contains("| C1: High beats low. | not run |"), "{document}");
    assert!(document.contains("| other | not run |"), "{document}");
}

#[test]
fn wrong_claims_name_their_place() {
    let error = |evidence: &str| {
        let text = format!(r#"{{"claims": [{{"id": "C1", "claim": "x", "source": "y", "evidence": [{evidence}]}}]}}"#);
        match Claims::read(&text) {
            Err(error) => error.to_string(),
            Ok(claims) => claims.document(&results(16), "claims.json").expect_err("a fault").to_string(),
        }
    };
    assert_eq!(
        error(r#"{"study": "small", "profile": "paper", "metric": "share"}"#),
        "claims[0].evidence[0]: expected one of equals, below, above, greater, never_above, alike, found 0"
    );
    assert_eq!(
        error(r#"{"study": "small", "profile": "paper", "metric": "share", "equals": {"high": "much"}}"#),
        "claims[0].evidence[0].equals.high: expected a number, found \"much\""
    );
    assert_eq!(
        error(r#"{"study": "small", "profile": "paper", "metric": "share", "equals": {"middle": 1}}"#),
        "claims[0].evidence[0]: expected a cell of study small, found \"middle\""
    );
    assert_eq!(
        error(r#"{"study": "small", "profile": "paper", "metric": "alive", "equals": {"high": 1}}"#),
        "claims[0].evidence[0].metric: expected a metric of study small, found \"alive\""
    );
}
