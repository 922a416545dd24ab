//! Whether results bear a claim out.

use super::{Evidence, Kind};
use crate::study::fields::{StudyError, fault};
use crate::study::metrics::{Form, Metric};
use crate::study::report::{Sample, interval, number, of_metric, p};
use crate::study::results::Results;
use crate::study::statistics::{Estimate, Summary, Tails, fisher, mann_whitney, mean_interval, wilson};
use std::collections::BTreeMap;

/// Fewer runs give no verdict.
const ENOUGH: usize = 16;
const ALPHA: f64 = 0.05;

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
    let sample = |cell: &str| -> Result<Sample, StudyError> {
        let cells = &results.study().cells;
        let found = cells.iter().position(|own| own.name == cell);
        let place = found.map_or_else(
            || fault(&evidence.path, format!("expected a cell of study {}, found \"{cell}\"", evidence.study)),
            Ok,
        )?;
        Ok(Sample::of(results, place, metric))
    };
    match &evidence.kind {
        Kind::Greater(first, second) => {
            let [first, second] = [sample(first)?, sample(second)?];
            let both = estimate(&first, metric).zip(estimate(&second, metric));
            let Some((first_value, second_value)) = both else { return Ok(nothing(Verdict::Open)) };
            let tails = contrast(&first, &second, metric);
            let enough = first.values.len().min(second.values.len()) >= ENOUGH;
            let verdict = match tails {
                _ if !enough => Verdict::Open,
                tails if tails.greater < ALPHA => Verdict::Reproduced,
                tails if tails.less < ALPHA => Verdict::Reversed,
                _ => Verdict::Not,
            };
            let value = |estimate: &Estimate| of_metric(metric, estimate.value);
            Ok(Judged {
                paper,
                ours: format!("{} against {}", value(&first_value), value(&second_value)),
                interval: format!("p = {}", p(tails.greater)),
                runs: format!("{}, {}", first.values.len(), second.values.len()),
                verdict,
            })
        }
        Kind::NeverAbove(cell, value) => {
            let sample = sample(cell)?;
            let Some(all) = Summary::of(&sample.values) else { return Ok(nothing(Verdict::Open)) };
            let verdict = match all.greatest <= *value {
                false => Verdict::Not,
                true if sample.values.len() < ENOUGH => Verdict::Open,
                true => Verdict::Reproduced,
            };
            Ok(Judged {
                paper,
                ours: format!("{} at most", of_metric(metric, all.greatest)),
                interval: String::new(),
                runs: runs(&sample),
                verdict,
            })
        }
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
            Ok(Judged {
                paper,
                ours: of_metric(metric, ours.value),
                interval: interval(metric, &ours),
                runs: runs(&sample),
                verdict,
            })
        }
    }
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
