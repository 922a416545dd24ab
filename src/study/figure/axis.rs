//! The axes of a figure.

use super::canvas::{BOTTOM, Canvas, LEFT, RIGHT, TOP};
use crate::study::metrics::Form;

/// An axis of numbers.
#[derive(Clone, Debug)]
pub struct Upward {
    low: f64,
    high: f64,
    step: f64,
    /// Pixels of low and high.
    ends: [f64; 2],
    in_per_cent: bool,
}

impl Upward {
    /// The axis of numbers of a form: from 0 to 100 % for shares, otherwise round numbers around the values.
    pub fn of(form: Form, values: impl Iterator<Item = f64>, ends: [f64; 2]) -> Self {
        if form != Form::Number {
            return Self { low: 0.0, high: 1.0, step: 0.2, ends, in_per_cent: true };
        }
        let (least, most) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
        // Most numbers are counts, whose axis begins at 0 unless all of them are far from it.
        let low = if least >= 0.0 && least < most * 0.7 { 0.0 } else { least };
        let step = round_step(if most > low { (most - low) / 5.0 } else { most.abs().max(1.0) / 5.0 });
        let low = (low / step).floor() * step;
        let high = ((most / step).ceil() * step).max(low + step);
        Self { low, high, step, ends, in_per_cent: false }
    }

    /// The pixel of a value.
    pub fn at(&self, value: f64) -> f64 {
        self.ends[0] + (value - self.low) / (self.high - self.low) * (self.ends[1] - self.ends[0])
    }

    /// The values from `low` to `high` that get a mark, with their words.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let count = (((self.high - self.low) / self.step).round() as u32).min(20);
        let decimals = (0..6).find(|&decimals| is_whole(self.step * f64::from(10_u32.pow(decimals)))).unwrap_or(6);
        let tick = |place: u32| {
            let value = self.low + f64::from(place) * self.step;
            let word = if self.in_per_cent {
                format!("{:.0} %", value * 100.0)
            } else {
                format!("{value:.*}", decimals as usize)
            };
            (value, word)
        };
        (0..=count).map(tick).collect()
    }

    /// Draws the axis at the left, with rules across the plot.
    pub fn draw(&self, canvas: &mut Canvas, title: &str) {
        for (value, word) in self.ticks() {
            let y = self.at(value);
            canvas.line([LEFT, y], [RIGHT, y], "rule");
            canvas.text([LEFT - 8.0, y + 4.0], "end", &word);
        }
        canvas.line([LEFT, TOP], [LEFT, BOTTOM], "axis");
        canvas.upward_text([18.0, f64::midpoint(TOP, BOTTOM)], title);
    }
}

fn is_whole(value: f64) -> bool {
    (value - value.round()).abs() < 1e-6
}

/// The least of 1, 2 or 5 times a power of ten that is not below `step`.
fn round_step(step: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(step)));
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * power >= step * 0.999_999);
    factor.unwrap_or(10.0) * power
}

/// The horizontal axis: places side by side, or numbers where they stand.
#[derive(Clone, Debug)]
pub struct Across {
    /// The pixel of each place.
    at: Vec<f64>,
    /// Pixels that each place has for itself.
    pub room: f64,
}

impl Across {
    /// Puts places along the axis.
    ///
    /// - `by_value`: numbers stand where they belong, on a plain scale or else a logarithmic one; where neither keeps them
    ///   apart they stand side by side, as words do.
    pub fn of(places: &[String], by_value: bool, ends: [f64; 2]) -> Self {
        let side_by_side = |count: usize| {
            let room = (ends[1] - ends[0]) / count as f64;
            let at = (0..count).map(|place| ends[0] + room * (place as f64 + 0.5)).collect();
            Self { at, room }
        };
        let numbers: Option<Vec<f64>> = places.iter().map(|place| place.parse().ok()).collect();
        let Some(numbers) = numbers.filter(|_| by_value && places.len() > 1) else {
            return side_by_side(places.len());
        };
        let logarithms = || numbers.iter().map(|&number| libm::log(number)).collect::<Vec<_>>();
        spread(&numbers, ends).or_else(|| spread(&logarithms(), ends)).unwrap_or_else(|| side_by_side(places.len()))
    }

    /// The pixel of a place.
    pub fn at(&self, place: usize) -> f64 {
        self.at[place]
    }

    /// Draws the axis below the plot.
    pub fn draw(&self, canvas: &mut Canvas, places: &[String], title: &str) {
        canvas.line([LEFT, BOTTOM], [RIGHT, BOTTOM], "axis");
        let mut lines = 0;
        for (place, &x) in places.iter().zip(&self.at) {
            canvas.line([x, BOTTOM], [x, BOTTOM + 5.0], "axis");
            lines = lines.max(canvas.wrapped([x, BOTTOM + 20.0], self.room.max(30.0), place));
        }
        canvas.text([f64::midpoint(LEFT, RIGHT), BOTTOM + 28.0 + 14.0 * lines as f64], "middle", title);
    }
}

/// Places at their values, if they are finite and no two are nearer than a label is wide.
fn spread(values: &[f64], ends: [f64; 2]) -> Option<Across> {
    const NEAREST: f64 = 34.0;
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let (low, high) = (*sorted.first()?, *sorted.last()?);
    if !(low.is_finite() && high.is_finite() && high > low) {
        return None;
    }
    let (from, to) = (ends[0] + NEAREST, ends[1] - NEAREST);
    let scale = (to - from) / (high - low);
    let room = sorted.windows(2).map(|pair| (pair[1] - pair[0]) * scale).fold(f64::INFINITY, f64::min);
    let at = values.iter().map(|value| from + (value - low) * scale).collect();
    (room >= NEAREST).then_some(Across { at, room })
}
