//! The Mann-Whitney U test, and Vargha and Delaney's A12 with an interval.

use super::{Estimate, Tails, Z95, normal_upper};

/// The outcome of a Mann-Whitney U test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MannWhitney {
    /// U of the first sample: pairs in which it is greater, ties counting half.
    pub u: f64,
    /// Whether p comes from the exact distribution; otherwise from the normal one.
    pub exact: bool,
    /// The p values; `greater` says that the first sample tends to be greater.
    pub p: Tails,
    /// A12, the probability that a draw of the first sample is greater, ties counting half.
    pub a12: Estimate,
}

/// Samples shorter than this, without ties, get the exact distribution.
const EXACT_BELOW: usize = 50;

/// Compares two samples of finite numbers; `None` when one is empty.
///
/// Source: Mann and Whitney (1947). Exact for small samples without ties, else normal with corrections for ties and
/// continuity, as in R. A12: Vargha and Delaney (2000); its interval: Newcombe (2006), method 5, which stays within
/// `[0, 1]` and does not shrink to a point when the samples do not overlap.
#[must_use]
pub fn mann_whitney(first: &[f64], second: &[f64]) -> Option<MannWhitney> {
    if first.is_empty() || second.is_empty() {
        return None;
    }
    let (m, n) = (first.len() as f64, second.len() as f64);
    let mut all: Vec<(f64, bool)> = first.iter().map(|&value| (value, true)).collect();
    all.extend(second.iter().map(|&value| (value, false)));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut rank_sum, mut before, mut ties) = (0.0, 0.0, 0.0);
    // Not by bits: 0 and -0 are tied.
    #[expect(clippy::float_cmp, reason = "only equal values are tied")]
    for tied in all.chunk_by(|a, b| a.0 == b.0) {
        let count = tied.len() as f64;
        let ours = tied.iter().filter(|value| value.1).count() as f64;
        rank_sum += ours * (before + f64::midpoint(count, 1.0));
        before += count;
        ties += count * count * count - count;
    }
    let u = rank_sum - m * (m + 1.0) / 2.0;
    let exact = ties == 0.0 && first.len() < EXACT_BELOW && second.len() < EXACT_BELOW;
    let p = if exact { exact_tails(first.len(), second.len(), u as usize) } else { normal_tails(m, n, u, ties) };
    Some(MannWhitney { u, exact, p, a12: a12_interval(u / (m * n), m, n) })
}

/// The distribution of U without ties: as many orders give U = u as there are partitions of u into at most `m` parts
/// of at most `n`.
fn exact_tails(m: usize, n: usize, u: usize) -> Tails {
    let most = m * n;
    let mut ways = vec![vec![0.0_f64; most + 1]; m + 1];
    ways[0][0] = 1.0;
    for part in 1..=n {
        for parts in 1..=m {
            let (fewer, these) = ways.split_at_mut(parts);
            for sum in part..=most {
                these[0][sum] += fewer[parts - 1][sum - part];
            }
        }
    }
    let at = |sum: usize| ways.iter().map(|row| row[sum]).sum::<f64>();
    let whole: f64 = (0..=most).map(at).sum();
    let less = (0..=u).map(at).sum::<f64>() / whole;
    let greater = (u..=most).map(at).sum::<f64>() / whole;
    Tails { two_sided: (2.0 * less.min(greater)).min(1.0), greater, less }
}

fn normal_tails(m: f64, n: f64, u: f64, ties: f64) -> Tails {
    let all = m + n;
    let variance = m * n / 12.0 * (all + 1.0 - ties / (all * (all - 1.0)));
    if variance <= 0.0 {
        return Tails { two_sided: 1.0, greater: 1.0, less: 1.0 };
    }
    let away = u - m * n / 2.0;
    let upper = |distance: f64| normal_upper(distance / variance.sqrt());
    Tails { two_sided: (2.0 * upper(away.abs() - 0.5)).min(1.0), greater: upper(away - 0.5), less: upper(-away - 0.5) }
}

/// The two values whose own standard error puts them 1.96 of it away from `a12`.
fn a12_interval(a12: f64, m: f64, n: f64) -> Estimate {
    let more = f64::midpoint(m, n) - 1.0;
    let error = |a: f64| {
        let spread = 1.0 + more * ((1.0 - a) / (2.0 - a) + a / (1.0 + a));
        Z95 * (a * (1.0 - a) * spread / (m * n)).sqrt()
    };
    // From a12 outward the distance grows from 0, and at the end of [0, 1] it is beyond the error, which is 0 there.
    let end = |limit: f64| {
        let (mut inside, mut outside) = (a12, limit);
        for _ in 0..200 {
            let middle = f64::midpoint(inside, outside);
            if (middle - a12).abs() <= error(middle) { inside = middle } else { outside = middle }
        }
        inside
    };
    Estimate { value: a12, low: end(0.0), high: end(1.0) }
}
