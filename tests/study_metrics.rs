//! Metrics on swarms whose programs are given by the grammar, so that every number is known.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::json;
use swarm_playground::study::Study;

/// The metrics of a short run in which everyone has one of the programs that `grammar` writes.
fn measured(grammar: &str, metrics: &[&str]) -> Vec<Option<f64>> {
    let study = json!({"study": "one", "scenario": {"world": "geese", "agents": 10, "grammar": grammar, "genome-length": 4},
        "steps": 20, "seeds": {"count": 1}, "metrics": metrics});
    let row = Study::from_value(&study, &[]).expect("it is a study").make(0);
    assert!(row.end.is_ok(), "{:?}", row.end);
    row.metrics
}

#[test]
fn an_action_that_can_never_run_makes_a_program_inert() {
    let cases = [
        ("Sel[Post(DummyNode) Act(Explore)]", 1.0),
        ("Seq[Con(not CanMove) Act(Explore)]", 1.0),
        ("Sel[Seq[Pre(DummyNode) Con(CanMove)] Act(Explore)]", 1.0),
        ("Seq[Sel[Post(DummyNode) Act(Explore)] Sel[Post(CanMove) Act(Explore)]]", 1.0),
        ("Seq[Sel[Post(DummyNode) Act(Explore)] Act(Explore)]", 0.0),
        ("Sel[Post(not DummyNode) Act(Explore)]", 0.0),
        ("Sel[Post(IsCarrying Food) Act(Explore)]", 0.0),
        ("Act(Explore)", 0.0),
    ];
    for (program, inert) in cases {
        assert_eq!(measured(&format!("<S> ::= {program}"), &["inert_share"]), [Some(inert)], "{program}");
    }
}

#[test]
fn programs_are_counted_by_their_actions() {
    let metrics = [
        "distinct_programs",
        "actions_per_program",
        "programs_with_1_action",
        "programs_with_2_actions",
        "programs_with_3_actions",
        "programs_with_4_or_more_actions",
    ];
    let of =
        |program: &str| measured(&format!("<S> ::= {program}"), &metrics).into_iter().flatten().collect::<Vec<_>>();
    assert_eq!(of("Act(Explore)"), [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(of("Seq[Act(Explore) Act(Explore) Act(Explore)]"), [1.0, 3.0, 0.0, 0.0, 1.0, 0.0]);
    let five = "Seq[Act(Explore) Act(Explore) Act(Explore) Act(Explore) Act(Explore)]";
    assert_eq!(of(five), [1.0, 5.0, 0.0, 0.0, 0.0, 1.0]);
    // Two programs that some robots each have: means are over programs, not over robots.
    assert_eq!(of("Act(Explore) | Seq[Act(Explore) Act(Explore)]"), [2.0, 1.5, 0.5, 0.5, 0.0, 0.0]);
}

#[test]
fn what_never_came_about_is_empty_and_the_rest_is_a_number() {
    let metrics = ["share", "delivered", "success", "steps", "steps_to_50", "steps_to_80", "carrying", "alive"];
    let found = measured("<S> ::= Act(Explore)", &metrics);
    assert_eq!(found, [Some(0.0), Some(0.0), Some(0.0), Some(20.0), None, None, Some(0.0), Some(10.0)]);
    let found = measured("<S> ::= Act(Explore)", &["swaps_per_agent_step", "mean_diversity", "mean_genome_length"]);
    // One name in the grammar, which every program has; nothing is ever more diverse, so nothing is swapped.
    assert_eq!(found, [Some(0.0), Some(1.0), Some(4.0)]);
}

#[test]
fn what_is_delivered_while_learning_counts_for_nothing() {
    // A tree written by hand clears the nest within the learning; the test is too short for it.
    let study = json!({"study": "one", "scenario": {"world": "geese", "agents": 20, "task": "nest", "grammar": "hand-tree",
        "learning-steps": 100, "population-form": "homogeneous"},
        "steps": 103, "seeds": {"count": 1}, "metrics": ["success", "steps_to_50"]});
    let row = Study::from_value(&study, &[]).expect("it is a study").make(0);
    assert_eq!(row.metrics, [Some(0.0), None]);
}
