//! Student's t distribution, and the tests and intervals that rest on it.

use super::{Estimate, Summary, Tails, beta_inc};

/// The outcome of a t test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StudentTest {
    /// The statistic.
    pub t: f64,
    /// Degrees of freedom; of Welch's test by Welch and Satterthwaite, not rounded.
    pub freedom: f64,
    /// The p values; `greater` says that the first mean is greater.
    pub p: Tails,
}

impl StudentTest {
    /// The test of a statistic.
    #[must_use]
    pub fn of(t: f64, freedom: f64) -> Self {
        let (greater, less) = (t_upper(t, freedom), t_upper(-t, freedom));
        Self { t, freedom, p: Tails { two_sided: 2.0 * greater.min(less), greater, less } }
    }
}

/// The probability that a draw of Student's t distribution is above `t`.
///
/// - `freedom`: above 0.
#[must_use]
pub fn t_upper(t: f64, freedom: f64) -> f64 {
    let tail = 0.5 * beta_inc(freedom / 2.0, 0.5, freedom / (freedom + t * t));
    if t >= 0.0 { tail } else { 1.0 - tail }
}

/// The value above which a draw lies with probability `upper`, in `(0, 0.5]`.
#[must_use]
pub fn t_quantile(upper: f64, freedom: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while t_upper(high, freedom) > upper && high < 1e12 {
        high *= 2.0;
    }
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if t_upper(middle, freedom) > upper { low = middle } else { high = middle }
    }
    high
}

/// The mean with its 95 % t interval; `None` for fewer than two numbers.
#[must_use]
pub fn mean_interval(summary: &Summary) -> Option<Estimate> {
    if summary.count < 2 {
        return None;
    }
    let n = summary.count as f64;
    let half = t_quantile(0.025, n - 1.0) * summary.deviation / n.sqrt();
    Some(Estimate { value: summary.mean, low: summary.mean - half, high: summary.mean + half })
}

/// Whether a mean differs from `value`; `None` for fewer than two numbers, or when all are equal.
#[must_use]
pub fn one_sample_t(summary: &Summary, value: f64) -> Option<StudentTest> {
    let n = summary.count as f64;
    (summary.count > 1 && summary.deviation > 0.0)
        .then(|| StudentTest::of((summary.mean - value) / (summary.deviation / n.sqrt()), n - 1.0))
}

/// Whether two means differ, without assuming equal variances; `None` when a sample has fewer than two numbers, or
/// when all numbers of both are equal to their means.
///
/// Source: Welch (1947).
#[must_use]
pub fn welch_t(first: &Summary, second: &Summary) -> Option<StudentTest> {
    let part = |summary: &Summary| summary.deviation * summary.deviation / summary.count as f64;
    let (a, b) = (part(first), part(second));
    if first.count < 2 || second.count < 2 || a + b <= 0.0 {
        return None;
    }
    let of = |part: f64, summary: &Summary| part * part / (summary.count - 1) as f64;
    let freedom = (a + b) * (a + b) / (of(a, first) + of(b, second));
    Some(StudentTest::of((first.mean - second.mean) / (a + b).sqrt(), freedom))
}
