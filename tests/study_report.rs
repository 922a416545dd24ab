//! Reports and figures on results made up for the purpose, so that every number in them is known.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use swarm_playground::study::{Report, Results, Row, Study, figure, report};

/// Two cells of 64 runs: the first succeeds 48 times, the second 6 times, as in the paper.
fn published() -> Value {
    json!({
        "study": "published", "title": "The paper's <own> numbers", "about": "Made up.",
        "scenario": {"world": "geese", "agents": 5},
        "cells": [{"name": "new | better"}, {"name": "old", "set": {"geese.children": 2}}],
        "seeds": {"count": 64}, "metrics": ["success", "share", "steps_to_80"],
        "tests": [
            {"kind": "proportions", "metric": "success", "compare": ["new | better", "old"]},
            {"kind": "mann-whitney", "metric": "share", "compare": ["new | better", "old"]},
            {"kind": "welch-t", "metric": "share", "compare": ["new | better", "old"]},
            {"kind": "one-sample-t", "metric": "share", "compare": ["old"], "against": 0.5},
        ],
        "figure": {"kind": "box", "metric": "share", "group": "geese.children"},
        "paper": {"new | better": {"success": 0.75, "share": 0.5}, "old": {"success": 0.2}},
    })
}

fn results(study: &Value, runs: u32) -> Results {
    let study = Study::from_value(study, &[]).expect("it is a study");
    let mut results = Results::new(study);
    for run in 0..runs {
        let (cell, round) = (run % 2, run / 2);
        let success = if cell == 0 { round < 48 } else { round < 6 };
        // 0.5 to 0.752 in the first cell, 0.4 to 0.652 in the second: no ties within a cell, many between them.
        let share = f64::from(if cell == 0 { 500 + 4 * round } else { 400 + 4 * round }) / 1000.0;
        let steps = success.then_some(f64::from(100 + round));
        let metrics = vec![Some(f64::from(u8::from(success))), Some(share), steps];
        results.add(Row { run, metrics, end: Ok(u64::from(run)) });
    }
    results
}

#[test]
fn the_published_numbers_are_reported_as_reproduced() {
    let text = report(&results(&published(), 128));
    let lines = [
        "# The paper's <own> numbers",
        "Study `published`, 2 cells: 64 of 64 seeds from 1 in each cell. Version 0.1.0, spec",
        "| new \\| better | 64 | 48 | 75.0 % | 63.2 % to 84.0 % |",
        "| old | 64 | 6 | 9.4 % | 4.4 % to 19.0 % |",
        // 0.5 + 0.004 k for k = 0 to 63: mean 0.5 + 0.126; sd 0.004 sqrt(64 65 / 12) = 0.07448; quartiles at 15.75 and
        // 47.25.
        "| new \\| better | 64 | 62.6 % | 7.4 % | 62.6 % | 56.3 % to 68.9 % | 50.0 % to 75.2 % |",
        "| new \\| better | 48 | 123.5 | 14 | 123.5 | 111.8 to 135.2 | 100 to 147 | 16 |",
        "| new \\| better / old | Success | Fisher's exact | 64, 64 | 48 and 6 successes |",
        // 0.65625 less sqrt(0.11816^2 + 0.09596^2), more sqrt(0.08985^2 + 0.05028^2), from the two Wilson intervals.
        "| difference 0.656 (0.504 to 0.759) | large |",
        "| new \\| better / old | Items delivered | Mann-Whitney U, normal | 64, 64 |",
        // 0.1 / (0.07448 sqrt(2/64)) = 7.596 and 0.026 / (0.07448 / 8) = 2.793.
        "| Welch's t | 64, 64 | t = 7.596, df 126 |",
        "| old / the value 0.5 | Items delivered | one-sample t | 64 | t = 2.793, df 63 |",
        "| new \\| better | Success | 75.0 % | 75.0 % | 63.2 % to 84.0 % | 0.0 points | reproduced |",
        "| new \\| better | Items delivered | 50.0 % | 62.6 % | 60.7 % to 64.5 % | +12.6 points | not reproduced |",
        "| old | Success | 20.0 % | 9.4 % | 4.4 % to 19.0 % | -10.6 points | not reproduced |",
    ];
    for line in lines {
        assert!(text.contains(line), "no \"{line}\" in\n{text}");
    }
}

#[test]
fn the_report_as_data_holds_the_tables_of_its_markdown() {
    let results = results(&published(), 9);
    let data = Report::of(&results);
    assert_eq!(data.extent, "4 to 5 of 64 seeds from 1 in each cell, not complete");
    let names: Vec<&str> = data.sections.iter().map(|section| section.name).collect();
    assert_eq!(names, ["success", "share", "steps_to_80", "tests", "paper"]);
    let markdown = report(&results);
    for section in &data.sections {
        assert!(markdown.contains(&format!("## {}\n\n{}", section.title, section.note)), "{}", section.title);
        for row in &section.rows {
            assert_eq!(row.len(), section.columns.len());
            let line = row.iter().map(|field| field.replace('|', "\\|")).collect::<Vec<_>>().join(" | ");
            assert!(markdown.contains(&format!("| {line} |")), "{line}");
        }
    }
}

#[test]
fn long_words_stay_within_the_figure() {
    let mut study = published();
    study["title"] = json!("t".repeat(200));
    study["cells"] = json!([{"name": "a".repeat(100)}, {"name": "b".repeat(100), "set": {"geese.children": 2}}]);
    let fields = study.as_object_mut().expect("an object");
    fields.retain(|name, _| !["tests", "paper"].contains(&name.as_str()));
    study["figure"] = json!({"kind": "box", "metric": "share"});
    let drawn = figure(&results(&study, 8)).expect("there are values");
    assert!(drawn.contains(&format!(">{}\u{2026}</text>", "t".repeat(62))), "the title is cut");
    assert!(drawn.contains(&format!("<title>{}</title>", "t".repeat(200))), "and whole in the file");
    let longest = drawn.split("<text").map(|text| text.matches(['a', 'b']).count()).max();
    assert!(drawn.contains("aaaa") && longest < Some(60), "names are broken: {longest:?}");
}

#[test]
fn what_is_not_there_yet_is_said() {
    let text = report(&results(&published(), 9));
    assert!(text.contains("4 to 5 of 64 seeds from 1 in each cell, not complete."), "{text}");
    assert!(text.contains("| old | Success | 20.0 % | 100.0 % | 51.0 % to 100.0 % | +80.0 points | not reproduced |"));
    assert!(
        text.contains("| new \\| better | Success | 75.0 % | 100.0 % | 56.6 % to 100.0 % | +25.0 points | open |"),
        "{text}"
    );
    let empty = report(&results(&published(), 0));
    assert!(empty.contains("not made: too few runs, or all alike") && empty.contains("too few runs |"), "{empty}");
    assert!(figure(&results(&published(), 0)).is_none(), "there is nothing to draw");
    let mut failed = results(&published(), 4);
    failed.add(Row { run: 4, metrics: vec![None; 3], end: Err("obstacles: no room".to_owned()) });
    let text = report(&failed);
    assert!(text.contains("* 1 run: obstacles: no room") && text.contains("2 to 3 of 64 seeds"), "{text}");
}

#[test]
fn every_kind_of_figure_shows_every_run_or_its_interval() {
    let drawn = |figure_of: Value| {
        let mut study = published();
        study["cells"] = Value::Null;
        study
            .as_object_mut()
            .expect("an object")
            .retain(|name, _| !["cells", "tests", "paper"].contains(&name.as_str()));
        study["grid"] = json!({"geese.children": [4, 20]});
        study["figure"] = figure_of;
        figure(&results(&study, 128)).expect("there are values")
    };
    let x = "geese.children";
    let boxes = drawn(json!({"kind": "box", "metric": "share", "x": x}));
    assert_eq!(boxes.matches("class=\"point c0\"").count(), 128);
    assert_eq!(boxes.matches("class=\"box c0\"").count(), 2);
    let curve = drawn(json!({"kind": "curve", "metric": "steps_to_80", "x": x}));
    assert_eq!(curve.matches("class=\"point").count(), 54, "runs that never got there are not drawn");
    assert_eq!((curve.matches("class=\"band").count(), curve.matches("<path class=\"mark").count()), (1, 1));
    let shares = drawn(json!({"kind": "proportion", "metric": "success", "group": x}));
    assert_eq!(shares.matches("class=\"fill c").count(), 4, "two shares and two colours of the legend");
    let histogram = drawn(json!({"kind": "histogram", "metric": "share", "group": x}));
    assert_eq!(histogram.matches("class=\"thin").count(), 128);
    for text in [boxes, curve, shares, histogram] {
        assert!(text.starts_with("<svg xmlns") && text.contains("prefers-color-scheme:dark"));
        assert!(text.contains("The paper's &lt;own&gt; numbers") && text.contains("64 of 64 seeds"), "{text}");
        assert!(roxmltree::Document::parse(&text).is_ok(), "it is XML");
    }
}
