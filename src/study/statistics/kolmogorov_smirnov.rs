//! The Kolmogorov-Smirnov test of two samples.

use super::Tails;

/// The outcome of a Kolmogorov-Smirnov test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KolmogorovSmirnov {
    /// The greatest distance between the two samples' shares of values up to a value.
    pub d: f64,
    /// The p values; `greater` says that the first sample tends to be greater: its shares lie below.
    pub p: Tails,
}

/// Whether two samples of finite numbers come from one distribution; `None` when one is empty.
///
/// p is exact, with and without ties: the share of all ways to deal the pooled values out to samples of these sizes whose
/// distance is as great. Ties are common where goals are counted, and the usual tables would be far off.
///
/// Source: Smirnov (1939); the recursion over paths, which looks only where a tie ends, is that of Schroeer and Trenkler
/// (1995), as in R since version 4.2.
#[must_use]
pub fn kolmogorov_smirnov(first: &[f64], second: &[f64]) -> Option<KolmogorovSmirnov> {
    if first.is_empty() || second.is_empty() {
        return None;
    }
    let (m, n) = (first.len(), second.len());
    let mut all: Vec<(f64, bool)> = first.iter().map(|&value| (value, true)).collect();
    all.extend(second.iter().map(|&value| (value, false)));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Element k: whether a tie ends with the k-th value, so that the shares may be compared there. Not by bits: 0 and -0
    // are tied.
    let mut ends = vec![false; m + n + 1];
    let (mut ours, mut theirs, mut above, mut below, mut counted) = (0, 0, 0_i64, 0_i64, 0);
    #[expect(clippy::float_cmp, reason = "only equal values are tied")]
    for tied in all.chunk_by(|a, b| a.0 == b.0) {
        let mine = tied.iter().filter(|value| value.1).count();
        (ours, theirs, counted) = (ours + mine, theirs + tied.len() - mine, counted + tied.len());
        ends[counted] = true;
        // The distance of the shares times m n: whole numbers, which do not round.
        let apart = gap(ours, theirs, m, n);
        (above, below) = (above.max(apart), below.max(-apart));
    }
    let d = above.max(below);
    let p = |reached: &dyn Fn(i64) -> bool| share_that_reaches(m, n, &ends, reached);
    let p = Tails {
        two_sided: if d == 0 { 1.0 } else { p(&|apart| apart.abs() >= d) },
        greater: if below == 0 { 1.0 } else { p(&|apart| -apart >= below) },
        less: if above == 0 { 1.0 } else { p(&|apart| apart >= above) },
    };
    Some(KolmogorovSmirnov { d: d as f64 / (m * n) as f64, p })
}

/// How far the share of the first sample lies above that of the second, times both lengths.
fn gap(ours: usize, theirs: usize, m: usize, n: usize) -> i64 {
    let product = |a: usize, b: usize| i64::from(a as u32) * i64::from(b as u32);
    product(ours, n) - product(theirs, m)
}

/// The share of all orders of `m` and `n` values that reach a distance where a tie ends.
fn share_that_reaches(m: usize, n: usize, ends: &[bool], reached: &dyn Fn(i64) -> bool) -> f64 {
    let stops = |i: usize, j: usize| ends[i + j] && reached(gap(i, j, m, n));
    // Element j: the share of the ways to i values of the first sample and j of the second that did not stop, times what
    // keeps the numbers small.
    let mut kept = vec![1.0_f64; n + 1];
    for j in 1..=n {
        kept[j] = if stops(0, j) { 0.0 } else { kept[j - 1] };
    }
    for i in 1..=m {
        let share = i as f64 / (i + n) as f64;
        kept[0] = if stops(i, 0) { 0.0 } else { share * kept[0] };
        for j in 1..=n {
            kept[j] = if stops(i, j) { 0.0 } else { share * kept[j] + kept[j - 1] };
        }
    }
    (1.0 - kept[n]).clamp(0.0, 1.0)
}
