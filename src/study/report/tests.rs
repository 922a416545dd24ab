//! The tests of a study, each with its statistic, p values, and an effect size with interval and word.

use super::words::{number, p};
use super::{Sample, Section};
use crate::study::metrics::Metric;
use crate::study::plan::{Test, TestKind};
use crate::study::results::Results;
use crate::study::statistics::{
    Estimate, Summary, Tails, Z95, difference_interval, fisher, holm, kolmogorov_smirnov, mann_whitney, one_sample_t,
    welch_t,
};

const RULE: &str = "Each row compares the first cell with the second. p is given for both tails together, for \"the first is \
    greater\" and for \"the first is less\"; Holm's correction is for all tests of this table. Words for effects: of a \
    difference of shares by Cohen's h, and of Cohen's d, from 0.2 small, from 0.5 medium, from 0.8 large; of A12, by its \
    distance from one half, from 0.06 small, from 0.14 medium, from 0.21 large (Vargha and Delaney).";

/// The outcome of a test.
struct Done {
    name: &'static str,
    n: String,
    statistic: String,
    p: Tails,
    effect: String,
    word: &'static str,
}

/// An effect with its interval.
fn effect(name: &str, Estimate { value, low, high }: Estimate) -> String {
    format!("{name} {} ({} to {})", number(value), number(low), number(high))
}

/// The section, if the study has tests.
pub fn section(results: &Results) -> Option<Section> {
    let tests = &results.study().tests;
    if tests.is_empty() {
        return None;
    }
    let done: Vec<Option<Done>> = tests.iter().map(|test| run(results, test)).collect();
    let adjusted = holm(&done.iter().flatten().map(|done| done.p.two_sided).collect::<Vec<_>>());
    let mut adjusted = adjusted.into_iter();
    let rows = tests.iter().zip(done).map(|(test, done)| {
        let mut row = vec![compared(results, test), test.metric.label().to_owned()];
        row.extend(match done {
            None => ["not made: too few runs, or all alike", "", "", "", "", "", "", "", ""].map(str::to_owned),
            Some(done) => [
                done.name.to_owned(),
                done.n,
                done.statistic,
                p(done.p.two_sided),
                p(done.p.greater),
                p(done.p.less),
                p(adjusted.next().unwrap_or(1.0)),
                done.effect,
                done.word.to_owned(),
            ],
        });
        row
    });
    let columns = vec![
        "compared",
        "metric",
        "test",
        "n",
        "statistic",
        "p, both tails",
        "p, greater",
        "p, less",
        "p, Holm",
        "effect (95 % interval)",
        "size",
    ];
    Some(Section { name: "tests", title: "Tests", note: RULE, columns, rows: rows.collect() })
}

fn compared(results: &Results, test: &Test) -> String {
    let name = |cell: usize| results.study().cells[cell].name.as_str();
    match test.kind {
        TestKind::Proportions([a, b])
        | TestKind::MannWhitney([a, b])
        | TestKind::KolmogorovSmirnov([a, b])
        | TestKind::WelchT([a, b]) => format!("{} / {}", name(a), name(b)),
        TestKind::OneSampleT(cell, against) => format!("{} / the value {}", name(cell), number(against)),
    }
}

fn run(results: &Results, test: &Test) -> Option<Done> {
    let metric: Metric = test.metric;
    let sample = |cell: usize| Sample::of(results, cell, metric);
    match test.kind {
        TestKind::Proportions(cells) => proportions(cells.map(|cell| sample(cell).successes())),
        TestKind::MannWhitney(cells) => {
            let [first, second] = cells.map(|cell| sample(cell).values);
            let test = mann_whitney(&first, &second)?;
            let name = if test.exact { "Mann-Whitney U, exact" } else { "Mann-Whitney U, normal" };
            let word = sized((test.a12.value - 0.5).abs(), [0.06, 0.14, 0.21]);
            let n = format!("{}, {}", first.len(), second.len());
            Some(Done {
                name,
                n,
                statistic: format!("U = {}", number(test.u)),
                p: test.p,
                effect: effect("A12", test.a12),
                word,
            })
        }
        TestKind::KolmogorovSmirnov(cells) => {
            let [first, second] = cells.map(|cell| sample(cell).values);
            let test = kolmogorov_smirnov(&first, &second)?;
            Some(Done {
                name: "Kolmogorov-Smirnov, exact",
                n: format!("{}, {}", first.len(), second.len()),
                statistic: format!("D = {}", number(test.d)),
                p: test.p,
                effect: format!("D {}", number(test.d)),
                word: "",
            })
        }
        TestKind::WelchT(cells) => {
            let [first, second] = cells.map(|cell| Summary::of(&sample(cell).values));
            let (first, second) = (first?, second?);
            let test = welch_t(&first, &second)?;
            let (m, n) = (first.count as f64, second.count as f64);
            let spread = f64::midpoint(first.deviation * first.deviation, second.deviation * second.deviation).sqrt();
            let d = (first.mean - second.mean) / spread;
            let error = ((m + n) / (m * n) + d * d / (2.0 * (m + n))).sqrt();
            let counts = format!("{}, {}", first.count, second.count);
            Some(student("Welch's t", counts, (test.t, test.freedom), test.p, d, error))
        }
        TestKind::OneSampleT(cell, against) => {
            let summary = Summary::of(&sample(cell).values)?;
            let test = one_sample_t(&summary, against)?;
            let n = summary.count as f64;
            let d = (summary.mean - against) / summary.deviation;
            let error = (1.0 / n + d * d / (2.0 * n)).sqrt();
            Some(student("one-sample t", summary.count.to_string(), (test.t, test.freedom), test.p, d, error))
        }
    }
}

fn proportions(pairs: [(u32, u32); 2]) -> Option<Done> {
    let [first, second] = pairs;
    if first.1 == 0 || second.1 == 0 {
        return None;
    }
    // Cohen's h: the difference on a scale on which shares of one sample size vary alike.
    let arc = |(successes, trials): (u32, u32)| 2.0 * libm::asin((f64::from(successes) / f64::from(trials)).sqrt());
    Some(Done {
        name: "Fisher's exact",
        n: format!("{}, {}", first.1, second.1),
        statistic: format!("{} and {} successes", first.0, second.0),
        p: fisher(first, second),
        effect: effect("difference", difference_interval(first, second)),
        word: sized((arc(first) - arc(second)).abs(), [0.2, 0.5, 0.8]),
    })
}

/// A t test with Cohen's d, whose interval is the normal one of Hedges and Olkin (1985).
fn student(name: &'static str, n: String, (t, freedom): (f64, f64), p: Tails, d: f64, error: f64) -> Done {
    let statistic = format!("t = {}, df {}", number(t), number(freedom));
    let effect = effect("d", Estimate { value: d, low: d - Z95 * error, high: d + Z95 * error });
    Done { name, n, statistic, p, effect, word: sized(d.abs(), [0.2, 0.5, 0.8]) }
}

fn sized(size: f64, [small, medium, large]: [f64; 3]) -> &'static str {
    if size < small {
        "negligible"
    } else if size < medium {
        "small"
    } else if size < large {
        "medium"
    } else {
        "large"
    }
}
