//! What every cell gave for a metric.

use super::words::{interval, of_metric};
use super::{Sample, Section};
use crate::study::metrics::{Form, Metric};
use crate::study::results::Results;
use crate::study::statistics::{Summary, wilson};

/// The section of a metric, one row a cell.
pub fn section(results: &Results, metric: Metric) -> Section {
    let study = results.study();
    let samples = study.cells.iter().enumerate().map(|(at, cell)| (&cell.name, Sample::of(results, at, metric)));
    let (columns, rows) = if metric.form() == Form::Flag {
        let rows = samples.map(|(name, sample)| successes(name, &sample, metric)).collect();
        (vec!["cell", "runs", "successes", "share", "95 % interval (Wilson)"], rows)
    } else {
        let samples: Vec<_> = samples.collect();
        let mut columns = vec!["cell", "runs", "mean", "sd", "median", "quartiles", "range"];
        let can_never = samples.iter().any(|(_, sample)| sample.never > 0);
        columns.extend(can_never.then_some("never"));
        let rows = samples.iter().map(|(name, sample)| {
            let mut row = vec![(*name).clone(), sample.values.len().to_string()];
            row.extend(described(sample, metric));
            row.extend(can_never.then(|| sample.never.to_string()));
            row
        });
        (columns, rows.collect())
    };
    Section { name: metric.name(), title: metric.label(), note: metric.help(), columns, rows }
}

fn successes(name: &str, sample: &Sample, metric: Metric) -> Vec<String> {
    let (successes, trials) = sample.successes();
    let mut row = vec![name.to_owned(), trials.to_string(), successes.to_string()];
    if trials == 0 {
        row.extend(["", ""].map(str::to_owned));
    } else {
        let estimate = wilson(successes, trials);
        row.extend([of_metric(metric, estimate.value), interval(metric, &estimate)]);
    }
    row
}

fn described(sample: &Sample, metric: Metric) -> [String; 5] {
    let word = |value: f64| of_metric(metric, value);
    let two = |low: f64, high: f64| format!("{} to {}", word(low), word(high));
    Summary::of(&sample.values).map_or_else(Default::default, |summary| {
        [
            word(summary.mean),
            if summary.count > 1 { word(summary.deviation) } else { String::new() },
            word(summary.median),
            two(summary.lower, summary.upper),
            two(summary.least, summary.greatest),
        ]
    })
}
