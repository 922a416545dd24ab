//! Mean, standard deviation and quantiles.

/// What describes a list of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// How many.
    pub count: usize,
    /// Their mean.
    pub mean: f64,
    /// Standard deviation of the sample (n - 1); 0 for a single number.
    pub deviation: f64,
    /// The least.
    pub least: f64,
    /// The lower quartile.
    pub lower: f64,
    /// The median.
    pub median: f64,
    /// The upper quartile.
    pub upper: f64,
    /// The greatest.
    pub greatest: f64,
}

impl Summary {
    /// Describes `values`, which are finite; `None` when there is none.
    #[must_use]
    pub fn of(values: &[f64]) -> Option<Self> {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let (&least, &greatest) = (sorted.first()?, sorted.last()?);
        let count = sorted.len();
        // In rising order, so that the sum does not depend on the order in which the values came.
        let mean = sorted.iter().sum::<f64>() / count as f64;
        let squares: f64 = sorted.iter().map(|value| (value - mean) * (value - mean)).sum();
        let deviation = if count > 1 { (squares / (count - 1) as f64).sqrt() } else { 0.0 };
        let at = |share| quantile(&sorted, share);
        Some(Self { count, mean, deviation, least, lower: at(0.25), median: at(0.5), upper: at(0.75), greatest })
    }
}

/// The quantile of numbers in rising order, interpolated linearly between the two nearest; NaN when there is none.
///
/// - `share`: in `[0, 1]`; 0.5 gives the median.
///
/// Source: Hyndman and Fan (1996), definition 7, which R and NumPy use.
#[must_use]
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = last as f64 * share;
    let below = (place as usize).min(last);
    let above = (below + 1).min(last);
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}
