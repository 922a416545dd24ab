//! What a team sees and what it answers: the border between the match and whoever plays it.
//!
//! Everything here is in the team's own frame: the own goal is at x = -0.75, the other team's at x = 0.75, y to
//! the left of a robot that looks at the other team's goal. Metres, seconds, radians.

/// Robots of one team.
pub const ROBOTS: usize = 3;

/// A ball, and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ball {
    /// Place, metres.
    pub at: [f64; 2],
    /// Velocity, metres per second.
    pub velocity: [f64; 2],
}

/// A robot, and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Place of the centre, metres.
    pub at: [f64; 2],
    /// Where the front looks, radians, counter-clockwise from the x axis, in `(-pi, pi]`.
    pub heading: f64,
    /// Velocity, metres per second.
    pub velocity: [f64; 2],
    /// Turn rate, radians per second.
    pub spin: f64,
}

/// Speeds asked of a robot's wheels, radians per second; positive rolls forward. The motors limit them to 46.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wheels {
    /// The wheel on the robot's left.
    pub left: f64,
    /// The wheel on the robot's right.
    pub right: f64,
}

/// How play starts again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Restart {
    /// From the centre: start of a half, or after a goal.
    KickOff,
    /// Nobody's ball, at a cross of the quadrant.
    FreeBall,
    /// Out of the goal area.
    GoalKick,
    /// From the penalty mark.
    PenaltyKick,
}

/// Which team, seen from one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whose {
    /// The team that looks.
    Ours,
    /// The other one.
    Theirs,
}

/// What the referee called last. For a free ball `taker` is the team for which the quadrant lies in its attacking half.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Call {
    /// How play starts again.
    pub restart: Restart,
    /// The team that takes it.
    pub taker: Whose,
    /// The quadrant, 1 to 4, in the team's frame; of a free ball only, else 0.
    pub quadrant: u8,
    /// Counts the calls of a match from 1.
    pub number: u32,
}

/// What a team is told at a control frame (1/60 s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Control frames of play since the start of the match; waiting for the referee does not count.
    pub frame: u32,
    /// Control frames of play since the last call was placed.
    pub since: u32,
    /// The last call.
    pub call: Call,
    /// The ball as the team's camera sees it.
    pub ball: Ball,
    /// The team's robots as its camera sees them.
    pub ours: [Pose; ROBOTS],
    /// The other team's robots as the camera sees them.
    pub theirs: [Pose; ROBOTS],
}

/// The place that a role takes at a restart: a column of the placement table of VSSReferee.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// Goalkeeper or penalty defender.
    Goalkeeper,
    /// Striker, wingback or penalty kicker.
    Attacker,
    /// Assistant, fullback or second striker.
    Supporter,
}

/// Where a team wants a robot at a restart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Place of the centre, metres.
    pub at: [f64; 2],
    /// Where the front shall look, radians.
    pub heading: f64,
}

/// A team's answer to a call: which robot takes which slot, and places of its own if it wants others than the table's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lineup {
    /// The slot of each robot; each slot once.
    pub slots: [Slot; ROBOTS],
    /// Places of the team's own, for the robots where it wants one.
    pub spots: [Option<Spot>; ROBOTS],
}
