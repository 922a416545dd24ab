//! Numbers as reports write them.

use crate::study::metrics::{Form, Metric};
use crate::study::statistics::Estimate;

/// A number with about four digits.
pub fn number(value: f64) -> String {
    let size = value.abs();
    let decimals = if size >= 1000.0 {
        0
    } else if size >= 100.0 {
        1
    } else if size >= 10.0 {
        2
    } else {
        3
    };
    let text = if size > 0.0 && size < 0.01 { format!("{value:.2e}") } else { format!("{value:.decimals$}") };
    if text.contains(['.']) && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A p value.
pub fn p(value: f64) -> String {
    if value < 0.001 { format!("{value:.1e}") } else { format!("{value:.4}") }
}

/// A value of a metric, shares in per cent.
pub fn of_metric(metric: Metric, value: f64) -> String {
    match metric.form() {
        Form::Flag | Form::Share => format!("{:.1} %", value * 100.0),
        Form::Number => number(value),
    }
}

/// An interval of a metric.
pub fn interval(metric: Metric, estimate: &Estimate) -> String {
    format!("{} to {}", of_metric(metric, estimate.low), of_metric(metric, estimate.high))
}

/// A table; the first column is text, the others are numbers.
pub fn table(columns: &[&str], rows: &[Vec<String>]) -> String {
    let line = |fields: &[String]| {
        let fields: Vec<String> = fields.iter().map(|field| field.replace('|', "\\|")).collect();
        format!("| {} |", fields.join(" | "))
    };
    let head: Vec<String> = columns.iter().map(|&column| column.to_owned()).collect();
    let rule: Vec<&str> = (0..columns.len()).map(|at| if at == 0 { "---" } else { "---:" }).collect();
    let mut lines = vec![line(&head), format!("|{}|", rule.join("|"))];
    lines.extend(rows.iter().map(|row| line(row)));
    lines.join("\n")
}
