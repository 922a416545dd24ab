//! The study command: however many runs go on at once, in however many parts, killed or not, the file is the same.
#![cfg(all(not(target_arch = "wasm32"), feature = "cli"))]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// An empty folder of the test's own, below the one that cargo keeps for tests.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("study_command_{name}"));
    let _ = fs::remove_dir_all(&folder);
    for below in ["scenarios", "studies"] {
        fs::create_dir_all(folder.join(below)).expect("the folder is ours");
    }
    fs::write(folder.join("scenarios/small.json"), r#"{"world": "geese", "agents": 8, "steps": 30}"#).expect("written");
    fs::write(folder.join("studies/small.json"), include_str!("cases/small_study.json")).expect("written");
    folder
}

fn command(folder: &Path, words: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_swarm-playground"));
    command.current_dir(folder).args(words.split(' ')).stdin(Stdio::null());
    command
}

fn done(folder: &Path, words: &str) -> String {
    let Output { status, stdout, stderr } = command(folder, words).output().expect("it starts");
    assert!(status.success(), "{words}: {}", String::from_utf8_lossy(&stderr));
    String::from_utf8(stdout).expect("text")
}

fn refused(folder: &Path, words: &str) -> String {
    let Output { status, stderr, .. } = command(folder, words).output().expect("it starts");
    assert_eq!(status.code(), Some(2), "{words}");
    String::from_utf8(stderr).expect("text").trim_end().to_owned()
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).expect("it is there")
}

#[test]
fn any_number_of_jobs_and_parts_gives_the_same_bytes() {
    let folder = folder("jobs");
    let said = done(&folder, "study studies/small.json --jobs 1 --out one.csv");
    assert_eq!(said, "one.csv: 12 new runs, 12 of 12 are there\n");
    let one = read(&folder, "one.csv");
    assert_eq!(one.lines().count(), 13);
    for jobs in ["2", "3"] {
        done(&folder, &format!("study studies/small.json --jobs {jobs} --out jobs{jobs}.csv"));
        assert_eq!(read(&folder, &format!("jobs{jobs}.csv")), one, "{jobs} jobs");
    }
    for part in ["1", "2", "3"] {
        done(&folder, &format!("study studies/small.json --jobs 2 --shard {part}/3 --out part{part}.csv"));
    }
    let parts = ["3", "1", "2"].map(|part| read(&folder, &format!("part{part}.csv")));
    assert!(parts.iter().all(|part| part.lines().count() == 5));
    done(&folder, "merge part2.csv part1.csv part3.csv --out merged.csv");
    assert_eq!(read(&folder, "merged.csv"), one);
    fs::write(folder.join("together.csv"), parts.concat()).expect("written");
    done(&folder, "merge together.csv --study studies/small.json --out merged2.csv");
    assert_eq!(read(&folder, "merged2.csv"), one);
    // Fewer seeds first, then all: the same study goes on.
    done(&folder, "study studies/small.json --seeds 1 --out grown.csv");
    assert_eq!(
        done(&folder, "study studies/small.json --out grown.csv"),
        "grown.csv: 8 new runs, 12 of 12 are there\n"
    );
    assert_eq!(read(&folder, "grown.csv"), one);
}

#[test]
fn killed_and_started_again_it_ends_with_the_same_bytes() {
    let folder = folder("kill");
    // Long enough to be killed on the way.
    let long = read(&folder, "studies/small.json").replacen("\"seeds\"", "\"steps\": 2000, \"seeds\"", 1);
    fs::write(folder.join("studies/long.json"), long).expect("written");
    done(&folder, "study studies/long.json --jobs 2 --out whole.csv");
    let whole = read(&folder, "whole.csv");
    let mut lines = 0;
    for jobs in [2, 3, 1] {
        let words = format!("study studies/long.json --jobs {jobs} --out killed.csv");
        let mut child = command(&folder, &words).stdout(Stdio::null()).spawn().expect("it starts");
        // Until a further row is there, or all are.
        let more = loop {
            let now = fs::read_to_string(folder.join("killed.csv")).unwrap_or_default().matches('\n').count();
            if now > lines + 1 || child.try_wait().expect("ours").is_some() {
                break now;
            }
            std::thread::yield_now();
        };
        child.kill().expect("ours");
        child.wait().expect("ours");
        assert!(more >= lines, "no row is lost");
        lines = more;
        // As if the kill had come in the middle of a row.
        let mut text = read(&folder, "killed.csv");
        text += "11,\"b, \"\"quo";
        fs::write(folder.join("killed.csv"), text).expect("written");
    }
    done(&folder, "study studies/long.json --jobs 2 --out killed.csv");
    assert_eq!(read(&folder, "killed.csv"), whole);
}

#[test]
fn nothing_is_overwritten() {
    let folder = folder("overwrite");
    fs::write(folder.join("notes.csv"), "my notes\n").expect("written");
    let said = refused(&folder, "study studies/small.json --out notes.csv");
    let expected = "notes.csv: line 1, column 1: expected the column \"run\", found \"my notes\"";
    assert_eq!(said, format!("swarm-playground: {expected}"));
    assert_eq!(read(&folder, "notes.csv"), "my notes\n");

    done(&folder, "study studies/small.json --size glance --out small.csv");
    let before = read(&folder, "small.csv");
    let said = refused(&folder, "study studies/small.json --out small.csv");
    assert_eq!(
        said,
        "swarm-playground: small.study.json: expected the study of these results, found another file; it is left alone"
    );
    fs::remove_file(folder.join("small.study.json")).expect("ours");
    let said = refused(&folder, "study studies/small.json --out small.csv");
    assert!(said.contains("small.csv: line 2, column 67: expected results of the study with hash "), "{said}");
    assert!(refused(&folder, "report small.csv").contains("expected its study beside it in small.study.json"));
    assert_eq!(read(&folder, "small.csv"), before);
    assert!(refused(&folder, "merge small.csv --study studies/small.json --out small.csv").contains("cannot write"));
    assert_eq!(read(&folder, "small.csv"), before);
}

#[test]
fn a_file_that_another_process_writes_is_left_to_it() {
    let folder = folder("lock");
    let file = fs::File::create(folder.join("small.csv")).expect("ours");
    file.try_lock().expect("nobody else has it");
    let said = refused(&folder, "study studies/small.json --out small.csv");
    assert_eq!(said, "swarm-playground: small.csv: another process is writing this file");
}

#[test]
fn a_shard_that_would_have_no_seed_is_refused() {
    let folder = folder("shard");
    let said = refused(&folder, "study studies/small.json --shard 4/4 --out a.csv");
    assert_eq!(said, "swarm-playground: --shard: expected at most 3 parts, one for each seed, found 4");
    assert!(refused(&folder, "study studies/small.json --shard 0/4 --out a.csv").contains("such as 2/3"));
    assert!(!folder.join("a.csv").exists());
}
