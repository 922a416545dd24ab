//! Matches that are filmed, looked at and changed by hand.

use serde_json::{Value, json};
use swarm_playground::scenario::{Film, Run, Scenario};
use swarm_playground::soccer::FRAME;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn scenario(events: &Value) -> Result<Scenario, String> {
    let text = json!({"world": "soccer", "seed": 3, "half-seconds": 10, "events": events});
    Scenario::from_value(&text).map_err(|error| error.to_string())
}

fn run(events: &Value) -> Run {
    Run::new(scenario(events).expect("it is valid")).expect("it builds")
}

fn film() -> Film {
    Film::new(run(&json!([])), 1 << 20).expect("a match")
}

fn event(tick: u32, key: &str, value: &Value) -> Value {
    json!([{"tick": tick, "key": format!("soccer.{key}"), "value": value}])
}

/// Everybody far from everybody, with the ball before blue's third robot.
fn places() -> Value {
    json!({
        "ball": [0.3, 0.0],
        "blue": [[-0.7, 0.0, 0.0], [-0.3, 0.3, 0.0], [0.2, 0.0, 0.0]],
        "yellow": [[0.7, 0.3, 3.0], [0.1, -0.4, 3.0], [-0.2, -0.4, 3.0]],
    })
}

#[test]
fn a_film_has_a_frame_for_every_tick_and_ends_as_a_straight_run_does() {
    let mut film = film();
    while film.ahead(50) {
        film.look(film.front() / 2); // looking back changes nothing
    }
    let mut straight = run(&json!([]));
    straight.advance(100_000);
    assert_eq!(film.front(), straight.tick());
    assert_eq!(film.frames().len(), FRAME * (straight.tick() as usize + 1));
    assert_eq!(film.fingerprint(film.front()), straight.fingerprint());
    let last = &film.frames()[film.frames().len() - FRAME..];
    let outcome = straight.soccer().expect("a match").outcome();
    assert!((last[21] - (outcome.goals[0] + 256 * outcome.goals[1]) as f32).abs() < 0.5, "{outcome:?}");
}

#[test]
fn skipping_ends_as_filming_does() {
    let (mut filmed, mut skipped) = (film(), film());
    while filmed.ahead(500) {}
    while skipped.skip(500) {}
    assert_eq!(filmed.front(), skipped.front());
    assert_eq!(filmed.fingerprint(u32::MAX), skipped.fingerprint(u32::MAX));
}

#[test]
fn a_moment_shows_what_the_nodes_of_that_frame_returned() {
    let mut film = film();
    film.ahead(300);
    let first = film.look(0).expect("a match");
    assert!(first.teams[0].statuses.is_empty() && first.teams[1].guards.is_empty());
    let kicked_off = film.look(1).expect("a match");
    assert!(kicked_off.teams[0].call.contains(&"SUCCESS"), "the tree answered the call");
    let later = film.look(200).expect("a match");
    assert_eq!((later.tick, later.teams[0].coach, later.teams[1].coach), (200, "tree", "machine"));
    assert_eq!(later.teams[0].statuses[0], "SUCCESS");
    assert!(later.teams[0].call.is_empty(), "no call led to this tick");
    assert!(!later.teams[1].guards.is_empty() && later.teams[1].state.is_some());
    assert!(later.teams.iter().all(|team| team.roles.iter().all(|statuses| !statuses.is_empty())));
}

#[test]
fn what_is_done_by_hand_is_part_of_the_scenario() {
    for (key, value) in [
        ("arrangement", places()),
        ("restart", json!({"kind": "penalty-kick", "team": "yellow"})),
        ("restart", json!({"kind": "free-ball", "quadrant": 2})),
        ("drive", json!({"team": "blue", "robot": 2, "wheels": [20.0, 25.0]})),
    ] {
        let mut film = film();
        film.ahead(2_000);
        film.set(250, &format!("soccer.{key}"), &value).expect("it is allowed");
        assert_eq!(film.front(), 250, "what was later is cut off");
        while film.ahead(500) {}
        let mut again = run(&event(250, key, &value));
        again.advance(100_000);
        assert_eq!(film.run().scenario(), again.scenario());
        assert_eq!(film.fingerprint(u32::MAX), again.fingerprint(), "{key}");
        let mut without = run(&json!([]));
        without.advance(100_000);
        assert_ne!(again.fingerprint(), without.fingerprint(), "{key} changes the match");
    }
}

#[test]
fn places_are_shown_at_the_tick_at_which_they_are_taken() {
    let mut film = film();
    film.ahead(300);
    film.set(200, "soccer.arrangement", &places()).expect("it is allowed");
    let frame = &film.frames()[..FRAME];
    assert!((frame[6] - 0.2).abs() < 1e-6 && (frame[18] - 0.3).abs() < 1e-6, "{frame:?}");
    assert_eq!(film.arrangement(200)["blue"], places()["blue"]);
}

#[test]
fn what_is_not_moved_goes_on_as_it_did() {
    let mut fast = 0;
    for tick in [90, 150, 210, 330] {
        let mut film = film();
        film.ahead(tick);
        let mut there = film.arrangement(tick);
        there["blue"][0] = json!([-0.7, 0.1, 0.5]);
        let after = |events: &Value| {
            let mut run = run(events);
            run.advance(tick + 1);
            run.soccer().expect("a match").state().game().robots()
        };
        let (moved, left) = (after(&event(tick, "arrangement", &there)), after(&json!([])));
        for (robot, (one, other)) in moved.iter().zip(&left).enumerate().skip(1) {
            let apart = libm::hypot(one.velocity[0] - other.velocity[0], one.velocity[1] - other.velocity[1]);
            // The camera looks once more, so that commands differ a little; from rest a robot reaches 0.125 in a frame.
            assert!(apart < 0.05, "tick {tick}, robot {robot}: {one:?} and {other:?}");
            fast += u32::from(libm::hypot(other.velocity[0], other.velocity[1]) > 0.2);
        }
    }
    assert!(fast > 0, "some were moving");
}

#[test]
fn a_match_changed_by_hand_survives_being_written_down() {
    let mut film = film();
    film.ahead(600);
    for tick in [97, 250, 403] {
        let mut there = film.arrangement(tick);
        there["yellow"][2] = json!([0.1, 0.55, 1.234_567]);
        film.set(tick, "soccer.arrangement", &there).expect("it is allowed");
        film.ahead(600);
    }
    while film.ahead(500) {}
    let text = film.run().scenario().to_value().to_string();
    let mut again = Scenario::read(&text).and_then(Run::new).expect("it is valid");
    again.advance(100_000);
    assert_eq!(again.fingerprint(), film.fingerprint(u32::MAX));
}

#[test]
fn a_staged_penalty_is_called_and_logged() {
    let mut run = run(&event(100, "restart", &json!({"kind": "penalty-kick", "team": "blue"})));
    run.advance(101);
    let log = run.soccer().expect("a match").state().game().log();
    let staged =
        log.iter().find(|entry| entry.reason(["blue", "yellow"]) == "somebody asked for it").expect("it is logged");
    assert_eq!(
        staged.text(["blue", "yellow"]),
        "first half, 0:01.7: penalty kick for blue, because somebody asked for it"
    );
}

#[test]
fn a_driven_robot_does_what_it_is_told_until_it_is_given_back() {
    let told = json!([
        {"tick": 0, "key": "soccer.arrangement", "value": places()},
        {"tick": 0, "key": "soccer.drive", "value": {"team": "yellow", "robot": 1, "wheels": [-30.0, 30.0]}},
        {"tick": 60, "key": "soccer.drive", "value": null},
    ]);
    let mut run = run(&told);
    run.advance(50);
    let world = run.soccer().expect("a match");
    assert!(world.state().game().robots()[3].spin > 15.0, "it spins");
    run.advance(20);
    assert_eq!(run.soccer().expect("a match").state().driven(), None);
}

#[test]
fn what_cannot_be_done_is_refused_with_its_place() {
    let refused = |key: &str, value: &Value| scenario(&event(5, key, value)).expect_err("it is refused");
    let mut overlap = places();
    overlap["yellow"][0] = json!([-0.3, 0.32, 0.0]);
    assert_eq!(
        refused("arrangement", &overlap),
        "events[0].value: robot 2 of the left team: expected a place apart from robot 1 of the right team, found an overlap of 55.0 mm"
    );
    let mut off = places();
    off["ball"] = json!([0.3, 2.0]);
    assert!(
        refused("arrangement", &off).starts_with("events[0].value: the ball: expected a place on the pitch"),
        "{}",
        refused("arrangement", &off)
    );
    assert_eq!(
        refused("arrangement", &json!([1])),
        "events[0].value: expected an object with ball, blue and yellow, found a list"
    );
    assert_eq!(
        refused("restart", &json!({"kind": "penalty", "team": "blue"})),
        "events[0].value: expected one of kick-off, free-ball, goal-kick, penalty-kick, found \"penalty\""
    );
    assert_eq!(
        refused("restart", &json!({"kind": "free-ball", "quadrant": 5})),
        "events[0].value: expected a quadrant from 1 to 4, found 5"
    );
    assert_eq!(
        refused("restart", &json!({"kind": "goal-kick", "team": "red"})),
        "events[0].value: expected the team \"blue\" or \"yellow\", found \"red\""
    );
    assert_eq!(
        refused("drive", &json!({"team": "blue", "robot": 4, "wheels": [0, 0]})),
        "events[0].value: expected a robot from 1 to 3, found 4"
    );
    assert_eq!(
        refused("drive", &json!({"team": "blue", "robot": 1, "wheels": [0, 99]})),
        "events[0].value: expected wheels from -46 to 46 rad/s, found 99"
    );
    assert_eq!(refused("arrangment", &json!(1)), "events[0].key: unknown event, did you mean \"soccer.arrangement\"?");
    assert_eq!(
        refused("substeps", &json!(1)),
        "events[0].key: expected a parameter that can change during a run, found one that needs a restart"
    );
}

#[test]
fn a_film_of_another_world_is_refused() {
    let geese = Scenario::read(r#"{"world": "geese"}"#).and_then(Run::new).expect("it is valid");
    let error = Film::new(geese, 1 << 20).expect_err("it is no match");
    assert_eq!(error.to_string(), "world: expected \"soccer\", found \"geese\"");
}
