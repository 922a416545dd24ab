//! `run`: one scenario from the first step to the last.

use super::{Failure, in_file, print, read_file};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value, json};
use std::fs::OpenOptions;
use std::io::{IsTerminal, Write, stderr};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use swarm_playground::scenario::{Run, Scenario, Start, WorldParams};

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
    let mut changes = changes(&arguments.set)?;
    let population = arguments.population.as_deref().map(read_file).transpose()?;
    changes.push(("population", population.map(Value::from)));
    changes.push(("seed", arguments.seed.map(Value::from)));
    changes.push(("steps", arguments.steps.map(Value::from)));
    let mut start = read_start(&arguments.scenario, &changes)?;
    let mut progress = Progress::new();
    // A world that plans is searched in slices of a few milliseconds.
    while !start.advance_on_threads(16) {
        progress.show_search(&start);
    }
    progress.clear();
    let mut run = start.run();
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

/// The parameters that options such as `--set KEY=VALUE` change.
pub fn changes(set: &[String]) -> Result<Vec<(&str, Option<Value>)>, Failure> {
    let mut changes = Vec::new();
    for change in set {
        let Some((key, value)) = change.split_once('=') else {
            return Err(Failure::Input(format!("--set: expected KEY=VALUE, found {change:?}")));
        };
        // A word that is no JSON is a text.
        changes.push((key, Some(serde_json::from_str(value).unwrap_or_else(|_| Value::from(value)))));
    }
    Ok(changes)
}

/// A run of a scenario file with some of its parameters changed; those without a value stay.
pub fn read_run(path: &Path, changes: &[(&str, Option<Value>)]) -> Result<Run, Failure> {
    Ok(read_start(path, changes)?.run())
}

/// As [`read_run`], before anything is planned.
fn read_start(path: &Path, changes: &[(&str, Option<Value>)]) -> Result<Start, Failure> {
    Run::start(read_scenario(path, changes)?).map_err(|error| in_file(path, &error))
}

/// A scenario file with some of its parameters changed; those without a value stay.
pub fn read_scenario(path: &Path, changes: &[(&str, Option<Value>)]) -> Result<Scenario, Failure> {
    let text = read_file(path)?;
    let mut scenario = Scenario::read(&text).map_err(|error| in_file(path, &error))?;
    for (option, value) in changes {
        if let Some(value) = value {
            scenario = scenario.with(option, value).map_err(|error| Failure::Input(format!("--{error}")))?;
        }
    }
    Ok(scenario)
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
        let steps = u64::from(run.scenario().world.steps());
        if let Some(bar) = self.bar(steps, "{bar:40} {pos}/{len} steps, {eta} left") {
            bar.set_position(u64::from(run.tick()));
        }
    }

    /// Shows how far a search is: of its budget, which it seldom needs, and what it found.
    fn show_search(&mut self, start: &Start) {
        let (WorldParams::Sequencing(params), Some(search)) = (&start.scenario().world, start.search()) else { return };
        let template = "{bar:40} {pos}/{len} integrations at most, {msg}";
        if let Some(bar) = self.bar(u64::from(params.budget), template) {
            bar.set_position(search.counts.integrated);
            let weight = search.weight;
            let found = search.cost.map_or_else(|| "no plan yet".to_owned(), |cost| format!("a plan of {cost:.0} m"));
            bar.set_message(format!("{found}, weight {weight}"));
        }
    }

    /// The bar, once it is time for one.
    fn bar(&mut self, length: u64, template: &str) -> Option<&ProgressBar> {
        if self.bar.is_none() && self.begun.elapsed() >= PATIENCE && stderr().is_terminal() {
            let bar = ProgressBar::new(length);
            if let Ok(style) = ProgressStyle::with_template(template) {
                bar.set_style(style);
            }
            self.bar = Some(bar);
        }
        self.bar.as_ref()
    }

    /// Takes the bar away; another may come.
    fn clear(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}
