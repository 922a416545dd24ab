//! Results of studies: files that are continued, shared out, repaired and refused.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use swarm_playground::study::{Presets, Results, Row, Size, Study, VERSION};

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

/// All rows of a study, and its file.
fn made(study: &Study) -> (Vec<Row>, String) {
    let rows: Vec<Row> = (0..study.run_count()).map(|run| study.make(run)).collect();
    let mut results = Results::new(study.clone());
    rows.iter().cloned().for_each(|row| results.add(row));
    (rows, results.text())
}

#[test]
fn results_are_one_tidy_row_a_run() {
    let study = read(&small()).sized(Size::Glance).expect("the file has one");
    let (rows, text) = made(&study);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[0],
        "run,cell,kind,geese.children,geese.mutation-mode,seed,share,success,steps_to_50,mean_diversity,\
         version,spec,fingerprint,reason"
    );
    assert_eq!(lines.len(), 9);
    let fingerprint = rows[6].end.clone().expect("it ran");
    let diversity = rows[6].metrics[3].expect("it ran");
    assert_eq!(
        lines[7],
        format!(
            "6,\"b, \"\"quoted\"\", mutation-mode bit\",few,4,bit,6,0,0,,{diversity},{VERSION},{:016x},{fingerprint:016x},",
            study.hash()
        )
    );
    let (again, whole) = Results::read(study, text.as_bytes()).expect("what was written is read");
    assert_eq!((again.text(), whole, again.missing()), (text.clone(), text.len(), vec![]));
    assert!(again.rows().eq(&rows));
}

#[test]
fn a_failed_run_has_a_reason_and_no_numbers() {
    let study = read(&with("/scenario", "set", json!({"geese.genome-length": 8})));
    let row = study.make(0);
    assert_eq!(row.metrics, [None; 4]);
    let reason = row.end.clone().expect_err("eight codons give no program");
    assert!(reason.starts_with("grammar: expected a grammar of which random genomes give programs"), "{reason}");
    let mut results = Results::new(study.clone());
    results.add(row);
    let text = results.text();
    assert!(Results::read(study.clone(), text.as_bytes()).expect("valid").0.missing().len() == 11);
    let error = Results::read(study, text.replacen(",,,,", ",0.5,,,", 1).as_bytes()).expect_err("a number").to_string();
    assert_eq!(error, "line 2, column 36: expected nothing in a failed run, found \"0.5\"");
}

#[test]
fn killed_at_any_byte_and_continued_the_file_is_the_same() {
    let study = read(&small()).sized(Size::Glance).expect("the file has one");
    let (rows, text) = made(&study);
    // Rows in the order in which three workers could have ended them.
    let ended = [2, 0, 1, 5, 3, 4, 7, 6];
    let mut file = Results::new(study.clone()).header();
    for run in ended {
        file += &Results::new(study.clone()).line(&rows[run]);
    }
    for cut in 0..=file.len() {
        let (mut results, whole) = Results::read(study.clone(), &file.as_bytes()[..cut]).expect("a beginning is valid");
        let kept = &file[..whole];
        assert!(kept.is_empty() || kept.ends_with('\n'));
        let missing = results.missing();
        assert_eq!(missing.len() + kept.lines().count().saturating_sub(1), rows.len(), "cut at {cut}");
        for run in missing {
            results.add(rows[run as usize].clone());
        }
        assert_eq!(results.text(), text, "cut at {cut}");
    }
}

#[test]
fn shards_put_one_after_the_other_are_the_same_file() {
    let study = read(&small()).sized(Size::Glance).expect("the file has one");
    let (rows, text) = made(&study);
    let mut files = String::new();
    for part in [1, 0] {
        let mut results = Results::new(study.clone());
        rows.iter().filter(|row| row.run / 4 % 2 == part).cloned().for_each(|row| results.add(row));
        assert_eq!(results.rows().count(), 4, "every part has all cells");
        files += &results.text();
    }
    let (results, _) = Results::read(study.clone(), files.as_bytes()).expect("valid");
    assert_eq!(results.text(), text);
    // Results with more seeds than are asked for keep them all.
    let fewer = study.with_seeds(1).expect("valid");
    assert_eq!(Results::read(fewer, text.as_bytes()).expect("valid").0.text(), text);
}

#[test]
fn foreign_or_damaged_results_are_refused_with_their_place() {
    let study = read(&small()).sized(Size::Glance).expect("the file has one");
    let (rows, text) = made(&study);
    let hash = format!("{:016x}", study.hash());
    let fingerprint = format!("{:016x}", rows[0].end.clone().expect("it ran"));
    let changed = |from: &str, to: &str| text.replacen(from, to, 1).into_bytes();
    let diversity = rows[0].metrics[3].expect("it ran").to_string();
    let version_at = 41 + diversity.len() + 1;
    let version = format!("line 2, column {version_at}: expected results of version {VERSION}, found version 0.0.9");
    let spec_at = version_at + VERSION.len() + 1;
    let cases = [
        (b"other text\n".to_vec(), "line 1, column 1: expected the column \"run\", found \"other text\"".to_owned()),
        (
            b"other".to_vec(),
            format!(
                "line 1, column 1: expected the columns {}, found another text",
                text.lines().next().expect("a header")
            ),
        ),
        (
            changed("share,success", "success,share"),
            "line 1, column 55: expected the column \"share\", found \"success\"".to_owned(),
        ),
        (changed(&format!(",{VERSION},"), ",0.0.9,"), version),
        (
            changed(&hash, "0123456789abcdef"),
            format!("line 2, column {spec_at}: expected results of the study with hash {hash}, found 0123456789abcdef"),
        ),
        (
            changed("\n1,", "\n0,"),
            "line 3, column 3: expected cell a, mutation-mode bit in run 0, found \"a, mutation-mode codon\""
                .to_owned(),
        ),
        (changed("\n1,", "\nx,"), "line 3, column 1: expected a run from 0 to 39999, found \"x\"".to_owned()),
        (changed("bit,5,0", "bit,6,0"), "line 2, column 34: expected seed 5 in run 0, found \"6\"".to_owned()),
        (changed("bit,5,0,0,", "bit,5,0,2,"), "line 2, column 38: expected 0 or 1, found \"2\"".to_owned()),
        (changed("bit,5,0,", "bit,5,0.0,"), "line 2, column 36: expected share 0 in run 0, found \"0.0\"".to_owned()),
        (
            changed("bit,5,0,", "bit,5,inf,"),
            "line 2, column 36: expected a number or nothing, found \"inf\"".to_owned(),
        ),
        (
            changed(&fingerprint, ""),
            format!("line 2, column {}: expected either a fingerprint or a reason", spec_at + 17),
        ),
        (
            changed("\n0,\"a", "\n0,a"),
            "line 2, column 23: expected a quote only around a whole field, found one within".to_owned(),
        ),
        (
            changed("bit\",,", "bit\"x,,"),
            "line 2, column 25: expected a comma after the closing quote, found 'x'".to_owned(),
        ),
        (
            changed("bit\",,", "bit,,"),
            "line 2, column 3: expected a closing quote, found the end of the line".to_owned(),
        ),
        (
            [text.as_bytes(), text.as_bytes()].concat(),
            "line 11, column 1: expected each run once, found run 0 of line 2 again".to_owned(),
        ),
        (b"run,\xff\n".to_vec(), "line 1, column 5: expected text in UTF-8, found other bytes".to_owned()),
    ];
    for (bytes, message) in cases {
        assert_eq!(Results::read(study.clone(), &bytes).expect_err(&message).to_string(), message);
    }
}

#[test]
fn a_run_ends_where_nothing_can_change_its_metrics_any_more() {
    let easy = json!({"study": "easy", "scenario": {"world": "geese", "agents": 30, "steps": 600,
        "arena-size": 40, "site-distance": 12, "site-radius": 5, "hub-radius": 5, "drop-rule": "sink",
        "explore-heading": "turning", "mutation-mode": "codon", "mutation-probability": 0.1, "swap-rule": "always",
        "success-threshold": 0.1}, "seeds": {"count": 1}, "metrics": ["success"]});
    let with_metrics = |metrics: Value| {
        let mut study = easy.clone();
        study["metrics"] = metrics;
        read(&study).make(0)
    };
    let (early, late) = (with_metrics(json!(["success"])), with_metrics(json!(["success", "steps"])));
    assert_eq!(early.metrics[0], Some(1.0));
    assert_eq!(late.metrics[0], Some(1.0));
    assert_ne!(early.end, late.end, "it stopped before the last step");
}
