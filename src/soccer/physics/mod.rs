//! Six robots and a ball in the plane: a small solver of our own, the same bits on every machine.
//!
//! A substep: overlaps are found; wheels pull and the ground brakes; impulses stop what moves into something else;
//! everything moves; overlaps are taken away. Impulses come between pulling and moving, so that what is pressed against
//! something stands: moved before, it would creep by a part of each substep, and goals, most of which come of pressing,
//! would depend on the number of substeps. Robots keep no heading but its cosine and sine, so a substep needs no
//! transcendental function at all.
//!
//! | question | choice | reason |
//! |---|---|---|
//! | engine | own impulse solver, not `rapier2d` | four times faster natively, ten times in WebAssembly |
//! | ball | turns about the vertical as well | without it friction would stop a ball that slides along a wall, not roll it |
//! | spin into robots | worn off as at walls | the same friction acts there |
//! | lifting of the ball | none | two dimensions |
//! | friction between robots, and of robots and ball | 0.3 and 0.5 | no source says |
//!
//! Source: the solver is our choice; what it is held against was measured on rSim 1.2, row by row in
//! `tests/soccer_physics.rs`.

mod body;
mod solve;
mod touch;

pub use body::{Drive, GRIP_ALONG, GRIP_TURN, HALF_TRACK, ROLLING, WHEEL_LIMIT, WHEEL_RADIUS};

use crate::fingerprint::Fingerprint;
use body::Body;
use solve::Contact;
use touch::Touch;

/// Robots of both teams: the left team's three, then the right team's.
pub const ROBOTS: usize = 6;
/// Control frames in a second.
pub const FRAMES_PER_SECOND: u32 = 60;
/// The ball's place among the bodies.
pub const BALL: usize = ROBOTS;
/// The walls' place among the bodies.
pub const WALL: usize = ROBOTS + 1;

/// Rounds of taking deep overlaps away, in a substep.
const PARTINGS: u32 = 4;
/// What counts as a deep overlap, metres.
const DEEP: f64 = 0.001;

/// Seconds of so many control frames.
#[must_use]
pub fn seconds(frames: u32) -> f64 {
    f64::from(frames) / f64::from(FRAMES_PER_SECOND)
}

/// An overlap of two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// A robot, 0 to 5, or [`BALL`].
    pub a: usize,
    /// A robot, [`BALL`] or [`WALL`].
    pub b: usize,
    /// Metres.
    pub depth: f64,
}

/// Everything that moves.
#[derive(Clone, Debug)]
pub struct Physics {
    bodies: [Body; WALL + 1],
    roll: [f64; 2],
    substeps: u32,
    /// Seconds of a substep.
    time: f64,
    /// Bit i: robot i touched the ball in the last frame.
    on_ball: u8,
    touches: Vec<Touch>,
    /// Whether `touches` are those of where the bodies are now.
    found: bool,
    /// The contacts of the last substep.
    contacts: Vec<Contact>,
    /// Room to work in.
    before: Vec<Contact>,
}

impl Physics {
    /// Robots and ball at rest at the origin, to be placed.
    ///
    /// - `substeps`: of a control frame; at least 1 is taken.
    #[must_use]
    pub fn new(substeps: u32) -> Self {
        let substeps = substeps.max(1);
        let mut bodies = [Body::robot(); WALL + 1];
        bodies[BALL] = Body::ball();
        bodies[WALL] = Body::wall();
        Self {
            bodies,
            roll: [0.0; 2],
            substeps,
            time: 1.0 / f64::from(FRAMES_PER_SECOND * substeps),
            on_ball: 0,
            touches: Vec::new(),
            found: false,
            contacts: Vec::new(),
            before: Vec::new(),
        }
    }

    /// Puts a robot somewhere, at rest.
    ///
    /// - `robot`: 0 to 5; others are left out.
    /// - `at`, `heading`: finite.
    pub fn put_robot(&mut self, robot: usize, at: [f64; 2], heading: f64) {
        if let Some(body) = self.bodies[..ROBOTS].get_mut(robot) {
            let (sin, cos) = libm::sincos(heading);
            *body = Body { at, front: [cos, sin], ..Body::robot() };
            self.contacts.clear();
            self.found = false;
        }
    }

    /// Puts the ball somewhere.
    ///
    /// - `velocity`: of its centre, finite.
    /// - `roll`: the velocity at which it would roll with its spin; `velocity` for a rolling ball, zero for one without
    ///   spin.
    pub fn put_ball(&mut self, at: [f64; 2], velocity: [f64; 2], roll: [f64; 2]) {
        self.bodies[BALL] = Body { at, velocity, ..Body::ball() };
        self.roll = roll;
        self.contacts.clear();
        self.found = false;
    }

    /// One control frame, 1/60 s.
    pub fn step(&mut self, drives: &[Drive; ROBOTS]) {
        self.on_ball = 0;
        for _ in 0..self.substeps {
            self.substep(drives);
        }
    }

    /// One substep of a control frame.
    pub fn substep(&mut self, drives: &[Drive; ROBOTS]) {
        let time = self.time;
        if !self.found {
            self.find();
        }
        for (body, drive) in self.bodies[..ROBOTS].iter_mut().zip(drives) {
            body.pull(*drive, time);
        }
        let Self { bodies, touches, contacts, before, roll, .. } = self;
        bodies[BALL].brake(roll, time);
        if touches.is_empty() {
            contacts.clear();
        } else {
            solve::velocities(bodies, touches, contacts, before, roll);
        }
        for touch in touches.iter().filter(|touch| touch.b == BALL) {
            self.on_ball |= 1 << touch.a;
        }
        for body in &mut bodies[..=BALL] {
            body.at[0] += body.velocity[0] * time;
            body.at[1] += body.velocity[1] * time;
        }
        for body in &mut bodies[..ROBOTS] {
            body.turn(body.spin * time);
        }
        self.part();
    }

    /// Looks where bodies overlap now.
    fn find(&mut self) {
        self.touches.clear();
        touch::find(&self.bodies, &mut self.touches);
    }

    /// Takes overlaps away. What was deep, such as a corner of a spinning robot, touches at other points once it has
    /// moved, so it is looked at again. Most often nothing has to be moved, and the next substep takes what was found.
    fn part(&mut self) {
        for _ in 0..PARTINGS {
            self.find();
            self.found = !solve::places(&mut self.bodies, &self.touches);
            if self.found || self.touches.iter().all(|touch| touch.depth < DEEP) {
                return;
            }
        }
    }

    /// Place of a robot's centre, or with [`BALL`] of the ball's.
    ///
    /// - `body`: 0 to 6; greater numbers mean the ball as well.
    #[must_use]
    pub fn at(&self, body: usize) -> [f64; 2] {
        self.bodies[body.min(BALL)].at
    }

    /// Velocity of a robot, or with [`BALL`] of the ball.
    #[must_use]
    pub fn velocity(&self, body: usize) -> [f64; 2] {
        self.bodies[body.min(BALL)].velocity
    }

    /// Where a robot's front looks, radians in `(-pi, pi]`.
    #[must_use]
    pub fn heading(&self, robot: usize) -> f64 {
        let [c, s] = self.bodies[robot.min(BALL)].front;
        // The sign of zero would decide between pi and -pi.
        libm::atan2(if s == 0.0 { 0.0 } else { s }, c)
    }

    /// Turn rate of a robot, radians per second.
    #[must_use]
    pub fn spin(&self, robot: usize) -> f64 {
        self.bodies[robot.min(BALL)].spin
    }

    /// Whether a robot touched the ball in the last frame.
    #[must_use]
    pub fn touched_ball(&self, robot: usize) -> bool {
        robot < ROBOTS && self.on_ball >> robot & 1 == 1
    }

    /// Every overlap now, in a fixed order; robots that rest on something overlap by up to half a millimetre.
    #[must_use]
    pub fn overlaps(&self) -> Vec<Overlap> {
        let mut touches = Vec::new();
        touch::find(&self.bodies, &mut touches);
        touches.into_iter().map(|Touch { a, b, depth, .. }| Overlap { a, b, depth }).collect()
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        for body in &self.bodies[..WALL] {
            for real in [body.at, body.front, body.velocity].into_iter().flatten().chain([body.spin]) {
                hash.f64(real);
            }
        }
        self.roll.iter().for_each(|&real| hash.f64(real));
        hash.u32(u32::from(self.on_ball));
        self.contacts.iter().for_each(|contact| contact.absorb(hash));
    }
}
