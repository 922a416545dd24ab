//! The pitch as a team sees it, and plane vectors.
//!
//! Team frame: the own goal at x = -0.75, the other one at x = 0.75; metres.

use crate::soccer::view::Ball;
use crate::soccer::{physics, pitch};

/// Control frames per second.
pub const FRAMES_PER_SECOND: f64 = physics::FRAMES_PER_SECOND as f64;
/// The centre of the own goal's mouth.
pub const OWN_GOAL: [f64; 2] = [-HALF[0], 0.0];
/// The centre of the other goal's mouth.
pub const THEIR_GOAL: [f64; 2] = [HALF[0], 0.0];
/// Half the width of a goal's mouth.
pub const POST: f64 = pitch::GOAL_HALF;
/// Half the length and half the width of the playing area.
pub const HALF: [f64; 2] = [pitch::HALF_LENGTH, pitch::HALF_WIDTH];
/// Where a goal area begins, from the halfway line.
pub const AREA_X: f64 = pitch::AREA_X;
/// Half the width of a goal area.
pub const AREA_Y: f64 = pitch::AREA_HALF;
/// The own penalty mark lies at minus this, the other one at this.
pub const MARK_X: f64 = pitch::PENALTY_X;
/// The length of a robot, s in the tables.
pub const ROBOT: f64 = pitch::ROBOT;
/// What rolling costs the ball, metres per second squared, as measured on rSim 1.2.
pub const ROLLING_LOSS: f64 = physics::ROLLING;

/// `a + b`.
#[must_use]
pub fn plus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// `a - b`.
#[must_use]
pub fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// `factor * a`.
#[must_use]
pub fn times(a: [f64; 2], factor: f64) -> [f64; 2] {
    [a[0] * factor, a[1] * factor]
}

/// The scalar product.
#[must_use]
pub fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The third component of the vector product: positive when `b` lies to the left of `a`.
#[must_use]
pub fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// The length of a vector.
#[must_use]
pub fn length(a: [f64; 2]) -> f64 {
    dot(a, a).sqrt()
}

/// The distance of two points.
#[must_use]
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    length(minus(a, b))
}

/// The vector of length 1 in the direction of `a`; `otherwise` when `a` is too short to have one.
#[must_use]
pub fn unit(a: [f64; 2], otherwise: [f64; 2]) -> [f64; 2] {
    let long = length(a);
    if long > 1e-9 { times(a, 1.0 / long) } else { otherwise }
}

/// `a` turned to the left by a right angle.
#[must_use]
pub fn left_of(a: [f64; 2]) -> [f64; 2] {
    [-a[1], a[0]]
}

/// 1 or -1: the side of the halfway line through both goals on which `y` lies; 1 on the line.
#[must_use]
pub fn side(y: f64) -> f64 {
    if y < 0.0 { -1.0 } else { 1.0 }
}

/// True when `at` lies in the own goal area or (`own` false) in the other one, grown by `by` on its open sides.
#[must_use]
pub fn in_area(at: [f64; 2], own: bool, by: f64) -> bool {
    let depth = if own { -at[0] } else { at[0] };
    depth > AREA_X - by && at[1].abs() < AREA_Y + by
}

/// Seconds until a rolling ball crosses the line `x`; `None` when it moves away from it or stops before.
#[must_use]
pub fn time_to_line(ball: &Ball, x: f64) -> Option<f64> {
    let gap = x - ball.at[0];
    if gap * ball.velocity[0] <= 0.0 {
        return None;
    }
    let speed = length(ball.velocity);
    let way = (gap / ball.velocity[0] * speed).abs();
    // way = speed t - loss t^2 / 2
    let left = speed * speed - 2.0 * ROLLING_LOSS * way;
    (left >= 0.0).then(|| (speed - left.sqrt()) / ROLLING_LOSS)
}
