//! Scenarios: what is read and refused, events, and going back in time.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use swarm_playground::scenario::{Run, Scenario, Timeline, schema};

fn read(value: &Value) -> Result<Scenario, String> {
    Scenario::read(&value.to_string()).map_err(|error| error.to_string())
}

fn refused(value: &Value) -> String {
    read(value).expect_err("it is refused")
}

#[test]
fn a_refusal_names_the_path_what_was_found_and_what_is_allowed() {
    let geese = |name: &str, value: Value| json!({"world": "geese", name: value});
    let cases = [
        (json!({}), "world: expected one of \"geese\", \"sequencing\", \"soccer\", found no such field"),
        (json!({"world": "ducks"}), "world: expected one of \"geese\", \"sequencing\", \"soccer\", found \"ducks\""),
        (json!([1]), "expected a scenario, an object with a field \"world\", found a list"),
        (geese("agents", json!(0)), "agents: expected a whole number from 1 to 10000 robots, found 0"),
        (geese("agents", json!(2.5)), "agents: expected a whole number from 1 to 10000 robots, found 2.5"),
        (geese("agents", json!("ten")), "agents: expected a whole number from 1 to 10000 robots, found \"ten\""),
        (geese("sense-radius", json!(-1)), "sense-radius: expected a number from 0.5 to 200 units, found -1"),
        (
            geese("swap-rule", json!("never")),
            "swap-rule: expected one of \"d-gt\", \"d-ge\", \"always\", found \"never\"",
        ),
        (geese("agnets", json!(3)), "agnets: unknown field, did you mean \"agents\"?"),
        (geese("wheels", json!(3)), "wheels: unknown field; `swarm-playground schema` lists all"),
        (geese("seed", json!(-4)), "seed: expected a whole number from 0 to 9007199254740991, found -4"),
        (
            geese("seed", json!(9_007_199_254_740_992_u64)),
            "seed: expected a whole number from 0 to 9007199254740991, found 9007199254740992",
        ),
        (geese("grammar", json!("<a> ::= <b>")), "grammar: line 1, column 9: expected a defined rule, found <b>"),
        (
            geese("max-depth", json!(8)),
            "max-depth: expected at least 9, the depth of the grammar's flattest program, found 8",
        ),
        (
            geese("codon-max", json!(200)),
            "codon-max: expected one less than a power of two (1, 3, 7 ... 65535) while mutation flips bits, found 200",
        ),
        (
            geese("site-distance", json!(45)),
            "site-distance: expected at most 40, so that a site of radius 10 lies inside the arena, found 45",
        ),
        (geese("title", json!(7)), "title: expected text, found 7"),
        (geese("events", json!({})), "events: expected a list of events, found an object"),
        (
            geese("events", json!([{"tick": 1, "key": "geese.agents", "value": 3}])),
            "events[0].key: expected a parameter that can change during a run, found one that needs a restart",
        ),
        (
            geese("events", json!([{"tick": 1, "key": "geese.children", "value": 0}])),
            "events[0].value: expected a whole number from 1 to 1000 genomes, found 0",
        ),
        (
            geese(
                "events",
                json!([{"tick": 9, "key": "geese.children", "value": 5}, {"tick": 8, "key": "geese.children", "value": 6}]),
            ),
            "events[1].tick: expected a whole number of at least 9, found 8",
        ),
        (
            geese("events", json!([{"tick": 1, "key": "geese.childern", "value": 0}])),
            "events[0].key: unknown parameter, did you mean \"geese.children\"?",
        ),
    ];
    for (scenario, message) in cases {
        assert_eq!(refused(&scenario), message);
    }
    let error = Scenario::read("{\"world\": \"geese\",\n \"seed\": }").expect_err("no JSON").to_string();
    assert_eq!(error, "expected a scenario as JSON: expected value at line 2 column 10");
}

#[test]
fn a_grammar_whose_genomes_hardly_ever_map_is_refused_when_the_world_is_built() {
    let scenario = read(&json!({"world": "geese", "genome-length": 8})).expect("each field is within its bounds");
    let error = Run::new(scenario).expect_err("eight codons are too few for any program").to_string();
    assert!(error.starts_with("grammar: expected a grammar of which random genomes give programs"), "{error}");
}

#[test]
fn a_scenario_survives_writing_and_reading() {
    let given = json!({"world": "geese", "title": "T", "seed": 77, "agents": 12, "mutation-mode": "codon",
        "events": [{"tick": 5, "key": "geese.children", "value": 7}]});
    let scenario = read(&given).expect("valid");
    let again = Scenario::from_value(&scenario.to_value()).expect("what was written is valid");
    assert_eq!(scenario, again);
}

#[test]
fn every_parameter_of_the_schema_is_a_field_with_a_valid_default() {
    let schema = schema();
    for world in ["geese", "sequencing"] {
        let all = read(&json!({ "world": world })).expect("the defaults are valid").to_value();
        let entries: Vec<(&str, &Value)> = (schema.as_array().expect("a list").iter())
            .filter_map(|entry| {
                let key = entry["key"].as_str().expect("a key");
                let name = if key == "seed" { key } else { key.strip_prefix(world)?.strip_prefix('.')? };
                Some((name, entry))
            })
            .collect();
        for (name, entry) in &entries {
            assert_eq!(all[name], entry["default"], "{world}.{name}");
            for text in ["label", "help", "source", "group"] {
                assert!(entry[text].as_str().is_some_and(|text| !text.is_empty()), "{world}.{name} lacks its {text}");
            }
            if let (Some(min), Some(max), Some(hard)) =
                (entry["min"].as_f64(), entry["max"].as_f64(), entry["hard_max"].as_f64())
            {
                let default = entry["default"].as_f64().expect("a number");
                assert!(min <= default && default <= max && max <= hard, "{world}.{name}");
            }
        }
        // And every field is in the schema: world, title, about and events belong to all worlds.
        assert_eq!(all.as_object().expect("an object").len(), entries.len() + 4);
    }
}

#[test]
fn a_plan_is_carried_out_tick_by_tick_and_can_be_sought_through() {
    let given = json!({"world": "sequencing", "seed": 4, "robots": 5, "decisions": 8, "target-x": -10, "target-y": -10,
        "obstacles": 0, "jitter-runs": 0});
    let scenario = read(&given).expect("valid");
    assert_eq!(Scenario::from_value(&scenario.to_value()), Ok(scenario.clone()));
    assert_eq!(scenario.world.steps(), 800);
    let mut run = Run::new(scenario.clone()).expect("it builds");
    let start = run.fingerprint();
    assert_eq!(run.advance(2000), 800);
    assert_eq!(run.finished(), Some("the plan was carried out"));
    let end = run.fingerprint();
    let outcome = serde_json::to_value(run.outcome()).expect("it is written");
    assert_eq!((&outcome["result"], &outcome["goal"]), (&json!("solved"), &json!(true)));
    let mut timeline = Timeline::new(Run::new(scenario).expect("it builds"), 1 << 20);
    for (tick, fingerprint) in [(800, Some(end)), (123, None), (0, Some(start)), (800, Some(end))] {
        assert_eq!(timeline.seek(tick, u32::MAX), tick);
        assert!(fingerprint.is_none_or(|fingerprint| fingerprint == timeline.run().fingerprint()), "tick {tick}");
    }
    let error = timeline.set("sequencing.weight", &json!(2)).expect_err("a plan is a plan").to_string();
    assert_eq!(
        error,
        "sequencing.weight: expected a parameter that can change during a run, found one that needs a restart"
    );
    let error = timeline.set("sequencing.q", &json!(2)).expect_err("no such").to_string();
    assert_eq!(error, "sequencing.q: unknown parameter; nothing of this world can change during a run");
}

fn timeline(budget: usize) -> Timeline {
    let scenario = read(&json!({"world": "geese", "seed": 3, "agents": 40, "swap-rule": "always"})).expect("valid");
    Timeline::new(Run::new(scenario).expect("it builds"), budget)
}

#[test]
fn seeking_in_any_order_finds_what_a_straight_run_finds() {
    let mut straight = timeline(usize::MAX);
    let mut expected = vec![straight.run().fingerprint()];
    for _ in 0..600 {
        straight.run_mut().advance(1);
        expected.push(straight.run().fingerprint());
    }
    // Memory for very few keyframes, so that they are thinned out again and again.
    for budget in [usize::MAX, 400_000, 0] {
        let mut timeline = timeline(budget);
        for tick in [600, 37, 128, 0, 599, 64, 65, 63, 300, 301, 1] {
            let mut reached = timeline.run().tick();
            while reached != tick {
                reached = timeline.seek(tick, 50);
            }
            assert_eq!(timeline.run().fingerprint(), expected[tick as usize], "tick {tick}, budget {budget}");
        }
    }
}

#[test]
fn a_live_change_becomes_an_event_that_replays() {
    let mut live = timeline(usize::MAX);
    live.run_mut().advance(40);
    live.keyframe();
    live.set("geese.mutation-probability", &json!(0.3)).expect("a live parameter");
    live.set("geese.mutation-probability", &json!(0.2)).expect("a live parameter");
    live.set("geese.children", &json!(5)).expect("a live parameter");
    live.run_mut().advance(60);
    let after = live.run().fingerprint();
    let events = &live.run().scenario().events;
    assert_eq!(events.len(), 2, "the last word in one tick counts");

    let written = live.run().scenario().to_value();
    let mut replay = Run::new(Scenario::from_value(&written).expect("valid")).expect("it builds");
    replay.advance(100);
    assert_eq!(replay.fingerprint(), after);

    while live.seek(20, 1000) != 20 {}
    while live.seek(100, 1000) != 100 {}
    assert_eq!(live.run().fingerprint(), after, "seeking back over the change keeps it");

    while live.seek(30, 1000) != 30 {}
    live.set("geese.children", &json!(9)).expect("a live parameter");
    assert_eq!(live.run().scenario().events.len(), 1, "a change in the past drops what was later");
    let fault = live.set("geese.mutation-mode", &json!("bit")).and_then(|()| live.set("geese.children", &json!(0)));
    assert!(
        fault.expect_err("no brood of 0").message.starts_with("expected a whole number from 1"),
        "bounds hold live"
    );
    live.set("geese.children", &json!(9)).expect("a live parameter");
    assert_eq!(live.set("geese.agents", &json!(9)).expect_err("it needs a restart").path, "geese.agents");
    assert_eq!(live.run().scenario().events.len(), 2);
}

#[test]
fn a_live_change_that_does_not_fit_the_rest_is_refused() {
    let scenario = json!({"world": "geese", "mutation-mode": "codon", "codon-max": 200});
    let mut run = Run::new(read(&scenario).expect("valid")).expect("it builds");
    let error = run.set("geese.mutation-mode", &json!("bit")).expect_err("200 is no power of two less one");
    assert_eq!(error.path, "codon-max");
    assert!(run.scenario().events.is_empty());
}

#[test]
fn events_change_the_run() {
    let run = |events: Value| {
        let scenario = json!({"world": "geese", "agents": 40, "swap-rule": "always", "events": events});
        let mut run = Run::new(read(&scenario).expect("valid")).expect("it builds");
        run.advance(30);
        run.fingerprint()
    };
    let plain = run(json!([]));
    assert_ne!(plain, run(json!([{"tick": 10, "key": "geese.children", "value": 2}])));
    assert_eq!(plain, run(json!([{"tick": 30, "key": "geese.children", "value": 2}])), "it comes with the next step");
}
