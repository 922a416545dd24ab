//! Shortest ways round obstacles to the target, never longer than the true ones.
//!
//! Discs are replaced by polygons inside them, so a way may cut through their rims; ways off the map are left out. A
//! way is blocked only by obstacles shrunk by a millionth, so that it may run along their sides.

use super::map::{Bounds, Form, Obstacle};
use std::f64::consts::PI;

/// Corners of the polygon that stands for a disc.
const DISC_CORNERS: u32 = 16;

/// The map of shortest ways to one point.
#[derive(Clone, Debug)]
pub struct Ways {
    target: [f64; 2],
    /// What blocks the view.
    blocks: Vec<Obstacle>,
    /// Corners at which ways turn, with the length of the way from there; the shortest first.
    corners: Vec<([f64; 2], f64)>,
}

impl Ways {
    /// Prepares the ways to a target disc.
    ///
    /// - `obstacles`: those that touch the disc are left out, since a robot may reach the disc in front of them: the
    ///   lengths stay lower bounds.
    #[must_use]
    pub fn new(bounds: &Bounds, obstacles: &[Obstacle], target: [f64; 2], radius: f64) -> Self {
        let near = |obstacle: &&Obstacle| Obstacle::new(obstacle.form().grown(radius)).crosses(target, target);
        let outlines: Vec<Vec<[f64; 2]>> =
            obstacles.iter().filter(|obstacle| !near(obstacle)).map(|obstacle| outline(obstacle.form())).collect();
        let blocks = outlines.iter().filter(|outline| outline.len() > 2).map(|outline| shrunk(outline)).collect();
        let mut corners: Vec<([f64; 2], f64)> = outlines
            .iter()
            .flatten()
            .filter(|corner| bounds.holds(**corner))
            .map(|corner| (*corner, f64::INFINITY))
            .collect();
        let mut ways = Self { target, blocks, corners: Vec::new() };
        // Dijkstra's algorithm from the target over the corners that see each other.
        let mut from = (target, 0.0);
        let mut settled = 0;
        loop {
            for (corner, length) in &mut corners[settled..] {
                let by = from.1 + distance(from.0, *corner);
                if by < *length && ways.sees(from.0, *corner) {
                    *length = by;
                }
            }
            let open = corners[settled..].iter().enumerate();
            let Some((next, _)) = open.min_by(|a, b| a.1.1.total_cmp(&b.1.1)) else { break };
            corners.swap(settled, settled + next);
            from = corners[settled];
            if from.1 == f64::INFINITY {
                break;
            }
            settled += 1;
        }
        corners.truncate(settled);
        ways.corners = corners;
        ways
    }

    /// A lower bound on the way from a point to the target's centre, metres; never less than the straight distance, and
    /// infinite where there is no way.
    #[must_use]
    pub fn length(&self, from: [f64; 2]) -> f64 {
        let straight = distance(from, self.target);
        if self.sees(from, self.target) {
            return straight;
        }
        let mut shortest = f64::INFINITY;
        for (corner, rest) in &self.corners {
            if *rest >= shortest {
                break;
            }
            let by = distance(from, *corner) + rest;
            if by < shortest && self.sees(from, *corner) {
                shortest = by;
            }
        }
        shortest
    }

    fn sees(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        !self.blocks.iter().any(|block| block.crosses(from, to))
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    (x * x + y * y).sqrt()
}

/// The corners of a polygon that lies inside the form.
fn outline(form: &Form) -> Vec<[f64; 2]> {
    match form {
        Form::Disc([x, y, radius]) => (0..DISC_CORNERS)
            .map(|at| {
                let (sin, cos) = libm::sincos(2.0 * PI * f64::from(at) / f64::from(DISC_CORNERS));
                // Inside the rim even after rounding.
                let radius = radius * (1.0 - 1e-12);
                [x + radius * cos, y + radius * sin]
            })
            .collect(),
        Form::Box(_) | Form::Polygon(_) => form.corners(),
    }
}

/// The polygon a millionth nearer to its middle.
fn shrunk(outline: &[[f64; 2]]) -> Obstacle {
    let count = outline.len() as f64;
    let sum = outline.iter().fold([0.0, 0.0], |sum, corner| [sum[0] + corner[0], sum[1] + corner[1]]);
    let middle = [sum[0] / count, sum[1] / count];
    let nearer = |at: f64, middle: f64| middle + (at - middle) * (1.0 - 1e-6);
    let corners = outline.iter().map(|corner| [nearer(corner[0], middle[0]), nearer(corner[1], middle[1])]);
    Obstacle::new(Form::Polygon(corners.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MAP: Bounds = Bounds { left: -50.0, right: 50.0, bottom: -50.0, top: 50.0 };

    #[test]
    fn the_way_round_a_wall_is_the_shorter_of_two() {
        // A wall of no width to speak of from (0, -3) to (0, 4): round its lower end 5 + 5, its upper end longer.
        let wall = Obstacle::new(Form::Box([-1e-9, -3.0, 1e-9, 4.0]));
        let ways = Ways::new(&MAP, &[wall], [4.0, 0.0], 1.0);
        assert!((ways.length([-4.0, 0.0]) - 10.0).abs() < 1e-6);
        assert!((ways.length([4.0, -9.0]) - 9.0).abs() < 1e-12, "in sight");
    }

    #[test]
    fn the_way_round_a_disc_is_not_longer_than_the_true_one() {
        let disc = Obstacle::new(Form::Disc([0.0, 0.0, 5.0]));
        let ways = Ways::new(&MAP, &[disc], [20.0, 0.0], 1.0);
        // Two tangents and an arc: 2 sqrt(400 - 25) + 5 (pi - 2 acos(5 / 20)).
        let truth = 2.0 * 375.0_f64.sqrt() + 5.0 * (PI - 2.0 * libm::acos(0.25));
        let found = ways.length([-20.0, 0.0]);
        assert!(found <= truth && found > 0.99 * truth, "{found} of {truth}");
    }

    #[test]
    fn a_target_behind_four_walls_has_no_way() {
        let walls =
            [[-6.0, -8.0, 18.0, -6.0], [-6.0, 14.0, 18.0, 16.0], [-6.0, -8.0, -4.0, 16.0], [16.0, -8.0, 18.0, 16.0]];
        let walls = walls.map(|sides| Obstacle::new(Form::Box(sides)));
        assert!(Ways::new(&MAP, &walls, [6.0, 4.0], 7.0).length([-20.0, 0.0]).is_infinite());
    }
}
