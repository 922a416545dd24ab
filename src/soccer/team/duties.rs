//! Who plays what: the roles, the formations, and what a Coach writes for its robots to read.

use crate::fingerprint::Fingerprint;
use crate::soccer::view::ROBOTS;
use serde::{Deserialize, Serialize};

/// What a robot can be told to play.
///
/// Source: the paper, section 4.1, names and purposes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Defends the goal.
    Goalkeeper,
    /// Attacks.
    Striker,
    /// Waits for rebounds.
    Assistant,
    /// Helps the goalkeeper.
    Fullback,
    /// Helps the defence and tries to counter.
    Wingback,
    /// Kicks penalties.
    PenaltyKicker,
    /// Defends the opponents' penalties.
    PenaltyDefender,
}

impl Role {
    /// Every role, in the order of their numbers.
    pub const ALL: [Self; 7] = [
        Self::Goalkeeper,
        Self::Striker,
        Self::Assistant,
        Self::Fullback,
        Self::Wingback,
        Self::PenaltyKicker,
        Self::PenaltyDefender,
    ];

    /// The name on the blackboard and in files.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Goalkeeper => "goalkeeper",
            Self::Striker => "striker",
            Self::Assistant => "assistant",
            Self::Fullback => "fullback",
            Self::Wingback => "wingback",
            Self::PenaltyKicker => "penalty_kicker",
            Self::PenaltyDefender => "penalty_defender",
        }
    }

    /// The name of the role's behaviour tree.
    #[must_use]
    pub fn tree(self) -> &'static str {
        match self {
            Self::Goalkeeper => "Goalkeeper",
            Self::Striker => "Striker",
            Self::Assistant => "Assistant",
            Self::Fullback => "Fullback",
            Self::Wingback => "Wingback",
            Self::PenaltyKicker => "PenaltyKicker",
            Self::PenaltyDefender => "PenaltyDefender",
        }
    }

    /// The role of that name.
    #[must_use]
    pub fn from_text(text: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.text() == text)
    }

    /// True for the two roles that guard the goal.
    #[must_use]
    pub fn keeps_goal(self) -> bool {
        matches!(self, Self::Goalkeeper | Self::PenaltyDefender)
    }
}

/// Whether the team attacks or defends: `team_mode` on the blackboard, and which group of the organisation is active.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// The group attack.
    Attack,
    /// The group defense.
    Defend,
}

impl Mode {
    /// The name on the blackboard.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Attack => "attack",
            Self::Defend => "defend",
        }
    }

    /// The name of the group.
    #[must_use]
    pub fn group(self) -> &'static str {
        match self {
            Self::Attack => "attack",
            Self::Defend => "defense",
        }
    }

    /// The mode of that name.
    #[must_use]
    pub fn from_text(text: &str) -> Option<Self> {
        [Self::Attack, Self::Defend].into_iter().find(|mode| mode.text() == text)
    }
}

/// The three roles that are played together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Formation {
    /// Goalkeeper and two Strikers.
    TwoStrikers,
    /// Goalkeeper, Striker, Assistant.
    StrikerAssistant,
    /// Goalkeeper, Penalty Kicker, Assistant.
    PenaltyKick,
    /// Goalkeeper, Fullback, Wingback.
    FullbackWingback,
    /// Penalty Defender, Fullback, Wingback.
    PenaltyDefense,
}

impl Formation {
    /// Every formation.
    pub const ALL: [Self; 5] =
        [Self::TwoStrikers, Self::StrikerAssistant, Self::PenaltyKick, Self::FullbackWingback, Self::PenaltyDefense];

    /// The name on the blackboard and in files.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::TwoStrikers => "two_strikers",
            Self::StrikerAssistant => "striker_assistant",
            Self::PenaltyKick => "penalty_kick",
            Self::FullbackWingback => "fullback_wingback",
            Self::PenaltyDefense => "penalty_defense",
        }
    }

    /// The formation of that name.
    #[must_use]
    pub fn from_text(text: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|formation| formation.text() == text)
    }

    /// The group it belongs to.
    #[must_use]
    pub fn mode(self) -> Mode {
        match self {
            Self::TwoStrikers | Self::StrikerAssistant | Self::PenaltyKick => Mode::Attack,
            Self::FullbackWingback | Self::PenaltyDefense => Mode::Defend,
        }
    }
}

/// Two roles that robots of one group exchange.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Pair {
    /// Striker and Assistant.
    StrikerAssistant,
    /// Fullback and Wingback.
    FullbackWingback,
    /// Goalkeeper and Wingback.
    GoalkeeperWingback,
}

impl Pair {
    /// Every pair, in the order of their numbers.
    pub const ALL: [Self; 3] = [Self::StrikerAssistant, Self::FullbackWingback, Self::GoalkeeperWingback];

    /// The two roles.
    #[must_use]
    pub fn roles(self) -> [Role; 2] {
        match self {
            Self::StrikerAssistant => [Role::Striker, Role::Assistant],
            Self::FullbackWingback => [Role::Fullback, Role::Wingback],
            Self::GoalkeeperWingback => [Role::Goalkeeper, Role::Wingback],
        }
    }

    /// The pair of two roles, in either order.
    #[must_use]
    pub fn of(first: Role, second: Role) -> Option<Self> {
        Self::ALL.into_iter().find(|pair| pair.roles() == [first, second] || pair.roles() == [second, first])
    }

    /// The name on the blackboard.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::StrikerAssistant => "striker_assistant",
            Self::FullbackWingback => "fullback_wingback",
            Self::GoalkeeperWingback => "goalkeeper_wingback",
        }
    }
}

/// What the Coach tells its robots: one role each. Both coaches write it and every reader reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Duties {
    /// The role of each robot.
    pub roles: [Role; ROBOTS],
    /// `team_mode`.
    pub mode: Mode,
    /// Which roles are played together.
    pub formation: Formation,
    /// The last swap since the start of the match.
    pub swap_last: Option<Pair>,
    /// The control frame of the last swap.
    pub swap_time: u32,
    /// Swaps since the start of the match; changes of group are no swaps.
    pub swap_count: u32,
}

impl Default for Duties {
    /// What is played before the first call.
    fn default() -> Self {
        Self {
            roles: [Role::Goalkeeper, Role::Wingback, Role::Fullback],
            mode: Mode::Defend,
            formation: Formation::FullbackWingback,
            swap_last: None,
            swap_time: 0,
            swap_count: 0,
        }
    }
}

impl Duties {
    /// The robot that plays `role`, the first of several.
    #[must_use]
    pub fn who(&self, role: Role) -> Option<usize> {
        self.roles.iter().position(|other| *other == role)
    }

    /// Takes everything into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        for role in self.roles {
            hash.u32(role as u32);
        }
        hash.u32(self.mode as u32);
        hash.u32(self.formation as u32);
        hash.u32(self.swap_last.map_or(0, |pair| pair as u32 + 1));
        hash.u32(self.swap_time);
        hash.u32(self.swap_count);
    }
}
