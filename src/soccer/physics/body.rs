//! Robots and the ball: what they weigh, what their motors do, and how the ground brakes them.
//!
//! Masses, wheels and limits are those of rSim's robot and ball; accelerations are those that its robots were
//! measured to reach (`tests/soccer_physics.rs`).

use crate::soccer::pitch::{BALL_RADIUS, ROBOT};
use crate::soccer::view::Wheels;

/// Mass of a robot with wheels and casters, kilograms.
pub const ROBOT_MASS: f64 = 0.154;
/// Mass of the ball, kilograms.
pub const BALL_MASS: f64 = 0.043;
/// Radius of a wheel, metres.
pub const WHEEL_RADIUS: f64 = 0.026;
/// Half of the distance between the wheels, metres.
pub const HALF_TRACK: f64 = 0.040;
/// The fastest that a motor turns its wheel, radians per second.
pub const WHEEL_LIMIT: f64 = 46.0;
/// The most by which wheels change a robot's speed, metres per second squared.
pub const GRIP_ALONG: f64 = 7.5;
/// The most by which wheels change a robot's turn rate, radians per second squared.
pub const GRIP_TURN: f64 = 265.0;
/// How fast wheels take away sideways speed, metres per second squared: friction of 1.0 times gravity.
pub const GRIP_ACROSS: f64 = 9.81;
/// What a ball that slides is braked by, metres per second squared: friction of 1.0 times gravity.
const SLIDING: f64 = 9.81;
/// What a ball that rolls is braked by, metres per second squared.
pub const ROLLING: f64 = 0.14;
/// A ball that rolls more slowly stands, metres per second.
const STANDING: f64 = 0.01;
/// What the surface of a ball that turns about the vertical is braked by, metres per second squared. No source says;
/// our choice is little, as the ball touches the ground in a point.
const TWIST_LOSS: f64 = 1.0;

/// A rigid body in the plane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Body {
    /// Place of the centre, metres.
    pub at: [f64; 2],
    /// Cosine and sine of the heading.
    pub front: [f64; 2],
    /// Metres per second.
    pub velocity: [f64; 2],
    /// Turn rate about the vertical, radians per second.
    pub spin: f64,
    /// 1 / mass; 0 for what does not move.
    pub ease: f64,
    /// 1 / moment of inertia about the vertical.
    pub turn_ease: f64,
}

impl Body {
    /// A robot at rest at the origin. Its moment of inertia is that of a square plate.
    #[must_use]
    pub fn robot() -> Self {
        let inertia = ROBOT_MASS * ROBOT * ROBOT / 6.0;
        Self { front: [1.0, 0.0], ease: 1.0 / ROBOT_MASS, turn_ease: 1.0 / inertia, ..Self::default() }
    }

    /// The ball at rest at the origin: a solid sphere.
    #[must_use]
    pub fn ball() -> Self {
        let inertia = 0.4 * BALL_MASS * BALL_RADIUS * BALL_RADIUS;
        Self { front: [1.0, 0.0], ease: 1.0 / BALL_MASS, turn_ease: 1.0 / inertia, ..Self::default() }
    }

    /// What stands: the walls.
    #[must_use]
    pub fn wall() -> Self {
        Self { front: [1.0, 0.0], ..Self::default() }
    }

    /// Turns by a small angle, at most 0.5 radians or so, without a sine: the series is exact to 1e-9 there, and the
    /// heading's length is brought back to 1.
    pub fn turn(&mut self, angle: f64) {
        let square = angle * angle;
        let cos = 1.0 - square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0)));
        let sin = angle * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0))));
        let [c, s] = self.front;
        let (c, s) = (c * cos - s * sin, s * cos + c * sin);
        let scale = 1.5 - 0.5 * (c * c + s * s);
        self.front = [c * scale, s * scale];
    }

    /// The wheels pull a robot for `time` seconds toward the speed and turn rate that were asked for.
    ///
    /// Source: measured on rSim 1.2 (`tests/soccer_physics.rs`); that the three limits are independent is our choice.
    pub fn pull(&mut self, drive: Drive, time: f64) {
        let [c, s] = self.front;
        let [x, y] = self.velocity;
        let (along, across) = (x * c + y * s, y * c - x * s);
        let along = toward(along, drive.speed, GRIP_ALONG * time);
        let across = toward(across, 0.0, GRIP_ACROSS * time);
        self.velocity = [along * c - across * s, along * s + across * c];
        self.spin = toward(self.spin, drive.turn, GRIP_TURN * time);
    }

    /// The ground brakes the ball for `time` seconds.
    ///
    /// - `roll`: the velocity at which the ball would roll with its spin; it changes as well.
    ///
    /// While the ball slides, friction moves velocity and surface toward each other; the surface of a sphere gives way
    /// 5/2 times as fast. Then it rolls, and is braked as measured. Source: measured on rSim 1.2
    /// (`tests/soccer_physics.rs`).
    pub fn brake(&mut self, roll: &mut [f64; 2], time: f64) {
        let slip = [self.velocity[0] - roll[0], self.velocity[1] - roll[1]];
        let square = slip[0] * slip[0] + slip[1] * slip[1];
        let most = 3.5 * SLIDING * time;
        if square > most * most {
            let step = SLIDING * time / square.sqrt();
            for axis in 0..2 {
                self.velocity[axis] -= step * slip[axis];
                roll[axis] += 2.5 * step * slip[axis];
            }
        } else {
            let rolling = [self.velocity[0] - slip[0] * (2.0 / 7.0), self.velocity[1] - slip[1] * (2.0 / 7.0)];
            let square = rolling[0] * rolling[0] + rolling[1] * rolling[1];
            let scale = if square > STANDING * STANDING { 1.0 - ROLLING * time / square.sqrt() } else { 0.0 };
            self.velocity = rolling.map(|speed| speed * scale.max(0.0));
            *roll = self.velocity;
        }
        self.spin = toward(self.spin, 0.0, TWIST_LOSS / BALL_RADIUS * time);
    }
}

/// `value` moved toward `target` by at most `most`.
fn toward(value: f64, target: f64, most: f64) -> f64 {
    if value < target - most {
        value + most
    } else if value > target + most {
        value - most
    } else {
        target
    }
}

/// What the wheels ask of a robot: speed forward in metres per second and turn rate in radians per second.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive {
    /// Metres per second, forward positive.
    pub speed: f64,
    /// Radians per second, counter-clockwise positive.
    pub turn: f64,
}

impl Drive {
    /// What wheels ask for.
    ///
    /// - `wheels`: finite; each is limited to [`WHEEL_LIMIT`].
    /// - `gain`: by how much the motors turn faster than asked, near 1. The limit holds before it.
    #[must_use]
    pub fn of(wheels: Wheels, gain: f64) -> Self {
        let [left, right] = [wheels.left, wheels.right].map(|speed| speed.clamp(-WHEEL_LIMIT, WHEEL_LIMIT) * gain);
        Self {
            speed: (left + right) * (WHEEL_RADIUS / 2.0),
            turn: (right - left) * (WHEEL_RADIUS / (2.0 * HALF_TRACK)),
        }
    }
}
