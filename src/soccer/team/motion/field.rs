//! The field of directions that a robot follows to a target.

use super::wheels::Motion;
use crate::soccer::team::geometry::{HALF, cross, distance, dot, left_of, length, minus, plus, side, times, unit};
use crate::soccer::view::{Pose, View, Wheels};
use std::f64::consts::FRAC_PI_2;

/// How far beside the target the centres of the spirals lie, and the radius of their inner circle.
const BESIDE: f64 = 0.08;
/// Where repulsion from a robot begins and where it is full.
const REPULSION: [f64; 2] = [0.16, 0.06];
/// Where the flow around an obstacle begins.
const FLOW: f64 = 0.28;
/// Where walls begin to push.
const WALL: f64 = 0.10;
/// Obstacles fade over this last way to the target.
const NEAR: f64 = 0.20;
/// The step over which curvature is measured.
const STEP: f64 = 0.01;
/// The greatest curvature that is followed, per metre.
const CURVATURE: f64 = 20.0;
/// So near, a robot that shall stand has arrived.
const ARRIVED: f64 = 0.012;

/// Where to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    /// The place, metres.
    pub at: [f64; 2],
    /// The unit vector in which to arrive, if it matters.
    pub arrival: Option<[f64; 2]>,
    /// k of the spirals: 0.004 is tight, 0.2 is wide.
    pub wide: f64,
    /// How much farther the robot would go: it arrives with the speed that the approach limit allows at this distance.
    pub past: f64,
}

impl Aim {
    /// A place to stand on.
    #[must_use]
    pub fn place(at: [f64; 2]) -> Self {
        Self { at, arrival: None, wide: 0.0, past: 0.0 }
    }
}

/// A robot to be avoided with a radius of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle {
    /// Which one of ours.
    pub robot: usize,
    /// Where its repulsion begins; the flow around it begins 0.12 farther out.
    pub radius: f64,
}

/// The field of one robot in one frame.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    view: &'a View,
    me: usize,
    aim: Aim,
    wide: Option<Obstacle>,
    /// The only spiral to use: 1 the left one, -1 the right one, seen along the arrival.
    only: f64,
}

impl<'a> Field<'a> {
    /// The field of robot `me` towards `aim`.
    ///
    /// - `motion`: remembers whether the target is at a wall: on beyond 0.40, off below 0.35.
    /// - `obstacle`: a robot of ours to be avoided with a radius of its own.
    pub fn new(view: &'a View, me: usize, aim: Aim, motion: &mut Motion, obstacle: Option<Obstacle>) -> Self {
        let y = aim.at[1];
        motion.at_wall = y.abs() > if motion.at_wall { 0.35 } else { 0.40 };
        // The left spiral's centre lies towards +y when the arrival points to +x.
        let only = match aim.arrival {
            Some(arrival) if motion.at_wall => -side(y) * side(arrival[0]),
            _ => 0.0,
        };
        Self { view, me, aim, wide: obstacle, only }
    }

    /// Where the field leads from `at`: a unit vector.
    #[must_use]
    pub fn at(&self, at: [f64; 2]) -> [f64; 2] {
        let to_go = distance(at, self.aim.at);
        let towards = self.attraction(at);
        let mut sum = towards;
        let near = (to_go / NEAR).min(1.0);
        for (team, robots) in [&self.view.ours, &self.view.theirs].into_iter().enumerate() {
            for (robot, other) in robots.iter().enumerate() {
                let away = minus(at, other.at);
                let (radius, flow) = match self.wide {
                    Some(wide) if team == 0 && wide.robot == robot => (wide.radius, wide.radius + FLOW - REPULSION[0]),
                    _ => (REPULSION[0], FLOW),
                };
                let square = dot(away, away);
                if square >= flow * flow || (team == 0 && robot == self.me) {
                    continue;
                }
                let gap = square.sqrt().max(1e-6);
                let away = times(away, 1.0 / gap);
                // What stands behind the target is in nobody's way.
                let ahead = -dot(away, towards);
                if ahead * gap > to_go {
                    continue;
                }
                let push = ((radius - gap) / (REPULSION[0] - REPULSION[1])).clamp(0.0, 1.0);
                sum = plus(sum, times(away, 1.5 * near * push));
                if ahead > 0.0 {
                    let around = times(left_of(away), -side(cross(times(away, -1.0), towards)));
                    sum = plus(sum, times(around, 1.2 * near * ahead * (flow - gap) / flow));
                }
            }
        }
        for axis in 0..2 {
            let push = wall(at[axis], HALF[axis]) - wall(self.aim.at[axis], HALF[axis]);
            if push > 0.0 {
                sum[axis] -= side(at[axis]) * push;
            }
        }
        unit(sum, towards)
    }

    /// Straight to the target, or by spirals that arrive in the wanted direction.
    fn attraction(&self, at: [f64; 2]) -> [f64; 2] {
        let from = minus(at, self.aim.at);
        let Some(arrival) = self.aim.arrival else { return unit(times(from, -1.0), [1.0, 0.0]) };
        let left = left_of(arrival);
        let beside = dot(from, left);
        // Linear between the centres: 1 on the left one's side, 0 on the right one's.
        let share = match self.only {
            only if only > 0.0 => 1.0,
            only if only < 0.0 => 0.0,
            _ => ((beside + BESIDE) / (2.0 * BESIDE)).clamp(0.0, 1.0),
        };
        let mut sum = [0.0; 2];
        if share > 0.0 {
            sum = times(spiral(minus(from, times(left, BESIDE)), self.aim.wide, 1.0), share);
        }
        if share < 1.0 {
            sum = plus(sum, times(spiral(plus(from, times(left, BESIDE)), self.aim.wide, -1.0), 1.0 - share));
        }
        unit(sum, arrival)
    }

    /// The field where the robot stands, and by how much it turns on the way, radians per metre.
    #[must_use]
    pub fn course(&self, at: [f64; 2]) -> ([f64; 2], f64) {
        let course = self.at(at);
        let next = self.at(plus(at, times(course, STEP)));
        (course, (cross(course, next) / STEP).clamp(-CURVATURE, CURVATURE))
    }
}

/// How hard the walls push back at a coordinate.
fn wall(coordinate: f64, half: f64) -> f64 {
    ((WALL - half + coordinate.abs()) / WALL).clamp(0.0, 1.0)
}

/// The flow of one hyperbolic spiral: around its centre to the left (`turn` 1) or to the right (-1).
///
/// Far out it leads to the centre, on the circle of radius [`BESIDE`] along it, within it outwards.
///
/// - `from`: the place relative to the centre.
///
/// Source: our choice, after the arrival fields of the league's teams UnBall and ThunderVolt.
fn spiral(from: [f64; 2], wide: f64, turn: f64) -> [f64; 2] {
    let far = length(from);
    let angle = if far > BESIDE {
        FRAC_PI_2 * (2.0 - (BESIDE + wide) / (far + wide))
    } else {
        FRAC_PI_2 * (far / BESIDE).sqrt()
    };
    let (sine, cosine) = libm::sincos(turn * angle);
    let [x, y] = unit(from, [1.0, 0.0]);
    [x * cosine - y * sine, x * sine + y * cosine]
}

impl Motion {
    /// Goes to a place along the field and stands there, looking in the arrival direction if one is given.
    ///
    /// - `front`: the unit vector of the robot's heading.
    /// - `obstacle`: a robot of ours to be avoided with a radius of its own.
    pub fn go(&mut self, view: &View, me: usize, front: [f64; 2], aim: Aim, obstacle: Option<Obstacle>) -> Wheels {
        let pose: &Pose = &view.ours[me];
        let to_go = distance(pose.at, aim.at);
        if to_go < ARRIVED && aim.past <= 0.0 {
            return aim.arrival.map_or_else(Wheels::default, |arrival| self.face(pose, front, arrival));
        }
        let field = Field::new(view, me, aim, self, obstacle);
        let (course, curvature) = field.course(pose.at);
        self.drive(front, course, curvature, to_go + aim.past)
    }
}
