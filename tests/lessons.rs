//! The lessons: every number that a lesson's words hold stands in its file under `facts`, with how it is found. Here each is
//! found again: by running the engine, in committed results, in the claims of a paper, or in the lesson's own question.
#![cfg(not(target_arch = "wasm32"))]

use serde_json::Value;
use std::fs;
use std::path::Path;
use swarm_playground::geese::{Derived, Detail, Measure, Query};
use swarm_playground::scenario::{Outcome, Run, Scenario, WorldParams};

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path))
        .unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn json(path: &str) -> Value {
    serde_json::from_str(&read(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Names of the lesson files, in the order of the lessons.
fn files() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    let mut names: Vec<_> = fs::read_dir(folder)
        .expect("the folder is there")
        .flatten()
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort_by_key(|name| name.split('-').next().and_then(|number| number.parse::<u32>().ok()));
    names
}

fn text<'a>(value: &'a Value, field: &str) -> &'a str {
    value[field].as_str().unwrap_or_else(|| panic!("{field} is a text in {value}"))
}

/// A scenario file with other fields.
fn scenario(preset: &str, seed: &Value, values: &Value) -> Scenario {
    let mut fields = json(&format!("scenarios/{preset}.json"));
    if !seed.is_null() {
        fields["seed"] = seed.clone();
    }
    for (field, value) in values.as_object().into_iter().flatten() {
        fields[field] = value.clone();
    }
    Scenario::read(&fields.to_string()).unwrap_or_else(|error| panic!("{preset}: {error}"))
}

/// A run of the engine, and what is measured at its last tick.
fn measured(recipe: &Value, measure: &str) -> f64 {
    let scenario = scenario(text(recipe, "preset"), &recipe["seed"], &recipe["values"]);
    let mut run = Run::new(scenario).expect("a world");
    let tick = u32::try_from(recipe["tick"].as_u64().expect("a tick")).expect("a small number");
    assert_eq!(run.advance(tick), tick);
    let Outcome::Geese(outcome) = run.outcome() else { panic!("not of the foraging swarm") };
    match measure {
        "delivered" => f64::from(outcome.delivered),
        "items" => f64::from(outcome.items),
        "inert" => (100.0 * Measure::of(run.geese().expect("the swarm")).inert).round(),
        "knowing" => {
            let world = run.geese_mut().expect("the swarm");
            let agents = world.params().agents;
            let knows = |agent: u32| {
                let query = Query::from_value(&serde_json::json!({ "agent": agent }));
                let detail = serde_json::to_value(Detail::of(world, &query)).expect("serialises");
                detail["agent"]["knows"].as_array().expect("a list").iter().any(|place| place == "Sites")
            };
            f64::from((0..agents).map(knows).map(u32::from).sum::<u32>())
        }
        other => panic!("nothing is measured as {other}"),
    }
}

/// A column of committed results: mean, sum or number of the runs of one cell, or of all where none is named.
fn committed(fact: &Value) -> f64 {
    let rows = read(text(fact, "results"));
    let mut lines = csv_lines(&rows);
    let header = lines.next().expect("a header");
    let column = header.iter().position(|name| name == text(fact, "metric")).expect("the metric is a column");
    let values: Vec<f64> = lines
        .filter(|line| fact["cell"].is_null() || line[1] == text(fact, "cell"))
        .map(|line| line[column].parse().unwrap_or_else(|_| panic!("a number, found {}", line[column])))
        .collect();
    assert!(!values.is_empty(), "no run of {fact}");
    let sum: f64 = values.iter().sum();
    match text(fact, "statistic") {
        "mean" => sum / values.len() as f64,
        "sum" => sum,
        "runs" => values.len() as f64,
        other => panic!("no statistic {other}"),
    }
}

/// The fields of each line; those with a comma stand in quotes.
fn csv_lines(text: &str) -> impl Iterator<Item = Vec<String>> {
    text.lines().map(|line| {
        let mut fields = vec![String::new()];
        let mut quoted = false;
        for letter in line.chars() {
            match letter {
                '"' => quoted = !quoted,
                ',' if !quoted => fields.push(String::new()),
                _ => fields.last_mut().expect("one at least").push(letter),
            }
        }
        fields
    })
}

/// A codon of the first robot's genome, from 1: its value, or how many alternatives it chooses among.
fn codon(lesson: &Value, number: u64, field: &str) -> f64 {
    let check = &lesson["check"];
    let mut run = Run::new(scenario(text(check, "preset"), &check["seed"], &check["values"])).expect("a world");
    let world = run.geese_mut().expect("the swarm");
    let query = Query::from_value(&serde_json::json!({ "agent": 0 }));
    let detail = serde_json::to_value(Detail::of(world, &query)).expect("serialises");
    let genome: Vec<u16> = serde_json::from_value(detail["agent"]["genome"].clone()).expect("codons");
    let derived = serde_json::to_value(Derived::of(world.compiler(), &genome)).expect("serialises");
    let step = derived["steps"].as_array().expect("steps").iter().find(|step| step["codon"] == number - 1);
    step.expect("the codon is used")[field].as_f64().expect("a number")
}

/// How many different orders the same letters have.
fn orders(letters: &str) -> f64 {
    let factorial = |count: usize| (1..=count).product::<usize>();
    let alike = |letter: char| letters.chars().filter(|&other| other == letter).count();
    let mut kinds: Vec<char> = letters.chars().collect();
    kinds.sort_unstable();
    kinds.dedup();
    (factorial(letters.len()) / kinds.into_iter().map(|letter| factorial(alike(letter))).product::<usize>()) as f64
}

/// The value of a fact, found in the way it names.
fn found(lesson: &Value, fact: &Value) -> f64 {
    let times = fact["times"].as_f64().unwrap_or(1.0);
    if let Some(pointer) = fact["pointer"].as_str() {
        let value = lesson.pointer(pointer).unwrap_or_else(|| panic!("nothing at {pointer}"));
        return value.as_f64().expect("a number") + fact["plus"].as_f64().unwrap_or(0.0);
    }
    if fact["results"].is_string() {
        return committed(fact) * times;
    }
    if let Some(file) = fact["claims"].as_str() {
        let claims = json(file);
        let claim = claims["claims"].as_array().expect("claims").iter().find(|claim| claim["id"] == fact["claim"]);
        let evidence = &claim.expect("the claim is there")["evidence"][0];
        return evidence["equals"][text(fact, "cell")].as_f64().unwrap_or_else(|| panic!("no value in {evidence}"))
            * times;
    }
    if let Some(number) = fact["codon"].as_u64() {
        return codon(lesson, number, text(fact, "field"));
    }
    if let Some(pointer) = fact["orders"].as_str() {
        return orders(lesson.pointer(pointer).and_then(Value::as_str).expect("letters"));
    }
    if let Some(measure) = fact["measure"].as_str() {
        return measured(&fact["run"], measure);
    }
    let field = text(fact, "field");
    let scenario = scenario(text(fact, "preset"), &Value::Null, &fact["values"]);
    assert!(matches!(scenario.world, WorldParams::Geese(_) | WorldParams::Sequencing(_) | WorldParams::Soccer(_)));
    scenario.to_value()[field].as_f64().unwrap_or_else(|| panic!("{field} is a number"))
}

#[test]
fn every_number_of_a_lesson_is_found_again() {
    let mut wrong = Vec::new();
    let mut facts = 0;
    for name in files() {
        let lesson = json(&format!("lessons/{name}"));
        for (fact, recipe) in lesson["facts"].as_object().expect("facts") {
            let value = recipe["value"].as_f64().expect("a value");
            let truth = found(&lesson, recipe);
            facts += 1;
            if (truth - value).abs() > 1e-9 {
                wrong.push(format!("{name}: {fact} says {value}, found {truth}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(facts > 20, "the test sees the facts: {facts}");
}

#[test]
fn the_plan_whose_orders_are_tried_is_the_planners_own() {
    let check = &json("lessons/7-order.json")["check"];
    let scenario = scenario(text(check, "preset"), &check["seed"], &Value::Null);
    let run = Run::new(scenario).expect("a plan");
    let Outcome::Sequencing(outcome) = run.outcome() else { panic!("not of sequencing") };
    let outcome = serde_json::to_value(outcome).expect("serialises");
    assert_eq!(outcome["plan"], check["letters"]);
}

#[test]
fn lessons_are_numbered_without_a_gap() {
    let numbers: Vec<u32> =
        files().iter().map(|name| name.split('-').next().expect("a number").parse().expect("a number")).collect();
    assert_eq!(numbers, (1..=u32::try_from(numbers.len()).expect("few")).collect::<Vec<_>>());
}
