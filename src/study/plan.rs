//! What the report of a study is to contain: tests, a figure, and the paper's values.

use super::fields::{Fields, StudyError, elements, entries, fault, one_of, text};
use super::metrics::{Form, Metric};
use super::spec::Study;
use crate::parameter::shown;
use serde_json::{Value, json};

/// A test of one metric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// What is compared.
    pub metric: Metric,
    /// With what.
    pub kind: TestKind,
}

/// The kinds of tests; cells by their places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TestKind {
    /// Fisher's exact test of two shares of successes.
    Proportions([usize; 2]),
    /// The Mann-Whitney U test of two samples.
    MannWhitney([usize; 2]),
    /// The Kolmogorov-Smirnov test of two samples.
    KolmogorovSmirnov([usize; 2]),
    /// Welch's t test of two means.
    WelchT([usize; 2]),
    /// A t test of the mean of a cell against a value.
    OneSampleT(usize, f64),
}

/// What the report draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// How.
    pub kind: FigureKind,
    /// What is drawn upward (to the right in a histogram).
    pub metric: Metric,
    /// The factor along the horizontal axis; without one, every cell stands for itself.
    pub x: Option<String>,
    /// The factor that colours tell apart.
    pub group: Option<String>,
}

/// The kinds of figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureKind {
    /// Box plots with every point.
    Box,
    /// The median as a line in the band of the quartiles, over a factor of numbers.
    Curve,
    /// Shares of successes with their intervals.
    Proportion,
    /// How often values occur, with every value as a mark.
    Histogram,
}

impl FigureKind {
    const ALL: [(&'static str, Self); 4] =
        [("box", Self::Box), ("curve", Self::Curve), ("proportion", Self::Proportion), ("histogram", Self::Histogram)];
}

/// A value that the paper reports.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PaperValue {
    /// Of which cell, by its place.
    pub cell: usize,
    /// Of which metric's mean.
    pub metric: Metric,
    /// What it is.
    pub value: f64,
}

/// The seconds that the paper's program took to search. They are no metric: seconds are the machine's.
#[derive(Clone, Debug, PartialEq)]
pub struct PaperSeconds {
    /// The machine, in words.
    pub machine: String,
    /// Cells by their places, each with its seconds.
    pub cells: Vec<(usize, f64)>,
}

const MOST_TESTS: usize = 100;

pub(super) fn read_tests(fields: &Fields, study: &Study) -> Result<Vec<Test>, StudyError> {
    let tests = fields.each("tests", MOST_TESTS)?;
    tests.into_iter().map(|(path, value)| read_test(value, &path, study)).collect()
}

fn read_test(value: &Value, path: &str, study: &Study) -> Result<Test, StudyError> {
    let fields = Fields::of(value, path, &["kind", "metric", "compare", "against"])?;
    let kinds =
        [("proportions", 0), ("mann-whitney", 1), ("welch-t", 2), ("one-sample-t", 3), ("kolmogorov-smirnov", 4)];
    let kind = *one_of(fields.need("kind", "the kind of test")?, &fields.at("kind"), &kinds)?;
    let metric = read_metric(&fields, study)?;
    let wanted = if kind == 3 { 1 } else { 2 };
    let compared = elements(fields.need("compare", "a list of cells")?, &fields.at("compare"), study.cells.len())?;
    if compared.len() != wanted {
        return fault(fields.at("compare"), format!("expected {wanted} of the cells, found {}", compared.len()));
    }
    let cells = compared.iter().map(|(path, value)| study.cell(value, path)).collect::<Result<Vec<_>, _>>()?;
    let pair = [cells[0], cells[wanted - 1]];
    if wanted == 2 && pair[0] == pair[1] {
        return fault(fields.at("compare"), "expected two different cells, found one twice");
    }
    if kind != 3 && fields.get("against").is_some() {
        return fault(fields.at("against"), "expected no such field: only a one-sample-t test is against a value");
    }
    let kind = match kind {
        0 if metric.form() != Form::Flag => {
            return fault(fields.at("metric"), no_flag(metric, study));
        }
        0 => TestKind::Proportions(pair),
        1 => TestKind::MannWhitney(pair),
        2 => TestKind::WelchT(pair),
        4 => TestKind::KolmogorovSmirnov(pair),
        _ => {
            let against = fields.need("against", "the value to test against")?;
            TestKind::OneSampleT(pair[0], number(against, &fields.at("against"))?)
        }
    };
    Ok(Test { metric, kind })
}

/// What is wrong with a metric where only one that is 0 or 1 can stand.
fn no_flag(metric: Metric, study: &Study) -> String {
    let known = Metric::of_world(&study.cells[0].scenario.world);
    let flags = known.iter().filter(|(_, metric)| metric.form() == Form::Flag);
    let names: Vec<String> = flags.map(|(name, _)| format!("\"{name}\"")).collect();
    format!("expected {}, which is 0 or 1, found \"{}\"", names.join(" or "), metric.name())
}

/// One of the study's own metrics.
fn read_metric(fields: &Fields, study: &Study) -> Result<Metric, StudyError> {
    let measured: Vec<(&str, Metric)> = study.metrics.iter().map(|metric| (metric.name(), *metric)).collect();
    one_of(fields.need("metric", "one of the study's metrics")?, &fields.at("metric"), &measured).copied()
}

fn number(value: &Value, path: &str) -> Result<f64, StudyError> {
    value.as_f64().map_or_else(|| fault(path, format!("expected a number, found {}", shown(value))), Ok)
}

pub(super) fn read_figure(fields: &Fields, study: &Study) -> Result<Option<Figure>, StudyError> {
    let Some(value) = fields.get("figure") else { return Ok(None) };
    let fields = Fields::of(value, "figure", &["kind", "metric", "x", "group"])?;
    let kind = *one_of(fields.need("kind", "the kind of figure")?, "figure.kind", &FigureKind::ALL)?;
    let metric = read_metric(&fields, study)?;
    let factors = study.factors();
    let choices: Vec<(&str, &String)> = factors.iter().map(|factor| (factor.as_str(), factor)).collect();
    let factor = |name: &str| {
        let value = fields.get(name);
        value.map(|value| one_of(value, &fields.at(name), &choices).map(|factor| (*factor).clone())).transpose()
    };
    let (x, group) = (factor("x")?, factor("group")?);
    if kind == FigureKind::Proportion && metric.form() != Form::Flag {
        return fault("figure.metric", no_flag(metric, study));
    }
    if kind == FigureKind::Curve {
        let Some(x) = &x else { return fault("figure.x", "expected a factor whose values are numbers") };
        let is_number = |cell: usize| study.factor(cell, x).parse::<f64>().is_ok_and(f64::is_finite);
        if !(0..study.cells.len()).all(is_number) {
            return fault("figure.x", format!("expected a factor whose values are numbers, found \"{x}\""));
        }
    }
    Ok(Some(Figure { kind, metric, x, group }))
}

pub(super) fn read_paper(fields: &Fields, study: &Study) -> Result<Vec<PaperValue>, StudyError> {
    let mut values = Vec::new();
    let cells = fields.get("paper").map_or_else(|| Ok(Vec::new()), |value| entries(value, "paper"))?;
    let measured: Vec<(&str, Metric)> = study.metrics.iter().map(|metric| (metric.name(), *metric)).collect();
    for (name, metrics) in cells {
        let path = format!("paper.{name}");
        let cell = study.cell(&Value::from(name), &path)?;
        for (metric, value) in entries(metrics, &path)? {
            let path = format!("{path}.{metric}");
            let metric = *one_of(&Value::from(metric), &path, &measured)?;
            values.push(PaperValue { cell, metric, value: number(value, &path)? });
        }
    }
    values.sort_by_key(|value| value.cell);
    Ok(values)
}

pub(super) fn read_seconds(fields: &Fields, study: &Study) -> Result<Option<PaperSeconds>, StudyError> {
    let Some(value) = fields.get("seconds") else { return Ok(None) };
    let fields = Fields::of(value, "seconds", &["machine", "cells"])?;
    let machine = text(fields.need("machine", "the machine in words")?, &fields.at("machine"))?;
    let given = entries(fields.need("cells", "seconds by cells")?, &fields.at("cells"))?;
    let cells = given.into_iter().map(|(name, seconds)| {
        let path = format!("seconds.cells.{name}");
        Ok((study.cell(&Value::from(name), &path)?, number(seconds, &path)?))
    });
    let mut cells = cells.collect::<Result<Vec<_>, StudyError>>()?;
    cells.sort_by_key(|(cell, _)| *cell);
    Ok(Some(PaperSeconds { machine, cells }))
}

impl Test {
    pub(super) fn to_value(self, study: &Study) -> Value {
        let name = |cell: usize| study.cells[cell].name.as_str();
        let metric = self.metric.name();
        let two = |kind: &str, cells: [usize; 2]| json!({"kind": kind, "metric": metric, "compare": cells.map(name)});
        match self.kind {
            TestKind::Proportions(cells) => two("proportions", cells),
            TestKind::MannWhitney(cells) => two("mann-whitney", cells),
            TestKind::KolmogorovSmirnov(cells) => two("kolmogorov-smirnov", cells),
            TestKind::WelchT(cells) => two("welch-t", cells),
            TestKind::OneSampleT(cell, against) => {
                json!({"kind": "one-sample-t", "metric": metric, "compare": [name(cell)], "against": against})
            }
        }
    }
}

impl Figure {
    pub(super) fn to_value(&self) -> Value {
        let kind = FigureKind::ALL[self.kind as usize].0;
        let mut value = json!({"kind": kind, "metric": self.metric.name()});
        for (name, factor) in [("x", &self.x), ("group", &self.group)] {
            if let Some(factor) = factor {
                value[name] = json!(factor);
            }
        }
        value
    }
}
