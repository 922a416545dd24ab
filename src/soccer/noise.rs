//! What is uncertain: where things are placed, what the camera sees, how strong motors are and what the radio loses.
//!
//! Everything is drawn from streams of its own, one for each robot and one for the ball, numbered by side of the pitch:
//! the same match with the sides exchanged gives each *side* the same luck. Where an amount is 0 nothing is drawn.
//!
//! The camera is one for both teams, as in the league's simulators: it sees places and headings with noise, and tells
//! velocities as they are, since filters are not what is studied here.
//!
//! Source: our choice; losses and delays are options of FIRASim.

use super::params::Params;
use super::physics::{BALL, Drive, Physics, ROBOTS};
use super::view::{Ball, Pose, Wheels};
use crate::fingerprint::Fingerprint;
use crate::random::{Purpose, Seed, Stream, chance, normal_pair, standard_normal, stream};
use std::f64::consts::PI;

/// The longest delay of a command, control frames.
pub const MOST_DELAY: u8 = 30;
const RING: usize = MOST_DELAY as usize;

/// One stream for each of the first `N` indices.
fn streams<const N: usize>(seed: Seed, purpose: Purpose) -> [Stream; N] {
    std::array::from_fn(|index| stream(seed, purpose, index as u32))
}

/// The camera, and what it saw last.
#[derive(Clone, Debug)]
pub struct Camera {
    /// Metres.
    place: f64,
    /// Radians.
    heading: f64,
    /// The share of detections that are lost.
    lost: f64,
    streams: [Stream; ROBOTS + 1],
    robots: [Pose; ROBOTS],
    ball: Ball,
}

impl Camera {
    /// A camera that has seen nothing yet.
    #[must_use]
    pub fn new(params: &Params, seed: Seed) -> Self {
        Self {
            place: params.vision_noise / 1000.0,
            heading: params.heading_noise * PI / 180.0,
            lost: params.lost_detections,
            streams: streams(seed, Purpose::Vision),
            robots: [Pose::default(); ROBOTS],
            ball: Ball::default(),
        }
    }

    /// Looks at everything once.
    ///
    /// - `first`: whether nothing can be lost, as after a placement; otherwise what is lost is told as it was last seen.
    pub fn look(&mut self, physics: &Physics, first: bool) {
        for body in 0..=BALL {
            let stream = &mut self.streams[body];
            let lost = self.lost > 0.0 && chance(stream, self.lost);
            let mut at = physics.at(body);
            if self.place > 0.0 {
                let [x, y] = normal_pair(stream);
                at = [at[0] + self.place * x, at[1] + self.place * y];
            }
            let turned = if self.heading > 0.0 && body < BALL { self.heading * standard_normal(stream) } else { 0.0 };
            if lost && !first {
                continue;
            }
            let velocity = physics.velocity(body);
            if body == BALL {
                self.ball = Ball { at, velocity };
            } else {
                let heading = within_a_turn(physics.heading(body) + turned);
                self.robots[body] = Pose { at, heading, velocity, spin: physics.spin(body) };
            }
        }
    }

    /// The robots as they were seen last: the left team's, then the right team's.
    #[must_use]
    pub fn robots(&self) -> &[Pose; ROBOTS] {
        &self.robots
    }

    /// The ball as it was seen last.
    #[must_use]
    pub fn ball(&self) -> Ball {
        self.ball
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        self.streams.iter().for_each(|stream| hash.stream(stream));
        for Pose { at, heading, velocity, spin } in &self.robots {
            for real in [at[0], at[1], *heading, velocity[0], velocity[1], *spin] {
                hash.f64(real);
            }
        }
        self.ball.at.into_iter().chain(self.ball.velocity).for_each(|real| hash.f64(real));
    }
}

/// An angle up to two turns off, brought into `(-pi, pi]`.
fn within_a_turn(angle: f64) -> f64 {
    if angle > PI {
        angle - 2.0 * PI
    } else if angle <= -PI {
        angle + 2.0 * PI
    } else {
        angle
    }
}

/// The radio and the motors: what is sent arrives later, at times not at all, and turns wheels a little too fast or too
/// slowly.
#[derive(Clone, Debug)]
pub struct Radio {
    lost: f64,
    delay: usize,
    gains: [f64; ROBOTS],
    streams: [Stream; ROBOTS],
    /// What was sent last; the robot goes on with it when a command is lost.
    last: [Wheels; ROBOTS],
    /// What is on its way, in a ring; `next` is the place of the oldest.
    sent: [[Wheels; ROBOTS]; RING],
    next: usize,
}

impl Radio {
    /// A radio with the motors of one match.
    #[must_use]
    pub fn new(params: &Params, seed: Seed) -> Self {
        let mut streams = streams(seed, Purpose::Wheels);
        let share = params.wheel_noise / 100.0;
        let gains = streams.each_mut().map(|stream| {
            // Four deviations at most: no robot is twice as strong, nor drives backwards.
            if share > 0.0 { 1.0 + share * standard_normal(stream).clamp(-4.0, 4.0) } else { 1.0 }
        });
        Self {
            lost: params.lost_commands,
            delay: (params.command_delay as usize).min(RING),
            gains,
            streams,
            last: [Wheels::default(); ROBOTS],
            sent: [[Wheels::default(); ROBOTS]; RING],
            next: 0,
        }
    }

    /// Forgets all commands, as after a placement.
    pub fn clear(&mut self) {
        self.last = [Wheels::default(); ROBOTS];
        self.sent = [self.last; RING];
        self.next = 0;
    }

    /// Sends commands to all robots; returns what the robots do now.
    ///
    /// - `wheels`: finite.
    pub fn send(&mut self, wheels: &[Wheels; ROBOTS]) -> [Drive; ROBOTS] {
        for (robot, &wheels) in wheels.iter().enumerate() {
            if self.lost == 0.0 || !chance(&mut self.streams[robot], self.lost) {
                self.last[robot] = wheels;
            }
        }
        let mut now = self.last;
        if self.delay > 0 {
            std::mem::swap(&mut now, &mut self.sent[self.next]);
            self.next = (self.next + 1) % self.delay;
        }
        std::array::from_fn(|robot| Drive::of(now[robot], self.gains[robot]))
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        self.streams.iter().for_each(|stream| hash.stream(stream));
        self.gains.iter().for_each(|&gain| hash.f64(gain));
        hash.u32(self.next as u32);
        for wheels in self.last.iter().chain(self.sent[..self.delay].iter().flatten()) {
            hash.f64(wheels.left);
            hash.f64(wheels.right);
        }
    }
}

/// The hands that place robots and ball.
#[derive(Clone, Debug)]
pub struct Hands {
    /// Metres.
    jitter: f64,
    streams: [Stream; ROBOTS + 1],
}

impl Hands {
    /// The hands of one match.
    #[must_use]
    pub fn new(params: &Params, seed: Seed) -> Self {
        Self { jitter: params.placement_noise / 1000.0, streams: streams(seed, Purpose::Placement) }
    }

    /// Where a robot, or with [`BALL`] the ball, comes to stand that shall be placed at `at`.
    pub fn put(&mut self, body: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        if self.jitter == 0.0 {
            return [x, y];
        }
        let [dx, dy] = normal_pair(&mut self.streams[body.min(BALL)]).map(|draw| draw.clamp(-3.0, 3.0));
        [x + self.jitter * dx, y + self.jitter * dy]
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        self.streams.iter().for_each(|stream| hash.stream(stream));
    }
}
