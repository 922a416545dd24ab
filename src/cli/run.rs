//! `run`: one scenario from the first step to the last.

use super::{Failure, in_file, print, read_file};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value, json};
use std::fs::OpenOptions;
use std::io::{IsTerminal, Write, stderr};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use swarm_playground::scenario::{Run, Scenario};

/// What `run` takes.
#[derive(clap::Args)]
pub struct RunArguments {
    /// A scenario file, such as scenarios/foraging.json
    scenario: PathBuf,
    /// Use this seed in place of the scenario's (0 to 2^53 - 1)
    #[arg(long)]
    seed: Option<u64>,
    /// Stop after this many steps in place of the scenario's
    #[arg(long)]
    steps: Option<u32>,
    /// Set a parameter, such as geese.max-depth=11; may be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Start with the programs of this population file
    #[arg(long, value_name = "FILE")]
    population: Option<PathBuf>,
    /// Write the programs at the end to a new population file
    #[arg(long, value_name = "FILE")]
    save_population: Option<PathBuf>,
}

/// Runs a scenario and prints its result.
pub fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let mut changes = Vec::new();
    for change in &arguments.set {
        let Some((key, value)) = change.split_once('=') else {
            return Err(Failure::Input(format!("--set: expected KEY=VALUE, found {change:?}")));
        };
        // A word that is no JSON is a text.
        changes.push((key, Some(serde_json::from_str(value).unwrap_or_else(|_| Value::from(value)))));
    }
    let population = arguments.population.as_deref().map(read_file).transpose()?;
    changes.push(("population", population.map(Value::from)));
    changes.push(("seed", arguments.seed.map(Value::from)));
    changes.push(("steps", arguments.steps.map(Value::from)));
    let mut run = read_run(&arguments.scenario, &changes)?;
    let mut progress = Progress::new();
    while run.advance(20) == 20 {
        progress.show(&run);
    }
    progress.clear();
    if let (Some(path), Some(population)) = (&arguments.save_population, run.population()) {
        let created = OpenOptions::new().write(true).create_new(true).open(path);
        let written = created.and_then(|mut file| file.write_all(population.as_bytes()));
        written.map_err(|error| in_file(path, &format!("cannot be written: {error}")))?;
    }
    let result = json!({
        "world": run.scenario().world.name(),
        "seed": run.scenario().seed.value(),
        "steps": run.tick(),
        "outcome": run.outcome(),
        "fingerprint": format!("{:016x}", run.fingerprint()),
        "version": env!("CARGO_PKG_VERSION"),
    });
    print(&result.to_string())
}

/// A run of a scenario file with some of its parameters changed; those without a value stay.
pub fn read_run(path: &Path, changes: &[(&str, Option<Value>)]) -> Result<Run, Failure> {
    let text = read_file(path)?;
    let mut scenario = Scenario::read(&text).map_err(|error| in_file(path, &error))?;
    for (option, value) in changes {
        if let Some(value) = value {
            scenario = scenario.with(option, value).map_err(|error| Failure::Input(format!("--{error}")))?;
        }
    }
    Run::new(scenario).map_err(|error| in_file(path, &error))
}

/// A progress bar on a terminal, for what takes more than two seconds.
struct Progress {
    begun: Instant,
    bar: Option<ProgressBar>,
}

const PATIENCE: Duration = Duration::from_secs(2);

impl Progress {
    #[expect(clippy::disallowed_methods, reason = "the clock decides only whether a progress bar is shown")]
    fn new() -> Self {
        Self { begun: Instant::now(), bar: None }
    }

    fn show(&mut self, run: &Run) {
        if self.bar.is_none() {
            if self.begun.elapsed() < PATIENCE || !stderr().is_terminal() {
                return;
            }
            let bar = ProgressBar::new(u64::from(run.scenario().world.steps()));
            if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} steps, {eta} left") {
                bar.set_style(style);
            }
            self.bar = Some(bar);
        }
        if let Some(bar) = &self.bar {
            bar.set_position(u64::from(run.tick()));
        }
    }

    fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
