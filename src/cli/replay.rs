//! `replay`: a match as a file, and whether such a file is what is played.

use super::study::replace;
use super::{Failure, in_file, print, read_file};
use clap::Args;
use serde_json::Value;
use std::path::{Path, PathBuf};
use swarm_playground::scenario::Replay;
use swarm_playground::study::VERSION;

/// Arguments of `replay`.
#[derive(Args)]
pub struct ReplayArguments {
    /// The scenario of a match, such as scenarios/match.json
    #[arg(required_unless_present = "check", requires = "out")]
    scenario: Option<PathBuf>,
    /// The file to write
    #[arg(long)]
    out: Option<PathBuf>,
    /// Use this seed in place of the scenario's (0 to 2^53 - 1)
    #[arg(long)]
    seed: Option<u64>,
    /// Set a parameter, such as soccer.half-seconds=60; may be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Play the match of this file again and say whether it is the same
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scenario", "out", "seed", "set"])]
    check: Option<PathBuf>,
}

/// Writes a match down, or checks one.
pub fn replay(arguments: &ReplayArguments) -> Result<(), Failure> {
    if let Some(path) = &arguments.check {
        return check(path);
    }
    let (Some(scenario), Some(out)) = (&arguments.scenario, &arguments.out) else {
        return Err(Failure::Input("expected a scenario and --out FILE, or --check FILE".to_owned()));
    };
    let mut changes = super::run::changes(&arguments.set)?;
    changes.push(("seed", arguments.seed.map(Value::from)));
    let replay = super::run::read_scenario(scenario, &changes)?;
    let replay = Replay::record(replay).map_err(|error| in_file(scenario, &error))?;
    replace(out, &format!("{}\n", replay.to_value()))?;
    print(&told(out, &replay))
}

fn check(path: &Path) -> Result<(), Failure> {
    let replay = Replay::read(&read_file(path)?).map_err(|error| in_file(path, &error))?;
    match replay.check().map_err(|error| in_file(path, &error))? {
        None => print(&format!("the same: {}", told(path, &replay))),
        Some(difference) => {
            print(&format!("not the same: {}: {difference}", path.display()))?;
            if replay.version != VERSION {
                print(&format!("It was played by version {}, this is {VERSION}.", replay.version))?;
            }
            Err(Failure::Cases)
        }
    }
}

fn told(path: &Path, replay: &Replay) -> String {
    let [blue, yellow] = replay.goals();
    let end = replay.marks.last().map(|(_, fingerprint)| format!("{fingerprint:016x}")).unwrap_or_default();
    format!("{}: {blue} to {yellow} after {} ticks, fingerprint {end}", path.display(), replay.ticks)
}
