//! The leaves of role trees: the conditions of the states and the skills, with the numbers they take.

use crate::bt::xml::{Direction, Manifest, NodeKind, Port, PortType};
use crate::bt::{Extra, HostLeaf, Source, Value};

/// What a leaf of a role tree looks at or does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// The robot is off its line.
    OffLine,
    /// The ball will cross the keeper's line.
    ShotComing,
    /// The ball is at the robot.
    BallNear,
    /// The ball lies beside the own goal.
    BallBesideGoal,
    /// The ball is deep in the own half.
    BallDeep,
    /// The ball is far in the other half.
    BallForward,
    /// The ball is at a side wall.
    BallAtWall,
    /// The ball hardly moves in the own goal area.
    BallResting,
    /// The robot is behind the ball.
    BehindBall,
    /// The robot is nearer to the middle of the own goal than the ball, across the pitch.
    GoalSide,
    /// One end of the robot looks at the ball.
    FacingBall,
    /// The ball lies between the robot and the other goal.
    BallInCone,
    /// No opponent stands between the robot and the other goal.
    ClearAhead,
    /// Another robot is the first Striker.
    SecondStriker,
    /// Goes back to the keeper's line.
    ReturnToLine,
    /// Goes where the ball will cross the line.
    Save,
    /// One full turn that carries the ball away.
    Spin,
    /// Drives straight at the ball and through it.
    DriveAtBall,
    /// Follows the ball on a line across the pitch.
    KeepLine,
    /// Guards the corner where the ball is.
    GuardCorner,
    /// Stands beside the goal, away from the ball.
    StandAside,
    /// Runs at the other goal with the ball.
    RunAtGoal,
    /// Gets behind the ball.
    GetBall,
    /// Gets the ball along the side wall.
    GetBallAlongWall,
    /// Waits beside the ball for it to come out.
    WaitBeside,
    /// Waits for a rebound behind the Striker.
    Rebound,
    /// Goes beside the ball, which the first Striker gets.
    RunBeside,
    /// Kicks the penalty.
    KickPenalty,
    /// Guards the line on which the penalty will come.
    GuardPenalty,
}

/// A port: its name, what is taken when it is not given, and what it is.
type Number = (&'static str, f64, &'static str);

/// The keeper's line, and how far it goes.
const LINE: Number = ("x", -0.69, "the line, metres");
const REACH: Number = ("reach", 0.20, "how far the line goes to both sides, metres");
const ASIDE: &str = "how far to both sides to go, metres";
/// What ends a run with the ball.
const RELEASE: &str = "brakes when the ball's x is above this, so that the ball rolls on, metres";

/// How many numbers a leaf takes at most.
pub const MOST_NUMBERS: usize = 5;

impl What {
    /// Every leaf.
    pub const ALL: [Self; 29] = [
        Self::OffLine,
        Self::ShotComing,
        Self::BallNear,
        Self::BallBesideGoal,
        Self::BallDeep,
        Self::BallForward,
        Self::BallAtWall,
        Self::BallResting,
        Self::BehindBall,
        Self::GoalSide,
        Self::FacingBall,
        Self::BallInCone,
        Self::ClearAhead,
        Self::SecondStriker,
        Self::ReturnToLine,
        Self::Save,
        Self::Spin,
        Self::DriveAtBall,
        Self::KeepLine,
        Self::GuardCorner,
        Self::StandAside,
        Self::RunAtGoal,
        Self::GetBall,
        Self::GetBallAlongWall,
        Self::WaitBeside,
        Self::Rebound,
        Self::RunBeside,
        Self::KickPenalty,
        Self::GuardPenalty,
    ];

    /// The registered name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::OffLine => "OffLine",
            Self::ShotComing => "ShotComing",
            Self::BallNear => "BallNear",
            Self::BallBesideGoal => "BallBesideGoal",
            Self::BallDeep => "BallDeep",
            Self::BallForward => "BallForward",
            Self::BallAtWall => "BallAtWall",
            Self::BallResting => "BallResting",
            Self::BehindBall => "BehindBall",
            Self::GoalSide => "GoalSide",
            Self::FacingBall => "FacingBall",
            Self::BallInCone => "BallInCone",
            Self::ClearAhead => "ClearAhead",
            Self::SecondStriker => "SecondStriker",
            Self::ReturnToLine => "ReturnToLine",
            Self::Save => "Save",
            Self::Spin => "Spin",
            Self::DriveAtBall => "DriveAtBall",
            Self::KeepLine => "KeepLine",
            Self::GuardCorner => "GuardCorner",
            Self::StandAside => "StandAside",
            Self::RunAtGoal => "RunAtGoal",
            Self::GetBall => "GetBall",
            Self::GetBallAlongWall => "GetBallAlongWall",
            Self::WaitBeside => "WaitBeside",
            Self::Rebound => "Rebound",
            Self::RunBeside => "RunBeside",
            Self::KickPenalty => "KickPenalty",
            Self::GuardPenalty => "GuardPenalty",
        }
    }

    /// True for the skills, false for the conditions.
    #[must_use]
    pub fn acts(self) -> bool {
        self >= Self::ReturnToLine
    }

    /// The numbers it takes. The defaults are those of the built-in roles.
    ///
    /// Source: our choice. Of two thresholds, the first lets a state begin and the second lets it end.
    #[must_use]
    pub fn numbers(self) -> &'static [Number] {
        match self {
            Self::OffLine => &[
                LINE,
                REACH,
                ("on", 0.165, "begins farther away than this, metres"),
                ("off", 0.10, "lasts while farther away than this, metres"),
            ],
            Self::ShotComing => &[
                LINE,
                ("within", 3.0, "the ball reaches it within, seconds"),
                ("on", -0.10, "begins when the ball's speed along x is below this, metres per second"),
                ("off", -0.05, "lasts while it is below this, metres per second"),
            ],
            Self::BallNear => &[
                ("on", 0.078, "begins nearer than this, metres"),
                ("off", 0.095, "lasts while nearer than this, metres"),
            ],
            Self::BallBesideGoal => &[
                ("x", -0.65, "deeper than this, metres"),
                ("post", 0.115, "farther than this from the nearer post, metres"),
            ],
            Self::BallDeep => &[
                ("on", -0.60, "begins when the ball's x is below this, metres"),
                ("off", -0.57, "lasts while it is below this, metres"),
            ],
            Self::BallForward => &[
                ("on", 0.55, "begins when the ball's x is above this, metres"),
                ("off", 0.50, "lasts while it is above this, metres"),
            ],
            Self::BallAtWall => &[
                ("on", 0.06, "begins when the ball is nearer to a side wall than this, metres"),
                ("off", 0.09, "lasts while it is nearer than this, metres"),
            ],
            Self::BallResting => &[
                ("on", 0.20, "begins in the area when the ball is slower than this, metres per second"),
                ("off", 2.0, "lasts near it while the ball is slower than this, metres per second"),
            ],
            Self::BehindBall => &[
                ("on", 0.0, "begins when the ball is ahead by more than this, metres"),
                ("off", -0.02, "lasts while it is ahead by more than this, metres"),
            ],
            Self::GoalSide => &[
                ("on", 0.04, "begins when the ball is farther from the middle by more than this, metres"),
                ("off", 0.02, "lasts while it is by more than this, metres"),
            ],
            Self::FacingBall => &[
                ("on", 30.0, "begins within this angle of either end, degrees"),
                ("off", 60.0, "lasts within this angle, degrees"),
            ],
            Self::BallInCone => &[
                ("on", 0.0, "begins this far inside the cone to the posts, degrees beyond them"),
                ("off", 10.0, "lasts this far beyond the posts, degrees"),
            ],
            Self::ClearAhead => &[
                ("angle", 15.0, "an opponent counts within this angle of the way to the goal, degrees"),
                ("within", 0.40, "an opponent counts within this distance, metres"),
            ],
            Self::SecondStriker | Self::Spin | Self::DriveAtBall => &[],
            Self::RunAtGoal => &[("release", 0.37, RELEASE)],
            Self::KickPenalty => &[("release", 0.39, RELEASE)],
            Self::ReturnToLine => &[LINE, REACH],
            Self::Save => &[
                LINE,
                ("reach", 0.20, ASIDE),
                ("fast", 0.50, "when more speed than this is needed, metres per second ..."),
                ("overshoot", 0.02, "... go this much farther, metres"),
            ],
            Self::KeepLine => &[LINE, ("reach", 0.20, ASIDE), ("share", 1.0, "the part of the ball's y to stand at")],
            Self::GuardCorner => &[("y", 0.40, "how far from the middle, metres")],
            Self::StandAside => &[
                ("x", -0.52, "where to stand, metres"),
                ("y", 0.30, "how far from the middle, away from the ball, metres"),
            ],
            Self::GetBall => &[
                ("away_before", -0.30, "while the ball's x is below this, aim away from the own goal, metres"),
                ("wide", 0.06, "k of the spirals: 0.004 is tight, 0.2 is wide"),
            ],
            Self::GetBallAlongWall => &[("wide", 0.02, "k of the spirals: 0.004 is tight, 0.2 is wide")],
            Self::WaitBeside => &[
                ("x", -0.425, "where to wait, metres"),
                ("aside", 0.225, "how far beside the ball, towards the middle, metres"),
            ],
            Self::Rebound => &[
                ("share", 0.80, "the part of the Striker's x ..."),
                ("lag", 0.15, "... and how far behind that, metres"),
                ("least", -0.55, "x at least, metres"),
                ("most", 0.50, "x at most, metres"),
                ("cross", 0.70, "the part of the ball's y to stand on the other side"),
            ],
            Self::RunBeside => &[
                ("aside", 0.15, "how far beside the ball, metres"),
                ("wide", 0.06, "k of the spirals: 0.004 is tight, 0.2 is wide"),
            ],
            Self::GuardPenalty => &[("x", -0.7125, LINE.2), ("reach", 0.15, ASIDE)],
        }
    }
}

/// A leaf with its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaf {
    /// What it looks at or does.
    pub what: What,
    /// Its numbers in the order of [`What::numbers`]; angles as their cosine or, for the cone, cosine and sine by turns.
    pub numbers: [f64; MOST_NUMBERS],
}

impl Leaf {
    /// The leaf of a node that was checked: registered, with literals for numbers.
    pub(super) fn of(leaf: &HostLeaf, extra: Option<&Extra>) -> Self {
        let what = What::ALL.into_iter().find(|what| what.name() == leaf.type_name).unwrap_or(What::SecondStriker);
        let mut numbers = [0.0; MOST_NUMBERS];
        for (number, (name, otherwise, _)) in numbers.iter_mut().zip(what.numbers()) {
            let given = extra.and_then(|extra| extra.ports.iter().find(|(port, _)| port == name));
            *number = match given {
                Some((_, Source::Literal(Value::Number(given)))) => *given,
                _ => *otherwise,
            };
        }
        let [on, off, ..] = numbers.map(f64::to_radians);
        match what {
            What::FacingBall => {
                numbers[0] = libm::cos(on);
                numbers[1] = libm::cos(off);
            }
            What::ClearAhead => numbers[0] = libm::cos(on),
            What::BallInCone => {
                let ((on_sine, on_cosine), (off_sine, off_cosine)) = (libm::sincos(on), libm::sincos(off));
                numbers[..4].copy_from_slice(&[on_cosine, on_sine, off_cosine, off_sine]);
            }
            _ => {}
        }
        Self { what, numbers }
    }
}

/// The nodes that role trees can be made of: the built-ins and the leaves.
///
/// # Panics
/// Never: the names are allowed and differ, which a test checks.
#[must_use]
pub fn manifest() -> Manifest {
    let mut manifest = Manifest::default();
    for what in What::ALL {
        let kind = if what.acts() { NodeKind::Action } else { NodeKind::Condition };
        let ports = what.numbers().iter().map(|(name, otherwise, description)| {
            Port::new(name, Direction::In, PortType::Real, description).with_default(&otherwise.to_string())
        });
        manifest.register(what.name(), kind, ports.collect()).expect("the names are allowed and differ");
    }
    manifest
}
