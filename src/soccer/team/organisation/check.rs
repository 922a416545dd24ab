//! The rules of the organisation at run time: refuses what breaks them, and allocates nothing while nothing does.

use super::{BUILT_IN, LinkKind, Member, Organisation, Scope};
use crate::soccer::team::duties::{Duties, Formation, Role};
use crate::soccer::view::ROBOTS;
use std::fmt;

/// How a change of roles broke the organisation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Violation {
    /// A robot was given something that is no role.
    NoRole {
        /// The robot, from 0.
        robot: usize,
        /// What it was given.
        found: String,
    },
    /// The roles are no formation.
    NoFormation {
        /// The roles.
        roles: [Role; ROBOTS],
    },
    /// A robot changed its role where no compatibility leads.
    NoLink {
        /// The robot, from 0.
        robot: usize,
        /// The role before.
        from: Role,
        /// The role after.
        to: Role,
        /// Whether both formations are of one group.
        scope: Scope,
    },
    /// Somebody without authority over a role changed it.
    NoAuthority {
        /// Who did.
        by: Member,
        /// The role that was taken away.
        over: Role,
    },
    /// `team_mode` names another group than the one whose roles are played.
    WrongMode {
        /// What stands on the blackboard.
        found: String,
        /// What is played.
        formation: Formation,
    },
    /// `formation` names another formation than the one that is played.
    WrongFormation {
        /// What stands on the blackboard.
        found: String,
        /// What is played.
        formation: Formation,
    },
}

impl fmt::Display for Violation {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoRole { robot, found } => write!(out, "robot {robot}: expected a role, found {found}"),
            Self::NoFormation { roles } => {
                let [a, b, c] = roles.map(Role::text);
                let keeper = if roles.iter().any(|role| role.keeps_goal()) { "" } else { ": nobody keeps the goal" };
                write!(out, "expected a formation of the organisation, found {a}, {b}, {c}{keeper}")
            }
            Self::NoLink { robot, from, to, scope } => {
                let (from, to) = (from.text(), to.text());
                let scope = match scope {
                    Scope::IntraGroup => "within a group",
                    Scope::InterGroup => "between the groups",
                };
                write!(out, "robot {robot}: no compatibility {scope} leads from {from} to {to}")
            }
            Self::NoAuthority { by, over } => {
                write!(out, "{} has no authority over {}: only the coach changes roles", by.text(), over.text())
            }
            Self::WrongMode { found, formation } => {
                let (wanted, formation) = (formation.mode().text(), formation.text());
                write!(out, "expected team_mode '{wanted}' with the formation {formation}, found {found}")
            }
            Self::WrongFormation { found, formation } => {
                write!(out, "expected formation '{}', which is what the roles are, found {found}", formation.text())
            }
        }
    }
}

impl std::error::Error for Violation {}

/// The rules in the form in which they are looked up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checker {
    /// How often each role is played in each formation.
    formations: Vec<(Formation, [u8; 7])>,
    /// The roles that can follow a role within the group, as bits.
    within: [u8; 7],
    /// The roles that can follow a role when the group changes, as bits.
    between: [u8; 7],
    /// Over which roles the Coach has authority.
    coach: u8,
    /// Over which roles each role has authority.
    players: [u8; 7],
}

fn bit(role: Role) -> u8 {
    1 << role as u8
}

fn counts(roles: [Role; ROBOTS]) -> [u8; 7] {
    let mut counts = [0; 7];
    for role in roles {
        counts[role as usize] += 1;
    }
    counts
}

impl Checker {
    /// The rules of an organisation.
    #[must_use]
    pub fn new(organisation: &Organisation) -> Self {
        let structural = &organisation.structural;
        let formations = structural.groups.iter().flat_map(|group| &group.formations);
        let mut checker = Self {
            formations: formations.map(|formation| (formation.name, counts(formation.roles))).collect(),
            within: [0; 7],
            between: [0; 7],
            coach: 0,
            players: [0; 7],
        };
        for link in &structural.compatibilities {
            let table = match link.scope {
                Scope::IntraGroup => &mut checker.within,
                Scope::InterGroup => &mut checker.between,
            };
            table[link.from as usize] |= bit(link.to);
            if link.both_ways {
                table[link.to as usize] |= bit(link.from);
            }
        }
        for link in structural.links.iter().filter(|link| link.kind == LinkKind::Authority) {
            for (from, to) in link.from.iter().flat_map(|from| link.to.iter().map(move |to| (*from, *to))) {
                checker.rule(from, to);
                if link.both_ways {
                    checker.rule(to, from);
                }
            }
        }
        checker
    }

    fn rule(&mut self, from: Member, over: Member) {
        let Member::Player(over) = over else { return };
        match from {
            Member::Coach => self.coach |= bit(over),
            Member::Player(role) => self.players[role as usize] |= bit(over),
        }
    }

    /// The rules of the organisation that every team has.
    #[must_use]
    pub fn built_in() -> &'static Self {
        &BUILT_IN.1
    }

    /// The formation of three roles.
    ///
    /// # Errors
    /// The organisation has no such formation.
    pub fn formation(&self, roles: [Role; ROBOTS]) -> Result<Formation, Violation> {
        let found = counts(roles);
        let known = self.formations.iter().find(|(_, counts)| *counts == found);
        known.map(|(formation, _)| *formation).ok_or(Violation::NoFormation { roles })
    }

    /// True when a robot may change from one role to the other.
    #[must_use]
    pub fn allows(&self, from: Role, to: Role, scope: Scope) -> bool {
        let table = match scope {
            Scope::IntraGroup => &self.within,
            Scope::InterGroup => &self.between,
        };
        table[from as usize] & bit(to) != 0
    }

    /// The formation after a start, where roles are given out afresh.
    ///
    /// - `by`: who gives them out.
    ///
    /// # Errors
    /// No formation, or no authority.
    pub fn start(&self, by: Member, before: [Role; ROBOTS], after: [Role; ROBOTS]) -> Result<Formation, Violation> {
        let formation = self.formation(after)?;
        self.authority(by, before, after)?;
        Ok(formation)
    }

    /// The formation after a change during play.
    ///
    /// - `by`: who changed the roles; robots whose role stays are nobody's business.
    ///
    /// # Errors
    /// No formation, no authority, or a robot's change follows no compatibility link.
    pub fn change(&self, by: Member, before: [Role; ROBOTS], after: [Role; ROBOTS]) -> Result<Formation, Violation> {
        let (old, new) = (self.formation(before)?, self.formation(after)?);
        self.authority(by, before, after)?;
        let scope = if old.mode() == new.mode() { Scope::IntraGroup } else { Scope::InterGroup };
        for (robot, (from, to)) in before.into_iter().zip(after).enumerate() {
            // Within a group, a role that stays needs no link; between groups even the keeper's is one.
            let stays = from == to && scope == Scope::IntraGroup;
            if !stays && !self.allows(from, to, scope) {
                return Err(Violation::NoLink { robot, from, to, scope });
            }
        }
        Ok(new)
    }

    fn authority(&self, by: Member, before: [Role; ROBOTS], after: [Role; ROBOTS]) -> Result<(), Violation> {
        let rules = match by {
            Member::Coach => self.coach,
            Member::Player(role) => self.players[role as usize],
        };
        match before.into_iter().zip(after).find(|(from, to)| from != to && rules & bit(*from) == 0) {
            Some((over, _)) => Err(Violation::NoAuthority { by, over }),
            None => Ok(()),
        }
    }

    /// Looks at what the robots are told in a frame.
    ///
    /// # Errors
    /// The roles are no formation, or mode or formation say something else than the roles.
    pub fn look(&self, duties: &Duties) -> Result<(), Violation> {
        let formation = self.formation(duties.roles)?;
        if formation != duties.formation {
            return Err(Violation::WrongFormation { found: quoted(duties.formation.text()), formation });
        }
        if formation.mode() != duties.mode {
            return Err(Violation::WrongMode { found: quoted(duties.mode.text()), formation });
        }
        Ok(())
    }
}

/// A text as messages show it.
fn quoted(text: &str) -> String {
    format!("'{text}'")
}
