//! How things stand after a tick, and what every node did in a stretch of ticks.

use super::bench::Run;
use super::record::letter;
use crate::bt::{NodeId, Status, Value};
use serde::Serialize;
use std::collections::BTreeMap;

/// How things stand after a tick.
#[derive(Clone, Debug, Serialize)]
pub struct Moment {
    /// Ticks made.
    pub tick: u32,
    /// Ticks known.
    pub length: u32,
    /// Simulated time, milliseconds.
    pub now: u64,
    /// What the root returned in this tick; `ERROR` when it ended with a fault.
    pub root: Option<&'static str>,
    /// The fault that ended this tick.
    pub error: Option<Fault>,
    /// A letter for each node: what it returned last in this tick, or a dot.
    pub ticked: String,
    /// A letter for each node: the status that is remembered.
    pub kept: String,
    /// Every return of this tick, in order.
    pub trace: Vec<(u32, &'static str)>,
    /// Passes from the root in this tick.
    pub passes: usize,
    /// Nodes halted while RUNNING in this tick, in order.
    pub halted: Vec<u32>,
    /// For each node the tick in which it last returned.
    pub last: Vec<Option<u32>>,
    /// For each node what it returned then, or a dot.
    #[serde(rename = "lastStatus")]
    pub last_status: String,
    /// What the scripted leaves do now.
    pub answers: Vec<ShownAnswer>,
    /// Leaves under way, and how often each has returned RUNNING since it started.
    pub progress: Vec<(u32, u32)>,
    /// The blackboards.
    pub entries: Vec<ShownEntry>,
    /// The breakpoint that was met.
    pub stopped: Option<Stopped>,
    /// True when no further tick can be recorded.
    pub full: bool,
    /// Of the tree's whole state, 16 hex digits.
    pub fingerprint: String,
}

/// A fault of a tick.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// The node.
    pub node: u32,
    /// What was found and what was expected.
    pub message: String,
}

/// A breakpoint that was met.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Stopped {
    /// The node.
    pub node: u32,
    /// What it returned, or `HALTED`.
    pub status: &'static str,
}

/// What the leaves of one name do.
#[derive(Clone, Debug, Serialize)]
pub struct ShownAnswer {
    leaf: String,
    running: u32,
    then: &'static str,
    writes: BTreeMap<String, String>,
}

/// A blackboard entry.
#[derive(Clone, Debug, Serialize)]
pub struct ShownEntry {
    /// Its board.
    pub board: String,
    /// Its name.
    pub name: String,
    /// Its value as text.
    pub value: Option<String>,
    /// What kind of value it is.
    #[serde(rename = "type")]
    pub kind: &'static str,
    /// How often it was written.
    pub writes: u32,
    /// The node that wrote it last.
    pub writer: Option<u32>,
    /// The tick of the last write.
    pub written: Option<u32>,
}

/// What every node did in a stretch of ticks.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Timeline {
    /// The first tick.
    pub from: u32,
    /// For each tick a letter for each node: S F R K, H for halted, or a dot.
    pub columns: Vec<String>,
    /// For each tick what the root returned: S F R K, or E for a fault.
    pub roots: Vec<String>,
}

/// Ticks of one [`Timeline`] at most.
const WIDEST: u32 = 512;

impl Moment {
    pub(super) fn of(run: &Run, stopped: Option<Stopped>) -> Self {
        let state = &run.state;
        let nodes = run.tree.nodes().len();
        let mut ticked = vec![None; nodes];
        let mut moment = Self {
            tick: state.tick,
            length: run.record.length(),
            now: state.memory.now(),
            root: None,
            error: None,
            ticked: String::new(),
            kept: (0..nodes as u32).map(|node| letter(state.memory.status(NodeId(node)))).collect(),
            trace: Vec::new(),
            passes: 0,
            halted: Vec::new(),
            last: state.last.iter().map(|last| last.map(|(tick, _)| tick)).collect(),
            last_status: state.last.iter().map(|last| last.map_or('.', |(_, status)| letter(status))).collect(),
            answers: answers(run),
            progress: (0..).zip(&state.progress).filter_map(|(node, made)| made.map(|made| (node, made))).collect(),
            entries: entries(run),
            stopped,
            full: run.is_full(),
            fingerprint: format!("{:016x}", run.fingerprint()),
        };
        if let Some(row) = run.record.row(state.tick) {
            for (node, status) in row.returns() {
                ticked[node.index()] = Some(status);
                moment.trace.push((node.0, status.name()));
                moment.passes += usize::from(node.0 == 0);
            }
            moment.root = if row.error.is_some() { Some("ERROR") } else { row.root.map(Status::name) };
            moment.error = row.error.map(|(node, message)| Fault { node: node.0, message: message.clone() });
            moment.halted = row.halted.to_vec();
        }
        moment.ticked = ticked.into_iter().map(|status| status.map_or('.', letter)).collect();
        moment
    }
}

fn answers(run: &Run) -> Vec<ShownAnswer> {
    let all = run.names.names.iter().zip(&run.state.answers);
    all.map(|(leaf, answer)| ShownAnswer {
        leaf: leaf.clone(),
        running: answer.running,
        then: answer.then.name(),
        writes: answer.writes.clone(),
    })
    .collect()
}

fn entries(run: &Run) -> Vec<ShownEntry> {
    let all = run.state.memory.entries().zip(&run.state.written);
    all.map(|((board, name, entry), (_, tick))| ShownEntry {
        board: run.boards.get(board as usize).cloned().unwrap_or_default(),
        name: name.to_owned(),
        value: entry.value.as_ref().map(ToString::to_string),
        kind: match entry.value {
            None => "none",
            Some(Value::Number(_)) => "number",
            Some(Value::Text(_)) => "text",
            Some(Value::Queue(_)) => "queue",
        },
        writes: entry.writes,
        writer: entry.writer.map(|node| node.0),
        written: (entry.writes > 0).then_some(*tick),
    })
    .collect()
}

pub(super) fn timeline(run: &Run, from: u32, to: u32) -> Timeline {
    let from = from.max(1);
    let to = to.min(run.record.length()).min(from.saturating_add(WIDEST - 1));
    let mut shown = Timeline { from, ..Timeline::default() };
    for row in (from..=to).filter_map(|tick| run.record.row(tick)) {
        let mut column = vec!['.'; run.tree.nodes().len()];
        for (node, status) in row.returns() {
            column[node.index()] = letter(status);
        }
        for &node in row.halted {
            // A node that was started again after the halt shows what it returned then.
            let mark = &mut column[node as usize];
            if matches!(mark, '.' | 'R') {
                *mark = 'H';
            }
        }
        shown.columns.push(column.into_iter().collect());
        let root = if row.error.is_some() { 'E' } else { row.root.map_or('.', letter) };
        shown.roots.push(root.to_string());
    }
    shown
}
