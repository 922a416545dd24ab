//! The Coach as a behaviour tree, read from XML and ticked by the shared engine.
//!
//! Paper: section 5 and Figures 4 to 7. The text fixes the branches, their order and that the mode stands on the
//! blackboard; node kinds, keys and conditions are ours. The tree ships as
//! `trees/soccer/coach.xml` and can be edited; [`Program::read`] refuses what would break the organisation.
//!
//! Leaves act through the same [`Roster`] as the machine. What scripts write to the board takes effect at the end of the
//! tick; when roles, mode and formation then do not fit together, the whole tick is undone and counted as a violation.

use super::check;
use super::leaf::{Leaf, manifest};
use crate::bt::blackboard::EntryId;
use crate::bt::xml::Problem;
use crate::bt::{
    Host, Memory, NodeId, Ports, Recorder, Status, TickError, Tree, Value, compile, pass_time, tick_once, xml,
};
use crate::fingerprint::Fingerprint;
use crate::soccer::team::conditions::{Condition, Form};
use crate::soccer::team::duties::{Duties, Formation, Mode, Pair, Role};
use crate::soccer::team::margins::Margins;
use crate::soccer::team::organisation::Violation;
use crate::soccer::team::roster::Roster;
use crate::soccer::team::start;
use crate::soccer::view::{Call, ROBOTS, Restart, View, Whose};

/// The built-in coach.
pub const BUILT_IN: &str = include_str!("../../../../trees/soccer/coach.xml");
/// The built-in coach without the three swaps of roles.
pub const WITHOUT_SWAPS: &str = include_str!("../../../../trees/soccer/coach-without-swaps.xml");

/// A coach tree, ready to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    tree: Tree<Leaf>,
}

impl Program {
    /// Reads a coach tree.
    ///
    /// # Errors
    /// What the reader refuses; unknown roles; swaps without a condition; changes that no compatibility allows; a start
    /// without a goalkeeper; a tree that never gives out the roles of a start.
    pub fn read(text: &str) -> Result<Self, Vec<Problem>> {
        let manifest = manifest();
        let (document, _) = xml::read(text, &manifest)?;
        check::check(&document)?;
        let tree = compile(&document, &manifest)?;
        let tree = tree.map_leaves(|leaf, extra| check::leaf(&leaf, extra));
        Ok(Self { tree })
    }

    /// The tree that is ticked, subtrees expanded.
    #[must_use]
    pub fn tree(&self) -> &Tree<Leaf> {
        &self.tree
    }
}

/// Keeps a pair from swapping back at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Latch {
    /// The control frame of the swap; `None` when the latch is open.
    pub swapped: Option<u32>,
    /// The leave form was false once since then.
    pub released: bool,
}

/// The entries that the host reads and writes.
#[derive(Clone, Copy, Debug)]
struct Keys {
    event: EntryId,
    team: EntryId,
    quadrant: EntryId,
    number: EntryId,
    mode: EntryId,
    formation: EntryId,
    roles: [EntryId; ROBOTS],
    swap_last: EntryId,
    swap_time: EntryId,
    swap_count: EntryId,
}

impl Keys {
    /// What the leaves change, mode excepted, which scripts change.
    fn texts(&self, duties: &Duties) -> [(EntryId, &'static str); 5] {
        let [first, second, third] = self.roles;
        let [a, b, c] = duties.roles.map(Role::text);
        let swap_last = duties.swap_last.map_or("none", Pair::text);
        [(self.formation, duties.formation.text()), (first, a), (second, b), (third, c), (self.swap_last, swap_last)]
    }

    fn numbers(&self, duties: &Duties) -> [(EntryId, u32); 2] {
        [(self.swap_time, duties.swap_time), (self.swap_count, duties.swap_count)]
    }
}

/// What a coach tree remembers.
#[derive(Clone, Debug)]
pub struct TreeCoach {
    memory: Memory,
    keys: Keys,
    latches: [Latch; 3],
    /// The call that ConsumeEvent dealt with last, and the one for which roles were given out last.
    consumed: u32,
    started: u32,
    /// How often mode, formation and roles had been written when they were looked at last.
    seen: [u32; 2 + ROBOTS],
}

impl TreeCoach {
    /// A coach before its first call, with all its keys on the board.
    #[must_use]
    pub fn new(program: &Program, duties: &Duties) -> Self {
        let mut memory = Memory::for_tree(&program.tree);
        let keys = Keys {
            event: memory.entry_of("ref_event"),
            team: memory.entry_of("ref_team"),
            quadrant: memory.entry_of("ref_quadrant"),
            number: memory.entry_of("ref_seq"),
            mode: memory.entry_of("team_mode"),
            formation: memory.entry_of("formation"),
            roles: ["role_0", "role_1", "role_2"].map(|name| memory.entry_of(name)),
            swap_last: memory.entry_of("swap_last"),
            swap_time: memory.entry_of("swap_time"),
            swap_count: memory.entry_of("swap_count"),
        };
        let mut coach =
            Self { memory, keys, latches: Default::default(), consumed: 0, started: 0, seen: [0; 2 + ROBOTS] };
        for entry in [keys.event, keys.team] {
            put(&mut coach.memory, entry, Value::Text("none".to_owned()));
        }
        for entry in [keys.quadrant, keys.number] {
            put(&mut coach.memory, entry, Value::Number(0.0));
        }
        coach.write(duties);
        coach
    }

    /// The blackboard and the state of the tree.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// The latch of each pair, in the order of [`Pair::ALL`].
    #[must_use]
    pub fn latches(&self) -> [Latch; 3] {
        self.latches
    }

    /// Puts a call on the board.
    pub fn tell(&mut self, call: &Call) {
        let event = match call.restart {
            Restart::KickOff => "kick_off",
            Restart::FreeBall => "free_ball",
            Restart::GoalKick => "goal_kick",
            Restart::PenaltyKick => "penalty_kick",
        };
        let team = match call.taker {
            Whose::Ours => "ours",
            Whose::Theirs => "theirs",
        };
        put(&mut self.memory, self.keys.event, Value::Text(event.to_owned()));
        put(&mut self.memory, self.keys.team, Value::Text(team.to_owned()));
        put(&mut self.memory, self.keys.quadrant, Value::Number(f64::from(call.quadrant)));
        put(&mut self.memory, self.keys.number, Value::Number(f64::from(call.number)));
        self.latches = Default::default();
    }

    /// Ticks the tree once and takes over what it decided.
    ///
    /// - `milliseconds`: what has passed since the last frame.
    ///
    /// # Errors
    /// The tick ended with an error; what was decided before it is undone.
    pub fn step<R: Recorder>(
        &mut self,
        program: &Program,
        view: &View,
        roster: &mut Roster,
        margins: &Margins,
        milliseconds: u64,
        recorder: &mut R,
    ) -> Result<Status, TickError> {
        let before = roster.snapshot();
        let latches = self.latches;
        let mut hands = Hands {
            view,
            margins,
            keys: &self.keys,
            roster,
            latches: &mut self.latches,
            consumed: &mut self.consumed,
            started: &mut self.started,
        };
        let tree = &program.tree;
        let ticked = pass_time(tree, &mut self.memory, &mut hands, recorder, milliseconds)
            .and_then(|()| tick_once(tree, &mut self.memory, &mut hands, recorder));
        let violation = if ticked.is_ok() { self.take_over(view, roster).err() } else { None };
        if ticked.is_err() || violation.is_some() {
            roster.restore(before);
            self.latches = latches;
            self.write(&before.duties);
        }
        if let Some(violation) = violation {
            roster.refuse(view, violation);
        }
        ticked
    }

    /// Reads what the tick wrote to mode, formation and roles, and checks that it all fits together.
    fn take_over(&mut self, view: &View, roster: &mut Roster) -> Result<(), Violation> {
        if self.writes() == self.seen {
            return Ok(());
        }
        let mut roles = roster.duties().roles;
        for (robot, role) in roles.iter_mut().enumerate() {
            let found = self.text(self.keys.roles[robot]);
            *role = Role::from_text(found)
                .ok_or_else(|| Violation::NoRole { robot, found: self.shown(self.keys.roles[robot]) })?;
        }
        if roles != roster.duties().roles {
            roster.write(view, roles)?;
        }
        let formation = roster.duties().formation;
        if Mode::from_text(self.text(self.keys.mode)) != Some(formation.mode()) {
            return Err(Violation::WrongMode { found: self.shown(self.keys.mode), formation });
        }
        if Formation::from_text(self.text(self.keys.formation)) != Some(formation) {
            return Err(Violation::WrongFormation { found: self.shown(self.keys.formation), formation });
        }
        roster.set_mode(formation.mode());
        self.seen = self.writes();
        Ok(())
    }

    fn writes(&self) -> [u32; 2 + ROBOTS] {
        let [a, b, c] = self.keys.roles;
        [self.keys.mode, self.keys.formation, a, b, c].map(|entry| self.memory.state(entry).writes)
    }

    fn text(&self, entry: EntryId) -> &str {
        match &self.memory.state(entry).value {
            Some(Value::Text(text)) => text,
            _ => "",
        }
    }

    /// An entry as messages show it.
    fn shown(&self, entry: EntryId) -> String {
        match &self.memory.state(entry).value {
            Some(Value::Text(text)) => format!("'{}'", text.chars().take(40).collect::<String>()),
            Some(Value::Number(number)) => format!("the number {number}"),
            Some(Value::Queue(_)) => "a queue".to_owned(),
            None => "nothing".to_owned(),
        }
    }

    /// Puts all duties on the board.
    fn write(&mut self, duties: &Duties) {
        put(&mut self.memory, self.keys.mode, Value::Text(duties.mode.text().to_owned()));
        for (entry, text) in self.keys.texts(duties) {
            put(&mut self.memory, entry, Value::Text(text.to_owned()));
        }
        for (entry, number) in self.keys.numbers(duties) {
            put(&mut self.memory, entry, Value::Number(f64::from(number)));
        }
        self.seen = self.writes();
    }

    /// Takes everything that decides what follows into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        self.memory.hash_into(hash);
        for latch in self.latches {
            hash.u64(latch.swapped.map_or(u64::MAX, u64::from));
            hash.u32(u32::from(latch.released));
        }
        hash.u32(self.consumed);
        hash.u32(self.started);
    }
}

/// Writes one of the host's entries, whatever type a script has given it.
fn put(memory: &mut Memory, entry: EntryId, value: Value) {
    if memory.write(entry, value.clone()).is_err() {
        memory.replace(entry, value);
    }
}

/// The host of a coach tree during a tick.
struct Hands<'a> {
    view: &'a View,
    margins: &'a Margins,
    keys: &'a Keys,
    roster: &'a mut Roster,
    latches: &'a mut [Latch; 3],
    consumed: &'a mut u32,
    started: &'a mut u32,
}

impl Host<Leaf> for Hands<'_> {
    fn tick(&mut self, _node: NodeId, leaf: &Leaf, ports: &mut Ports) -> Status {
        let done = match *leaf {
            Leaf::RefereeEventPending => *self.consumed != self.view.call.number,
            Leaf::ConsumeEvent => {
                *self.consumed = self.view.call.number;
                true
            }
            Leaf::Holds(condition) => self.roster.scene(self.view, self.margins).enters(condition),
            Leaf::ShouldSwap(pair) => self.should_swap(pair),
            Leaf::AssignStartRoles(roles) => self.assign(roles) && self.publish(ports),
            Leaf::Swap(pair) => self.swap(pair) && self.publish(ports),
            Leaf::ChangeGroup => self.roster.change_group(self.view) && self.publish(ports),
            Leaf::Become(from, to) => self.roster.transfer(self.view, from, to) && self.publish(ports),
        };
        Status::completed(done)
    }
}

impl Hands<'_> {
    /// The pair's condition, behind its latch: closed by a swap, opened once the leave form was false and the dwell is over.
    ///
    /// Source: our choice, so that the tree has the hysteresis that the paper gives the state machine (section 4.3).
    fn should_swap(&mut self, pair: Pair) -> bool {
        let scene = self.roster.scene(self.view, self.margins);
        let condition = Condition::of(pair);
        let latch = &mut self.latches[pair as usize];
        if let Some(frame) = latch.swapped {
            latch.released |= !scene.holds(condition, Form::Leave);
            if !latch.released || scene.seconds_since(frame) < self.margins.swap_dwell {
                return false;
            }
            *latch = Latch::default();
        }
        scene.enters(condition)
    }

    fn swap(&mut self, pair: Pair) -> bool {
        let swapped = self.roster.swap(self.view, pair);
        if swapped {
            self.latches[pair as usize] = Latch { swapped: Some(self.view.frame), released: false };
        }
        swapped
    }

    /// A start once for each call; later ones are changes during play.
    fn assign(&mut self, given: Option<[Role; ROBOTS]>) -> bool {
        let given = given.unwrap_or_else(|| start::roles(start::formation(&self.view.call)));
        if *self.started == self.view.call.number {
            return self.roster.change(self.view, start::assign(start::slots(self.view), given));
        }
        let started = self.roster.start(self.view, given);
        if started {
            *self.started = self.view.call.number;
        }
        started
    }

    /// Puts what the leaf changed on the board, for the nodes that follow.
    fn publish(&self, ports: &mut Ports) -> bool {
        let duties = self.roster.duties();
        // An entry that a script has made a number stays one, and the end of the tick says so.
        let mut fits = true;
        for (entry, text) in self.keys.texts(duties) {
            fits &= ports.write(entry, Value::Text(text.to_owned())).is_ok();
        }
        for (entry, number) in self.keys.numbers(duties) {
            fits &= ports.write(entry, Value::Number(f64::from(number))).is_ok();
        }
        fits
    }
}
