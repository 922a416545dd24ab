//! What the referee decides.

use super::log::Rule;
use crate::soccer::pitch::{Quadrant, Side};
use crate::soccer::view::Restart;

/// How play starts again, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kick {
    /// From the centre.
    KickOff,
    /// At the cross of a quadrant.
    FreeBall(Quadrant),
    /// Beside the goal area.
    GoalKick,
    /// From the penalty mark.
    Penalty,
}

impl Kick {
    /// The kind alone, as teams are told.
    #[must_use]
    pub fn restart(self) -> Restart {
        match self {
            Self::KickOff => Restart::KickOff,
            Self::FreeBall(_) => Restart::FreeBall,
            Self::GoalKick => Restart::GoalKick,
            Self::Penalty => Restart::PenaltyKick,
        }
    }

    /// The quadrant of a free ball.
    #[must_use]
    pub fn quadrant(self) -> Option<Quadrant> {
        match self {
            Self::FreeBall(quadrant) => Some(quadrant),
            Self::KickOff | Self::GoalKick | Self::Penalty => None,
        }
    }
}

/// How play goes on, and why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// How play starts again.
    pub kick: Kick,
    /// The side that takes it; at a free ball the one for which the quadrant lies in its attacking half.
    pub taker: Side,
    /// The rule that fired.
    pub rule: Rule,
}

impl Decision {
    /// A free ball in a quadrant.
    ///
    /// Source: VSSSLeague/VSSReferee, placements.
    #[must_use]
    pub fn free_ball(quadrant: Quadrant, rule: Rule) -> Self {
        Self { kick: Kick::FreeBall(quadrant), taker: quadrant.side().other(), rule }
    }
}

/// What the referee says after a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ruling {
    /// Play stops and starts again.
    Restart(Decision),
    /// The match is over.
    Over(Rule),
}
