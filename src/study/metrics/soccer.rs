//! What is measured of a match of robot soccer, when it is over.

use super::Form;
use crate::soccer::{Finished, Outcome, World};

/// A number that a match gives; each is described once, by its help text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Soccer {
    GoalsBlue,
    GoalsYellow,
    GoalDifference,
    Goals,
    Win,
    Tie,
    Loss,
    PossessionBlue,
    ShotsBlue,
    ShotsYellow,
    SwapsBlue,
    SwapsYellow,
    GroupChangesBlue,
    GroupChangesYellow,
    KickOffs,
    FreeBalls,
    GoalKicks,
    PenaltiesBlue,
    PenaltiesYellow,
    ViolationsBlue,
    ViolationsYellow,
    ForcedPlacements,
    Faults,
}

impl Soccer {
    /// Every metric, in the order of the documentation, with the name it has in studies and results.
    pub const ALL: [(&'static str, Self); 23] = [
        ("goals_blue", Self::GoalsBlue),
        ("goals_yellow", Self::GoalsYellow),
        ("goal_difference", Self::GoalDifference),
        ("goals", Self::Goals),
        ("win", Self::Win),
        ("tie", Self::Tie),
        ("loss", Self::Loss),
        ("possession_blue", Self::PossessionBlue),
        ("shots_blue", Self::ShotsBlue),
        ("shots_yellow", Self::ShotsYellow),
        ("swaps_blue", Self::SwapsBlue),
        ("swaps_yellow", Self::SwapsYellow),
        ("group_changes_blue", Self::GroupChangesBlue),
        ("group_changes_yellow", Self::GroupChangesYellow),
        ("kick_offs", Self::KickOffs),
        ("free_balls", Self::FreeBalls),
        ("goal_kicks", Self::GoalKicks),
        ("penalties_blue", Self::PenaltiesBlue),
        ("penalties_yellow", Self::PenaltiesYellow),
        ("violations_blue", Self::ViolationsBlue),
        ("violations_yellow", Self::ViolationsYellow),
        ("forced_placements", Self::ForcedPlacements),
        ("faults", Self::Faults),
    ];

    /// The name in studies and results.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }

    /// The name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::GoalsBlue => "Goals of blue",
            Self::GoalsYellow => "Goals of yellow",
            Self::GoalDifference => "Goal difference of blue",
            Self::Goals => "Goals of both teams",
            Self::Win => "Win of blue",
            Self::Tie => "Tie",
            Self::Loss => "Loss of blue",
            Self::PossessionBlue => "Possession of blue",
            Self::ShotsBlue => "Shots of blue",
            Self::ShotsYellow => "Shots of yellow",
            Self::SwapsBlue => "Role swaps of blue",
            Self::SwapsYellow => "Role swaps of yellow",
            Self::GroupChangesBlue => "Changes of group of blue",
            Self::GroupChangesYellow => "Changes of group of yellow",
            Self::KickOffs => "Kick-offs",
            Self::FreeBalls => "Free balls",
            Self::GoalKicks => "Goal kicks",
            Self::PenaltiesBlue => "Penalties for blue",
            Self::PenaltiesYellow => "Penalties for yellow",
            Self::ViolationsBlue => "Violations by blue",
            Self::ViolationsYellow => "Violations by yellow",
            Self::ForcedPlacements => "Forced placements",
            Self::Faults => "Faulty commands",
        }
    }

    /// What is measured, in one sentence.
    pub fn help(self) -> &'static str {
        match self {
            Self::GoalsBlue => "Goals that blue scored, without those of a shoot-out.",
            Self::GoalsYellow => "Goals that yellow scored, without those of a shoot-out.",
            Self::GoalDifference => "Goals of blue less goals of yellow, without those of a shoot-out.",
            Self::Goals => "Goals that both teams scored together, without those of a shoot-out.",
            Self::Win => "1 when blue won the match, in a knock-out game after overtime and shoot-out, else 0.",
            Self::Tie => "1 when nobody won the match, else 0.",
            Self::Loss => "1 when yellow won the match, else 0.",
            Self::PossessionBlue => {
                "Share of the frames with an owner of the ball in which blue touched it last; empty when nobody did."
            }
            Self::ShotsBlue => "Balls that blue let go toward the goal, and goals that it pushed in.",
            Self::ShotsYellow => "Balls that yellow let go toward the goal, and goals that it pushed in.",
            Self::SwapsBlue => "How often two robots of blue exchanged their roles within a group.",
            Self::SwapsYellow => "How often two robots of yellow exchanged their roles within a group.",
            Self::GroupChangesBlue => "How often blue changed between attack and defence.",
            Self::GroupChangesYellow => "How often yellow changed between attack and defence.",
            Self::KickOffs => "Kick-offs called for either team, those of the halves included.",
            Self::FreeBalls => "Free balls called.",
            Self::GoalKicks => "Goal kicks called for either team.",
            Self::PenaltiesBlue => "Penalty kicks that blue took.",
            Self::PenaltiesYellow => "Penalty kicks that yellow took.",
            Self::ViolationsBlue => "Changes of roles by blue's coach that broke the organisation and were refused.",
            Self::ViolationsYellow => {
                "Changes of roles by yellow's coach that broke the organisation and were refused."
            }
            Self::ForcedPlacements => "Placements in which the referee did not take a team's own places.",
            Self::Faults => "Commands of either team that were no numbers.",
        }
    }

    /// What numbers it can be.
    pub fn form(self) -> Form {
        match self {
            Self::Win | Self::Tie | Self::Loss => Form::Flag,
            Self::PossessionBlue => Form::Share,
            Self::GoalsBlue
            | Self::GoalsYellow
            | Self::GoalDifference
            | Self::Goals
            | Self::ShotsBlue
            | Self::ShotsYellow
            | Self::SwapsBlue
            | Self::SwapsYellow
            | Self::GroupChangesBlue
            | Self::GroupChangesYellow
            | Self::KickOffs
            | Self::FreeBalls
            | Self::GoalKicks
            | Self::PenaltiesBlue
            | Self::PenaltiesYellow
            | Self::ViolationsBlue
            | Self::ViolationsYellow
            | Self::ForcedPlacements
            | Self::Faults => Form::Number,
        }
    }

    /// Its value; who won is empty while the match goes on.
    ///
    /// - `outcome`: of this very `world`.
    pub fn of(self, world: &World, outcome: &Outcome) -> Option<f64> {
        let Outcome { goals: [ours, theirs], blue, yellow, finished, .. } = outcome;
        let ended = |end: Finished| finished.map(|finished| f64::from(u8::from(finished == end)));
        let called = |kind: usize| Some(f64::from(blue.calls[kind] + yellow.calls[kind]));
        match self {
            Self::GoalsBlue => Some(f64::from(*ours)),
            Self::GoalsYellow => Some(f64::from(*theirs)),
            Self::GoalDifference => Some(f64::from(*ours) - f64::from(*theirs)),
            Self::Goals => Some(f64::from(ours + theirs)),
            Self::Win => ended(Finished::Blue),
            Self::Tie => ended(Finished::Tie),
            Self::Loss => ended(Finished::Yellow),
            Self::PossessionBlue => (blue.possession + yellow.possession > 0.0).then_some(blue.possession),
            Self::ShotsBlue => Some(f64::from(blue.shots)),
            Self::ShotsYellow => Some(f64::from(yellow.shots)),
            Self::SwapsBlue => Some(f64::from(blue.swaps)),
            Self::SwapsYellow => Some(f64::from(yellow.swaps)),
            Self::GroupChangesBlue => Some(f64::from(blue.group_changes)),
            Self::GroupChangesYellow => Some(f64::from(yellow.group_changes)),
            Self::KickOffs => called(0),
            Self::FreeBalls => called(1),
            Self::GoalKicks => called(2),
            Self::PenaltiesBlue => Some(f64::from(blue.calls[3])),
            Self::PenaltiesYellow => Some(f64::from(yellow.calls[3])),
            Self::ViolationsBlue => Some(f64::from(blue.violations)),
            Self::ViolationsYellow => Some(f64::from(yellow.violations)),
            Self::ForcedPlacements => Some(f64::from(world.state().game().statistics().forced)),
            Self::Faults => Some(f64::from(blue.faults + yellow.faults)),
        }
    }
}
