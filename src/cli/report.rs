//! `report` and `merge`: what is done with results that are there.

use super::study::{read_study, replace, spec_path};
use super::{Failure, in_file, print, read_file};
use clap::Args;
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use swarm_playground::study::{Claims, Results, Size, Study};

/// Arguments of `report`.
#[derive(Args)]
pub struct ReportArguments {
    /// A results file
    results: PathBuf,
    /// The study file [default: the one that was written beside the results]
    #[arg(long)]
    study: Option<PathBuf>,
    /// Also draw the study's figure into this file
    #[arg(long)]
    svg: Option<PathBuf>,
}

/// Arguments of `merge`.
#[derive(Args)]
pub struct MergeArguments {
    /// The results files of the shards, or such files put one after the other
    #[arg(required = true)]
    results: Vec<PathBuf>,
    /// The file to write; it must not be there yet
    #[arg(long)]
    out: PathBuf,
    /// The study file [default: the one that was written beside the first results]
    #[arg(long)]
    study: Option<PathBuf>,
}

/// Arguments of `reproduction`.
#[derive(Args)]
pub struct ReproductionArguments {
    /// The claims of a paper
    #[arg(default_value = "studies/claims/betr-geese.json")]
    claims: PathBuf,
    /// The folder with the results files of the studies that the claims name
    #[arg(long, default_value = "results")]
    results: PathBuf,
}

/// Prints which claims the results bear out. A study without a results file counts as not run.
pub fn reproduction(arguments: &ReproductionArguments) -> Result<(), Failure> {
    let text = read_file(&arguments.claims)?;
    let claims = Claims::read(&text).map_err(|error| in_file(&arguments.claims, &error))?;
    let mut all = BTreeMap::new();
    for study in claims.studies() {
        let path = arguments.results.join(format!("{study}.csv"));
        if path.exists() {
            all.insert(study.to_owned(), read_results(&path, None)?);
        }
    }
    let document = claims
        .document(&all, &arguments.claims.display().to_string())
        .map_err(|error| in_file(&arguments.claims, &error))?;
    print(document.trim_end())
}

/// Prints the report.
pub fn report(arguments: &ReportArguments) -> Result<(), Failure> {
    let results = read_results(&arguments.results, arguments.study.as_deref())?;
    if let Some(path) = &arguments.svg {
        let figure = swarm_playground::study::figure(&results);
        let figure = figure.ok_or_else(|| in_file(&arguments.results, &"the study has no figure"))?;
        replace(path, &figure)?;
    }
    print(swarm_playground::study::report(&results).trim_end())
}

/// Writes the results of several files as one.
pub fn merge(arguments: &MergeArguments) -> Result<(), Failure> {
    let mut all: Option<Results> = None;
    for path in &arguments.results {
        let given =
            arguments.study.clone().or_else(|| Some(spec_path(&arguments.results[0])).filter(|path| path.exists()));
        let results = read_results(path, given.as_deref())?;
        let all = all.get_or_insert_with(|| Results::new(results.study().clone()));
        for row in results.rows() {
            if all.row_of(row.run).is_some_and(|other| other != row) {
                return Err(in_file(path, &format!("run {} differs from that in another file", row.run)));
            }
            all.add(row.clone());
        }
    }
    let Some(all) = all else { return Ok(()) };
    let out = &arguments.out;
    let written = OpenOptions::new().write(true).create_new(true).open(out);
    let written = written.and_then(|mut file| file.write_all(all.text().as_bytes()));
    written.map_err(|error| in_file(out, &format!("cannot write: {error}")))?;
    replace(&spec_path(out), &format!("{:#}\n", all.study().to_value()))?;
    print(&format!("{}: {} of {} runs", out.display(), all.rows().count(), all.study().run_count()))
}

/// Reads results of the study in `given` in whichever of its sizes they are, or of the study beside them.
fn read_results(path: &Path, given: Option<&Path>) -> Result<Results, Failure> {
    let bytes = fs::read(path).map_err(|error| Failure::Input(format!("cannot read {}: {error}", path.display())))?;
    let read = |study: &Study| Results::read(study.clone(), &bytes).map(|(results, _)| results);
    let Some(given) = given else {
        let beside = spec_path(path);
        let text = read_file(&beside).map_err(|_| {
            in_file(
                path,
                &format!("expected its study beside it in {}, found none; say --study FILE", beside.display()),
            )
        })?;
        let study = Study::read(&text, &[]).map_err(|error| in_file(&beside, &error))?;
        return read(&study).map_err(|error| in_file(path, &error));
    };
    let study = read_study(given, None)?;
    let sizes = [Size::Paper, Size::Class, Size::Glance].map(|size| study.sized(size).ok());
    let found = sizes.iter().flatten().find_map(|study| read(study).ok());
    found.map_or_else(|| read(&study).map_err(|error| in_file(path, &error)), Ok)
}
