//! How often values occur: one stepped line a colour, and every run as a tick below.

use super::Chart;
use super::axis::Upward;
use super::canvas::{BOTTOM, Canvas, LEFT, RIGHT, TOP, colour};
use crate::study::metrics::{Form, Metric};

/// Bins across the axis, where values are not few whole numbers.
const BINS: usize = 20;
/// The most whole numbers that get a bin each.
const MOST_WHOLE: f64 = 40.0;

/// Draws the histogram with its axes.
pub fn draw(canvas: &mut Canvas, chart: &Chart, metric: Metric) {
    let whole = whole_numbers(chart).filter(|_| metric.form() == Form::Number);
    // Each whole number stands in the middle of its bin.
    let ends = whole.iter().flat_map(|[least, most]| [least - 0.5, most + 0.5]);
    let across = Upward::of(metric.form(), chart.values().chain(ends), [LEFT, RIGHT]);
    for (value, word) in across.ticks() {
        canvas.line([across.at(value), BOTTOM], [across.at(value), BOTTOM + 5.0], "axis");
        canvas.text([across.at(value), BOTTOM + 34.0], "middle", &word);
    }
    canvas.line([LEFT, BOTTOM], [RIGHT, BOTTOM], "axis");
    canvas.text([f64::midpoint(LEFT, RIGHT), BOTTOM + 58.0], "middle", metric.label());
    let (left, width, count) = match whole {
        Some([least, most]) => {
            let left = across.at(least - 0.5);
            (left, across.at(least + 0.5) - left, (most - least) as usize + 1)
        }
        None => (LEFT, (RIGHT - LEFT) / BINS as f64, BINS),
    };
    let bin_of = |value: f64| (((across.at(value) - left) / width) as usize).min(count - 1);
    let upward = Upward::of(Form::Share, std::iter::empty(), [BOTTOM, TOP]);
    upward.draw(canvas, "Share of the runs");
    for group in 0..chart.groups.len() {
        let shares = shares(chart, group, count, bin_of);
        let steps = shares.iter().enumerate().flat_map(|(place, &share)| {
            let x = left + width * place as f64;
            [[x, upward.at(share)], [x + width, upward.at(share)]]
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

/// The least and the greatest value, where all are whole numbers and few enough for a bin each.
fn whole_numbers(chart: &Chart) -> Option<[f64; 2]> {
    let ends = |[least, most]: [f64; 2], value: f64| [value.min(least), value.max(most)];
    let [least, most] = chart.values().fold([f64::INFINITY, f64::NEG_INFINITY], ends);
    (most - least < MOST_WHOLE && chart.values().all(|value| value % 1.0 == 0.0)).then_some([least, most])
}

/// The share of a group's runs in each bin.
fn shares(chart: &Chart, group: usize, count: usize, bin_of: impl Fn(f64) -> usize) -> Vec<f64> {
    let mut shares = vec![0.0; count];
    let spots = chart.of_group(group);
    let all: usize = spots.iter().map(|spot| spot.values.len()).sum();
    for value in spots.iter().flat_map(|spot| &spot.values) {
        shares[bin_of(*value)] += 1.0 / all as f64;
    }
    shares
}
