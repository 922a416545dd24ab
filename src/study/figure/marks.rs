//! Boxes, curves and proportions. Every run is a point wherever there are values.

use super::axis::{Across, Upward};
use super::canvas::{Canvas, colour};
use super::{Chart, Spot};
use crate::study::statistics::{Summary, wilson};

/// Box plots: quartiles, median, whiskers, and every run.
pub fn boxes(canvas: &mut Canvas, chart: &Chart, across: &Across, upward: &Upward) {
    let lane = (across.room * 0.84 / chart.groups.len() as f64).min(90.0);
    for spot in &chart.spots {
        let Some(summary) = Summary::of(&spot.values) else { continue };
        let (c, x) = (colour(spot.group), lane_of(chart, across, spot, lane));
        let (half, y) = (lane * 0.34, |value: f64| upward.at(value));
        // Whiskers reach to the last run within 1.5 quartile distances of the box (Tukey).
        let reach = 1.5 * (summary.upper - summary.lower);
        let within = |value: &&f64| (summary.lower - reach..=summary.upper + reach).contains(*value);
        let low = spot.values.iter().filter(within).copied().fold(summary.lower, f64::min);
        let high = spot.values.iter().filter(within).copied().fold(summary.upper, f64::max);
        canvas.line([x, y(low)], [x, y(summary.lower)], &format!("thin c{c}"));
        canvas.line([x, y(summary.upper)], [x, y(high)], &format!("thin c{c}"));
        canvas.rectangle([x - half, y(summary.lower)], [x + half, y(summary.upper)], &format!("box c{c}"));
        dots(canvas, spot, x, half, upward);
        canvas.line([x - half, y(summary.median)], [x + half, y(summary.median)], &format!("mark c{c}"));
    }
}

/// Medians as a line in the band of the quartiles, and every run.
pub fn curves(canvas: &mut Canvas, chart: &Chart, across: &Across, upward: &Upward) {
    let lane = (across.room * 0.5 / chart.groups.len() as f64).min(16.0);
    for group in 0..chart.groups.len() {
        let mut spots = chart.of_group(group);
        spots.sort_by(|a, b| across.at(a.x).total_cmp(&across.at(b.x)));
        let at = |of: &dyn Fn(&Summary) -> f64| -> Vec<[f64; 2]> {
            let point = |spot: &&Spot| Some([across.at(spot.x), upward.at(of(&Summary::of(&spot.values)?))]);
            spots.iter().filter_map(point).collect()
        };
        let mut band = at(&|summary| summary.lower);
        band.extend(at(&|summary| summary.upper).into_iter().rev());
        canvas.path(&band, true, &format!("band c{}", colour(group)));
        for spot in &spots {
            dots(canvas, spot, lane_of(chart, across, spot, lane), lane * 0.4, upward);
        }
        canvas.path(&at(&|summary| summary.median), false, &format!("mark c{}", colour(group)));
    }
}

/// Shares of successes with their intervals.
pub fn proportions(canvas: &mut Canvas, chart: &Chart, across: &Across, upward: &Upward) {
    let lane = (across.room * 0.6 / chart.groups.len() as f64).min(24.0);
    for spot in chart.spots.iter().filter(|spot| !spot.values.is_empty()) {
        let successes = spot.values.iter().filter(|value| **value > 0.5).count() as u32;
        let estimate = wilson(successes, spot.values.len() as u32);
        let (c, x) = (colour(spot.group), lane_of(chart, across, spot, lane));
        canvas.line([x, upward.at(estimate.low)], [x, upward.at(estimate.high)], &format!("mark c{c}"));
        for end in [estimate.low, estimate.high] {
            canvas.line([x - 4.0, upward.at(end)], [x + 4.0, upward.at(end)], &format!("mark c{c}"));
        }
        canvas.dot([x, upward.at(estimate.value)], 5.0, &format!("fill c{c}"));
    }
}

/// The middle of a spot's lane: the colours of a place stand side by side.
fn lane_of(chart: &Chart, across: &Across, spot: &Spot, lane: f64) -> f64 {
    across.at(spot.x) + (spot.group as f64 - (chart.groups.len() - 1) as f64 / 2.0) * lane
}

/// Every run as a dot, moved sideways so that they can be told apart; by its number, so the figure is always the same.
fn dots(canvas: &mut Canvas, spot: &Spot, x: f64, half: f64, upward: &Upward) {
    // Multiples of the golden section spread evenly however many there are.
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    for (number, &value) in spot.values.iter().enumerate() {
        let aside = (number as f64 * GOLDEN % 1.0 - 0.5) * 1.6 * half;
        canvas.dot([x + aside, upward.at(value)], 2.5, &format!("point c{}", colour(spot.group)));
    }
}
