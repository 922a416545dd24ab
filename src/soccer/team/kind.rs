//! The seven teams.

use super::Formation;
use super::margins::Margins;
use super::{coach, roles};
use serde::{Deserialize, Serialize};

/// A team of the playground: how it is coached and what its roles are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TeamKind {
    /// The behaviour tree.
    Tree,
    /// The state machine.
    Machine,
    /// The behaviour tree without the three swaps of roles.
    TreeWithoutSwaps,
    /// The state machine without its three swap states.
    MachineWithoutSwaps,
    /// The behaviour tree, changing roles only when it is twice as clear.
    TreeDoubleMargins,
    /// No coach: a goalkeeper on its line, two robots that chase the ball.
    Chase,
    /// No coach: Goalkeeper, Fullback and Wingback for the whole match.
    Formation,
}

/// Who gives out the roles of a team.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coached {
    /// A tree, unless the user brings one.
    ByTree(&'static str),
    /// A machine, with or without its swap states.
    ByMachine {
        /// With them.
        swaps: bool,
    },
    /// Nobody: the same formation at every start.
    ByNobody(Formation),
}

impl TeamKind {
    /// Every team.
    pub const ALL: [Self; 7] = [
        Self::Tree,
        Self::Machine,
        Self::TreeWithoutSwaps,
        Self::MachineWithoutSwaps,
        Self::TreeDoubleMargins,
        Self::Chase,
        Self::Formation,
    ];

    /// The name in files.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Tree => "tree",
            Self::Machine => "machine",
            Self::TreeWithoutSwaps => "tree-without-swaps",
            Self::MachineWithoutSwaps => "machine-without-swaps",
            Self::TreeDoubleMargins => "tree-double-margins",
            Self::Chase => "chase",
            Self::Formation => "formation",
        }
    }

    /// The team of that name.
    #[must_use]
    pub fn from_text(text: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.text() == text)
    }

    /// Who gives out the roles.
    #[must_use]
    pub fn coached(self) -> Coached {
        match self {
            Self::Tree | Self::TreeDoubleMargins => Coached::ByTree(coach::BUILT_IN),
            Self::TreeWithoutSwaps => Coached::ByTree(coach::WITHOUT_SWAPS),
            Self::Machine => Coached::ByMachine { swaps: true },
            Self::MachineWithoutSwaps => Coached::ByMachine { swaps: false },
            Self::Chase => Coached::ByNobody(Formation::TwoStrikers),
            Self::Formation => Coached::ByNobody(Formation::FullbackWingback),
        }
    }

    /// The trees of the roles, unless the user brings some.
    #[must_use]
    pub fn roles(self) -> &'static str {
        match self {
            Self::Chase => roles::CHASE,
            Self::Tree
            | Self::Machine
            | Self::TreeWithoutSwaps
            | Self::MachineWithoutSwaps
            | Self::TreeDoubleMargins
            | Self::Formation => roles::BUILT_IN,
        }
    }

    /// The margins with which the team plays, of those that the match is given.
    #[must_use]
    pub fn margins(self, given: Margins) -> Margins {
        if self == Self::TreeDoubleMargins { given.doubled() } else { given }
    }
}
