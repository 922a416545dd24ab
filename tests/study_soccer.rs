//! Studies of robot soccer: what is measured of a match, pairs of matches with the sides exchanged, and the tables.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use std::collections::BTreeMap;
use swarm_playground::scenario::{Run, Scenario};
use swarm_playground::study::{Claims, Report, Results, Row, Size, Study, figure, report};

/// Two cells of eight seeds that differ in the sides alone, with the paper's matches.
fn exchanged() -> Value {
    json!({
        "study": "pairs", "title": "Pairs", "scenario": {"world": "soccer", "half-seconds": 1},
        "cells": [{"name": "one", "labels": {"match": "one"}}],
        "grid": {"soccer.sides-exchanged": [false, true]},
        "seeds": {"count": 8}, "metrics": ["goals_blue", "goals_yellow", "goal_difference"],
        "figure": {"kind": "histogram", "metric": "goal_difference", "group": "match"},
        "matches": {"source": "the paper", "wins": 87, "ties": 106, "losses": 57, "goals": [193, 140], "most": [5, 3],
            "deviations": [0.955, 0.7526], "difference": [0.212, 1.1794]},
    })
}

/// A change of a study, and what is said of it.
type Case<'a> = (&'a dyn Fn(&mut Value), &'a str);

fn study(value: &Value) -> Study {
    Study::from_value(value, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// In every seed blue wins 2:1 with the sides as they are; exchanged it is 1:1, but 0:3 in the last seed.
fn results() -> Results {
    let study = study(&exchanged());
    let mut results = Results::new(study.clone());
    for run in 0..study.run_count() {
        let (cell, seed) = study.job(run);
        let [blue, yellow] = match (cell, seed) {
            (0, _) => [2.0, 1.0],
            (_, 8) => [0.0, 3.0],
            _ => [1.0, 1.0],
        };
        results.add(Row { run, metrics: [blue, yellow, blue - yellow].map(Some).to_vec(), end: Ok(u64::from(run)) });
    }
    results
}

#[test]
fn every_metric_is_what_the_match_says() {
    let scenario = json!({"world": "soccer", "half-seconds": 15, "yellow": "chase"});
    let metrics: Vec<&str> = [
        "goals_blue",
        "goals_yellow",
        "goal_difference",
        "goals",
        "win",
        "tie",
        "loss",
        "possession_blue",
        "shots_blue",
        "shots_yellow",
        "swaps_blue",
        "swaps_yellow",
        "group_changes_blue",
        "group_changes_yellow",
        "kick_offs",
        "free_balls",
        "goal_kicks",
        "penalties_blue",
        "penalties_yellow",
        "violations_blue",
        "violations_yellow",
        "forced_placements",
        "faults",
    ]
    .to_vec();
    let value = json!({"study": "one", "scenario": scenario, "seeds": {"first": 4, "count": 1}, "metrics": metrics});
    let row = study(&value).make(0);
    let mut whole = scenario;
    whole["seed"] = json!(4);
    let mut run = Run::new(Scenario::from_value(&whole).expect("valid")).expect("it builds");
    run.advance(u32::MAX);
    assert_eq!(row.end, Ok(run.fingerprint()));
    let world = run.soccer().expect("a match");
    let outcome = world.outcome();
    let of = |name: &str| row.metrics[metrics.iter().position(|metric| *metric == name).expect("measured")];
    let [blue, yellow] = outcome.goals.map(f64::from);
    for (name, expected) in [("goals_blue", blue), ("goals_yellow", yellow), ("goal_difference", blue - yellow)] {
        assert_eq!(of(name), Some(expected), "{name}");
    }
    assert_eq!(of("goals"), Some(blue + yellow));
    let expected = [blue > yellow, (blue - yellow).abs() < 0.5, blue < yellow].map(|is| Some(f64::from(u8::from(is))));
    assert_eq!(["win", "tie", "loss"].map(of), expected);
    assert_eq!(of("possession_blue"), Some(outcome.blue.possession));
    for (name, count) in [
        ("shots_blue", outcome.blue.shots),
        ("shots_yellow", outcome.yellow.shots),
        ("swaps_blue", outcome.blue.swaps),
        ("swaps_yellow", 0),
        ("group_changes_blue", outcome.blue.group_changes),
        ("kick_offs", outcome.blue.calls[0] + outcome.yellow.calls[0]),
        ("free_balls", outcome.blue.calls[1] + outcome.yellow.calls[1]),
        ("goal_kicks", outcome.blue.calls[2] + outcome.yellow.calls[2]),
        ("penalties_blue", outcome.blue.calls[3]),
        ("penalties_yellow", outcome.yellow.calls[3]),
        ("violations_blue", 0),
        ("violations_yellow", 0),
        ("forced_placements", world.state().game().statistics().forced),
        ("faults", 0),
    ] {
        assert_eq!(of(name), Some(f64::from(count)), "{name}");
    }
}

#[test]
fn two_rows_of_one_seed_with_the_sides_exchanged_are_a_pair() {
    // The same teams on both sides: what blue has on one side, yellow has on the other, so the pair is even.
    let value = json!({"study": "even", "scenario": {"world": "soccer", "half-seconds": 10, "blue": "chase", "yellow": "chase"},
        "grid": {"soccer.sides-exchanged": [false, true]}, "seeds": {"first": 3, "count": 1},
        "metrics": ["goals_blue", "goals_yellow", "shots_blue", "shots_yellow"]});
    let study = study(&value);
    let [plain, turned] = [study.make(0).metrics, study.make(1).metrics];
    assert_eq!([plain[0], plain[1]], [turned[1], turned[0]]);
    assert_eq!([plain[2], plain[3]], [turned[3], turned[2]]);
    let mut results = Results::new(study.clone());
    (0..2).for_each(|run| results.add(study.make(run)));
    assert!(report(&results).contains("| even | pairs of a seed | 1 | 0.0000 |"), "{}", report(&results));
    // Two cells with the same sides are one pairing, but their matches are no pairs.
    let mut twice = exchanged();
    twice["cells"] = json!([{"name": "a", "labels": {"match": "x"}}, {"name": "b", "labels": {"match": "x"}}]);
    twice.as_object_mut().expect("an object").remove("grid");
    let study = self::study(&twice);
    let mut results = Results::new(study.clone());
    (0..2).for_each(|run| results.add(study.make(run)));
    let text = report(&results);
    assert!(text.contains("| a | games | 2 |") && !text.contains("| pairs of a seed |"), "{text}");
}

#[test]
fn tables_count_both_sides_together_and_stand_beside_the_papers() {
    let text = report(&results());
    let lines = [
        // 8 wins, 7 ties and a loss in 16 games.
        "| one | 16 | 8 | 7 | 1 | 50.00 % (28.00 % to 72.00 %) |",
        "| the paper | 250 | 87 | 106 | 57 | 34.80 % | 42.40 % | 22.80 % |",
        "| one beside the paper |  |  |  |  | reproduced (+15.2 points) | reproduced (+1.4 points) |",
        // Blue: 8 x 2 + 7 x 1 + 0 = 23 goals; yellow 8 + 7 + 3 = 18; 5 / 16 = 0.3125.
        "| one | blue: tree | 23 | 2 | 1.438 (",
        "| one | yellow: machine | 18 | 3 | 1.125 (",
        "| the paper | blue | 193 | 5 | 0.7720 | 0.9550 | 0.2120 | 1.1794 |",
        "| the paper | yellow | 140 | 3 | 0.5600 | 0.7526 | -0.2120 | 1.1794 |",
        // Squares 8 x 1 + 9 = 17, less 16 x 0.3125^2 = 1.5625: sd = sqrt(15.4375 / 15) = 1.0145; t = 0.3125 / (1.0145 / 4).
        "| one | games | 16 | 0.3125 | 1.0145 | -0.228 to 0.853 | 1.232 | 15 |",
        // Seven pairs of 1/2 and one of (1 - 3) / 2 = -1: mean 2.5 / 8, sd = sqrt((7 / 4 + 1 - 8 x 0.3125^2) / 7) = 0.5303.
        "| one | pairs of a seed | 8 | 0.3125 | 0.5303 |",
        "| 8 | 7 | 0.07031 |",
        "| the paper | games | 250 | 0.2120 | 1.1794 | 0.065 to 0.359 | 2.842 | 249 | 0.00243 | 0.00485 | 0.18 (",
        "| 144 | 87 | 0.01537 |",
    ];
    for line in lines {
        assert!(text.contains(line), "no \"{line}\" in\n{text}");
    }
    let names: Vec<&str> = Report::of(&results()).sections.iter().map(|section| section.name).collect();
    assert_eq!(names[..3], ["matches-ends", "matches-goals", "matches-difference"]);
}

#[test]
fn a_histogram_of_whole_numbers_has_a_step_for_each() {
    let drawn = figure(&results()).expect("there are values");
    assert_eq!(drawn.matches("class=\"thin").count(), 16, "both cells are one colour");
    // Differences of -3 to 1: five steps of two points each.
    let path = drawn.split("class=\"mark c0\" d=\"").nth(1).expect("the steps").split('"').next().expect("their end");
    assert_eq!(path.matches(['M', 'L']).count(), 10, "{path}");
}

#[test]
fn a_claim_may_name_all_cells_of_a_label_or_ask_that_two_are_alike() {
    let all = BTreeMap::from([("pairs".to_owned(), results())]);
    let document = |evidence: &str| {
        let text = format!(
            r#"{{"claims": [{{"id": "S", "claim": "x", "source": "y", "evidence": [{{"study": "pairs", "profile": "all",
                "metric": "goals_blue", {evidence}}}]}}]}}"#
        );
        Claims::read(&text)
            .and_then(|claims| claims.document(&all, "claims.json"))
            .unwrap_or_else(|error| error.to_string())
    };
    let pooled = document(r#""above": {"one": 1}"#);
    assert!(
        pooled.contains("| all | one: goals of blue | above 1 | 1.438 |") && pooled.contains("| 16 | "),
        "{pooled}"
    );
    let cells = r#"["one, sides-exchanged false", "one, sides-exchanged true"]"#;
    let few = document(&format!(r#""alike": {cells}, "within": 2"#));
    assert!(few.contains("| means within 2 | 2 against 0.875 |") && few.contains("| 8, 8 | open |"), "{few}");
    let same = document(r#""alike": ["one", "one"], "within": 0.25"#);
    assert!(same.contains("| p = 1.0000 | 16, 16 | reproduced |"), "{same}");
    let unlike = document(r#""alike": ["one", "one"], "within": -1"#);
    assert_eq!(unlike, "claims[0].evidence[0].within: expected a number of at least 0, found -1");
    let lost = document(r#""above": {"one": 1}, "within": 1"#);
    assert_eq!(lost, "claims[0].evidence[0].within: expected no such field: it says how near means are that are alike");
}

#[test]
fn sizes_of_matches_may_have_shorter_halves() {
    let mut value = exchanged();
    value["scenario"]["half-seconds"] = json!(300);
    value["sizes"] = json!({"glance": {"seeds": 1, "half-seconds": 5}});
    let glance = study(&value).sized(Size::Glance).expect("the file has one");
    assert_eq!((glance.run_count(), glance.cells[0].scenario.world.steps()), (2, 600));
}

#[test]
fn a_study_survives_writing_and_what_does_not_fit_is_refused_with_its_place() {
    let read = study(&exchanged());
    let again = Study::from_value(&read.to_value(), &[]).expect("it needs nothing else");
    assert_eq!((&again.matches, again.hash()), (&read.matches, read.hash()));
    let mut plain = exchanged();
    plain.as_object_mut().expect("an object").remove("matches");
    assert_eq!(study(&plain).hash(), read.hash(), "what the paper counted changes no run");
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut value = exchanged();
        change(&mut value);
        Study::from_value(&value, &[]).expect_err("it is refused").to_string()
    };
    let cases: [Case; 8] = [
        (
            &|value| value["metrics"] = json!(["goals_blue", "goal_difference"]),
            "matches: expected \"goals_yellow\" among the metrics, found no such one",
        ),
        (&|value| value["matches"]["win"] = json!(1), "matches.win: unknown field, did you mean \"wins\"?"),
        (
            &|value| value["matches"]["goals"] = json!([1.5, 2]),
            "matches.goals: expected two whole numbers from 0 to 1000000, found 1.5 and 2",
        ),
        (&|value| value["matches"]["most"] = json!([1]), "matches.most: expected two numbers, found one"),
        (
            &|value| {
                for end in ["wins", "ties", "losses"] {
                    value["matches"][end] = json!(0);
                }
            },
            "matches.wins: expected at least one match, found none",
        ),
        (
            &|value| value["metrics"] = json!(["goals_blu"]),
            "metrics[0]: unknown name \"goals_blu\", did you mean \"goals_blue\"?",
        ),
        (&|value| value["steps"] = json!(10), "steps: unknown field; `swarm-playground schema` lists all"),
        (
            &|value| value["cells"][0]["set"] = json!({"soccer.blue": "trees"}),
            "cells[0].set.soccer.blue: expected one of \"tree\", \"machine\", \"tree-without-swaps\", \
             \"machine-without-swaps\", \"tree-double-margins\", \"chase\", \"formation\", found \"trees\"",
        ),
    ];
    for (change, message) in cases {
        assert_eq!(refused(change), message);
    }
    let mut geese = exchanged();
    geese["scenario"] = json!({"world": "geese"});
    geese.as_object_mut().expect("an object").retain(|name, _| !["grid", "matches", "figure"].contains(&name.as_str()));
    let error = Study::from_value(&geese, &[]).expect_err("geese score no goals").to_string();
    assert!(error.ends_with("found \"goals_blue\" of the world \"soccer\""), "{error}");
}
