//! The hands of both coaches: gives out roles, swaps them and changes the group, and refuses what the organisation
//! forbids.

use super::conditions::Scene;
use super::duties::{Duties, Formation, Mode, Pair, Role};
use super::geometry::distance;
use super::margins::Margins;
use super::organisation::{Checker, Member, Violation};
use super::start;
use crate::fingerprint::Fingerprint;
use crate::soccer::view::{ROBOTS, Slot, View};
use std::fmt;

/// Something that the log of a match notes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// The control frame of play.
    pub frame: u32,
    /// What happened.
    pub kind: EventKind,
}

/// What happened to the roles of a team.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// Roles were given out after a call.
    Start {
        /// The number of the call.
        call: u32,
        /// The formation.
        formation: Formation,
    },
    /// Two robots exchanged their roles.
    Swap(Pair),
    /// The team went over to the other group.
    ChangeGroup(Mode),
    /// One robot took another role: a special formation ended.
    Become {
        /// The role before.
        from: Role,
        /// The role after.
        to: Role,
    },
    /// Scripts of a coach tree wrote these roles.
    Written([Role; ROBOTS]),
    /// A change was refused.
    Refused(Violation),
    /// The tick of a tree ended with an error; the motors are off.
    Fault(String),
}

impl EventKind {
    /// What kind it is, in a word.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Start { .. } => "start",
            Self::Swap(_) => "swap",
            Self::ChangeGroup(_) => "group",
            Self::Become { .. } => "become",
            Self::Written(_) => "written",
            Self::Refused(_) => "refused",
            Self::Fault(_) => "fault",
        }
    }
}

impl fmt::Display for EventKind {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start { call, formation } => write!(out, "call {call}: starts as {}", formation.text()),
            Self::Swap(pair) => {
                let [first, second] = pair.roles().map(Role::text);
                write!(out, "{first} and {second} swap")
            }
            Self::ChangeGroup(mode) => write!(out, "changes to the group {}", mode.group()),
            Self::Become { from, to } => write!(out, "{} becomes {}", from.text(), to.text()),
            Self::Written(roles) => {
                let [a, b, c] = roles.map(Role::text);
                write!(out, "writes the roles {a}, {b}, {c}")
            }
            Self::Refused(violation) => write!(out, "refused: {violation}"),
            Self::Fault(error) => write!(out, "motors off: {error}"),
        }
    }
}

/// The most events that wait to be fetched: a tree that errs in every frame must not fill the memory.
const MOST_EVENTS: usize = 256;

/// A roster as it was before a tick.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot {
    /// Who played what.
    pub duties: Duties,
    slots: [Slot; ROBOTS],
    group_changed: Option<u32>,
    events: usize,
}

/// The duties of a team, and what both coaches do with them.
#[derive(Clone, Debug)]
pub struct Roster {
    duties: Duties,
    slots: [Slot; ROBOTS],
    group_changed: Option<u32>,
    violations: u32,
    refused: Option<Violation>,
    events: Vec<Event>,
}

impl Default for Roster {
    fn default() -> Self {
        Self {
            duties: Duties::default(),
            slots: [Slot::Goalkeeper, Slot::Attacker, Slot::Supporter],
            group_changed: None,
            violations: 0,
            refused: None,
            events: Vec::new(),
        }
    }
}

impl Roster {
    /// Who plays what.
    #[must_use]
    pub fn duties(&self) -> &Duties {
        &self.duties
    }

    /// The slot of each robot at the last start.
    #[must_use]
    pub fn slots(&self) -> [Slot; ROBOTS] {
        self.slots
    }

    /// Changes that were refused since the start of the match.
    #[must_use]
    pub fn violations(&self) -> u32 {
        self.violations
    }

    /// What happened since it was fetched last.
    pub fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.events)
    }

    /// What the conditions are asked about now.
    #[must_use]
    pub fn scene<'a>(&self, view: &'a View, margins: &'a Margins) -> Scene<'a> {
        Scene { view, roles: self.duties.roles, margins, group_changed: self.group_changed }
    }

    /// Gives out the roles of a start; true when the organisation allows them.
    ///
    /// - `given`: the role of goalkeeper, ball player and supporter.
    pub fn start(&mut self, view: &View, given: [Role; ROBOTS]) -> bool {
        let slots = start::slots(view);
        let roles = start::assign(slots, given);
        match Checker::built_in().start(Member::Coach, self.duties.roles, roles) {
            Ok(formation) => {
                self.slots = slots;
                self.group_changed = None;
                self.set(roles, formation);
                self.note(view, EventKind::Start { call: view.call.number, formation });
                true
            }
            Err(violation) => self.refuse(view, violation),
        }
    }

    /// Lets the two robots of a pair exchange their roles; true when it was done.
    pub fn swap(&mut self, view: &View, pair: Pair) -> bool {
        let [first, second] = pair.roles();
        let exchanged = self.duties.roles.map(|role| match role {
            role if role == first => second,
            role if role == second => first,
            role => role,
        });
        let both = self.duties.who(first).is_some() && self.duties.who(second).is_some();
        if !both || !self.change(view, exchanged) {
            return false;
        }
        self.duties.swap_last = Some(pair);
        self.duties.swap_time = view.frame;
        self.duties.swap_count += 1;
        self.note(view, EventKind::Swap(pair));
        true
    }

    /// Lets every robot take the role that belongs to its own in the other group; true when it was done. The mode is not
    /// touched.
    ///
    /// Source: our choice; that a Wingback becomes Striker when defence turns into attack is the paper's.
    pub fn change_group(&mut self, view: &View) -> bool {
        let roles = self.duties.roles.map(|role| match role {
            Role::Wingback => Role::Striker,
            Role::Striker => Role::Wingback,
            Role::Fullback => Role::Assistant,
            Role::Assistant => Role::Fullback,
            Role::Goalkeeper | Role::PenaltyKicker | Role::PenaltyDefender => role,
        });
        let changed = self.change(view, roles);
        if changed {
            self.group_changed = Some(view.frame);
            self.note(view, EventKind::ChangeGroup(self.duties.formation.mode()));
        }
        changed
    }

    /// Lets one robot of role `from`, of several the one farthest from the ball, take the role `to`; true when it was done.
    pub fn transfer(&mut self, view: &View, from: Role, to: Role) -> bool {
        let way = |robot: usize| distance(view.ours[robot].at, view.ball.at);
        let mut farthest = None;
        for robot in (0..ROBOTS).filter(|robot| self.duties.roles[*robot] == from) {
            if farthest.is_none_or(|other| way(robot) > way(other)) {
                farthest = Some(robot);
            }
        }
        let Some(robot) = farthest else { return false };
        let mut roles = self.duties.roles;
        roles[robot] = to;
        let changed = self.change(view, roles);
        if changed {
            self.note(view, EventKind::Become { from, to });
        }
        changed
    }

    /// Changes roles during play; true when the organisation allows it.
    pub fn change(&mut self, view: &View, roles: [Role; ROBOTS]) -> bool {
        match Checker::built_in().change(Member::Coach, self.duties.roles, roles) {
            Ok(formation) => {
                self.set(roles, formation);
                true
            }
            Err(violation) => self.refuse(view, violation),
        }
    }

    /// Takes over roles that scripts wrote one by one.
    ///
    /// # Errors
    /// How the change would break the organisation; nothing is changed then, and the violation is the caller's to refuse.
    pub fn write(&mut self, view: &View, roles: [Role; ROBOTS]) -> Result<(), Violation> {
        let formation = Checker::built_in().change(Member::Coach, self.duties.roles, roles)?;
        if formation.mode() != self.duties.formation.mode() {
            self.group_changed = Some(view.frame);
        }
        self.set(roles, formation);
        self.note(view, EventKind::Written(roles));
        Ok(())
    }

    /// Says whether the team attacks or defends.
    pub fn set_mode(&mut self, mode: Mode) {
        self.duties.mode = mode;
    }

    /// Counts what was refused, and notes it unless it is the same as the last time; always false.
    pub fn refuse(&mut self, view: &View, violation: Violation) -> bool {
        self.violations = self.violations.saturating_add(1);
        if self.refused.as_ref() != Some(&violation) {
            self.refused = Some(violation.clone());
            self.note(view, EventKind::Refused(violation));
        }
        false
    }

    /// The last change that was refused.
    #[must_use]
    pub fn refused(&self) -> Option<&Violation> {
        self.refused.as_ref()
    }

    /// Notes the error of a tree.
    pub fn fault(&mut self, view: &View, text: String) {
        self.note(view, EventKind::Fault(text));
    }

    /// What a tick may have to be undone to.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            duties: self.duties,
            slots: self.slots,
            group_changed: self.group_changed,
            events: self.events.len(),
        }
    }

    /// Goes back to what was before a tick whose outcome broke the organisation; what it noted is forgotten.
    pub fn restore(&mut self, before: Snapshot) {
        self.duties = before.duties;
        self.slots = before.slots;
        self.group_changed = before.group_changed;
        self.events.truncate(before.events);
    }

    fn set(&mut self, roles: [Role; ROBOTS], formation: Formation) {
        self.duties.roles = roles;
        self.duties.formation = formation;
    }

    fn note(&mut self, view: &View, kind: EventKind) {
        if self.events.len() < MOST_EVENTS {
            self.events.push(Event { frame: view.frame, kind });
        }
    }

    /// Takes everything that decides what follows into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        self.duties.feed(hash);
        for slot in self.slots {
            hash.u32(match slot {
                Slot::Goalkeeper => 0,
                Slot::Attacker => 1,
                Slot::Supporter => 2,
            });
        }
        hash.u64(self.group_changed.map_or(u64::MAX, u64::from));
        hash.u32(self.violations);
    }
}
