//! What a tree remembers between ticks: a slot for each node, the blackboard entries, timers and the clock.

use super::blackboard::{Boards, Entry, EntryId, MAIN};
use super::builtin::{BoundScript, Extra, Key, Source};
use super::script::Entries;
use super::tree::Rest;
use super::{NodeId, Status, Tree, Value};
use crate::fingerprint::Fingerprint;

/// The state of a tree; made for one tree, and good for no other.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    pub(super) slots: Vec<Slot>,
    /// Raised by nodes that give the control back between children that were done at once, and by timers.
    pub(super) wake_up: bool,
    /// Simulated time since the start, in milliseconds.
    pub(super) now: u64,
    /// When the timer of a node is due; as long as the last node that ever set one.
    pub(super) timers: Vec<Option<u64>>,
    entries: Vec<Entry>,
    /// The tree's boards, with the entries whose names turned up at run time.
    boards: Option<Box<Boards>>,
}

/// What one node remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Slot {
    pub status: Status,
    /// The child to continue with; 0 means the first (no node is its own child). Other nodes: a number of their own.
    pub cursor: u32,
    /// Children skipped since the node started. Other nodes: a number of their own.
    pub count: u32,
}

impl Memory {
    /// Fresh memory for `tree`: every node IDLE, every entry without a value, time 0.
    #[must_use]
    pub fn for_tree<L>(tree: &Tree<L>) -> Self {
        let mut memory = Self::default();
        memory.fit(tree);
        memory
    }

    /// Forgets everything and takes the size of `tree`; without blackboards it allocates only for a larger tree than
    /// ever before.
    pub fn fit<L>(&mut self, tree: &Tree<L>) {
        self.slots.clear();
        self.slots.resize(tree.nodes().len(), Slot::default());
        self.wake_up = false;
        self.now = 0;
        self.timers.clear();
        self.entries.clear();
        self.boards = tree.boards().cloned().map(Box::new);
        self.entries.resize(self.boards.as_ref().map_or(0, |boards| boards.len()), Entry::default());
        for (entry, value) in tree.boards().map_or(&[][..], Boards::initial) {
            let entry = &mut self.entries[entry.0 as usize];
            (entry.value, entry.writes) = (Some(value.clone()), 1);
        }
    }

    /// The remembered status of `node`: IDLE unless it or a parent of it is RUNNING.
    #[must_use]
    pub fn status(&self, node: NodeId) -> Status {
        self.slots[node.index()].status
    }

    /// Simulated time since the start, in milliseconds.
    #[must_use]
    pub fn now(&self) -> u64 {
        self.now
    }

    /// The value of an entry of the main tree's board, or with `@` of the global one.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Value> {
        let entry = self.boards.as_ref()?.find(MAIN, name)?;
        self.entry(entry).value.as_ref()
    }

    /// Writes an entry of the main tree's board, or with `@` of the global one, for the host.
    ///
    /// # Errors
    /// The value does not fit the entry's type.
    pub fn set(&mut self, name: &str, value: Value) -> Result<(), String> {
        let entry = self.resolve(MAIN, name);
        self.entries[entry.0 as usize].write(value, None)
    }

    /// The entry that `name` means on the main tree's board, or with `@` on the global one; it is made when there is none.
    /// With it a host reads and writes without looking for the name again.
    pub fn entry_of(&mut self, name: &str) -> EntryId {
        self.resolve(MAIN, name)
    }

    /// The state of an entry.
    #[must_use]
    pub fn state(&self, entry: EntryId) -> &Entry {
        self.entry(entry)
    }

    /// Writes an entry for the host.
    ///
    /// # Errors
    /// The value does not fit the entry's type.
    pub fn write(&mut self, entry: EntryId, value: Value) -> Result<(), String> {
        self.entry_mut(entry).write(value, None)
    }

    /// Gives an entry a value of any type, for the host.
    pub fn replace(&mut self, entry: EntryId, value: Value) {
        let entry = self.entry_mut(entry);
        entry.value = None;
        // Without a value, an entry takes every type.
        let written = entry.write(value, None);
        debug_assert!(written.is_ok(), "an empty entry takes every value");
    }

    /// Every entry with its board, name and state.
    pub fn entries(&self) -> impl Iterator<Item = (u32, &str, &Entry)> {
        let known = self.boards.iter().flat_map(|boards| boards.entries());
        known.map(|(id, board, name)| (board, name, &self.entries[id.0 as usize]))
    }

    /// Takes the whole state into a fingerprint.
    pub fn hash_into(&self, hash: &mut Fingerprint) {
        for slot in &self.slots {
            hash.u32(slot.status as u32);
            hash.u64(u64::from(slot.cursor) << 32 | u64::from(slot.count));
        }
        hash.u64(u64::from(self.wake_up));
        hash.u64(self.now);
        for timer in &self.timers {
            hash.u64(timer.unwrap_or(u64::MAX));
        }
        for entry in &self.entries {
            hash.u32(entry.writes);
            entry.value.iter().for_each(|value| value.hash_into(hash));
        }
    }

    pub(super) fn entry(&self, entry: EntryId) -> &Entry {
        &self.entries[entry.0 as usize]
    }

    pub(super) fn entry_mut(&mut self, entry: EntryId) -> &mut Entry {
        &mut self.entries[entry.0 as usize]
    }

    fn resolve(&mut self, board: u32, name: &str) -> EntryId {
        let boards = self.boards.get_or_insert_default();
        let entry = boards.resolve(board, name);
        self.entries.resize(boards.len(), Entry::default());
        entry
    }

    /// The entry a key means now; `None` when the entry that should name it holds no text.
    pub(super) fn find_key(&mut self, key: &Key) -> Option<EntryId> {
        match key {
            Key::Entry(entry) => Some(*entry),
            Key::Named { board, by } => {
                let name = self.entry(*by).value.as_ref()?.to_string();
                Some(self.resolve(*board, &name))
            }
        }
    }

    /// The value of a port, if there is one.
    pub(super) fn read<'a>(&'a self, source: &'a Source) -> Option<&'a Value> {
        match source {
            Source::Missing => None,
            Source::Literal(value) => Some(value),
            Source::Entry(entry) => self.entry(*entry).value.as_ref(),
        }
    }

    /// Runs a script on behalf of `node`.
    pub(super) fn run(&mut self, script: &BoundScript, node: NodeId) -> Result<Value, String> {
        script.script.run(&mut Scope { memory: self, entries: &script.entries, node })
    }

    /// Starts the timer of a node.
    pub(super) fn start_timer(&mut self, node: NodeId, due: u64) {
        if self.timers.len() <= node.index() {
            self.timers.resize(node.index() + 1, None);
        }
        self.timers[node.index()] = Some(due);
    }

    /// When the node's timer is due; `None` when it is not running.
    pub(super) fn timer(&self, node: NodeId) -> Option<u64> {
        self.timers.get(node.index()).copied().flatten()
    }

    pub(super) fn stop_timer(&mut self, node: NodeId) {
        if let Some(timer) = self.timers.get_mut(node.index()) {
            *timer = None;
        }
    }
}

/// The entries of one script.
struct Scope<'a> {
    memory: &'a mut Memory,
    entries: &'a [EntryId],
    node: NodeId,
}

impl Entries for Scope<'_> {
    fn get(&self, slot: usize, _name: &str) -> Option<&Value> {
        self.memory.entry(self.entries[slot]).value.as_ref()
    }

    fn assign(&mut self, slot: usize, name: &str, value: Value, create: bool) -> Result<(), String> {
        let entry = self.memory.entry_mut(self.entries[slot]);
        if entry.value.is_none() && !create {
            return Err(format!("expected an existing entry for =, found none named \"{name}\"; := creates one"));
        }
        entry.write(value, Some(self.node)).map_err(|fault| format!("\"{name}\": {fault}"))
    }
}

/// The ports of a host leaf during its tick.
#[derive(Debug)]
pub struct Ports<'a> {
    pub(super) memory: &'a mut Memory,
    pub(super) rest: Option<&'a Rest>,
    pub(super) node: NodeId,
}

impl Ports<'_> {
    /// The leaf's instance name; empty when it has none.
    #[must_use]
    pub fn instance_name(&self) -> &str {
        self.extra().map_or("", |extra| extra.name.as_str())
    }

    /// Looked up only by leaves that ask, not in each tick.
    fn extra(&self) -> Option<&Extra> {
        self.rest?.extra(self.node)
    }

    fn source(&self, port: &str) -> Option<&Source> {
        self.extra()?.ports.iter().find(|(name, _)| name == port).map(|(_, source)| source)
    }

    /// The value of an input port; `None` when it is not given, or its entry has no value.
    #[must_use]
    pub fn get(&self, port: &str) -> Option<&Value> {
        self.memory.read(self.source(port)?)
    }

    /// Writes an entry that the host knows of, on behalf of the leaf.
    ///
    /// # Errors
    /// The value does not fit the entry's type.
    pub fn write(&mut self, entry: EntryId, value: Value) -> Result<(), String> {
        self.memory.entry_mut(entry).write(value, Some(self.node))
    }

    /// Writes an output port.
    ///
    /// # Errors
    /// The port is not given or is a literal, or the value does not fit the entry's type.
    pub fn set(&mut self, port: &str, value: Value) -> Result<(), String> {
        match self.source(port) {
            Some(&Source::Entry(entry)) => self.memory.entry_mut(entry).write(value, Some(self.node)),
            _ => Err(format!("expected the output port \"{port}\" to name an entry such as {{{port}}}")),
        }
    }
}
