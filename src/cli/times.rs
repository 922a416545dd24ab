//! `times`: how long the searches of studies take, beside what the paper's took.

use super::sequence::{cpu, median};
use super::study::read_study;
use super::{Failure, in_file, print};
use clap::Args;
use std::path::{Path, PathBuf};
use swarm_playground::scenario::{Run, Start};
use swarm_playground::study::{PaperSeconds, Study, VERSION};

/// Arguments of `times`.
#[derive(Args)]
pub struct TimesArguments {
    /// Study files with the seconds of a paper, such as studies/navigation.json
    #[arg(required = true)]
    studies: Vec<PathBuf>,
}

/// Seconds after which a search need not be made again to know how long it takes.
const ENOUGH: f64 = 0.2;
const ABOUT: &str = "Seconds of one thread on the processor for the search alone, without drawing the layout and without \
    carrying the plan out; short searches are made again until a fifth of a second is full. They are this machine's, and other work on it moves them by a third or more, \
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
        let start = Run::start(scenario).map_err(|error| in_file(path, &error))?;
        let (took, counted) = measure(&start).ok_or_else(|| in_file(path, &"scenario: expected a world that plans"))?;
        seconds.push(took);
        integrations.push(counted);
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

/// Seconds and integrations of a search; `None` where nothing is searched for.
fn measure(start: &Start) -> Option<(f64, f64)> {
    start.search()?;
    let (begun, mut times) = (cpu(), 0.0);
    loop {
        let mut again = start.clone();
        while !again.advance(u32::MAX) {}
        times += 1.0;
        let took = cpu() - begun;
        // Some systems count the processor's time in steps of milliseconds.
        if took >= ENOUGH {
            return Some((took / times, again.search()?.counts.integrated as f64));
        }
    }
}

/// The processor's name and pace, where the system tells.
fn processor() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| told.lines().find(|line| line.starts_with(name))?.split_once(": ").map(|(_, value)| value);
    let Some(name) = field("model name") else { return "a processor that the system does not name".to_owned() };
    let pace = field("cpu MHz").and_then(|pace| pace.trim().parse::<f64>().ok());
    let pace = pace.map(|pace| format!(", {:.1} GHz", pace / 1000.0)).unwrap_or_default();
    format!("{}{pace}", name.trim())
}
