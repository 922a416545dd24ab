//! The report on a study's results, as data and as Markdown: what was run, what came out, the tests, and the paper's values
//! beside ours.

#[cfg(feature = "soccer")]
mod matches;
mod paper;
mod table;
mod tests;
mod words;

pub(super) use words::{interval, number, of_metric, p, table};

use super::figure::draw;
use super::metrics::Metric;
use super::results::Results;
use super::spec::{Study, VERSION};
use serde::Serialize;
use std::collections::BTreeMap;

/// What one cell gave for one metric.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Sample {
    /// The numbers, in the order of the runs.
    pub values: Vec<f64>,
    /// Runs in which it never came about.
    pub never: u32,
}

impl Sample {
    pub fn of(results: &Results, cell: usize, metric: Metric) -> Self {
        let study = results.study();
        let place = study.metrics.iter().position(|other| *other == metric).unwrap_or_default();
        let mut sample = Self::default();
        for row in results.rows().filter(|row| row.end.is_ok() && study.job(row.run).0 == cell) {
            match row.metrics[place] {
                Some(value) => sample.values.push(value),
                None => sample.never += 1,
            }
        }
        sample
    }

    /// Successes and trials, of a metric that is 0 or 1.
    pub fn successes(&self) -> (u32, u32) {
        (self.values.iter().filter(|value| **value > 0.5).count() as u32, self.values.len() as u32)
    }
}

/// One part of a report: a table, with how to read it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Section {
    /// The name of the metric that it describes, or `tests`, or `paper`; of matches, `matches-` and what is told of them.
    pub name: &'static str,
    /// Its heading.
    pub title: &'static str,
    /// How to read the table.
    pub note: &'static str,
    /// What stands in each column.
    pub columns: Vec<&'static str>,
    /// The table's words, one row a cell or test; the first column is text, the others are mostly numbers.
    pub rows: Vec<Vec<String>>,
}

/// Everything that is said of results, complete or not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Report {
    /// The study's title, or its name when it has none.
    pub title: String,
    /// What the study is about.
    pub about: String,
    /// How much there is, such as `7 of 10 seeds from 1 in each cell, not complete`.
    pub extent: String,
    /// The study, its extent, version and hash in one sentence.
    pub run: String,
    /// Why runs failed, and how many for each reason.
    pub failures: Vec<(String, u32)>,
    /// What is told of matches, if the study is of any; a table for each metric in their order; then the tests and the
    /// paper's values where the study has them.
    pub sections: Vec<Section>,
}

impl Report {
    /// The report on results.
    #[must_use]
    pub fn of(results: &Results) -> Self {
        let study = results.study();
        let mut sections: Vec<Section> = Vec::new();
        #[cfg(feature = "soccer")]
        sections.extend(matches::sections(results));
        sections.extend(study.metrics.iter().map(|metric| table::section(results, *metric)));
        sections.extend(tests::section(results));
        sections.extend(paper::section(results));
        Self {
            title: if study.title.is_empty() { study.name.clone() } else { study.title.clone() },
            about: study.about.clone(),
            extent: extent(results),
            run: what_was_run(results),
            failures: failures(results),
            sections,
        }
    }

    /// The report as Markdown.
    #[must_use]
    pub fn markdown(&self) -> String {
        let mut parts = vec![format!("# {}", self.title)];
        parts.extend(Some(self.about.clone()).filter(|about| !about.is_empty()));
        parts.push(self.run.clone());
        if !self.failures.is_empty() {
            let line = |(reason, count): &(String, u32)| {
                format!("* {count} run{}: {reason}", if *count == 1 { "" } else { "s" })
            };
            let lines: Vec<String> = self.failures.iter().map(line).collect();
            parts.push(format!("Runs that failed, which no number below counts:\n\n{}", lines.join("\n")));
        }
        for Section { title, note, columns, rows, .. } in &self.sections {
            parts.push(format!("## {title}\n\n{note}\n\n{}", words::table(columns, rows)));
        }
        parts.join("\n\n") + "\n"
    }
}

/// The report on results, complete or not, as Markdown.
#[must_use]
pub fn report(results: &Results) -> String {
    Report::of(results).markdown()
}

/// The study's figure as the text of an SVG file; `None` when it has none, or no run to show.
#[must_use]
pub fn figure(results: &Results) -> Option<String> {
    let figure = results.study().figure.as_ref()?;
    let cells = (0..results.study().cells.len()).map(|cell| Sample::of(results, cell, figure.metric));
    let cells: Vec<Vec<f64>> = cells.map(|sample| sample.values).collect();
    draw(results.study(), figure, &cells, &extent(results))
}

fn what_was_run(results: &Results) -> String {
    let study = results.study();
    format!(
        "Study `{}`, {} cells: {}. Version {VERSION}, spec {:016x}.",
        study.name,
        study.cells.len(),
        extent(results),
        study.hash()
    )
}

/// How much there is, such as `64 of 64 seeds from 1`.
fn extent(results: &Results) -> String {
    let study: &Study = results.study();
    let mut of_cells = vec![0_u32; study.cells.len()];
    for row in results.rows() {
        of_cells[study.job(row.run).0] += 1;
    }
    let least = of_cells.iter().min().copied().unwrap_or_default();
    let most = of_cells.iter().max().copied().unwrap_or_default();
    let have = if least == most { format!("{least}") } else { format!("{least} to {most}") };
    let (all, first) = (study.seeds.max(most), study.first_seed);
    let partial = if least < all { ", not complete" } else { "" };
    format!("{have} of {all} seeds from {first} in each cell{partial}")
}

fn failures(results: &Results) -> Vec<(String, u32)> {
    let mut reasons: BTreeMap<&str, u32> = BTreeMap::new();
    for row in results.rows() {
        if let Err(reason) = &row.end {
            *reasons.entry(reason).or_default() += 1;
        }
    }
    reasons.into_iter().map(|(reason, count)| (reason.to_owned(), count)).collect()
}
