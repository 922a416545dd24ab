//! The organisation of a team as MOISE+ describes it: structure, functions and duties, as data.
//!
//! Paper: section 3.2 for the model, section 4.2 and Figure 2 for the team. The text fixes the seven roles, the Coach with
//! authority over all of them, the compositions of both groups and some compatibilities; the other cardinalities and links,
//! the functional and the deontic specification are ours. The paper calls compatibility within one group "inter-group"
//! and between groups "intra-group"; MOISE+ has it the other way round, and so do we.
//!
//! The data stand in `moise.json`, which the page draws. [`Checker`] holds what the rules need of them in every frame.

mod check;

pub use check::{Checker, Violation};

use super::duties::{Formation, Mode, Role};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::LazyLock;

/// Somebody in the organisation: the Coach, or a robot by its role.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum Member {
    /// The agent that gives out the roles.
    Coach,
    /// A robot that plays.
    Player(Role),
}

impl Member {
    /// The name in files.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Coach => "coach",
            Self::Player(role) => role.text(),
        }
    }
}

impl TryFrom<String> for Member {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        if text == "coach" {
            return Ok(Self::Coach);
        }
        Role::from_text(&text).map(Self::Player).ok_or_else(|| format!("expected coach or a role, found {text:?}"))
    }
}

impl From<Member> for String {
    fn from(member: Member) -> Self {
        member.text().to_owned()
    }
}

/// The whole organisation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Organisation {
    /// All roles, the Coach's among them.
    pub roles: Vec<Member>,
    /// Groups and links.
    pub structural: Structural,
    /// Goals and missions.
    pub functional: Functional,
    /// Who has to or may take which mission.
    pub deontic: Vec<Duty>,
}

/// How many there may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bounds {
    /// At least.
    pub least: u32,
    /// At most.
    pub most: u32,
}

/// The structural specification.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Structural {
    /// The team as a whole.
    pub team: Whole,
    /// The groups attack and defense.
    pub groups: Vec<Group>,
    /// Authority, communication and acquaintance.
    pub links: Vec<Link>,
    /// Which roles one robot can play one after the other.
    pub compatibilities: Vec<Compatibility>,
}

/// The team as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Whole {
    /// Coaches.
    pub coach: Bounds,
    /// Groups that are active at a time.
    pub active_groups: Bounds,
}

/// A group of the team.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Group {
    /// The mode in which it is active.
    pub mode: Mode,
    /// How many robots it has.
    pub players: Bounds,
    /// How many robots may play each role.
    pub roles: Vec<Cardinality>,
    /// The roles that are played together.
    pub formations: Vec<Composition>,
}

/// How many robots of a group may play a role.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cardinality {
    /// The role.
    pub role: Role,
    /// At least.
    pub least: u32,
    /// At most.
    pub most: u32,
}

/// A formation and its roles.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Composition {
    /// Its name.
    pub name: Formation,
    /// A role for each robot.
    pub roles: [Role; 3],
}

/// A link between roles.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Link {
    /// What it is.
    pub kind: LinkKind,
    /// From each of these ...
    pub from: Vec<Member>,
    /// ... to each of those.
    pub to: Vec<Member>,
    /// And back.
    pub both_ways: bool,
}

/// What a link between roles is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LinkKind {
    /// May change the other's role.
    Authority,
    /// May speak to the other.
    Communication,
    /// Knows of the other.
    Acquaintance,
}

/// That a robot may change from one role to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Compatibility {
    /// Within a group or between groups.
    pub scope: Scope,
    /// The role before.
    pub from: Role,
    /// The role after.
    pub to: Role,
    /// And back.
    pub both_ways: bool,
}

/// Where a compatibility holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scope {
    /// While the group stays the same.
    IntraGroup,
    /// When the group changes.
    InterGroup,
}

/// The functional specification.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Functional {
    /// The goals; the first is the root.
    pub goals: Vec<Goal>,
    /// The missions.
    pub missions: Vec<Mission>,
}

/// A goal, and the plan of its parts if it has any.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Goal {
    /// What other places call it.
    pub id: String,
    /// What people call it.
    pub title: String,
    /// How the parts serve it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// The goals it consists of.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<String>,
}

/// How the parts of a goal serve it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Plan {
    /// One after the other.
    Sequence,
    /// One of them.
    Choice,
    /// All at a time.
    Parallel,
}

/// Goals that one agent commits itself to together.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mission {
    /// m0 to m7.
    pub id: String,
    /// What people call it.
    pub title: String,
    /// Its goals.
    pub goals: Vec<String>,
    /// How many agents take it at least.
    pub least: u32,
    /// How many agents take it at most.
    pub most: u32,
}

/// What a role has to or may do.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Duty {
    /// The role.
    pub role: Member,
    /// Obliged or permitted.
    pub relation: Relation,
    /// The mission.
    pub mission: String,
    /// The occasion, for people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub when: Option<String>,
}

/// How a role stands to a mission.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Relation {
    /// It has to.
    Obliged,
    /// It may.
    Permitted,
}

/// Why a text is no organisation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrganisationError(String);

impl fmt::Display for OrganisationError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl std::error::Error for OrganisationError {}

/// The organisation that every team of the playground has.
static BUILT_IN: LazyLock<(Organisation, Checker)> = LazyLock::new(|| {
    let organisation = Organisation::read(include_str!("moise.json")).expect("a test reads the committed file");
    let checker = Checker::new(&organisation);
    (organisation, checker)
});

impl Organisation {
    /// The organisation that every team of the playground has.
    #[must_use]
    pub fn built_in() -> &'static Self {
        &BUILT_IN.0
    }

    /// Reads an organisation from JSON.
    ///
    /// # Errors
    /// What JSON or a field says is wrong, with line and column; a formation that breaks the cardinalities of its group or
    /// stands in no group's mode; a goal, mission or part that nothing declares.
    pub fn read(text: &str) -> Result<Self, OrganisationError> {
        let organisation: Self = serde_json::from_str(text).map_err(|error| OrganisationError(error.to_string()))?;
        for group in &organisation.structural.groups {
            group.check()?;
        }
        organisation.functional.check()?;
        let missions = &organisation.functional.missions;
        for duty in &organisation.deontic {
            if missions.iter().all(|mission| mission.id != duty.mission) {
                let (role, mission) = (duty.role.text(), &duty.mission);
                return Err(OrganisationError(format!(
                    "deontic, {role}: expected a declared mission, found {mission:?}"
                )));
            }
        }
        Ok(organisation)
    }
}

impl Group {
    fn check(&self) -> Result<(), OrganisationError> {
        for formation in &self.formations {
            let place = format!("group {}, formation {}", self.mode.group(), formation.name.text());
            if formation.name.mode() != self.mode {
                return Err(OrganisationError(format!("{place}: expected a formation of this group")));
            }
            let players = formation.roles.len() as u32;
            if players < self.players.least || players > self.players.most {
                let Bounds { least, most } = self.players;
                return Err(OrganisationError(format!("{place}: expected {least} to {most} players, found {players}")));
            }
            for role in Role::ALL {
                let found = formation.roles.iter().filter(|other| **other == role).count() as u32;
                let bounds = self.roles.iter().find(|cardinality| cardinality.role == role);
                let (least, most) = bounds.map_or((0, 0), |bounds| (bounds.least, bounds.most));
                if found < least || found > most {
                    let name = role.text();
                    return Err(OrganisationError(format!(
                        "{place}: expected {least} to {most} of {name}, found {found}"
                    )));
                }
            }
        }
        Ok(())
    }
}

impl Functional {
    fn check(&self) -> Result<(), OrganisationError> {
        let named = self.goals.iter().flat_map(|goal| goal.parts.iter().map(move |part| ("goal", &goal.id, part)));
        let taken = self
            .missions
            .iter()
            .flat_map(|mission| mission.goals.iter().map(move |goal| ("mission", &mission.id, goal)));
        for (what, id, part) in named.chain(taken) {
            if self.goals.iter().all(|goal| goal.id != *part) {
                return Err(OrganisationError(format!("{what} {id}: expected a declared goal, found {part:?}")));
            }
        }
        Ok(())
    }
}
