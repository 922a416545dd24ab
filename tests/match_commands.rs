//! The commands on matches as a user types them: `run`, `tournament`, `replay`.
#![cfg(all(not(target_arch = "wasm32"), feature = "cli"))]

use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// Runs the binary in the project's folder: status, standard output, standard error.
fn run(words: &str) -> (i32, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_swarm-playground"))
        .args(words.split(' '))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("it starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("it prints text").trim_end().to_owned();
    (output.status.code().expect("it ends"), text(output.stdout), text(output.stderr))
}

fn done(words: &str) -> String {
    let (status, output, error) = run(words);
    assert_eq!((status, error.as_str()), (0, ""), "{words}");
    output
}

fn refused(words: &str) -> String {
    let (status, output, error) = run(words);
    assert_eq!((status, output.as_str()), (2, ""), "{words}");
    error.strip_prefix("swarm-playground: ").unwrap_or(&error).to_owned()
}

fn fresh(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_file(&path);
    path
}

#[test]
fn a_match_prints_its_score_and_what_was_counted() {
    let line = done("run scenarios/match.json --set half-seconds=10");
    let found: Value = serde_json::from_str(&line).expect("it is JSON");
    let outcome = &found["outcome"];
    assert!(outcome["goals"].as_array().is_some_and(|goals| goals.len() == 2), "{line}");
    for team in ["blue", "yellow"] {
        for field in ["possession", "shots", "swaps", "group-changes", "calls", "violations", "faults"] {
            assert!(!outcome[team][field].is_null(), "{team}.{field} in {line}");
        }
    }
    assert_eq!((&found["steps"], found["fingerprint"].as_str().map(str::len)), (&Value::from(1200), Some(16)));
}

#[test]
fn a_tournament_is_the_same_with_any_number_of_jobs() {
    let play = |jobs: u32| {
        let file = fresh(&format!("tournament{jobs}.csv"));
        let words = "tournament --teams tree,chase,mine=trees/soccer/coach.xml --rounds 2 --set half-seconds=5";
        let printed = done(&format!("{words} --jobs {jobs} --out {}", file.display()));
        (printed, fs::read_to_string(file).expect("it was written"))
    };
    let (printed, csv) = play(1);
    assert_eq!(play(2), (printed.clone(), csv.clone()));
    assert!(printed.contains("| round | blue team | goals | | goals | yellow team |\n"), "{printed}");
    assert!(printed.contains("| Team | Pts | GP | Vic | Tie | Def | GS | GC | GD |\n"), "{printed}");
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let head = "game,round,seed,blue,yellow,goals_blue,goals_yellow,version,fingerprint";
    assert_eq!((lines.len(), lines[0].join(",")), (7, head.to_owned()));
    // Every match has a seed of its own, and in the second round the colours are exchanged.
    assert_eq!(lines[1][..5], ["0", "1", "1", "tree", "chase"]);
    assert_eq!(lines[4][..5], ["3", "2", "4", "chase", "tree"]);
    let goals: u32 =
        lines[1..].iter().flat_map(|line| &line[5..7]).map(|goals| goals.parse::<u32>().expect("goals")).sum();
    assert!(printed.contains(&format!("6 games of 3; goals scored {goals}, conceded {goals}.")), "{printed}");
}

#[test]
fn the_papers_tournament_is_printed_with_its_inconsistency() {
    let printed = done("tournament --teams chase,formation --set half-seconds=1 --paper");
    for line in [
        "| ThunderVolt | 15 | 6 | 5 | 1 | 32 | 3 | 29 |",
        "| Neon | 0 | x | 14 | ThunderVolt |",
        "goals scored sum to 227, goals conceded to 196",
    ] {
        assert!(printed.contains(line), "no \"{line}\" in\n{printed}");
    }
}

#[test]
fn teams_that_cannot_play_are_refused_before_the_first_match() {
    let all = "tree, machine, tree-without-swaps, machine-without-swaps, tree-double-margins, chase, formation";
    for (words, message) in [
        ("--teams tree,trees", format!("--teams: expected {all}, or NAME=FILE with a coach tree, found \"trees\"")),
        ("--teams tree,tree", "--teams: expected each team once, found \"tree\" twice".to_owned()),
        ("--teams tree", "--teams: expected 2 to 64 teams, found 1".to_owned()),
        ("scenarios/nest.json", "scenarios/nest.json: world: expected \"soccer\", found \"geese\"".to_owned()),
        ("--set half-secnds=3", "--half-secnds: unknown field, did you mean \"half-seconds\"?".to_owned()),
    ] {
        assert_eq!(refused(&format!("tournament {words}")), message);
    }
    assert!(refused("tournament --teams tree,mine=no.xml").starts_with("cannot read no.xml: "));
    let roles = refused("tournament --teams tree,mine=trees/soccer/roles.xml");
    assert!(roles.starts_with("team \"mine\": yellow-coach: coach, line "), "{roles}");
}

#[test]
fn a_replay_is_checked_by_playing_it_again() {
    let file = fresh("match.replay.json");
    let name = file.display();
    let words = format!("replay scenarios/match.json --seed 9 --set half-seconds=12 --out {name}");
    let told = done(&words);
    assert!(told.contains(" after 1440 ticks, fingerprint "), "{told}");
    assert_eq!(done(&format!("replay --check {name}")), format!("the same: {told}"));
    let text = fs::read_to_string(&file).expect("it was written");
    fs::write(&file, text.replacen("\"seed\":9", "\"seed\":10", 1)).expect("ours");
    let (status, output, error) = run(&format!("replay --check {name}"));
    assert_eq!((status, error.as_str()), (1, ""));
    let parted = format!("not the same: {name}: fingerprints[0]: the file has [600,\"");
    assert!(output.starts_with(&parted), "{output}");
    fs::write(&file, text.replacen("\"ticks\":1440", "\"ticks\":\"all\"", 1)).expect("ours");
    let message = format!("{name}: ticks: expected a whole number from 0 to 4294967295, found \"all\"");
    assert_eq!(refused(&format!("replay --check {name}")), message);
}
