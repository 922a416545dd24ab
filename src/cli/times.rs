//! `times`: how long the searches of studies take, beside what the paper's took.

use super::sequence::{cpu, median};
use super::study::read_study;
use super::{Failure, in_file, print};
use clap::Args;
use std::path::{Path, PathBuf};
use swarm_playground::scenario::Run;
use swarm_playground::study::{PaperSeconds, Study, VERSION};

/// Arguments of `times`.
#[derive(Args)]
pub struct TimesArguments {
    /// Study files with the seconds of a paper, such as studies/navigation.json
    #[arg(required = true)]
    studies: Vec<PathBuf>,
}

const ABOUT: &str = "Seconds of one thread on the processor for the search alone, without drawing the layout and without \
    carrying the plan out; one run of each layout. They are this machine's, and other work on it moves them by a third or more, \
    so they stand in no results file and no claim rests on them: integrations are the same everywhere. The two machines are \
    years apart, and the paper's program is not known; what can be compared is how times go with robots and weight.";

/// Measures every run of the studies and prints a table for each.
pub fn times(arguments: &TimesArguments) -> Result<(), Failure> {
    print("# Times of the search beside the paper's\n")?;
    print(&format!("{ABOUT}\n"))?;
    print(&format!("Ours: {}, version {VERSION}.", processor()))?;
    for path in &arguments.studies {
        let study = read_study(path, None)?;
        let Some(seconds) = &study.seconds else {
            return Err(in_file(path, &"seconds: expected the paper's seconds, found no such field"));
        };
        print(&format!("\n## {}\n\nThe paper's: {}.\n", study.title, seconds.machine))?;
        print("| cell | layouts | paper, s | ours, median, s | mean | range | integrations, median | mean |")?;
        print("|---|---:|---:|---:|---:|---:|---:|---:|")?;
        for cell in 0..study.cells.len() {
            print(&row(&study, seconds, cell, path)?)?;
        }
    }
    let files: Vec<String> = arguments.studies.iter().map(|path| path.display().to_string()).collect();
    print(&format!("\nThis document: `cargo run --release -- times {}`.", files.join(" ")))
}

fn row(study: &Study, paper: &PaperSeconds, cell: usize, path: &Path) -> Result<String, Failure> {
    let (mut seconds, mut integrations) = (Vec::new(), Vec::new());
    for number in 0..study.seeds {
        let scenario = study.cells[cell].scenario_of(study.first_seed + u64::from(number));
        let mut start = Run::start(scenario).map_err(|error| in_file(path, &error))?;
        let begun = cpu();
        while !start.advance(u32::MAX) {}
        seconds.push(cpu() - begun);
        let Some(progress) = start.search() else {
            return Err(in_file(path, &"scenario: expected a world that plans"));
        };
        integrations.push(progress.counts.integrated as f64);
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let least = seconds.iter().copied().fold(f64::INFINITY, f64::min);
    let most = seconds.iter().copied().fold(0.0, f64::max);
    let published = paper.cells.iter().find(|(own, _)| *own == cell).map(|(_, seconds)| seconds.to_string());
    Ok(format!(
        "| {} | {} | {} | {:.4} | {:.4} | {least:.4} to {most:.4} | {} | {:.0} |",
        study.cells[cell].name,
        study.seeds,
        published.unwrap_or_default(),
        median(seconds.clone()),
        mean(&seconds),
        median(integrations.clone()),
        mean(&integrations),
    ))
}

/// The processor's name, where the system tells.
fn processor() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told.lines().find(|line| line.starts_with("model name")).and_then(|line| line.split_once(": "));
    name.map_or_else(|| "a processor that the system does not name".to_owned(), |(_, name)| name.trim().to_owned())
}
