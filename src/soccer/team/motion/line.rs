//! Keeping to a line across the pitch.

use super::wheels::Motion;
use crate::soccer::team::geometry::{length, side, unit};
use crate::soccer::view::{Pose, Wheels};

/// The spread of the Gaussian weight.
const SPREAD: f64 = 0.03;
/// So near to its place a robot rests.
const ARRIVED: f64 = 0.006;
/// Within this the way along the line fades, so that the robot does not hunt about its place.
const FADES: f64 = 0.02;

/// Steers to the line at `x`, and along it to `y`, where it stands looking along the line.
///
/// The weight of the way along the line is Gaussian in the distance to it: 1 on the line, where the weight of the way to
/// the line is 0.
///
/// Source: our choice.
///
/// - `front`: the unit vector of the robot's heading.
pub fn keep_line(motion: &mut Motion, pose: &Pose, front: [f64; 2], x: f64, y: f64) -> Wheels {
    let off = [x - pose.at[0], y - pose.at[1]];
    if off[1].abs() < ARRIVED && off[0].abs() < 2.0 * ARRIVED {
        return motion.face(pose, front, [0.0, 1.0]);
    }
    let along = libm::exp(-off[0] * off[0] / (2.0 * SPREAD * SPREAD));
    let course = [(1.0 - along) * side(off[0]), along * (off[1] / FADES).clamp(-1.0, 1.0)];
    motion.drive(front, unit(course, [0.0, 1.0]), 0.0, length(off))
}
