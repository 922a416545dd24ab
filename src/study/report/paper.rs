//! The paper's values beside ours.

use super::words::{interval, number, of_metric};
use super::{Sample, Section};
use crate::study::metrics::{Form, Metric};
use crate::study::results::Results;
use crate::study::statistics::{Estimate, Summary, mean_interval, wilson};

const RULE: &str = "\"Reproduced\" means that the paper's value lies within the 95 % interval of our mean (Wilson's interval \
    for shares of successes, Student's t otherwise) of at least 16 runs; within an interval of fewer runs almost any value \
    lies, and the verdict is open. The gap is ours less the paper's.";
const ENOUGH: usize = 16;

/// The section, if the study has values of the paper.
pub fn section(results: &Results) -> Option<Section> {
    let study = results.study();
    if study.paper.is_empty() {
        return None;
    }
    let rows: Vec<Vec<String>> = study
        .paper
        .iter()
        .map(|paper| {
            let metric = paper.metric;
            let mut row = vec![study.cells[paper.cell].name.clone(), metric.label().to_owned()];
            row.push(of_metric(metric, paper.value));
            let sample = Sample::of(results, paper.cell, metric);
            row.extend(match ours(&sample, metric) {
                None => ["", "", "", "too few runs"].map(str::to_owned),
                Some(ours) => [
                    of_metric(metric, ours.value),
                    interval(metric, &ours),
                    gap(metric, ours.value - paper.value),
                    match (ours.holds(paper.value), sample.values.len() >= ENOUGH) {
                        (false, _) => "not reproduced".to_owned(),
                        (true, true) => "reproduced".to_owned(),
                        (true, false) => "open".to_owned(),
                    },
                ],
            });
            row
        })
        .collect();
    let columns = vec!["cell", "metric", "paper", "ours", "95 % interval", "gap", "verdict"];
    Some(Section { name: "paper", title: "Beside the paper", note: RULE, columns, rows })
}

fn ours(sample: &Sample, metric: Metric) -> Option<Estimate> {
    if metric.form() == Form::Flag {
        let (successes, trials) = sample.successes();
        return (trials > 0).then(|| wilson(successes, trials));
    }
    mean_interval(&Summary::of(&sample.values)?)
}

fn gap(metric: Metric, gap: f64) -> String {
    let sign = if gap > 0.0 { "+" } else { "" };
    match metric.form() {
        Form::Flag | Form::Share => format!("{sign}{:.1} points", gap * 100.0),
        Form::Number => format!("{sign}{}", number(gap)),
    }
}
