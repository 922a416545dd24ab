//! The sign test.

use super::Tails;

/// The p values of so many signs of each kind, where both are equally likely; signs that are neither are left out.
///
/// - `more`, `less`: how often the first was greater, and how often it was less.
///
/// Source: Dixon and Mood (1946); exact, from the binomial distribution.
#[must_use]
pub fn sign_test(more: u32, less: u32) -> Tails {
    let all = more + less;
    let ln_factorial = |value: u32| libm::lgamma(f64::from(value) + 1.0);
    let weight = |k: u32| {
        let ln_ways = ln_factorial(all) - ln_factorial(k) - ln_factorial(all - k);
        libm::exp(ln_ways - f64::from(all) * std::f64::consts::LN_2)
    };
    let upper = |least: u32| (least..=all).map(weight).sum::<f64>().min(1.0);
    // Both signs are equally likely, so one tail is the other one seen from the other end.
    let (greater, less) = (upper(more), upper(less));
    Tails { two_sided: (2.0 * greater.min(less)).min(1.0), greater, less }
}
