//! Laws for any input: the readers of studies and results never panic, and what they accept is sound.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use serde_json::{Map, Value, json};
use swarm_playground::study::{Form, Metric, Presets, Results, Row, Size, Study, figure, report};

const PRESETS: &Presets = &[("small", r#"{"world": "geese", "agents": 8, "steps": 30}"#)];

/// Values that fit somewhere in a study.
fn value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        (-2_i64..40).prop_map(Value::from),
        any::<u64>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        prop::sample::select(vec![
            "small",
            "a",
            "b",
            "share",
            "success",
            "steps_to_50",
            "box",
            "curve",
            "histogram",
            "proportion",
            "proportions",
            "mann-whitney",
            "welch-t",
            "one-sample-t",
            "geese.children",
            "codon",
            "kind",
            "children 3",
            "a, children 3",
            "",
            "x,\"\n",
            "\u{0}",
        ])
        .prop_map(Value::from),
    ];
    let names = prop::sample::select(vec![
        "preset",
        "set",
        "name",
        "labels",
        "kind",
        "metric",
        "compare",
        "against",
        "x",
        "group",
        "first",
        "count",
        "glance",
        "class",
        "seeds",
        "steps",
        "geese.children",
        "geese.mutation-mode",
        "geese.agents",
        "world",
        "a",
        "b",
        "share",
        "success",
    ]);
    leaf.prop_recursive(3, 24, 5, move |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..4).prop_map(Value::from),
            prop::collection::btree_map(names.clone(), inner, 0..5).prop_map(|fields| Value::Object(
                fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
            )),
        ]
    })
}

/// A valid study in which a few fields were replaced, most by values of the right kind.
fn nearly_study() -> impl Strategy<Value = Value> {
    let fields = prop::sample::select(vec![
        "study", "title", "scenario", "cells", "grid", "seeds", "steps", "metrics", "sizes", "tests", "figure",
        "paper", "extra",
    ]);
    let good = prop::sample::select(vec![
        ("cells", json!([{"name": "a"}, {"name": "b", "set": {"geese.children": 4}, "labels": {"kind": "few"}}])),
        ("grid", json!({"geese.children": [3, 5], "geese.max-depth": [10, 11]})),
        ("metrics", json!(["success", "share", "steps_to_80", "mean_fitness"])),
        ("sizes", json!({"glance": {"seeds": 1, "steps": 5}})),
        ("tests", json!([{"kind": "mann-whitney", "metric": "share", "compare": ["a", "b"]}])),
        ("figure", json!({"kind": "curve", "metric": "share", "x": "geese.children"})),
        ("figure", json!({"kind": "histogram", "metric": "share"})),
        ("paper", json!({"a": {"share": 0.5}})),
        ("steps", json!(7)),
    ]);
    (prop::collection::vec(good, 0..5), prop::collection::vec((fields, value()), 0..3)).prop_map(|(good, near)| {
        let study = json!({"study": "s", "scenario": {"preset": "small"}, "seeds": {"count": 2}, "metrics": ["share", "success"]});
        let mut study: Map<String, Value> = study.as_object().cloned().unwrap_or_default();
        study.extend(good.into_iter().map(|(name, value)| (name.to_owned(), value)));
        study.extend(near.into_iter().map(|(name, value)| (name.to_owned(), value)));
        Value::Object(study)
    })
}

/// A row of numbers of any kind that the metrics allow.
fn row(study: &Study, run: u32, numbers: &[Option<f64>]) -> Row {
    let value = |(metric, number): (&Metric, &Option<f64>)| match metric {
        metric if metric.form() == Form::Flag => number.map(|number| f64::from(u8::from(number > 0.0))),
        _ => *number,
    };
    Row { run, metrics: study.metrics.iter().zip(numbers).map(value).collect(), end: Ok(u64::from(run)) }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn a_study_that_is_accepted_survives_writing_and_reports_on_anything(
        value in nearly_study(),
        numbers in prop::collection::vec(prop::option::of(prop_oneof![Just(0.0), Just(1.0), -1e3..1e3, -1e300..1e300]), 4 * 20),
    ) {
        let Ok(study) = Study::from_value(&value, PRESETS) else { return Ok(()) };
        prop_assert!(study.run_count() > 0);
        let again = Study::from_value(&study.to_value(), &[]).expect("what was written is a study");
        prop_assert_eq!(again.hash(), study.hash());
        prop_assert_eq!(again.factors(), study.factors());
        for (_, size) in Size::ALL {
            prop_assert!(study.sized(size).is_ok_and(|sized| sized.run_count() > 0) || size != Size::Paper);
        }
        let mut results = Results::new(study.clone());
        for (run, numbers) in (0..study.run_count()).zip(numbers.chunks(4)) {
            results.add(row(&study, run, numbers));
        }
        let text = results.text();
        let read = Results::read(study, text.as_bytes());
        prop_assert_eq!(read.as_ref().map(|(results, _)| results.text()), Ok(text));
        prop_assert!(!report(&results).is_empty());
        if let Some(figure) = figure(&results) {
            prop_assert!(roxmltree::Document::parse(&figure).is_ok());
        }
    }

    #[test]
    fn any_text_is_no_study_and_no_results(text in any::<String>(), bytes in prop::collection::vec(any::<u8>(), 0..80)) {
        prop_assert!(Study::read(&text, PRESETS).is_err());
        let study = Study::read(include_str!("cases/small_study.json"), PRESETS).expect("valid");
        let read = Results::read(study, &bytes);
        prop_assert!(bytes.is_empty() || read.is_err());
    }

    #[test]
    fn damage_anywhere_in_results_is_found_or_harmless(at in 0_usize..2000, byte in any::<u8>(), remove in 0_usize..3) {
        let study = Study::read(include_str!("cases/small_study.json"), PRESETS).expect("valid");
        let mut results = Results::new(study.clone());
        for run in 0..study.run_count() {
            results.add(row(&study, run, &[Some(f64::from(run) / 8.0), Some(1.0), None, Some(0.5)]));
        }
        let mut bytes = results.text().into_bytes();
        let at = at % bytes.len();
        bytes.splice(at..(at + remove).min(bytes.len()), [byte]);
        match Results::read(study, &bytes) {
            Err(error) => {
                let line = error.place().line as usize;
                prop_assert!(line >= 1 && line <= bytes.split(|byte| *byte == b'\n').count(), "{error}");
            }
            // What is accepted is written as it was read, but for a last line that was cut.
            Ok((read, whole)) => {
                let text = read.text();
                let sorted = |text: &str| { let mut lines: Vec<String> = text.lines().map(str::to_owned).collect(); lines.sort(); lines };
                prop_assert_eq!(sorted(&text), sorted(std::str::from_utf8(&bytes[..whole]).expect("it was read")));
            }
        }
    }
}
