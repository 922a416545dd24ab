//! Matches written down and played again.

use serde_json::{Value, json};
use swarm_playground::scenario::{Replay, Run, Scenario};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

fn scenario() -> Scenario {
    let value = json!({"world": "soccer", "seed": 5, "half-seconds": 15, "yellow": "chase", "sides-exchanged": true});
    Scenario::from_value(&value).expect("it is valid")
}

/// A change of a file, and what is said of it.
type Case<'a> = (&'a dyn Fn(&mut Value), &'a str);

/// The file as text and back, as a user has it.
fn file() -> Value {
    let text = Replay::record(scenario()).expect("it is a match").to_value().to_string();
    serde_json::from_str(&text).expect("it is JSON")
}

#[test]
fn a_match_that_was_written_down_is_the_match_that_runs() {
    let replay = Replay::read(&file().to_string()).expect("it is a match");
    let mut run = Run::new(scenario()).expect("it builds");
    run.advance(u32::MAX);
    assert_eq!(replay.scenario, scenario());
    assert_eq!(replay.marks.last(), Some(&(1800, run.fingerprint())));
    assert_eq!(replay.marks.iter().map(|mark| mark.0).collect::<Vec<_>>(), [600, 1200, 1800]);
    assert_eq!(replay.goals(), run.soccer().expect("a match").outcome().goals.map(u64::from));
    assert_eq!(replay.check().expect("it builds"), None);
}

#[test]
fn calls_stand_with_their_reasons_and_teams_by_colour() {
    let file = file();
    let first = &file["calls"][0];
    assert_eq!((&first["tick"], &first["command"], &first["rule"]), (&json!(0), &json!("kick-off"), &json!("coin")));
    let team = first["team"].as_str().expect("somebody kicks off");
    let text = format!("first half, 0:00.0: kick-off for {team}, because the coin gave it the first kick-off");
    assert_eq!(first["text"], json!(text));
    let commands: Vec<&Value> = file["calls"].as_array().expect("a list").iter().map(|call| &call["command"]).collect();
    assert!(!commands.contains(&&json!("stop")) && commands.last() == Some(&&json!("halt")), "{commands:?}");
    let event = &file["events"][0];
    assert!(event["text"].as_str().is_some_and(|text| text.starts_with("call 1: starts as ")), "{event}");
}

#[test]
fn whatever_is_changed_in_the_file_is_found_at_its_place() {
    let differs = |pointer: &str, value: Value| {
        let mut file = file();
        *file.pointer_mut(pointer).expect("it is there") = value;
        let replay = Replay::read(&file.to_string()).unwrap_or_else(|error| panic!("{pointer}: {error}"));
        replay.check().expect("it builds").expect("it differs").path
    };
    assert_eq!(differs("/fingerprints/1/1", json!("0123456789abcdef")), "fingerprints[1]");
    assert_eq!(differs("/scenario/seed", json!(6)), "fingerprints[0]");
    assert_eq!(differs("/outcome/goals/0", json!(99)), "outcome.goals");
    assert_eq!(differs("/calls/0/text", json!("no reason")), "calls[0].text");
    assert_eq!(differs("/events/0/tick", json!(7)), "events[0].tick");
    let mut longer = file();
    longer["calls"].as_array_mut().expect("a list").push(json!({}));
    let found =
        Replay::read(&longer.to_string()).expect("well formed").check().expect("it builds").expect("it differs");
    let count = file()["calls"].as_array().expect("a list").len();
    let text = format!("calls: the file has {} entries, played again it is {count} entries", count + 1);
    assert_eq!(found.to_string(), text);
}

#[test]
fn a_file_that_is_no_match_is_refused_with_its_place() {
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut value = file();
        change(&mut value);
        Replay::read(&value.to_string()).expect_err("it is refused").to_string()
    };
    let cases: [Case; 12] = [
        (&|file| *file = json!([]), "expected a match, an object with a field \"format\", found a list"),
        (&|file| file["format"] = json!(2), "format: expected \"swarm-playground-match/1\", found 2"),
        (&|file| file["cals"] = json!([]), "cals: unknown field, did you mean \"calls\"?"),
        (
            &|file| drop(file.as_object_mut().map(|all| all.remove("calls"))),
            "calls: expected this field, found no such one",
        ),
        (
            &|file| file["scenario"]["substeps"] = json!(0),
            "scenario.substeps: expected a whole number from 1 to 32 substeps, found 0",
        ),
        (&|file| file["scenario"] = json!({"world": "geese"}), "scenario.world: expected \"soccer\", found \"geese\""),
        (&|file| file["version"] = json!(1), "version: expected text, found 1"),
        (&|file| file["ticks"] = json!(-1), "ticks: expected a whole number from 0 to 4294967295, found -1"),
        (&|file| file["fingerprints"] = json!([]), "fingerprints: expected at least that of the end, found none"),
        (&|file| file["ticks"] = json!(1900), "fingerprints: expected the last one at tick 1900, found 1800"),
        (
            &|file| file["fingerprints"][1] = json!([500, "0123456789abcdef"]),
            "fingerprints[1][0]: expected a tick from 601 to 1800, found 500",
        ),
        (
            &|file| file["fingerprints"][0][1] = json!("0x"),
            "fingerprints[0][1]: expected 16 hexadecimal digits, found \"0x\"",
        ),
    ];
    for (change, message) in cases {
        assert_eq!(refused(change), message);
    }
    let cut = Replay::read("{\"format\": ").expect_err("it is cut").to_string();
    assert!(cut.starts_with("expected a match as JSON: ") && cut.contains("line 1"), "{cut}");
    let geese = Scenario::read(r#"{"world": "geese", "agents": 2, "steps": 1}"#).expect("valid");
    assert_eq!(Replay::record(geese).expect_err("no match").to_string(), "world: expected \"soccer\", found \"geese\"");
}
