//! From a direction to wheel speeds.

use super::unstick::Held;
use crate::fingerprint::Fingerprint;
use crate::soccer::physics::{HALF_TRACK, WHEEL_LIMIT, WHEEL_RADIUS};
use crate::soccer::team::geometry::{cross, dot, side, times};
use crate::soccer::view::{Pose, Wheels};
use std::f64::consts::PI;

/// Greatest speed, metres per second.
const SPEED: f64 = 1.2;
/// Greatest turn rate while driving, radians per second.
const TURN: f64 = 18.0;
/// Turn rate of a spin, radians per second.
pub const SPIN: f64 = 25.0;
/// Sideways acceleration without slip: 0.4 g.
const GRIP: f64 = 0.4 * 9.81;
/// The direction is so far off that the other end should lead: 100 degrees.
const FLIP: f64 = 100.0 / 180.0 * PI;
/// Frames between two flips: 0.5 s.
const FLIP_FRAMES: u32 = 30;

/// Wheel speeds for a speed and a turn rate; when a wheel would be too fast the turn is kept and the speed reduced.
///
/// Source: our choice.
#[must_use]
pub fn wheels(speed: f64, turn: f64) -> Wheels {
    let most = WHEEL_LIMIT * WHEEL_RADIUS;
    // Not clamp, which panics when a bound is no number: a view may hold anything.
    let across = (turn * HALF_TRACK).min(most).max(-most);
    let room = most - across.abs();
    let speed = speed.min(room).max(-room);
    Wheels { left: (speed - across) / WHEEL_RADIUS, right: (speed + across) / WHEEL_RADIUS }
}

/// What a robot's motion remembers from frame to frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// The rear leads.
    reversed: bool,
    /// Frames before the next flip.
    keeps: u32,
    /// The target is so near to a side wall that only one spiral is used.
    pub(super) at_wall: bool,
    /// Whether something holds it.
    pub(super) held: Held,
}

impl Motion {
    /// Lets a frame pass.
    pub fn pass(&mut self) {
        self.keeps = self.keeps.saturating_sub(1);
    }

    /// Drives in a direction with whichever end is nearer to it.
    ///
    /// - `front`: the unit vector of the robot's heading.
    /// - `course`: the unit vector in which to drive.
    /// - `curvature`: by how much the course turns on the way, radians per metre, counter-clockwise.
    /// - `left_to_go`: distance to where the robot shall stand; infinite when it shall not stop.
    ///
    /// Source: our choice.
    pub fn drive(&mut self, front: [f64; 2], course: [f64; 2], curvature: f64, left_to_go: f64) -> Wheels {
        let leads = if self.reversed { times(front, -1.0) } else { front };
        let mut error = libm::atan2(cross(leads, course), dot(leads, course));
        if error.abs() > FLIP && self.keeps == 0 {
            self.reversed = !self.reversed;
            self.keeps = FLIP_FRAMES;
            error -= side(error) * PI;
        }
        let approach = 5.0 * left_to_go;
        let slowed = libm::exp(-error * error / (2.0 * 0.7 * 0.7));
        let correction = correction(error);
        let speed = SPEED.min(approach).min(without_slip(curvature, correction)) * slowed;
        let turn = (speed * curvature + correction).clamp(-TURN, TURN);
        wheels(if self.reversed { -speed } else { speed }, turn)
    }

    /// Turns on the spot until one end looks along `course`.
    ///
    /// - `pose`, `front`: where the robot is, and the unit vector of its heading.
    #[must_use]
    pub fn face(&self, pose: &Pose, front: [f64; 2], course: [f64; 2]) -> Wheels {
        let course = if dot(front, course) < 0.0 { times(course, -1.0) } else { course };
        let error = libm::atan2(cross(front, course), dot(front, course));
        // Within 3 degrees and hardly turning: rest, instead of trembling about the direction.
        if error.abs() < 0.05 && pose.spin.abs() < 1.0 {
            return Wheels::default();
        }
        wheels(0.0, correction(error).clamp(-TURN, TURN))
    }

    /// Takes everything into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        hash.u32(u32::from(self.reversed) | u32::from(self.at_wall) << 1 | self.keeps << 2);
        self.held.feed(hash);
    }
}

/// The greatest speed v at which v times the turn rate, v * curvature + correction, does not exceed the grip, nor the turn
/// rate its limit.
fn without_slip(curvature: f64, correction: f64) -> f64 {
    let bend = curvature.abs();
    if bend < 1e-3 {
        return GRIP / correction.abs().max(1e-9);
    }
    // bend v^2 + same v = grip; `same` is negative when the correction turns against the curve.
    let same = correction * side(curvature);
    let slip = ((same * same + 4.0 * bend * GRIP).sqrt() - same) / (2.0 * bend);
    slip.min((TURN - same) / bend)
}

/// The turn rate that takes away an error of the heading.
fn correction(error: f64) -> f64 {
    8.0 * side(error) * error.abs().sqrt()
}
