//! The statistics of a study's report, each checked against an independent library and against values worked by hand.

mod describe;
mod fisher;
mod interval;
mod kolmogorov_smirnov;
mod mann_whitney;
mod sign;
mod special;
mod student;

pub use describe::{Summary, quantile};
pub use fisher::fisher;
pub use interval::{difference_interval, wilson};
pub use kolmogorov_smirnov::{KolmogorovSmirnov, kolmogorov_smirnov};
pub use mann_whitney::{MannWhitney, mann_whitney};
pub use sign::sign_test;
pub use special::{beta_inc, normal_upper};
pub use student::{StudentTest, mean_interval, one_sample_t, t_quantile, t_upper, welch_t};

/// The two-sided 95 % point of the standard normal distribution.
pub const Z95: f64 = 1.959_963_984_540_054;

/// The p values of a test: both tails, and each one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tails {
    /// Two-sided.
    pub two_sided: f64,
    /// Against the alternative that the first is greater.
    pub greater: f64,
    /// Against the alternative that the first is less.
    pub less: f64,
}

/// An estimate with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// The lower end of the interval.
    pub low: f64,
    /// The upper end of the interval.
    pub high: f64,
}

impl Estimate {
    /// Whether the interval holds `value`, its ends included.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// The p values of several tests, made greater so that the chance of any false alarm among them stays what it is for one.
///
/// Source: Holm (1979).
#[must_use]
pub fn holm(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
    let mut adjusted = vec![0.0; values.len()];
    let mut least = 0.0_f64;
    for (place, index) in order.into_iter().enumerate() {
        least = least.max((values.len() - place) as f64 * values[index]).min(1.0);
        adjusted[index] = least;
    }
    adjusted
}
