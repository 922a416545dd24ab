//! Getting free: a robot that drives and does not move backs off.
//!
//! A square robot that stands flush against a wall cannot turn there, since its corners need more room than its sides.

use super::wheels::{Motion, wheels};
use crate::fingerprint::Fingerprint;
use crate::soccer::team::geometry::{HALF, dot, length, side};
use crate::soccer::view::{Pose, Wheels};

/// A wheel that is told less than this, radians per second, is not expected to move the robot.
const TOLD: f64 = 4.0;
/// Slower than this, metres per second, and ...
const STILL: f64 = 0.04;
/// ... turning less than this, radians per second, a robot does not move.
const STEADY: f64 = 0.6;
/// Frames without motion before the robot backs off: 0.4 s.
const PATIENCE: u32 = 24;
/// Frames of backing off: 0.2 s.
const FREEING: u32 = 12;
/// Speed of backing off, metres per second.
const SPEED: f64 = 0.8;
/// Nearer to a wall than this, metres from its centre, the wall decides in which direction.
const WALL: f64 = 0.07;

/// What a robot remembers of being held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Frames in which it drove and did not move.
    frames: u32,
    /// Frames of backing off that are left.
    freeing: u32,
    /// With the rear first.
    backwards: bool,
}

impl Held {
    /// Takes everything into a fingerprint.
    pub fn feed(self, hash: &mut Fingerprint) {
        hash.u32(self.frames << 8 | self.freeing << 1 | u32::from(self.backwards));
    }
}

impl Motion {
    /// What the wheels are told instead of `told` when the robot has been held for a while: away from the wall it stands
    /// at, otherwise away from where it wanted to go.
    ///
    /// - `front`: the unit vector of the robot's heading.
    pub fn unstick(&mut self, pose: &Pose, front: [f64; 2], told: Wheels) -> Wheels {
        let held = &mut self.held;
        if held.freeing > 0 {
            held.freeing -= 1;
            return wheels(if held.backwards { -SPEED } else { SPEED }, 0.0);
        }
        let drives = told.left.abs().max(told.right.abs()) > TOLD;
        let moves = length(pose.velocity) > STILL || pose.spin.abs() > STEADY;
        held.frames = if drives && !moves { held.frames + 1 } else { 0 };
        if held.frames < PATIENCE {
            return told;
        }
        let [x, y] = pose.at;
        let mut inwards = [0.0; 2];
        if HALF[0] - x.abs() < WALL {
            inwards[0] = -side(x);
        }
        if HALF[1] - y.abs() < WALL {
            inwards[1] = -side(y);
        }
        let along = dot(front, inwards);
        let backwards = if along.abs() > 0.3 { along < 0.0 } else { told.left + told.right > 0.0 };
        *held = Held { frames: 0, freeing: FREEING, backwards };
        told
    }
}
