//! How a robot moves: the field it follows, the lines it keeps, and the wheel speeds that follow from both.
//!
//! Source: our choice, after the league's teams ThunderVolt and UnBall. All roles share it, under both coaches.
//!
//! | question | choice |
//! |---|---|
//! | weights of the field | attraction 1, repulsion up to 1.5, flow around obstacles up to 1.2, walls up to 1 |
//! | obstacles near the target | fade over the last 0.20 to the target, so that a contested ball can be reached |
//! | walls near the target | push no more than they push at the target, so that a ball at the wall can be reached |
//! | curvature of the field | difference over 0.01 along it, at most 20 per metre |
//! | speed and turn limit each other | solved together, so that the robot follows the curvature of the field at the slip limit |
//! | a robot that is held | after 0.4 s of driving without motion it backs off for 0.2 s, at a wall away from it |
//! | at the target | within 0.012 of a place to stand the robot only turns |

mod field;
mod line;
mod unstick;
mod wheels;

pub use field::{Aim, Field, Obstacle};
pub use line::keep_line;
pub use wheels::{Motion, SPIN, wheels};

use super::geometry::{HALF, distance, plus, times};
use crate::soccer::view::{Ball, Wheels};

/// Where to meet a moving ball, for a robot at `from`.
///
/// Source: our choice.
#[must_use]
pub fn meet(ball: &Ball, from: [f64; 2]) -> [f64; 2] {
    let [x, y] = plus(ball.at, times(ball.velocity, distance(ball.at, from) / 0.8));
    let [most_x, most_y] = [HALF[0] - 0.03, HALF[1] - 0.03];
    [x.clamp(-most_x, most_x), y.clamp(-most_y, most_y)]
}

/// Turns on the spot, to the left when `turn` is positive.
#[must_use]
pub fn spin(turn: f64) -> Wheels {
    wheels(0.0, if turn < 0.0 { -SPIN } else { SPIN })
}
