//! The command line: runs scenarios, lists parameters, and checks the engine against cases files.

mod cli;

use clap::{Parser, Subcommand};
use cli::{Failure, print, read_file};
use serde_json::{Value, json};
use std::io::{Write, stderr};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;
use swarm_playground::bt::xml::{self, Manifest, Problem};
use swarm_playground::scenario::{WorldParams, schema};
use swarm_playground::workbench::{Setup, tick_headless};
use swarm_playground::{bt, evolution, sequencing};

/// Evolve, search for and coach the behaviour of groups of agents.
#[derive(Parser)]
#[command(version, max_term_width = 100)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a scenario and print its result as one line of JSON
    Run(cli::run::RunArguments),
    /// Print every parameter with its bounds, meaning and source, as JSON
    Schema,
    /// Run a file of cases against the engine: one line for each, then a summary
    Conform {
        #[command(subcommand)]
        what: Conform,
    },
    /// Check, format or draw behaviour trees in BehaviorTree.CPP's XML
    Tree {
        #[command(subcommand)]
        what: TreeCommand,
    },
    /// Measure the variants of the search for behaviour sequences
    Sequence {
        #[command(subcommand)]
        what: SequenceCommand,
    },
    /// Make the runs of a study; a run that was stopped goes on where it was
    Study(cli::study::StudyArguments),
    /// Print the report on the results of a study, as Markdown
    Report(cli::report::ReportArguments),
    /// Print which of a paper's claims the results bear out, as Markdown
    Reproduction(cli::report::ReproductionArguments),
    /// Measure the searches of studies and print the paper's seconds beside ours, as Markdown
    Times(cli::times::TimesArguments),
    /// Play matches everyone against everyone and print the games and the table, as Markdown
    Tournament(cli::tournament::TournamentArguments),
    /// Write a match down as a file that can be played again, or check such a file
    Replay(cli::replay::ReplayArguments),
    /// Put the results of a study's shards into one file, in the order of the runs
    Merge(cli::report::MergeArguments),
    /// Measure how fast a scenario runs and print the result as one line of JSON; a run that ends is followed by the next seed
    Bench {
        /// A scenario file
        scenario: PathBuf,
        /// Steps to run
        #[arg(long, default_value_t = 2000, value_parser = clap::value_parser!(u32).range(1..))]
        steps: u32,
        /// Seeds, from that of the scenario on, each for so many steps
        #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
        seeds: u32,
    },
}

#[derive(Subcommand)]
enum Conform {
    /// Mapping cases of grammatical evolution (schema ge-oracle/1)
    Evolution {
        /// The cases file
        file: PathBuf,
    },
    /// Behaviour-tree cases (schema bt-oracle/1)
    Bt {
        /// The cases file
        file: PathBuf,
    },
    /// Cases of the swarm model and of the planner of behaviour sequences
    Sequencing {
        /// The cases file
        file: PathBuf,
    },
}

#[derive(Subcommand)]
enum SequenceCommand {
    /// Print integrations, time and cost of each variant on generated layouts, as a Markdown table
    Bench(cli::sequence::BenchArguments),
    /// Print what the scenario's own search takes on generated layouts, as one line of JSON
    Measure(cli::sequence::MeasureArguments),
}

#[derive(Subcommand)]
enum TreeCommand {
    /// Say whether a file is valid, and every fault with its place
    Check {
        /// The XML file
        file: PathBuf,
    },
    /// Print the file in its canonical form
    Format {
        /// The XML file
        file: PathBuf,
    },
    /// Measure how fast the root is ticked and print the result as one line of JSON
    Bench {
        /// A setup of the workbench, saved by the page as JSON
        file: PathBuf,
        /// Ticks of the root
        #[arg(long, default_value_t = 2_000_000)]
        ticks: u32,
    },
    /// Print a drawing of the trees as SVG
    Svg {
        /// The XML file
        file: PathBuf,
    },
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Run(arguments) => cli::run::run(&arguments),
        Command::Schema => print(&format!("{:#}", schema())),
        Command::Conform { what } => conform(&what),
        Command::Tree { what } => tree(&what),
        Command::Sequence { what: SequenceCommand::Bench(arguments) } => cli::sequence::bench(&arguments),
        Command::Sequence { what: SequenceCommand::Measure(arguments) } => cli::sequence::measure_layouts(&arguments),
        Command::Study(arguments) => cli::study::study(&arguments),
        Command::Report(arguments) => cli::report::report(&arguments),
        Command::Reproduction(arguments) => cli::report::reproduction(&arguments),
        Command::Times(arguments) => cli::times::times(&arguments),
        Command::Tournament(arguments) => cli::tournament::tournament(&arguments),
        Command::Replay(arguments) => cli::replay::replay(&arguments),
        Command::Merge(arguments) => cli::report::merge(&arguments),
        Command::Bench { scenario, steps, seeds } => bench(&scenario, steps, seeds),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Cases) => ExitCode::from(1),
        Err(Failure::Input(message)) => {
            // Nothing can be done when standard error is gone too.
            let _ = writeln!(stderr(), "swarm-playground: {message}");
            ExitCode::from(2)
        }
    }
}

fn conform(what: &Conform) -> Result<(), Failure> {
    let (Conform::Evolution { file } | Conform::Bt { file } | Conform::Sequencing { file }) = what;
    let text = read_file(file)?;
    let mut skipped = Vec::new();
    let verdicts = match what {
        Conform::Evolution { .. } => evolution::Cases::read(&text).map(|cases| cases.run()),
        Conform::Bt { .. } => bt::Cases::read(&text).map(|cases| cases.run()),
        Conform::Sequencing { .. } => sequencing::Cases::read(&text).map(|cases| {
            skipped = cases.skipped();
            cases.run()
        }),
    };
    let verdicts = verdicts.map_err(|error| Failure::Input(format!("{}: {error}", file.display())))?;
    for verdict in &verdicts {
        match &verdict.fault {
            None => print(&format!("ok {}", verdict.id))?,
            Some(fault) => print(&format!("FAIL {}: {fault}", verdict.id))?,
        }
    }
    for reason in &skipped {
        print(&format!("skip {reason}"))?;
    }
    let failed = verdicts.iter().filter(|verdict| verdict.fault.is_some()).count();
    print(&format!("{} passed, {failed} failed", verdicts.len() - failed))?;
    if failed == 0 { Ok(()) } else { Err(Failure::Cases) }
}

fn tree(what: &TreeCommand) -> Result<(), Failure> {
    let file = match what {
        TreeCommand::Bench { file, ticks } => return bench_tree(file, *ticks),
        TreeCommand::Check { file } | TreeCommand::Format { file } | TreeCommand::Svg { file } => file,
    };
    let text = read_file(file)?;
    let manifest = Manifest::default();
    let place = |problem: &Problem| format!("{}: {problem}", file.display());
    let (document, warnings) = xml::read(&text, &manifest).map_err(|problems| {
        let lines: Vec<String> = problems.iter().map(place).collect();
        Failure::Input(lines.join("\nswarm-playground: "))
    })?;
    match what {
        TreeCommand::Svg { .. } => print(bt::draw_svg(&document).trim_end()),
        TreeCommand::Format { .. } => print(xml::write(&document, &manifest).trim_end()),
        TreeCommand::Check { .. } | TreeCommand::Bench { .. } => {
            for warning in &warnings {
                print(&format!("warning: {}", place(warning)))?;
            }
            let mut nodes = 0;
            document.each(&mut |_| nodes += 1);
            print(&format!("{}: valid, {nodes} nodes in {} trees", file.display(), document.trees.len()))
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "measuring time is what this command is for")]
fn bench_tree(file: &Path, ticks: u32) -> Result<(), Failure> {
    let in_file = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", file.display()));
    let value: Value = serde_json::from_str(&read_file(file)?).map_err(|error| in_file(&error))?;
    let setup = Setup::from_value(&value).map_err(|error| in_file(&error))?;
    let begun = Instant::now();
    let done = tick_headless(&setup, ticks).map_err(|problems| {
        let first = problems.iter().find(|problem| !problem.warning);
        in_file(&first.map(|problem| format!("xml, {problem}")).unwrap_or_default())
    })?;
    let seconds = begun.elapsed().as_secs_f64();
    let result = json!({
        "ticks": ticks,
        "completed": done.completed,
        "seconds": seconds,
        "ticks_per_second": f64::from(ticks) / seconds,
        "fingerprint": format!("{:016x}", done.fingerprint),
    });
    print(&result.to_string())
}

#[expect(clippy::disallowed_methods, reason = "measuring time is what this command is for")]
fn bench(path: &Path, steps: u32, seeds: u32) -> Result<(), Failure> {
    // Where the length of a run is no parameter, as in a match, a run that ends early is followed by the next seed.
    let is_set = cli::run::read_scenario(path, &[])?.to_value().get("steps").is_some();
    let length = is_set.then(|| Value::from(steps));
    let read = |seed| cli::run::read_run(path, &[("steps", length.clone()), ("seed", seed)]);
    let mut run = read(None)?;
    let agents = match &run.scenario().world {
        WorldParams::Geese(params) => params.agents,
        WorldParams::Sequencing(params) => params.robots,
        WorldParams::Soccer(_) => 6,
    };
    let (mut made, mut seconds, first) = (0, 0.0, run.scenario().seed.value());
    let (mut runs, all) = (0, steps.saturating_mul(seeds));
    loop {
        let begun = Instant::now();
        made += run.advance(steps.min(all - made));
        seconds += begun.elapsed().as_secs_f64();
        runs += 1;
        // A run without any step would never fill the time.
        if made >= all || run.tick() == 0 {
            break;
        }
        run = read(Some(Value::from(first + runs)))?;
    }
    let agent_steps = u64::from(made) * u64::from(agents);
    let result = json!({
        "world": run.scenario().world.name(),
        "seed": first,
        "runs": runs,
        "steps": made,
        "agent_steps": agent_steps,
        "seconds": seconds,
        "agent_steps_per_second": agent_steps as f64 / seconds,
        "fingerprint": format!("{:016x}", run.fingerprint()),
    });
    print(&result.to_string())
}
