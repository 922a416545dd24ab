//! A robot that plays a role: its tree's memory, and what its conditions and skills remember.

use super::leaf::{Leaf, What};
use super::{Roles, act, sense};
use crate::bt::{Host, Memory, NodeId, Ports, Recorder, Status, TickError, pass_time, tick_once};
use crate::fingerprint::Fingerprint;
use crate::soccer::team::duties::Role;
use crate::soccer::team::motion::Motion;
use crate::soccer::view::{Pose, ROBOTS, View, Wheels};

/// What all robots of a team are told in a frame.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// What the team sees.
    pub view: &'a View,
    /// Who plays what.
    pub roles: [Role; ROBOTS],
    /// With two Strikers, the one that gets the ball.
    pub first_striker: Option<usize>,
    /// On which side of the ball the penalty kicker starts: 1 or -1.
    pub penalty_side: f64,
}

/// What one robot remembers.
#[derive(Clone, Debug, Default)]
pub struct Player {
    role: Option<Role>,
    memory: Memory,
    /// By node: whether a condition with two thresholds is on.
    on: Vec<bool>,
    pub(super) state: State,
}

/// What the skills of a robot remember.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Of the wheels and the field.
    pub motion: Motion,
    /// The side away from the ball, 1 or -1; 0 before it was needed.
    pub aside: f64,
    /// By how much the spin under way has turned, radians.
    pub turned: f64,
    /// Frames of the spin under way.
    pub spinning: u32,
}

/// A robot during the tick of its tree.
pub(super) struct Robot<'a> {
    pub scene: &'a Scene<'a>,
    pub me: usize,
    /// The unit vector of its heading.
    pub front: [f64; 2],
    pub state: &'a mut State,
    on: &'a mut [bool],
    /// What its wheels are told.
    pub wheels: Wheels,
}

impl<'a> Robot<'a> {
    pub fn pose(&self) -> &'a Pose {
        &self.scene.view.ours[self.me]
    }

    /// A condition with two thresholds: `begins` when it was off, `lasts` when it was on.
    pub fn latch(&mut self, node: NodeId, begins: bool, lasts: bool) -> bool {
        let Some(on) = self.on.get_mut(node.index()) else { return begins };
        *on = if *on { lasts } else { begins };
        *on
    }
}

impl Host<Leaf> for Robot<'_> {
    fn tick(&mut self, node: NodeId, leaf: &Leaf, _ports: &mut Ports) -> Status {
        if leaf.what.acts() { act::act(self, leaf) } else { Status::completed(sense::sense(self, node, leaf)) }
    }

    fn halt(&mut self, _node: NodeId, leaf: &Leaf) {
        if leaf.what == What::Spin {
            (self.state.turned, self.state.spinning) = (0.0, 0);
        }
    }
}

impl Player {
    /// Ticks the tree of the robot's role and returns what it tells the wheels: nothing told is standing still.
    ///
    /// - `milliseconds`: what has passed since the last frame.
    ///
    /// # Errors
    /// The tree's tick ended with an error.
    pub fn play<R: Recorder>(
        &mut self,
        roles: &Roles,
        scene: &Scene,
        me: usize,
        milliseconds: u64,
        recorder: &mut R,
    ) -> Result<Wheels, TickError> {
        let role = scene.roles[me];
        let tree = roles.tree(role);
        if self.role != Some(role) {
            // A new role begins afresh; what the wheels remember is the robot's, not the role's.
            self.role = Some(role);
            self.memory.fit(tree);
            self.on.clear();
            self.on.resize(tree.nodes().len(), false);
            self.state = State { motion: self.state.motion, ..State::default() };
        }
        let pose = &scene.view.ours[me];
        let (sine, cosine) = libm::sincos(pose.heading);
        self.state.motion.pass();
        let mut robot = Robot {
            scene,
            me,
            front: [cosine, sine],
            state: &mut self.state,
            on: &mut self.on,
            wheels: Wheels::default(),
        };
        pass_time(tree, &mut self.memory, &mut robot, recorder, milliseconds)?;
        tick_once(tree, &mut self.memory, &mut robot, recorder)?;
        let (wheels, front) = (robot.wheels, robot.front);
        let wheels = self.state.motion.unstick(pose, front, wheels);
        // A view with something that is no number must not reach the motors.
        Ok(if wheels.left.is_finite() && wheels.right.is_finite() { wheels } else { Wheels::default() })
    }

    /// Forgets the role: the next frame begins it afresh.
    pub fn restart(&mut self) {
        self.role = None;
    }

    /// Takes everything that decides what follows into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        hash.u32(self.role.map_or(0, |role| role as u32 + 1));
        self.memory.hash_into(hash);
        for on in &self.on {
            hash.u32(u32::from(*on));
        }
        self.state.motion.feed(hash);
        hash.f64(self.state.aside);
        hash.f64(self.state.turned);
        hash.u32(self.state.spinning);
    }
}
