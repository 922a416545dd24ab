//! A tree on the bench: its timeline, and the state at one tick of it.

use super::leaves::{LeafNames, Leaves};
use super::moment::{Moment, Stopped, Timeline, timeline};
use super::record::{Record, Row, Tick};
use super::setup::{Answer, Event, EventKind, MOST_TICKS, Mode, Setup};
use super::shown::{Opened, ShownProblem, shown};
use super::variants::understand;
use crate::bt::xml::Problem;
use crate::bt::{
    HostLeaf, Memory, NodeId, Status, TickError, Tree, Value, compile, halt_tree, pass_time, tick_exactly_once,
    tick_once,
};
use crate::fingerprint::Fingerprint;

/// Ticks between two states kept for going back.
const SPACING: u32 = 64;
/// Bytes that kept states may take, roughly; the spacing grows beyond.
const MOST_BYTES: usize = 24 << 20;

/// A tree that runs; empty before the first valid document.
#[derive(Clone, Debug, Default)]
pub struct Bench {
    run: Option<Run>,
    /// For each node the letters of [`Bench::breakpoints`].
    breakpoints: Vec<(u32, String)>,
}

/// What follows from one setup.
#[derive(Clone, Debug)]
pub(super) struct Run {
    pub tree: Tree<HostLeaf>,
    pub names: LeafNames,
    pub boards: Vec<String>,
    script: Vec<Event>,
    mode: Mode,
    ms: u64,
    pub record: Record,
    pub state: State,
    kept: Vec<State>,
    spacing: u32,
}

/// Everything that the next tick depends on, and what is shown of the past.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub tick: u32,
    pub memory: Memory,
    pub answers: Vec<Answer>,
    pub progress: Vec<Option<u32>>,
    /// For each node the tick in which it last returned, and what.
    pub last: Vec<Option<(u32, Status)>>,
    /// For each entry how often it had been written when it was last looked at, and in which tick.
    pub written: Vec<(u32, u32)>,
}

impl Bench {
    /// Reads the document, runs `setup.length` ticks and shows the tick `setup.at`; breakpoints do not stop it.
    ///
    /// A document with a fault leaves everything as it was. Breakpoints on nodes that are no more are forgotten.
    pub fn open(&mut self, setup: &Setup) -> Opened {
        let all = |problems: &[Problem]| problems.iter().map(ShownProblem::from).collect::<Vec<_>>();
        let (document, manifest, mut problems) = match understand(&setup.xml) {
            Ok(understood) => understood,
            Err(problems) => return Opened { problems: all(&problems), tree: None, moment: None },
        };
        let compiled = compile(&document, &manifest);
        let (tree, boards) = shown(&document, &manifest, compiled.is_ok());
        match compiled {
            Ok(compiled) => {
                let mut run = Run::new(compiled, boards, setup);
                while run.record.length() < setup.length && run.step() {}
                run.seek(setup.at);
                self.breakpoints.retain(|(node, _)| (*node as usize) < run.tree.nodes().len());
                self.run = Some(run);
            }
            Err(faults) => {
                // It can be shown, so what keeps it from running is a warning, unless the reading said so already.
                let new = faults.into_iter().filter(|fault| problems.iter().all(|known| known.place != fault.place));
                let new: Vec<Problem> = new.map(|fault| Problem { warning: true, ..fault }).collect();
                problems.extend(new);
                self.run = None;
            }
        }
        let moment = self.run.as_ref().map(|run| Moment::of(run, None));
        Opened { problems: all(&problems), tree: Some(tree), moment }
    }

    /// Goes up to `ticks` further and shows where it stands: it ends behind a tick in which a breakpoint was met or
    /// that ended with an error. `None` without a tree.
    pub fn advance(&mut self, ticks: u32) -> Option<Moment> {
        let run = self.run.as_mut()?;
        let mut stopped = None;
        for _ in 0..ticks {
            if stopped.is_some() || !run.step() {
                break;
            }
            let Some(row) = run.record.row(run.state.tick) else { break };
            stopped = met(&self.breakpoints, &row);
            if row.error.is_some() {
                break;
            }
        }
        Some(Moment::of(run, stopped))
    }

    /// Shows the state after `tick` ticks, computing what is not known yet. `None` without a tree.
    pub fn seek(&mut self, tick: u32) -> Option<Moment> {
        let run = self.run.as_mut()?;
        run.seek(tick);
        Some(Moment::of(run, None))
    }

    /// What every node did in the ticks `from` to `to`, both included, as far as they are known; at most 512.
    #[must_use]
    pub fn timeline(&self, from: u32, to: u32) -> Timeline {
        self.run.as_ref().map_or_else(Timeline::default, |run| timeline(run, from, to))
    }

    /// Sets where [`Bench::advance`] stops: nodes with letters for what they return (S F R K) or H for halted.
    pub fn breakpoints(&mut self, list: Vec<(u32, String)>) {
        self.breakpoints = list;
    }
}

/// The first breakpoint met in a tick: returns in their order, then halts.
fn met(breakpoints: &[(u32, String)], row: &Row) -> Option<Stopped> {
    if breakpoints.is_empty() {
        return None;
    }
    let holds =
        |node: u32, letter: char| breakpoints.iter().any(|(other, letters)| *other == node && letters.contains(letter));
    let returned = row.returns().find(|(node, status)| holds(node.0, super::record::letter(*status)));
    let halted = || row.halted.iter().copied().find(|node| holds(*node, 'H'));
    match returned {
        Some((node, status)) => Some(Stopped { node: node.0, status: status.name() }),
        None => halted().map(|node| Stopped { node, status: "HALTED" }),
    }
}

impl Run {
    fn new(tree: Tree<HostLeaf>, boards: Vec<String>, setup: &Setup) -> Self {
        let names = LeafNames::of(&tree);
        let nodes = tree.nodes().len();
        let state = State {
            tick: 0,
            memory: Memory::for_tree(&tree),
            answers: vec![Answer::default(); names.names.len()],
            progress: vec![None; nodes],
            last: vec![None; nodes],
            written: Vec::new(),
        };
        let mut run = Self {
            tree,
            names,
            boards,
            script: setup.script.clone(),
            mode: setup.mode,
            ms: setup.ms,
            record: Record::default(),
            state,
            kept: Vec::new(),
            spacing: SPACING,
        };
        let mut row = Tick::default();
        run.apply_events(&mut row);
        run.end_tick(&row);
        run
    }

    /// True when no further tick can be recorded: of the returns, or of the ticks, there are as many as a timeline keeps.
    pub(super) fn is_full(&self) -> bool {
        self.record.is_full() || self.record.length() >= MOST_TICKS
    }

    /// Makes one tick and what the script says behind it; false when the timeline is full.
    fn step(&mut self) -> bool {
        if self.state.tick == self.record.length() && self.is_full() {
            return false;
        }
        self.state.tick += 1;
        let mut row = Tick::default();
        let State { memory, answers, progress, .. } = &mut self.state;
        let mut leaves = Leaves { names: &self.names, answers, progress, fault: None };
        let waited = pass_time(&self.tree, memory, &mut leaves, &mut row, self.ms);
        let ticked = match self.mode {
            Mode::Once => tick_once(&self.tree, memory, &mut leaves, &mut row),
            Mode::ExactlyOnce => tick_exactly_once(&self.tree, memory, &mut leaves, &mut row),
        };
        let mut result = waited.and(ticked).map_err(|error| (error.node, error.to_string()));
        if let (Some((node, fault)), true) = (leaves.fault.take(), result.is_ok()) {
            // The reference's leaves throw here; the tree is halted as after any error of a tick.
            let halted = halt_tree(&self.tree, memory, &mut leaves, &mut row);
            result = Err((node, halted.err().map_or(fault.clone(), |error| format!("{fault}; {error}"))));
        }
        match result {
            Ok(status) => row.root = Some(status),
            Err(error) => row.error = Some(error),
        }
        self.apply_events(&mut row);
        self.end_tick(&row);
        true
    }

    /// What the script says for the present tick.
    fn apply_events(&mut self, row: &mut Tick) {
        let tick = self.state.tick;
        let first = self.script.partition_point(|event| event.tick < tick);
        let State { memory, answers, progress, .. } = &mut self.state;
        for event in self.script[first..].iter().take_while(|event| event.tick == tick) {
            let fault = match &event.kind {
                EventKind::Answer(leaf, answer) => {
                    if let Some(index) = self.names.find(leaf) {
                        answers[index] = answer.clone();
                    }
                    None
                }
                EventKind::Set(name, value) => memory
                    .set(name, Value::literal(value))
                    .err()
                    .map(|fault| (NodeId(0), format!("entry \"{name}\", written by hand: {fault}"))),
                EventKind::Halt => {
                    let mut leaves = Leaves { names: &self.names, answers, progress, fault: None };
                    let halted = halt_tree(&self.tree, memory, &mut leaves, row);
                    halted.err().map(|error: TickError| (error.node, error.to_string()))
                }
            };
            row.error = row.error.take().or(fault);
        }
    }

    /// Notes what the tick did, and keeps the state where it is due.
    fn end_tick(&mut self, row: &Tick) {
        let tick = self.state.tick;
        for (node, status) in &row.returns {
            self.state.last[node.index()] = Some((tick, *status));
        }
        let State { memory, written, .. } = &mut self.state;
        for (index, (_, _, entry)) in memory.entries().enumerate() {
            match written.get_mut(index) {
                Some(seen) if seen.0 != entry.writes => *seen = (entry.writes, tick),
                Some(_) => {}
                None => written.push((entry.writes, tick)),
            }
        }
        if tick < self.record.rows() {
            return; // known already: going on after going back
        }
        self.record.push(row);
        if tick.is_multiple_of(self.spacing) {
            self.kept.push(self.state.clone());
            if self.kept.len() > 2 && self.kept.len() * self.state_bytes() > MOST_BYTES {
                self.spacing *= 2;
                let spacing = self.spacing;
                self.kept.retain(|state| state.tick.is_multiple_of(spacing));
            }
        }
    }

    fn state_bytes(&self) -> usize {
        self.state.last.len() * 40 + self.state.written.len() * 80 + self.names.names.len() * 64
    }

    fn seek(&mut self, tick: u32) {
        if tick < self.state.tick {
            let kept = self.kept.partition_point(|state| state.tick <= tick);
            if let Some(state) = kept.checked_sub(1).and_then(|index| self.kept.get(index)) {
                self.state = state.clone();
            }
        }
        while self.state.tick < tick && self.step() {}
    }

    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fingerprint::default();
        hash.u32(self.state.tick);
        self.state.memory.hash_into(&mut hash);
        for progress in &self.state.progress {
            hash.u64(progress.map_or(u64::MAX, u64::from));
        }
        hash.finish()
    }
}
