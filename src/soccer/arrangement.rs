//! Robots and ball put somewhere by hand, and why they cannot be put there.

use super::physics::{BALL, Overlap, Physics, ROBOTS, WALL};
use super::pitch::Side;
use super::view::{self, Ball, Spot};
use std::fmt;

/// Where everything is, in the frame of the pitch; robots of the left team first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrangement {
    /// The ball, and how it moves.
    pub ball: Ball,
    /// The robots.
    pub robots: [[Spot; view::ROBOTS]; 2],
}

/// Overlaps up to this are accepted, as robots that press against each other have them, metres.
const TOLERANCE: f64 = 0.002;
/// What differs by less is the same number, metres, radians or metres per second: places are written in millionths.
const SAME: f64 = 1e-6;
/// The greatest speed of a ball that somebody sets, metres per second.
const FASTEST: f64 = 4.0;

/// Why an arrangement is refused.
#[derive(Clone, Debug, PartialEq)]
pub struct ArrangementError {
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    NotFinite { body: usize },
    TooFast { speed: f64 },
    Off { body: usize, depth: f64 },
    Overlap { bodies: [usize; 2], depth: f64 },
}

fn name(body: usize) -> String {
    match body {
        BALL => "the ball".to_owned(),
        robot => {
            let side = if robot < view::ROBOTS { "left" } else { "right" };
            format!("robot {} of the {side} team", robot % view::ROBOTS + 1)
        }
    }
}

impl fmt::Display for ArrangementError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            Kind::NotFinite { body } => write!(out, "{}: expected finite numbers, found one that is none", name(*body)),
            Kind::TooFast { speed } => write!(out, "the ball: expected at most {FASTEST} m/s, found {speed:.1}"),
            Kind::Off { body, depth } => {
                let body = name(*body);
                write!(out, "{body}: expected a place on the pitch, found one {:.1} mm into a wall", depth * 1000.0)
            }
            Kind::Overlap { bodies: [a, b], depth } => {
                let (a, b) = (name(*a), name(*b));
                write!(out, "{a}: expected a place apart from {b}, found an overlap of {:.1} mm", depth * 1000.0)
            }
        }
    }
}

impl std::error::Error for ArrangementError {}

impl Arrangement {
    /// The spot of a robot, 0 to 5; the last one stands in for others.
    #[must_use]
    pub fn spot(&self, robot: usize) -> Spot {
        let robot = robot.min(ROBOTS - 1);
        self.robots[robot / view::ROBOTS][robot % view::ROBOTS]
    }

    /// Checks that everything is on the pitch and apart.
    ///
    /// # Errors
    /// Which robot or ball, what was found and what is allowed.
    pub fn check(&self) -> Result<(), ArrangementError> {
        let fault = |kind| Err(ArrangementError { kind });
        let finite = |reals: &[f64]| reals.iter().all(|real| real.is_finite());
        for robot in 0..ROBOTS {
            let Spot { at, heading } = self.spot(robot);
            if !finite(&[at[0], at[1], heading]) {
                return fault(Kind::NotFinite { body: robot });
            }
        }
        let Ball { at, velocity } = self.ball;
        if !finite(&[at[0], at[1], velocity[0], velocity[1]]) {
            return fault(Kind::NotFinite { body: BALL });
        }
        let speed = libm::hypot(velocity[0], velocity[1]);
        if speed > FASTEST {
            return fault(Kind::TooFast { speed });
        }
        let overlaps = self.physics().overlaps();
        match overlaps.into_iter().max_by(|one, other| one.depth.total_cmp(&other.depth)) {
            Some(Overlap { a, b: WALL, depth }) if depth > TOLERANCE => fault(Kind::Off { body: a, depth }),
            Some(Overlap { a, b, depth }) if depth > TOLERANCE => fault(Kind::Overlap { bodies: [a, b], depth }),
            Some(_) | None => Ok(()),
        }
    }

    /// The same arrangement, with everything that stands where it is in `now` taken from there: what was written down and
    /// is not moved shall go on.
    #[must_use]
    pub fn keeping(&self, now: &Self) -> Self {
        let near = |one: f64, other: f64| (one - other).abs() < SAME;
        let both = |one: [f64; 2], other: [f64; 2]| near(one[0], other[0]) && near(one[1], other[1]);
        let mut kept = *self;
        for (spot, now) in kept.robots.iter_mut().flatten().zip(now.robots.iter().flatten()) {
            if both(spot.at, now.at) && near(spot.heading, now.heading) {
                *spot = *now;
            }
        }
        if both(kept.ball.at, now.ball.at) && both(kept.ball.velocity, now.ball.velocity) {
            kept.ball = now.ball;
        }
        kept
    }

    /// Everything put where it is, at rest.
    pub(super) fn physics(&self) -> Physics {
        let mut physics = Physics::new(1);
        for robot in 0..ROBOTS {
            let Spot { at, heading } = self.spot(robot);
            physics.put_robot(robot, at, heading);
        }
        physics.put_ball(self.ball.at, [0.0; 2], [0.0; 2]);
        physics
    }

    /// The side that a robot belongs to.
    pub(super) fn side(robot: usize) -> Side {
        if robot < view::ROBOTS { Side::Left } else { Side::Right }
    }
}
