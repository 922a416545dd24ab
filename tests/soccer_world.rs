//! Whole matches as worlds of scenarios.

use serde_json::{Value, json};
use swarm_playground::scenario::{Run, Scenario, Timeline};
use swarm_playground::soccer::team::TeamKind;
use swarm_playground::soccer::{Colour, Finished};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn scenario(fields: &Value) -> Result<Scenario, String> {
    let mut text = json!({"world": "soccer", "seed": 3, "half-seconds": 20});
    if let (Value::Object(all), Value::Object(more)) = (&mut text, fields) {
        all.extend(more.clone());
    }
    Scenario::from_value(&text).map_err(|error| error.to_string())
}

fn run(fields: &Value) -> Run {
    Run::new(scenario(fields).expect("it is valid")).expect("it builds")
}

#[test]
fn a_match_gives_the_same_bits_everywhere() {
    let mut tree = run(&json!({}));
    assert_eq!(tree.advance(10_000), 2_400, "two halves of 20 s");
    assert_eq!(format!("{:016x}", tree.fingerprint()), GOLDEN[0]);
    let mut others = run(&json!({"blue": "chase", "yellow": "formation", "seed": 4}));
    others.advance(10_000);
    assert_eq!(format!("{:016x}", others.fingerprint()), GOLDEN[1]);
}

const GOLDEN: [&str; 2] = ["82b16a1d0f7bdb5f", "ca152727018bd5ef"];

#[test]
fn outcome_counts_for_both_teams_and_says_who_won() {
    let mut one = run(&json!({}));
    assert_eq!(one.finished(), None);
    one.advance(10_000);
    let outcome = one.soccer().expect("a match").outcome();
    let [blue, yellow] = outcome.goals;
    let expected = match blue.cmp(&yellow) {
        std::cmp::Ordering::Greater => Finished::Blue,
        std::cmp::Ordering::Less => Finished::Yellow,
        std::cmp::Ordering::Equal => Finished::Tie,
    };
    assert_eq!((outcome.finished, outcome.seconds), (Some(expected), 40.0));
    assert_eq!((outcome.blue.team, outcome.yellow.team), ("tree", "machine"));
    assert!((outcome.blue.possession + outcome.yellow.possession - 1.0).abs() < 1e-12);
    assert_eq!((outcome.blue.violations, outcome.yellow.violations), (0, 0));
    assert!(one.finished().expect("it is over").starts_with("full time"));
}

#[test]
fn exchanged_sides_exchange_nothing_but_the_teams() {
    let end = |fields: &Value| {
        let mut run = run(fields);
        run.advance(10_000);
        run.soccer().expect("a match").outcome().goals
    };
    let [blue, yellow] = end(&json!({"blue": "tree", "yellow": "chase"}));
    assert_eq!(end(&json!({"blue": "chase", "yellow": "tree", "sides-exchanged": true})), [yellow, blue]);
}

#[test]
fn seeking_finds_what_a_straight_run_finds() {
    let mut straight = run(&json!({}));
    straight.advance(700);
    let mut timeline = Timeline::new(run(&json!({})), 1 << 20);
    for tick in [1_500, 20, 700] {
        timeline.seek(tick, 10_000);
    }
    assert_eq!(timeline.run().fingerprint(), straight.fingerprint());
}

#[test]
fn a_goalkeeper_is_on_the_pitch_in_every_frame() {
    let mut one = run(&json!({"blue": "tree-double-margins", "yellow": "machine-without-swaps"}));
    while one.advance(1) > 0 {
        let state = one.soccer().expect("a match").state();
        for team in [Colour::Blue, Colour::Yellow] {
            let keepers = state.team(team).duties().roles.iter().filter(|role| role.keeps_goal()).count();
            assert_eq!(keepers, 1, "tick {}", state.tick());
        }
    }
}

#[test]
fn every_team_is_a_value_of_both_teams() {
    for kind in TeamKind::ALL {
        for field in ["blue", "yellow"] {
            let read = scenario(&json!({field: kind.text()})).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(read.to_value()[field], kind.text());
        }
    }
}

#[test]
fn what_cannot_be_played_is_refused_with_its_place() {
    let refused = |fields: &Value| scenario(fields).expect_err("it is refused");
    assert!(refused(&json!({"blue": "trees"})).starts_with("blue: expected"), "{}", refused(&json!({"blue": "trees"})));
    assert!(refused(&json!({"enter": 0})).starts_with("enter: expected a number from 0.1 to 10"));
    let foreign = refused(&json!({"yellow-coach": "<root BTCPP_format=\"4\"/>"}));
    assert!(foreign.starts_with("yellow-coach: expected no coach tree for the team \"machine\""), "{foreign}");
    let broken = refused(
        &json!({"blue-coach": "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"A\"><Nonsense/></BehaviorTree></root>"}),
    );
    assert!(broken.starts_with("blue-coach: coach, line 2, column "), "{broken}");
}
