//! The log of a match: each call with the rule that fired and the numbers it saw.

use super::shootout::Attempt;
use crate::soccer::pitch::{Quadrant, Side};
use serde::Serialize;
use std::fmt::{self, Write};

/// What the referee sends.
///
/// Source: VSSSLeague/VSSReferee, commands. A free kick is unused in games of three against three.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Command {
    /// Play starts from the centre.
    KickOff,
    /// Nobody's ball.
    FreeBall,
    /// Out of the goal area.
    GoalKick,
    /// From the penalty mark.
    PenaltyKick,
    /// Unused.
    FreeKick,
    /// Robots and ball are placed.
    Stop,
    /// Play runs.
    GameOn,
    /// Nothing goes on.
    Halt,
}

impl Command {
    fn name(self) -> &'static str {
        match self {
            Self::KickOff => "kick-off",
            Self::FreeBall => "free ball",
            Self::GoalKick => "goal kick",
            Self::PenaltyKick => "penalty kick",
            Self::FreeKick => "free kick",
            Self::Stop => "stop",
            Self::GameOn => "game on",
            Self::Halt => "halt",
        }
    }
}

/// Part of a match.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Phase {
    /// The first half.
    FirstHalf,
    /// The second half.
    SecondHalf,
    /// The first half of overtime.
    FirstExtra,
    /// The second half of overtime.
    SecondExtra,
    /// Penalties in turns.
    ShootOut,
}

impl Phase {
    fn name(self) -> &'static str {
        match self {
            Self::FirstHalf => "first half",
            Self::SecondHalf => "second half",
            Self::FirstExtra => "overtime, first half",
            Self::SecondExtra => "overtime, second half",
            Self::ShootOut => "shoot-out",
        }
    }
}

/// Why robots were not placed as a team asked. Robots are numbered 0 to 5, the left team's first.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Forced {
    /// A team named a slot twice: the referee dealt the slots.
    Slots {
        /// The team's.
        side: Side,
    },
    /// A team asked for a place that is off the pitch, in a wall or no number: its robots stand by the table.
    OffPitch {
        /// The robot.
        robot: usize,
    },
    /// A team asked for a place on the ball: its robots stand by the table.
    OnBall {
        /// The robot.
        robot: usize,
    },
    /// Two robots would be closer than allowed: all robots stand by the table.
    Close {
        /// The two.
        robots: [usize; 2],
        /// Between their centres, metres.
        distance: f64,
    },
}

/// The rule that fired, with the numbers that it saw: seconds, metres, metres per second.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rule {
    /// The coin gave the first kick-off.
    Coin,
    /// A part of the match is over.
    TimeOver {
        /// Its length.
        seconds: f64,
    },
    /// All of the ball crossed the line.
    Goal {
        /// Who scored.
        by: Side,
        /// Where the ball was.
        ball: [f64; 2],
        /// For how long the other side had two or more robots in its area in this play; the goal counts all the same.
        defenders: f64,
    },
    /// A play ended in which two or more attackers were in the area.
    PlayOfAttackers {
        /// Whose area.
        area: Side,
        /// Whether there was a goal, which is void.
        goal: bool,
        /// For how long they were there.
        seconds: f64,
    },
    /// A play ended without a goal in which two or more defenders were in their area.
    PlayOfDefenders {
        /// Whose area.
        area: Side,
        /// For how long they were there.
        seconds: f64,
    },
    /// A play ended in which both were: the foul that lasted longer counts, of equal ones the defenders'.
    PlayOfBoth {
        /// Whose area.
        area: Side,
        /// Whether there was a goal, which is void.
        goal: bool,
        /// For how long two or more attackers were there.
        attackers: f64,
        /// For how long two or more defenders were there.
        defenders: f64,
    },
    /// Two or more attackers were in the area with the ball for too long.
    TwoAttackers {
        /// Whose area.
        area: Side,
        /// For how long.
        seconds: f64,
    },
    /// Two or more defenders were in their area with the ball for too long.
    TwoDefenders {
        /// Whose area.
        area: Side,
        /// For how long.
        seconds: f64,
    },
    /// The ball did not move for too long.
    StuckBall {
        /// The goal area it is in.
        area: Option<Side>,
        /// For how long.
        seconds: f64,
        /// Its speed.
        speed: f64,
        /// The distance to the nearest robot of each side.
        nearest: [f64; 2],
    },
    /// An attempt of the shoot-out ended.
    Attempt {
        /// Whose.
        by: Side,
        /// How.
        ended: Attempt,
        /// How long it took.
        seconds: f64,
        /// Goals of the shoot-out.
        scored: [u32; 2],
    },
    /// Somebody outside the match asked for this situation.
    Staged,
    /// A team's own places were not taken.
    Forced(Forced),
    /// Robots and ball were placed.
    Placed,
    /// The wait after a placement is over.
    WaitOver,
    /// A robot was sent a speed that is no number, which counts as 0; noted once for each robot.
    Fault {
        /// The robot, 0 to 5.
        robot: usize,
    },
}

/// One line of the log.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Entry {
    /// Control frames of play since the match began.
    pub frame: u32,
    /// Part of the match.
    pub phase: Phase,
    /// Seconds of play in that part.
    pub seconds: f64,
    /// Seconds since the match began, with the waits that a match without an audience skips.
    pub elapsed: f64,
    /// What the referee sends.
    pub command: Command,
    /// The team that it is for.
    pub side: Option<Side>,
    /// Where a free ball is placed.
    pub quadrant: Option<Quadrant>,
    /// Why.
    pub rule: Rule,
}

impl Entry {
    /// The line as a sentence.
    ///
    /// - `names`: of the left and the right team.
    #[must_use]
    pub fn text(&self, names: [&str; 2]) -> String {
        let mut text = String::new();
        // Writing into a string does not fail.
        let _ = self.write(&mut text, names);
        text
    }

    /// Why, without when and what, as a part of a sentence.
    ///
    /// - `names`: of the left and the right team.
    #[must_use]
    pub fn reason(&self, names: [&str; 2]) -> String {
        let mut text = String::new();
        // Writing into a string does not fail.
        let _ = self.rule.write(&mut text, names);
        text
    }

    fn write(&self, out: &mut String, names: [&str; 2]) -> fmt::Result {
        let (minutes, seconds) = ((self.seconds / 60.0) as u32, self.seconds % 60.0);
        write!(out, "{}, {minutes}:{seconds:04.1}: {}", self.phase.name(), self.command.name())?;
        if let Some(side) = self.side {
            write!(out, " for {}", names[side.index()])?;
        }
        if let Some(quadrant) = self.quadrant {
            write!(out, " in quadrant {}", quadrant.number())?;
        }
        out.push_str(", because ");
        self.rule.write(out, names)
    }
}

impl Rule {
    fn write(&self, out: &mut String, names: [&str; 2]) -> fmt::Result {
        let name = |side: Side| names[side.index()];
        let robot = |robot: usize| format!("robot {} of {}", robot % 3 + 1, names[usize::from(robot >= 3)]);
        let voided = |goal: bool| if goal { ", so the goal is void" } else { "" };
        match *self {
            Self::Coin => write!(out, "the coin gave it the first kick-off"),
            Self::TimeOver { seconds } => write!(out, "{seconds:.0} s of play are over"),
            Self::Goal { by, ball, defenders } => {
                write!(out, "{} scored, with the ball at {:.3}, {:.3}", name(by), ball[0], ball[1])?;
                if defenders > 0.0 {
                    write!(out, "; that two robots defended in their area for {defenders:.2} s does not matter")?;
                }
                Ok(())
            }
            Self::PlayOfAttackers { area, goal, seconds } => {
                let (by, of) = (name(area.other()), name(area));
                write!(out, "{by} had two robots in the area of {of} for {seconds:.2} s of this play{}", voided(goal))
            }
            Self::PlayOfDefenders { area, seconds } => {
                write!(out, "{} had two robots in its own area for {seconds:.2} s of this play", name(area))
            }
            Self::PlayOfBoth { area, goal, attackers, defenders } => {
                let (by, of) = (name(area.other()), name(area));
                write!(out, "in the area of {of} {by} had two robots for {attackers:.2} s of this play, ")?;
                write!(out, "{of} for {defenders:.2} s{}", voided(goal))
            }
            Self::TwoAttackers { area, seconds } => {
                let (by, of) = (name(area.other()), name(area));
                write!(out, "{by} had two robots in the area of {of}, with the ball, for {seconds:.2} s")
            }
            Self::TwoDefenders { area, seconds } => {
                write!(out, "{} had two robots in its own area, with the ball, for {seconds:.2} s", name(area))
            }
            Self::StuckBall { area, seconds, speed, nearest: [left, right] } => {
                write!(out, "the ball was stuck for {seconds:.2} s, at {speed:.2} m/s, ")?;
                match area {
                    Some(area) => write!(out, "in the area of {}", name(area))?,
                    None => write!(out, "outside the areas")?,
                }
                write!(out, ", {left:.3} m from {} and {right:.3} m from {}", names[0], names[1])
            }
            Self::Attempt { by, ended, seconds, scored: [left, right] } => {
                let how = match ended {
                    Attempt::Goal => "ended with a goal",
                    Attempt::LeftArea => "ended as the ball left the area",
                    Attempt::CrossedMidfield => "ended as the ball crossed midfield",
                    Attempt::Stuck => "ended as the ball was stuck",
                    Attempt::TooLong => "took too long",
                };
                write!(out, "the attempt of {} {how} after {seconds:.2} s: {left} to {right}", name(by))
            }
            Self::Staged => write!(out, "somebody asked for it"),
            Self::Forced(Forced::Slots { side }) => {
                write!(out, "{} named a slot twice, and the referee deals its slots", name(side))
            }
            Self::Forced(Forced::OffPitch { robot: at }) => {
                write!(out, "the place asked for {} is off the pitch, and its team stands by the table", robot(at))
            }
            Self::Forced(Forced::OnBall { robot: at }) => {
                write!(out, "the place asked for {} is on the ball, and its team stands by the table", robot(at))
            }
            Self::Forced(Forced::Close { robots: [a, b], distance }) => {
                write!(out, "{} and {} would be {distance:.4} m apart, and all stand by the table", robot(a), robot(b))
            }
            Self::Placed => write!(out, "robots and ball were placed"),
            Self::WaitOver => write!(out, "the wait is over"),
            Self::Fault { robot: at } => write!(out, "{} was sent a speed that is no number, taken as 0", robot(at)),
        }
    }
}
