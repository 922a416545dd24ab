//! Fisher's exact test of two proportions.

use super::Tails;

/// The p values of the table that two pairs of successes and trials make.
///
/// Two-sided by small p: the probabilities of all tables with the same margins that are no likelier than this one.
/// `greater` is the tail in which the first share is greater.
///
/// - Each pair: successes, at most the trials.
///
/// Source: Fisher (1935). Tables within one part in ten million count as equally likely, as in R.
#[must_use]
pub fn fisher(first: (u32, u32), second: (u32, u32)) -> Tails {
    let all = first.0 + second.0;
    let (least, most) = (all.saturating_sub(second.1), all.min(first.1));
    let ln_whole = ln_choose(first.1 + second.1, all);
    let weight = |k: u32| libm::exp(ln_choose(first.1, k) + ln_choose(second.1, all - k) - ln_whole);
    let ours = weight(first.0) * (1.0 + 1e-7);
    let mut tails = Tails { two_sided: 0.0, greater: 0.0, less: 0.0 };
    for k in least..=most {
        let weight = weight(k);
        tails.two_sided += if weight <= ours { weight } else { 0.0 };
        tails.greater += if k >= first.0 { weight } else { 0.0 };
        tails.less += if k <= first.0 { weight } else { 0.0 };
    }
    Tails { two_sided: tails.two_sided.min(1.0), greater: tails.greater.min(1.0), less: tails.less.min(1.0) }
}

fn ln_choose(n: u32, k: u32) -> f64 {
    let ln_factorial = |value: u32| libm::lgamma(f64::from(value) + 1.0);
    ln_factorial(n) - ln_factorial(k) - ln_factorial(n - k)
}
