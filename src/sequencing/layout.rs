//! Layouts drawn from a seed. The paper gives none of its own; these are made to look like its figures.

use super::lists::area;
use super::map::{Bounds, Form, Obstacle};
use super::params::{Params, TaskKind};
use super::parts::Parts;
use crate::random::{Purpose, Seed, Stream, stream};
use rand::RngExt;
use std::f64::consts::PI;

/// Places that are tried for an obstacle or a robot before there is no room for it.
const TRIES: u32 = 10_000;

/// The parts of a scenario's task: random obstacles, then listed ones; listed starts, or random ones.
///
/// # Errors
/// A field is not as it should be, or there is no room.
pub fn parts(params: &Params, seed: Seed) -> Result<Parts, (&'static str, String)> {
    let bounds = params.bounds()?;
    let listed = params.forms()?;
    let mut obstacles = draw_obstacles(params, &mut stream(seed, Purpose::Terrain, 0))?;
    obstacles.extend(listed);
    let mut start = params.starts()?;
    if start.is_empty() {
        start = draw_starts(params, &bounds, &obstacles, &mut stream(seed, Purpose::Placement, 0))?;
    }
    Ok(Parts {
        bounds,
        obstacles,
        goal: params.goal()?,
        library: params.behaviours()?,
        start,
        decisions: params.decisions,
        interval: params.interval,
    })
}

fn between(rng: &mut Stream, low: f64, high: f64) -> f64 {
    low + rng.random::<f64>() * (high - low)
}

/// Discs and boxes in equal shares, their centres uniform in an area, their circumscribed circles clear of the middle
/// of the start area and of the target's centre.
fn draw_obstacles(params: &Params, rng: &mut Stream) -> Result<Vec<Form>, (&'static str, String)> {
    let area_of = area("obstacle-area", &params.obstacle_area)?;
    let start = area("start-area", &params.start_area)?;
    let middle = [f64::midpoint(start.left, start.right), f64::midpoint(start.bottom, start.top)];
    let mut drawn = Vec::new();
    let mut tries = 0;
    while drawn.len() < params.obstacles as usize {
        if tries == TRIES {
            return Err(("obstacles", format!("expected room for {}, found it for {}", params.obstacles, drawn.len())));
        }
        tries += 1;
        // Every try takes the same number of draws.
        let is_disc = rng.random::<f64>() < 0.5;
        let (a, b) = (
            between(rng, params.obstacle_least, params.obstacle_most),
            between(rng, params.obstacle_least, params.obstacle_most),
        );
        let (x, y) = (between(rng, area_of.left, area_of.right), between(rng, area_of.bottom, area_of.top));
        let around = if is_disc { a } else { (a * a + b * b).sqrt() };
        let clear_of = |[px, py]: [f64; 2], clear: f64| {
            let (dx, dy) = (x - px, y - py);
            clear == 0.0 || (dx * dx + dy * dy).sqrt() - around >= clear
        };
        let target = [params.target_x, params.target_y];
        let clear = clear_of(middle, params.clear_of_start)
            && (params.task == TaskKind::Cover || clear_of(target, params.clear_of_target));
        if clear {
            drawn.push(if is_disc { Form::Disc([x, y, a]) } else { Form::Box([x - a, y - b, x + a, y + b]) });
            tries = 0;
        }
    }
    Ok(drawn)
}

/// Places uniform in the start area but for those near obstacles; headings uniform.
fn draw_starts(
    params: &Params,
    bounds: &Bounds,
    obstacles: &[Form],
    rng: &mut Stream,
) -> Result<Vec<[f64; 3]>, (&'static str, String)> {
    let start = area("start-area", &params.start_area)?;
    let grown: Vec<Obstacle> = obstacles.iter().map(|form| Obstacle::new(form.grown(params.start_clearance))).collect();
    let mut drawn = Vec::new();
    let mut tries = 0;
    while drawn.len() < params.robots as usize {
        if tries == TRIES {
            let message = format!("expected room for {} robots, found it for {}", params.robots, drawn.len());
            return Err(("start-area", message));
        }
        tries += 1;
        let at = [between(rng, start.left, start.right), between(rng, start.bottom, start.top)];
        let heading = between(rng, -PI, PI);
        if bounds.holds(at) && !grown.iter().any(|obstacle| obstacle.crosses(at, at)) {
            drawn.push([at[0], at[1], heading]);
            tries = 0;
        }
    }
    Ok(drawn)
}
