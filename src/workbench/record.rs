//! What happened in each tick, kept in flat lists: a letter a return, whatever the length of the timeline.

use crate::bt::{NodeId, Recorder, Status};

/// Returns that a timeline keeps at most: 32 MB.
const MOST_RETURNS: usize = 8 << 20;

/// One tick as it was recorded.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    pub root: Option<Status>,
    pub error: Option<&'a (NodeId, String)>,
    returns: &'a [u32],
    pub halted: &'a [u32],
}

impl Row<'_> {
    pub fn returns(&self) -> impl Iterator<Item = (NodeId, Status)> {
        self.returns.iter().map(|packed| (NodeId(packed >> 2), unpacked(packed & 3)))
    }
}

/// Every tick so far; row 0 is what happened before the first.
#[derive(Clone, Debug, Default)]
pub struct Record {
    rows: Vec<RowEnds>,
    returns: Vec<u32>,
    halted: Vec<u32>,
    errors: Vec<(u32, (NodeId, String))>,
}

#[derive(Clone, Copy, Debug)]
struct RowEnds {
    root: Option<Status>,
    returns: u32,
    halted: u32,
}

impl Record {
    /// Ticks recorded.
    pub fn length(&self) -> u32 {
        self.rows.len().saturating_sub(1) as u32
    }

    /// Rows recorded: one more than ticks.
    pub fn rows(&self) -> u32 {
        self.rows.len() as u32
    }

    /// True when no further tick is to be recorded.
    pub fn is_full(&self) -> bool {
        self.returns.len() >= MOST_RETURNS || self.halted.len() >= MOST_RETURNS
    }

    pub fn push(&mut self, tick: &Tick) {
        if let Some(error) = &tick.error {
            self.errors.push((self.rows.len() as u32, error.clone()));
        }
        self.returns.extend(tick.returns.iter().map(|(node, status)| node.0 << 2 | packed(*status)));
        self.halted.extend(tick.halted.iter().map(|node| node.0));
        let (returns, halted) = (self.returns.len() as u32, self.halted.len() as u32);
        self.rows.push(RowEnds { root: tick.root, returns, halted });
    }

    pub fn row(&self, tick: u32) -> Option<Row<'_>> {
        let row = self.rows.get(tick as usize)?;
        let before = tick.checked_sub(1).and_then(|before| self.rows.get(before as usize));
        let (returns, halted) = before.map_or((0, 0), |before| (before.returns as usize, before.halted as usize));
        let error = self.errors.binary_search_by_key(&tick, |error| error.0).ok();
        Some(Row {
            root: row.root,
            error: error.map(|index| &self.errors[index].1),
            returns: &self.returns[returns..row.returns as usize],
            halted: &self.halted[halted..row.halted as usize],
        })
    }
}

/// A tick being made: the recorder.
#[derive(Clone, Debug, Default)]
pub struct Tick {
    pub returns: Vec<(NodeId, Status)>,
    pub halted: Vec<NodeId>,
    pub root: Option<Status>,
    pub error: Option<(NodeId, String)>,
}

impl Recorder for Tick {
    fn returned(&mut self, node: NodeId, status: Status) {
        self.returns.push((node, status));
    }

    fn halted(&mut self, node: NodeId) {
        self.halted.push(node);
    }
}

/// Two bits; no node returns IDLE.
fn packed(status: Status) -> u32 {
    match status {
        Status::Success | Status::Idle => 0,
        Status::Failure => 1,
        Status::Running => 2,
        Status::Skipped => 3,
    }
}

fn unpacked(bits: u32) -> Status {
    [Status::Success, Status::Failure, Status::Running, Status::Skipped][bits as usize & 3]
}

/// A letter for a status: S F R K, or I for IDLE.
pub fn letter(status: Status) -> char {
    match status {
        Status::Idle => 'I',
        Status::Success => 'S',
        Status::Failure => 'F',
        Status::Running => 'R',
        Status::Skipped => 'K',
    }
}
