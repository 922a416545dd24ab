//! Intervals of proportions.

use super::{Estimate, Z95};

/// The share of successes with Wilson's 95 % score interval; the whole of `[0, 1]` around 0.5 when there was no trial.
///
/// - `successes`: at most `trials`.
///
/// Source: Wilson (1927), without continuity correction.
#[must_use]
pub fn wilson(successes: u32, trials: u32) -> Estimate {
    if trials == 0 {
        return Estimate { value: 0.5, low: 0.0, high: 1.0 };
    }
    let (n, z2) = (f64::from(trials), Z95 * Z95);
    let value = f64::from(successes) / n;
    let centre = (value + z2 / (2.0 * n)) / (1.0 + z2 / n);
    let half = Z95 * (value * (1.0 - value) / n + z2 / (4.0 * n * n)).sqrt() / (1.0 + z2 / n);
    // Exact at the ends, where rounding would leave 1e-17.
    let low = if successes == 0 { 0.0 } else { centre - half };
    let high = if successes == trials { 1.0 } else { centre + half };
    Estimate { value, low, high }
}

/// The difference of two shares, first less second, with its 95 % interval.
///
/// - Each pair: successes and trials.
///
/// Source: Newcombe (1998), method 10, made from the two Wilson intervals.
#[must_use]
pub fn difference_interval(first: (u32, u32), second: (u32, u32)) -> Estimate {
    let (a, b) = (wilson(first.0, first.1), wilson(second.0, second.1));
    let value = a.value - b.value;
    let apart = |x: f64, y: f64| (x * x + y * y).sqrt();
    Estimate {
        value,
        low: value - apart(a.value - a.low, b.high - b.value),
        high: value + apart(a.high - a.value, b.value - b.low),
    }
}
