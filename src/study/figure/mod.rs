//! A study's figure: SVG that stands alone, with title, axes and legend inside, and follows the viewer's light or dark theme.

mod axis;
mod canvas;
mod histogram;
mod marks;

use super::plan::{Figure, FigureKind};
use super::spec::{Study, VERSION};
use axis::{Across, Upward};
use canvas::{BOTTOM, Canvas, LEFT, RIGHT, TOP};

/// The numbers of one place and one colour.
#[derive(Clone, Debug)]
struct Spot {
    /// The place along the horizontal axis.
    x: usize,
    /// The colour.
    group: usize,
    values: Vec<f64>,
}

/// What there is to draw: cells that share place and colour are taken together.
#[derive(Clone, Debug)]
struct Chart {
    /// The words of the places, in the order of the study.
    places: Vec<String>,
    /// The words of the colours; one empty word when there are none.
    groups: Vec<String>,
    spots: Vec<Spot>,
}

impl Chart {
    fn of(study: &Study, figure: &Figure, cells: &[Vec<f64>]) -> Self {
        let mut chart = Self { places: Vec::new(), groups: Vec::new(), spots: Vec::new() };
        for (cell, values) in cells.iter().enumerate() {
            let place = figure.x.as_ref().map_or_else(|| study.cells[cell].name.clone(), |x| study.factor(cell, x));
            let group = figure.group.as_ref().map(|group| study.factor(cell, group)).unwrap_or_default();
            let (x, group) = (place_of(&mut chart.places, place), place_of(&mut chart.groups, group));
            match chart.spots.iter_mut().find(|spot| (spot.x, spot.group) == (x, group)) {
                Some(spot) => spot.values.extend(values),
                None => chart.spots.push(Spot { x, group, values: values.clone() }),
            }
        }
        chart
    }

    /// The spots of a colour, in the order of their places.
    fn of_group(&self, group: usize) -> Vec<&Spot> {
        let mut spots: Vec<&Spot> = self.spots.iter().filter(|spot| spot.group == group).collect();
        spots.sort_by_key(|spot| spot.x);
        spots.retain(|spot| !spot.values.is_empty());
        spots
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.spots.iter().flat_map(|spot| spot.values.iter().copied())
    }
}

fn place_of(words: &mut Vec<String>, word: String) -> usize {
    words.iter().position(|other| *other == word).unwrap_or_else(|| {
        words.push(word);
        words.len() - 1
    })
}

/// Draws the figure; `None` when there is no value at all.
///
/// - `cells`: the values of the figure's metric, by cell.
/// - `extent`: how much was run, in words.
pub(super) fn draw(study: &Study, figure: &Figure, cells: &[Vec<f64>], extent: &str) -> Option<String> {
    let chart = Chart::of(study, figure, cells);
    chart.values().next()?;
    let metric = figure.metric;
    let title = if study.title.is_empty() { &study.name } else { &study.title };
    let foot = format!("{} \u{2013} {extent} \u{2013} version {VERSION}, spec {:016x}", study.name, study.hash());
    let mut canvas = Canvas::new(title, &foot);
    let x_title = figure.x.as_deref().map(|x| x.split_once('.').map_or(x, |(_, field)| field).replace('-', " "));
    if figure.kind == FigureKind::Histogram {
        histogram::draw(&mut canvas, &chart, metric);
    } else {
        let upward = Upward::of(metric.form(), chart.values(), [BOTTOM, TOP]);
        let lines = matches!(figure.kind, FigureKind::Curve | FigureKind::Proportion);
        let across = Across::of(&chart.places, lines, [LEFT, RIGHT]);
        let x_title = x_title.unwrap_or_default();
        upward.draw(&mut canvas, metric.label());
        across.draw(&mut canvas, &chart.places, &x_title);
        match figure.kind {
            FigureKind::Box => marks::boxes(&mut canvas, &chart, &across, &upward),
            FigureKind::Curve => marks::curves(&mut canvas, &chart, &across, &upward),
            FigureKind::Proportion | FigureKind::Histogram => {
                marks::proportions(&mut canvas, &chart, &across, &upward);
            }
        }
    }
    let marks = match figure.kind {
        FigureKind::Box => "dots: runs; box: quartiles; line: median; whiskers: up to 1.5 quartile distances",
        FigureKind::Curve => "line: median; band: quartiles; dots: runs",
        FigureKind::Proportion => "dots: share of the runs; lines: Wilson's 95 % interval",
        FigureKind::Histogram => "steps: share of the runs; ticks below: runs",
    };
    canvas.legend(&chart.groups, marks);
    Some(canvas.finish())
}
