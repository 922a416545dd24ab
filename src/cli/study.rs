//! `study`: makes the runs of a study on several processors and writes their rows as they end.

use super::{Failure, in_file, print, read_file};
use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::iter::{ParallelBridge, ParallelIterator};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{IsTerminal, Read, Seek, Write, stderr};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use swarm_playground::study::{Results, Row, Size, Study};

/// Arguments of `study`.
#[derive(Args)]
pub struct StudyArguments {
    /// A study file, such as studies/success.json
    study: PathBuf,
    /// The results file; one of the same study is continued, any other is left alone
    #[arg(long)]
    out: PathBuf,
    /// Runs that go on at once [default: one for each processor]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// How much to run
    #[arg(long, default_value = "paper")]
    size: SizeArgument,
    /// Seeds for each cell in place of those of the size
    #[arg(long)]
    seeds: Option<u32>,
    /// Make only part I of N, such as 2/3; every part has all cells, with some of the seeds
    #[arg(long, value_parser = shard)]
    shard: Option<(u32, u32)>,
    /// The folder with the presets [default: scenarios beside the study's folder]
    #[arg(long)]
    scenarios: Option<PathBuf>,
}

/// The sizes of a study.
#[derive(Clone, Copy, ValueEnum)]
enum SizeArgument {
    Glance,
    Class,
    Paper,
}

fn shard(text: &str) -> Result<(u32, u32), String> {
    let parts = text.split_once('/').and_then(|(part, all)| Some((part.parse().ok()?, all.parse().ok()?)));
    let parts = parts.filter(|(part, all)| (1..=*all).contains(part));
    parts.ok_or_else(|| "expected a part and the number of parts, such as 2/3".to_owned())
}

/// Makes the runs that the results file does not have yet.
pub fn study(arguments: &StudyArguments) -> Result<(), Failure> {
    let study = read_study(&arguments.study, arguments.scenarios.as_deref())?;
    let size = match arguments.size {
        SizeArgument::Glance => Size::Glance,
        SizeArgument::Class => Size::Class,
        SizeArgument::Paper => Size::Paper,
    };
    let mut study = study.sized(size).map_err(|error| in_file(&arguments.study, &error))?;
    if let Some(seeds) = arguments.seeds {
        study = study.with_seeds(seeds).map_err(|error| Failure::Input(format!("--seeds: {}", error.message)))?;
    }
    let (part, parts) = arguments.shard.unwrap_or((1, 1));
    if parts > study.seeds {
        let message = format!("--shard: expected at most {} parts, one for each seed, found {parts}", study.seeds);
        return Err(Failure::Input(message));
    }
    let out = &arguments.out;
    check_spec(out, &study)?;
    let (mut file, mut results) = open(out, &study)?;
    let cells = study.cells.len() as u32;
    let runs: Vec<u32> = results.missing().into_iter().filter(|run| run / cells % parts == part - 1).collect();
    write_spec(out, &study)?;

    let bar = progress(runs.len());
    let threads = rayon::ThreadPoolBuilder::new().num_threads(arguments.jobs.map_or(0, usize::from)).build();
    let threads = threads.map_err(|error| Failure::Input(format!("--jobs: {error}")))?;
    let shared = Mutex::new((&mut file, &mut results, true));
    // A bridge hands the runs out in their order, so that results that were stopped are balanced.
    let written = threads.install(|| {
        runs.iter().par_bridge().try_for_each(|&run| {
            let row = study.make(run);
            let mut guard = shared.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            let (file, results, is_whole) = &mut *guard;
            // After a write that failed half way another row would end up in the middle of a line.
            if *is_whole {
                *is_whole = false;
                write_row(file, results, row)?;
                *is_whole = true;
            }
            bar.inc(1);
            Ok(())
        })
    });
    bar.finish_and_clear();
    written.map_err(|error: std::io::Error| in_file(out, &format!("cannot write: {error}")))?;
    finish(out, &mut file, &results)?;
    let all = results.rows().count();
    print(&format!("{}: {} new runs, {all} of {} are there", out.display(), runs.len(), study.run_count()))
}

/// Reads a study file; its presets are the scenarios of `scenarios`, or of that folder beside the study's own.
pub fn read_study(path: &Path, scenarios: Option<&Path>) -> Result<Study, Failure> {
    let beside = || path.canonicalize().ok()?.parent()?.parent().map(|folder| folder.join("scenarios"));
    let folder = scenarios.map(Path::to_owned).or_else(beside).filter(|folder| folder.is_dir());
    let mut presets = Vec::new();
    for file in folder.map(fs::read_dir).into_iter().flatten().flatten().flatten() {
        let file = file.path();
        if let (Some(name), Some(true)) = (file.file_stem(), file.extension().map(|ending| ending == "json")) {
            presets.push((name.to_string_lossy().into_owned(), read_file(&file)?));
        }
    }
    // So that messages do not depend on the order of the folder.
    presets.sort();
    let presets: Vec<(&str, &str)> = presets.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    Study::read(&read_file(path)?, &presets).map_err(|error| in_file(path, &error))
}

/// Opens the results file for this process alone, with the results it has; a new one gets its header.
fn open(path: &Path, study: &Study) -> Result<(File, Results), Failure> {
    let fault = |doing: &str, error: std::io::Error| in_file(path, &format!("cannot {doing}: {error}"));
    let options = OpenOptions::new().read(true).append(true).create(true).clone();
    let mut file = options.open(path).map_err(|error| fault("open", error))?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => return Err(in_file(path, &"another process is writing this file")),
        Err(TryLockError::Error(error)) => return Err(fault("lock", error)),
    }
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes).map_err(|error| fault("read", error))?;
    let (results, whole) = Results::read(study.clone(), &bytes).map_err(|error| in_file(path, &error))?;
    if whole < bytes.len() {
        file.set_len(whole as u64).map_err(|error| fault("shorten", error))?;
    }
    if whole == 0 {
        file.write_all(results.header().as_bytes()).map_err(|error| fault("write", error))?;
    }
    Ok((file, results))
}

/// Appends a row in one piece, so that a kill cuts at most the last line.
fn write_row(file: &mut File, results: &mut Results, row: Row) -> std::io::Result<()> {
    file.write_all(results.line(&row).as_bytes())?;
    results.add(row);
    Ok(())
}

/// Puts the rows into the order of the runs, if they are not: as a new file that takes the old one's place.
fn finish(path: &Path, file: &mut File, results: &Results) -> Result<(), Failure> {
    let fault = |doing: &str, error: std::io::Error| in_file(path, &format!("cannot {doing}: {error}"));
    let mut bytes = Vec::new();
    file.rewind().and_then(|()| file.read_to_end(&mut bytes)).map_err(|error| fault("read", error))?;
    let text = results.text();
    if text.as_bytes() == bytes {
        return file.sync_all().map_err(|error| fault("write", error));
    }
    replace(path, &text)
}

/// Writes a file beside `path` and lets it take its place, so that there is a whole file at every moment.
pub fn replace(path: &Path, text: &str) -> Result<(), Failure> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".new");
    let beside = PathBuf::from(beside);
    let write = || {
        let mut file = File::create(&beside)?;
        file.write_all(text.as_bytes())?;
        file.sync_all()?;
        fs::rename(&beside, path)
    };
    write().map_err(|error: std::io::Error| in_file(&beside, &format!("cannot write: {error}")))
}

/// The file that says of which study results are: the results' name, ending in `.study.json`.
pub fn spec_path(results: &Path) -> PathBuf {
    results.with_extension("study.json")
}

/// Puts the study beside its results, if it is not there.
fn write_spec(results: &Path, study: &Study) -> Result<(), Failure> {
    let text = format!("{:#}\n", study.to_value());
    let path = spec_path(results);
    if fs::read_to_string(&path).is_ok_and(|there| there == text) { Ok(()) } else { replace(&path, &text) }
}

/// Refuses to write beside the results where another study stands.
fn check_spec(results: &Path, study: &Study) -> Result<(), Failure> {
    let path = spec_path(results);
    let Ok(text) = fs::read_to_string(&path) else { return Ok(()) };
    match Study::read(&text, &[]) {
        Ok(there) if there.hash() == study.hash() => Ok(()),
        _ => Err(in_file(&path, &"expected the study of these results, found another file; it is left alone")),
    }
}

fn progress(runs: usize) -> ProgressBar {
    if runs == 0 || !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(runs as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} runs, {eta} left") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(std::time::Duration::from_secs(1));
    bar
}
