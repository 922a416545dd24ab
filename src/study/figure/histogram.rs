//! How often values occur: one stepped line a colour, and every run as a tick below.

use super::Chart;
use super::axis::Upward;
use super::canvas::{BOTTOM, Canvas, LEFT, RIGHT, TOP, colour};
use crate::study::metrics::{Form, Metric};

/// Bins across the axis.
const BINS: usize = 20;

/// Draws the histogram with its axes.
pub fn draw(canvas: &mut Canvas, chart: &Chart, metric: Metric) {
    let across = Upward::of(metric.form(), chart.values(), [LEFT, RIGHT]);
    for (value, word) in across.ticks() {
        canvas.line([across.at(value), BOTTOM], [across.at(value), BOTTOM + 5.0], "axis");
        canvas.text([across.at(value), BOTTOM + 34.0], "middle", &word);
    }
    canvas.line([LEFT, BOTTOM], [RIGHT, BOTTOM], "axis");
    canvas.text([f64::midpoint(LEFT, RIGHT), BOTTOM + 58.0], "middle", metric.label());
    let shares: Vec<[f64; BINS]> = (0..chart.groups.len()).map(|group| shares(chart, group, &across)).collect();
    let upward = Upward::of(Form::Share, std::iter::empty(), [BOTTOM, TOP]);
    upward.draw(canvas, "Share of the runs");
    let bin = (RIGHT - LEFT) / BINS as f64;
    for (group, shares) in shares.iter().enumerate() {
        let steps = shares.iter().enumerate().flat_map(|(place, &share)| {
            let x = LEFT + bin * place as f64;
            [[x, upward.at(share)], [x + bin, upward.at(share)]]
        });
        canvas.path(&steps.collect::<Vec<_>>(), false, &format!("mark c{}", colour(group)));
        for spot in chart.of_group(group) {
            let y = BOTTOM + 8.0 + 3.0 * (group % 3) as f64;
            for &value in &spot.values {
                canvas.line([across.at(value), y], [across.at(value), y + 6.0], &format!("thin c{}", colour(group)));
            }
        }
    }
}

fn shares(chart: &Chart, group: usize, across: &Upward) -> [f64; BINS] {
    let mut shares = [0.0; BINS];
    let spots = chart.of_group(group);
    let all: usize = spots.iter().map(|spot| spot.values.len()).sum();
    for value in spots.iter().flat_map(|spot| &spot.values) {
        let place = (across.at(*value) - LEFT) / (RIGHT - LEFT) * BINS as f64;
        shares[(place as usize).min(BINS - 1)] += 1.0 / all as f64;
    }
    shares
}
