//! Runs of a study made in slices, as the page makes them.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::json;
use swarm_playground::study::{Results, Row, Study};

fn small() -> Study {
    let study = json!({"study": "small", "scenario": {"world": "geese", "agents": 10, "steps": 60},
        "grid": {"geese.agents": [10, 20]}, "seeds": {"first": 3, "count": 2},
        "metrics": ["share", "steps", "success", "mean_diversity"]});
    Study::from_value(&study, &[]).expect("it is a study")
}

#[test]
fn a_run_in_slices_gives_the_row_of_one_made_at_once() {
    let study = small();
    for run in 0..study.run_count() {
        let whole = study.make(run);
        assert!(whole.end.is_ok(), "{:?}", whole.end);
        for slice in [1, 7, 60, 1000] {
            let mut job = study.start(run);
            let mut slices = 1;
            while !job.advance(slice) {
                slices += 1;
                assert!(slices <= 62, "it comes to an end");
            }
            assert_eq!(job.row(), whole, "run {run} in slices of {slice}");
            assert!(job.advance(slice), "a run that is over stays over");
            assert_eq!(job.row(), whole, "and says the same");
        }
    }
}

#[test]
fn a_failed_run_is_one_line_with_its_reason() {
    let study = small();
    let results = Results::new(study.clone());
    let row = Row::failed(&study, 1, "it broke\nin line 2, \"badly\"");
    let line = results.line(&row);
    assert_eq!(line.matches('\n').count(), 1);
    let (read, _) = Results::read(study.clone(), (results.header() + &line).as_bytes()).expect("it is a results file");
    assert_eq!(read.row_of(1), Some(&row));
    assert_eq!(row.end, Err("it broke in line 2, \"badly\"".to_owned()));
    assert_eq!(
        Row::failed(&study, 0, "\n").end,
        Err("no reason was given".to_owned()),
        "a row has numbers or a reason"
    );
}

#[test]
fn robot_steps_count_every_cell_and_seed() {
    // 10 and 20 robots, 60 steps, 2 seeds.
    assert_eq!(small().robot_steps(), (10 + 20) * 60 * 2);
}
