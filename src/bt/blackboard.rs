//! Blackboards: named entries with scopes, remapped between a tree and its subtrees.
//!
//! Which entry a name means is decided once, when the tree is built: `@name` is on the global board, an explicitly
//! remapped name is on the parent's board, with `_autoremap` so is every other name that does not begin with `_`; any
//! other name is local. At run time an entry is a number.

use super::{NodeId, Value};

/// An entry of some board, counted through all boards of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct EntryId(pub u32);

/// The global board, which `@` addresses.
pub const GLOBAL: u32 = 0;
/// The board of the main tree.
pub const MAIN: u32 = 1;

/// The boards of a tree and the entries known so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Boards {
    list: Vec<Board>,
    entries: Vec<(u32, String)>,
    /// Values that entries have from the start.
    initial: Vec<(EntryId, Value)>,
}

#[derive(Clone, Debug, Default, PartialEq)]
struct Board {
    parent: u32,
    /// Name here, entry of the parent's side.
    remapped: Vec<(String, EntryId)>,
    /// Names that stay here whatever `autoremap` says.
    private: Vec<String>,
    autoremap: bool,
}

impl Default for Boards {
    fn default() -> Self {
        Self { list: vec![Board::default(), Board::default()], entries: Vec::new(), initial: Vec::new() }
    }
}

impl Boards {
    /// Adds the board of a subtree below `parent`; returns its number.
    pub fn add(&mut self, parent: u32, autoremap: bool) -> u32 {
        self.list.push(Board { parent, autoremap, ..Board::default() });
        self.list.len() as u32 - 1
    }

    /// Lets `name` of `board` mean an entry of the parent's side.
    pub fn remap(&mut self, board: u32, name: &str, entry: EntryId) {
        self.list[board as usize].remapped.push((name.to_owned(), entry));
    }

    /// Keeps `name` on `board` itself; returns its entry.
    pub fn keep(&mut self, board: u32, name: &str) -> EntryId {
        self.list[board as usize].private.push(name.to_owned());
        self.resolve(board, name)
    }

    /// Gives an entry a value from the start.
    pub fn begin_with(&mut self, entry: EntryId, value: Value) {
        self.initial.push((entry, value));
    }

    /// The values that entries have from the start.
    #[must_use]
    pub fn initial(&self) -> &[(EntryId, Value)] {
        &self.initial
    }

    /// The entry that `name` means on `board`; it is created where its path ends.
    pub fn resolve(&mut self, board: u32, name: &str) -> EntryId {
        let (board, name) = match self.find_home(board, name) {
            Ok(entry) => return entry,
            Err(home) => home,
        };
        let known = self.entries.iter().position(|entry| entry.0 == board && entry.1 == name);
        let id = known.unwrap_or_else(|| {
            self.entries.push((board, name.to_owned()));
            self.entries.len() - 1
        });
        EntryId(id as u32)
    }

    /// The entry that `name` means on `board`, if it was ever asked for.
    #[must_use]
    pub fn find(&self, board: u32, name: &str) -> Option<EntryId> {
        match self.find_home(board, name) {
            Ok(entry) => Some(entry),
            Err((board, name)) => {
                let known = self.entries.iter().position(|entry| entry.0 == board && entry.1 == name);
                known.map(|id| EntryId(id as u32))
            }
        }
    }

    /// Follows a name upwards: an explicitly remapped entry, or the board on which the name lives.
    fn find_home<'a>(&self, board: u32, name: &'a str) -> Result<EntryId, (u32, &'a str)> {
        if let Some(global) = name.strip_prefix('@') {
            return Err((GLOBAL, global));
        }
        let mut board = board;
        loop {
            let here = &self.list[board as usize];
            if here.private.iter().any(|other| other == name) {
                return Err((board, name));
            }
            if let Some((_, entry)) = here.remapped.iter().find(|(other, _)| other == name) {
                return Ok(*entry);
            }
            if !here.autoremap || name.starts_with('_') {
                return Err((board, name));
            }
            board = here.parent;
        }
    }

    /// Every entry with its board and name.
    pub fn entries(&self) -> impl Iterator<Item = (EntryId, u32, &str)> {
        self.entries.iter().enumerate().map(|(id, (board, name))| (EntryId(id as u32), *board, name.as_str()))
    }

    /// How many entries are known.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// True when no entry is known.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The name of an entry.
    #[must_use]
    pub fn name(&self, entry: EntryId) -> &str {
        self.entries.get(entry.0 as usize).map_or("", |entry| entry.1.as_str())
    }
}

/// An entry at run time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Entry {
    /// Its value; `None` before the first write and after it was removed.
    pub value: Option<Value>,
    /// How many times it was written.
    pub writes: u32,
    /// The node that wrote it last; `None` for the host.
    pub writer: Option<NodeId>,
}

impl Entry {
    /// Writes a value. A text into an entry of numbers is read as one; a number into an entry of texts is refused.
    ///
    /// # Errors
    /// What the entry holds and what was to be written.
    pub fn write(&mut self, value: Value, writer: Option<NodeId>) -> Result<(), String> {
        let fitting = match (&self.value, value) {
            (Some(Value::Number(_)), Value::Text(text)) => match (text.as_str(), Value::literal(&text)) {
                ("true", _) => Value::Number(1.0),
                ("false", _) => Value::Number(0.0),
                (_, Value::Number(number)) => Value::Number(number),
                _ => return Err(format!("expected a number for an entry of numbers, found the text '{text}'")),
            },
            (Some(Value::Text(_)), Value::Number(number)) => {
                return Err(format!("expected a text for an entry of texts, found the number {number}"));
            }
            (_, value) => value,
        };
        self.value = Some(fitting);
        self.writes += 1;
        self.writer = writer;
        Ok(())
    }
}
