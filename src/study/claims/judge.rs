//! Whether results bear a claim out.

use super::{Evidence, Kind};
use crate::study::cells::Cell;
use crate::study::fields::{StudyError, fault};
use crate::study::metrics::{Form, Metric};
use crate::study::report::{Sample, interval, number, of_metric, p};
use crate::study::results::Results;
use crate::study::statistics::{
    Estimate, Summary, Tails, fisher, kolmogorov_smirnov, mann_whitney, mean_interval, wilson,
};
use std::collections::BTreeMap;

/// Fewer runs give no verdict.
const ENOUGH: usize = 16;
const ALPHA: f64 = 0.05;
/// Two samples whose Kolmogorov-Smirnov test gives less are not alike.
const UNLIKE: f64 = 0.01;

/// What came of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The results bear it out.
    Reproduced,
    /// They contradict it, or do not show it.
    Not,
    /// They show the opposite of a contrast.
    Reversed,
    /// Too few runs, or the interval is too wide.
    Open,
    /// There are no results.
    NotRun,
}

impl Verdict {
    pub fn word(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Not => "not reproduced",
            Self::Reversed => "reversed",
            Self::Open => "open",
            Self::NotRun => "not run",
        }
    }

    /// The verdicts of one claim in one profile, in words: one if all agree, else how many of each.
    pub fn of_all(all: &[Self]) -> String {
        match all {
            [] => String::new(),
            [first, rest @ ..] if rest.iter().all(|other| other == first) => first.word().to_owned(),
            _ => {
                let kinds = [Self::Reproduced, Self::Not, Self::Reversed, Self::Open, Self::NotRun];
                let counted = kinds.map(|kind| (all.iter().filter(|&&other| other == kind).count(), kind.word()));
                let words: Vec<String> = counted
                    .iter()
                    .filter(|(count, _)| *count > 0)
                    .map(|(count, word)| format!("{count} {word}"))
                    .collect();
                words.join(", ")
            }
        }
    }
}

/// A verdict with the numbers behind it, as the table shows them.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    pub paper: String,
    pub ours: String,
    pub interval: String,
    pub runs: String,
    pub verdict: Verdict,
}

/// Judges one piece of evidence.
///
/// # Errors
/// Its study has no such cell or metric.
pub fn judge(evidence: &Evidence, results: &BTreeMap<String, Results>) -> Result<Judged, StudyError> {
    let metric = evidence.metric;
    let paper = match &evidence.kind {
        Kind::Equals(_, value) => of_metric(metric, *value),
        Kind::Below(_, value) => format!("below {}", of_metric(metric, *value)),
        Kind::Above(_, value) => format!("above {}", of_metric(metric, *value)),
        Kind::Greater(..) => "greater".to_owned(),
        Kind::NeverAbove(_, value) => format!("never above {}", of_metric(metric, *value)),
        Kind::Alike(_, within) => format!("means within {}", of_metric(metric, *within)),
    };
    let nothing = |verdict| Judged {
        paper: paper.clone(),
        ours: String::new(),
        interval: String::new(),
        runs: "0".to_owned(),
        verdict,
    };
    let Some(results) = results.get(&evidence.study) else { return Ok(nothing(Verdict::NotRun)) };
    if !results.study().metrics.contains(&metric) {
        let message = format!("expected a metric of study {}, found \"{}\"", evidence.study, metric.name());
        return fault(format!("{}.metric", evidence.path), message);
    }
    let sample = |cell: &str| sample(results, evidence, cell);
    let judged = match &evidence.kind {
        Kind::Greater(first, second) => greater(&sample(first)?, &sample(second)?, metric, &paper),
        Kind::Alike([first, second], within) => alike(&sample(first)?, &sample(second)?, *within, metric, &paper),
        Kind::NeverAbove(cell, value) => never_above(&sample(cell)?, *value, metric, &paper),
        Kind::Equals(cell, value) | Kind::Below(cell, value) | Kind::Above(cell, value) => {
            let sample = sample(cell)?;
            let Some(ours) = estimate(&sample, metric) else { return Ok(nothing(Verdict::Open)) };
            let is_in = ours.holds(*value);
            let verdict = match &evidence.kind {
                _ if sample.values.len() < ENOUGH => Verdict::Open,
                Kind::Equals(..) if is_in => Verdict::Reproduced,
                Kind::Below(..) if ours.high < *value => Verdict::Reproduced,
                Kind::Above(..) if ours.low > *value => Verdict::Reproduced,
                Kind::Below(..) | Kind::Above(..) if is_in => Verdict::Open,
                _ => Verdict::Not,
            };
            let (runs, interval) = (runs(&sample), interval(metric, &ours));
            Some(Judged { paper: paper.clone(), ours: of_metric(metric, ours.value), interval, runs, verdict })
        }
    };
    Ok(judged.unwrap_or_else(|| nothing(Verdict::Open)))
}

/// What a cell gave, or all cells with a label of that word together.
fn sample(results: &Results, evidence: &Evidence, cell: &str) -> Result<Sample, StudyError> {
    let cells = results.study().cells.iter().enumerate();
    let of_name = |own: &Cell| own.name == cell;
    let of_label = |own: &Cell| own.labels.values().any(|label| label == cell);
    let is_a_name = cells.clone().any(|(_, own)| of_name(own));
    let meant = cells.filter(|(_, own)| if is_a_name { of_name(own) } else { of_label(own) });
    let samples: Vec<Sample> = meant.map(|(place, _)| Sample::of(results, place, evidence.metric)).collect();
    if samples.is_empty() {
        let message = format!("expected a cell of study {}, found \"{cell}\"", evidence.study);
        return fault(&evidence.path, message);
    }
    Ok(Sample {
        never: samples.iter().map(|sample| sample.never).sum(),
        values: samples.into_iter().flat_map(|sample| sample.values).collect(),
    })
}

/// Whether the first has more; `None` when there is nothing to compare.
fn greater(first: &Sample, second: &Sample, metric: Metric, paper: &str) -> Option<Judged> {
    let (first_value, second_value) = estimate(first, metric).zip(estimate(second, metric))?;
    let tails = contrast(first, second, metric);
    let enough = first.values.len().min(second.values.len()) >= ENOUGH;
    let verdict = match tails {
        _ if !enough => Verdict::Open,
        tails if tails.greater < ALPHA => Verdict::Reproduced,
        tails if tails.less < ALPHA => Verdict::Reversed,
        _ => Verdict::Not,
    };
    let value = |estimate: &Estimate| of_metric(metric, estimate.value);
    Some(Judged {
        paper: paper.to_owned(),
        ours: format!("{} against {}", value(&first_value), value(&second_value)),
        interval: format!("p = {}", p(tails.greater)),
        runs: format!("{}, {}", first.values.len(), second.values.len()),
        verdict,
    })
}

/// Whether both come from one distribution; `None` when there is nothing to compare.
fn alike(first: &Sample, second: &Sample, within: f64, metric: Metric, paper: &str) -> Option<Judged> {
    let (one, other) = Summary::of(&first.values).zip(Summary::of(&second.values))?;
    let test = kolmogorov_smirnov(&first.values, &second.values)?;
    let is_alike = (one.mean - other.mean).abs() <= within && test.p.two_sided > UNLIKE;
    let verdict = match is_alike {
        _ if first.values.len().min(second.values.len()) < ENOUGH => Verdict::Open,
        true => Verdict::Reproduced,
        false => Verdict::Not,
    };
    Some(Judged {
        paper: paper.to_owned(),
        ours: format!("{} against {}", of_metric(metric, one.mean), of_metric(metric, other.mean)),
        interval: format!("p = {}", p(test.p.two_sided)),
        runs: format!("{}, {}", first.values.len(), second.values.len()),
        verdict,
    })
}

/// Whether no run is above a value; `None` when there is no run.
fn never_above(sample: &Sample, value: f64, metric: Metric, paper: &str) -> Option<Judged> {
    let all = Summary::of(&sample.values)?;
    let verdict = match all.greatest <= value {
        false => Verdict::Not,
        true if sample.values.len() < ENOUGH => Verdict::Open,
        true => Verdict::Reproduced,
    };
    Some(Judged {
        paper: paper.to_owned(),
        ours: format!("{} at most", of_metric(metric, all.greatest)),
        interval: String::new(),
        runs: runs(sample),
        verdict,
    })
}

/// How many runs there are, and how many more in which the metric never came about.
fn runs(sample: &Sample) -> String {
    let never = if sample.never > 0 { format!(", {} never", number(f64::from(sample.never))) } else { String::new() };
    format!("{}{never}", sample.values.len())
}

fn estimate(sample: &Sample, metric: Metric) -> Option<Estimate> {
    if metric.form() == Form::Flag {
        let (successes, trials) = sample.successes();
        return (trials > 0).then(|| wilson(successes, trials));
    }
    let summary = Summary::of(&sample.values)?;
    // Runs that are all alike have no spread to estimate, and one run has none either.
    mean_interval(&summary).or(Some(Estimate { value: summary.mean, low: summary.least, high: summary.greatest }))
}

fn contrast(first: &Sample, second: &Sample, metric: Metric) -> Tails {
    if metric.form() == Form::Flag {
        return fisher(first.successes(), second.successes());
    }
    let alike = Tails { two_sided: 1.0, greater: 1.0, less: 1.0 };
    mann_whitney(&first.values, &second.values).map_or(alike, |test| test.p)
}
