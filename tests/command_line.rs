//! The command line as a user types it.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// Runs the binary in the project's folder: status, standard output, standard error.
fn run(arguments: &[&str]) -> (i32, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_swarm-playground"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("it starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("it prints text").trim_end().to_owned();
    (output.status.code().expect("it ends"), text(output.stdout), text(output.stderr))
}

fn fresh(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_file(&path);
    path
}

#[test]
fn a_population_is_saved_once_and_runs_again_without_evolution() {
    let file = fresh("population.json");
    let name = file.to_str().expect("a plain name");
    let save = ["run", "scenarios/foraging.json", "--steps", "40", "--save-population", name];
    assert_eq!(run(&save).0, 0);
    let (status, _, error) = run(&save);
    assert_eq!(status, 2);
    assert!(error.starts_with(&format!("swarm-playground: {name}: cannot be written: ")), "{error}");

    let fixed = |form: &str| {
        let form = format!("population-form={form}");
        let arguments =
            ["run", "scenarios/foraging.json", "--steps", "40", "--population", name, "--set", "evolution=false"];
        let (status, line, error) = run(&[&arguments[..], &["--set", &form]].concat());
        assert_eq!((status, error.as_str()), (0, ""));
        line
    };
    assert_ne!(fixed("blended"), fixed("homogeneous"));
}

#[test]
fn a_change_that_is_none_is_refused_in_one_sentence() {
    for (change, message) in [
        ("nothing", "--set: expected KEY=VALUE, found \"nothing\""),
        ("max-depht=3", "--max-depht: unknown field, did you mean \"max-depth\"?"),
        ("geese.task=swim", "--task: expected one of \"forage\", \"nest\", found \"swim\""),
    ] {
        let (status, output, error) = run(&["run", "scenarios/foraging.json", "--set", change]);
        assert_eq!((status, output.as_str()), (2, ""));
        assert_eq!(error, format!("swarm-playground: {message}"));
    }
    let (status, _, error) = run(&["run", "scenarios/foraging.json", "--population", "scenarios/nest.json"]);
    assert_eq!(status, 2);
    assert!(error.contains("population: format: expected \"geese-population/1\", found null"), "{error}");
}

#[test]
fn a_search_prints_its_result_and_nothing_else_where_nobody_watches() {
    // Seconds of search on a hard layout: a terminal would see a bar, a pipe must not.
    let words = ["run", "scenarios/navigation.json", "--seed", "2", "--set", "budget=6000", "--set", "jitter-runs=0"];
    let (status, line, error) = run(&words);
    assert_eq!((status, error.as_str()), (0, ""));
    assert!(line.contains("\"result\":\"gave up at the budget of integrations\""), "{line}");
    assert_eq!(line.lines().count(), 1);
}

#[test]
fn layouts_are_measured_in_one_line_for_programs_to_read() {
    let words = ["sequence", "measure", "scenarios/plan-walled.json", "--layouts", "2"];
    let (status, line, error) = run(&words);
    assert_eq!((status, error.as_str()), (0, ""));
    let found: serde_json::Value = serde_json::from_str(&line).expect("it is JSON");
    let layouts = found["layouts"].as_array().expect("a list");
    assert_eq!(layouts.len(), 2);
    assert!(
        layouts.iter().all(|layout| layout["outcome"] == "proved infeasible" && layout["seconds"].is_f64()),
        "{line}"
    );
    let (status, _, error) = run(&["sequence", "measure", "scenarios/foraging.json"]);
    assert_eq!(
        (status, error.as_str()),
        (2, "swarm-playground: scenarios/foraging.json: world: expected \"sequencing\"")
    );
}

#[test]
fn times_needs_the_papers() {
    let (status, _, error) = run(&["times", "studies/sequences.json"]);
    let message = "studies/sequences.json: seconds: expected the paper's seconds, found no such field";
    assert_eq!((status, error), (2, format!("swarm-playground: {message}")));
}
