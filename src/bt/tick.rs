//! Ticking and halting a tree.
//!
//! The rules are those of `BehaviorTree.CPP` 4.10: a node that starts marks itself RUNNING before it ticks a
//! child; a node that completes resets its children (RUNNING ones are halted); SKIPPED is told to the parent
//! but not remembered; the root is reset after it completes, so the next tick starts afresh.

use super::builtin::{BoundScript, Builtin, Scripts, Source};
use super::memory::{Memory, Ports, Slot};
use super::{Kind, NodeId, Recorder, Status, Tree, Value};
use std::fmt;

/// Runs the leaves of a world.
pub trait Host<L> {
    /// Ticks one leaf and returns its status, which is never IDLE.
    fn tick(&mut self, node: NodeId, leaf: &L, ports: &mut Ports) -> Status;

    /// Stops a leaf that had returned RUNNING; worlds without RUNNING leaves need nothing here.
    fn halt(&mut self, _node: NodeId, _leaf: &L) {}
}

/// Why a tick ended without a status: the node and the cause.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TickError {
    /// The node whose tick failed.
    pub node: NodeId,
    /// Its kind's name and, where it has one, its own.
    pub name: String,
    /// What was found and what was expected.
    pub cause: String,
}

impl fmt::Display for TickError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "node {} ({}): {}", self.node.0, self.name, self.cause)
    }
}

impl std::error::Error for TickError {}

/// Passes of one [`tick_once`]: a tree that wakes itself up again and again is stopped, where the reference hangs.
const MOST_PASSES: u32 = 10_000;

/// Makes one pass from the root and returns the root's status; SKIPPED leaves the root IDLE.
///
/// - `memory` must have been made for `tree` ([`Memory::for_tree`] or [`Memory::fit`]).
/// - `recorder` sees each node that returns.
///
/// # Errors
/// The node's place and the cause; the tree is then halted.
pub fn tick_exactly_once<L, H: Host<L>, R: Recorder>(
    tree: &Tree<L>,
    memory: &mut Memory,
    host: &mut H,
    recorder: &mut R,
) -> Result<Status, TickError> {
    debug_assert_eq!(memory.slots.len(), tree.nodes().len(), "memory of another tree");
    let mut ticking = Ticking { tree, memory, host, recorder, fault: None, broken: None };
    let result = ticking.tick(NodeId(0));
    if let Some(error) = ticking.broken.take().or(ticking.fault.take()) {
        ticking.halt_child(NodeId(0));
        return Err(error);
    }
    let status = result.unwrap_or_default();
    if status.is_completed() {
        ticking.slot(NodeId(0)).status = Status::Idle;
    }
    Ok(status)
}

/// As [`tick_exactly_once`], and again while the root is RUNNING and a wake-up is pending.
///
/// # Errors
/// As [`tick_exactly_once`]; also when the tree wakes itself up without an end.
pub fn tick_once<L, H: Host<L>, R: Recorder>(
    tree: &Tree<L>,
    memory: &mut Memory,
    host: &mut H,
    recorder: &mut R,
) -> Result<Status, TickError> {
    for _ in 0..MOST_PASSES {
        let status = tick_exactly_once(tree, memory, host, recorder)?;
        if status != Status::Running || !std::mem::take(&mut memory.wake_up) {
            return Ok(status);
        }
    }
    let mut ticking = Ticking { tree, memory, host, recorder, fault: None, broken: None };
    ticking.halt_child(NodeId(0));
    ticking.error(NodeId(0), format!("expected an end within {MOST_PASSES} passes of one tick, found none"));
    ticking.broken.map_or(Ok(Status::Running), Err)
}

/// Halts the whole tree: RUNNING leaves are told, every node becomes IDLE.
///
/// # Errors
/// An `_onHalted` script failed; the tree is halted all the same.
pub fn halt_tree<L, H: Host<L>, R: Recorder>(
    tree: &Tree<L>,
    memory: &mut Memory,
    host: &mut H,
    recorder: &mut R,
) -> Result<(), TickError> {
    let mut ticking = Ticking { tree, memory, host, recorder, fault: None, broken: None };
    ticking.halt_child(NodeId(0));
    ticking.reset_children(NodeId(0));
    ticking.fault.map_or(Ok(()), Err)
}

/// Lets `milliseconds` of simulated time pass. A Timeout that comes due halts its child now and fails with the next
/// tick; every timer that comes due raises the wake-up.
///
/// # Errors
/// An `_onHalted` script failed; the time has passed all the same.
pub fn pass_time<L, H: Host<L>, R: Recorder>(
    tree: &Tree<L>,
    memory: &mut Memory,
    host: &mut H,
    recorder: &mut R,
    milliseconds: u64,
) -> Result<(), TickError> {
    let before = memory.now;
    memory.now = memory.now.saturating_add(milliseconds);
    let mut ticking = Ticking { tree, memory, host, recorder, fault: None, broken: None };
    for node in (0..ticking.memory.timers.len() as u32).map(NodeId) {
        if !ticking.memory.timer(node).is_some_and(|due| due > before && due <= ticking.memory.now) {
            continue;
        }
        ticking.memory.wake_up = true;
        if let Kind::Builtin(id) = tree.nodes()[node.index()].kind
            && matches!(tree.builtin(id), Some(Builtin::Timeout { .. }))
            && ticking.memory.status(NodeId(node.0 + 1)) == Status::Running
        {
            ticking.slot(node).count = 1;
            ticking.halt_child(NodeId(node.0 + 1));
        }
    }
    ticking.fault.map_or(Ok(()), Err)
}

/// A tick under way. Control nodes are in `control.rs`, the others in `decorator.rs`.
pub(super) struct Ticking<'a, L, H, R> {
    pub tree: &'a Tree<L>,
    pub memory: &'a mut Memory,
    pub host: &'a mut H,
    pub recorder: &'a mut R,
    /// The first fault of a script that ran at a halt, where no status can carry it.
    pub fault: Option<TickError>,
    /// The error behind a [`Broken`].
    pub broken: Option<TickError>,
}

/// Says that the tick has ended with an error, which lies in [`Ticking::broken`]: a status or this fit in one byte, so
/// that nodes hand their statuses up in a register.
#[derive(Clone, Copy, Debug)]
pub(super) struct Broken;

impl<'a, L, H: Host<L>, R: Recorder> Ticking<'a, L, H, R> {
    pub(super) fn slot(&mut self, node: NodeId) -> &mut Slot {
        &mut self.memory.slots[node.index()]
    }

    pub(super) fn tick(&mut self, node: NodeId) -> Result<Status, Broken> {
        let tree: &'a Tree<L> = self.tree;
        let status = match tree.scripts(node) {
            Some(scripts) => self.tick_with(node, scripts)?,
            None => self.tick_kind(node, &tree.nodes()[node.index()].kind)?,
        };
        self.slot(node).status = if status == Status::Skipped { Status::Idle } else { status };
        if R::RECORDING {
            self.recorder.returned(node, status);
        }
        Ok(status)
    }

    /// A tick between the scripts of the node; apart, so that the ticks of nodes without scripts stay short.
    #[inline(never)]
    fn tick_with(&mut self, node: NodeId, scripts: &'a Scripts) -> Result<Status, Broken> {
        let tree: &'a Tree<L> = self.tree;
        let status = match self.check_before(node, scripts)? {
            Some(status) => status,
            None => self.tick_kind(node, &tree.nodes()[node.index()].kind)?,
        };
        if status.is_completed() {
            let own = if status == Status::Success { &scripts.after[0] } else { &scripts.after[1] };
            for script in [own, &scripts.after[2]].into_iter().flatten() {
                self.run(node, script)?;
            }
        }
        Ok(status)
    }

    /// Part of [`Ticking::tick`]: a call less for each node, which WebAssembly feels more than other machines.
    #[expect(clippy::inline_always, reason = "measured: a quarter more ticks per second in WebAssembly")]
    #[inline(always)]
    fn tick_kind(&mut self, node: NodeId, kind: &'a Kind<L>) -> Result<Status, Broken> {
        if !matches!(kind, Kind::Leaf(_) | Kind::Builtin(_)) && self.slot(node).status != Status::Running {
            let slot = self.slot(node);
            slot.status = Status::Running;
            slot.count = 0;
        }
        match kind {
            Kind::Leaf(leaf) => {
                let mut ports = Ports { rest: self.tree.rest(), memory: self.memory, node };
                match self.host.tick(node, leaf, &mut ports) {
                    Status::Idle => Err(self.error(node, "expected a status from the leaf, found IDLE")),
                    status => Ok(status),
                }
            }
            Kind::Sequence => self.in_order(node, Status::Failure, false, false),
            Kind::Fallback => self.in_order(node, Status::Success, false, false),
            Kind::SequenceWithMemory => self.in_order(node, Status::Failure, true, true),
            Kind::ReactiveSequence => self.reactive(node, Status::Failure),
            Kind::ReactiveFallback => self.reactive(node, Status::Success),
            Kind::Inverter => Ok(match self.only_child(node)? {
                Status::Success => Status::Failure,
                Status::Failure => Status::Success,
                other => other,
            }),
            Kind::ForceSuccess => self.only_child(node).map(|status| forced(status, Status::Success)),
            Kind::ForceFailure => self.only_child(node).map(|status| forced(status, Status::Failure)),
            Kind::Builtin(id) => self.tick_builtin(node, *id),
        }
    }

    /// Pre-conditions, in the order `_failureIf`, `_successIf`, `_skipIf`, `_while`: the status they decide, if any.
    fn check_before(&mut self, node: NodeId, scripts: &Scripts) -> Result<Option<Status>, Broken> {
        let status = self.slot(node).status;
        if status == Status::Idle {
            let decide = [Status::Failure, Status::Success, Status::Skipped];
            for (script, decided) in scripts.before.iter().zip(decide) {
                if let Some(script) = script
                    && self.is_true(node, script)?
                {
                    return Ok(Some(decided));
                }
            }
        }
        if let Some(guard) = &scripts.before[3]
            && matches!(status, Status::Idle | Status::Running)
            && !self.is_true(node, guard)?
        {
            self.halt_child(node);
            return Ok(Some(Status::Skipped));
        }
        Ok(None)
    }

    /// Ticks the only child, and resets it when it completes.
    pub(super) fn only_child(&mut self, node: NodeId) -> Result<Status, Broken> {
        let child = NodeId(node.0 + 1);
        let status = self.tick(child)?;
        if status.is_completed() {
            self.halt_child(child);
        }
        Ok(status)
    }

    pub(super) fn run(&mut self, node: NodeId, script: &BoundScript) -> Result<Value, Broken> {
        self.memory.run(script, node).map_err(|cause| self.error(node, cause))
    }

    /// Whether a script's value is true: a number other than 0, or a text that is not empty.
    pub(super) fn is_true(&mut self, node: NodeId, script: &BoundScript) -> Result<bool, Broken> {
        Ok(match self.run(node, script)? {
            Value::Number(number) => number != 0.0,
            Value::Text(text) => !text.is_empty(),
            Value::Queue(values) => !values.is_empty(),
        })
    }

    /// The number of a port; a text is read as one.
    pub(super) fn number(&mut self, node: NodeId, port: &str, source: &Source) -> Result<f64, Broken> {
        let found = match self.memory.read(source) {
            Some(Value::Number(number)) => return Ok(*number),
            Some(Value::Text(text)) => match text.trim() {
                "true" => return Ok(1.0),
                "false" => return Ok(0.0),
                other => match Value::literal(other) {
                    Value::Number(number) => return Ok(number),
                    _ => format!("the text '{text}'"),
                },
            },
            Some(Value::Queue(_)) => "a queue".to_owned(),
            None => "no value".to_owned(),
        };
        Err(self.error(node, format!("port {port}: expected a number, found {found}")))
    }

    /// Notes why the tick has ended.
    #[cold]
    pub(super) fn error(&mut self, node: NodeId, cause: impl Into<String>) -> Broken {
        let kind = self.tree.kind_name(node);
        let name = self.tree.extra(node).map_or("", |extra| extra.name.as_str());
        let name = if name.is_empty() || name == kind { kind.to_owned() } else { format!("{kind} \"{name}\"") };
        self.broken = Some(TickError { node, name, cause: cause.into() });
        Broken
    }

    /// Keeps an error that no status can carry until the end of the tick; only the first is told.
    pub(super) fn tell_later(&mut self) {
        let error = self.broken.take();
        self.fault = self.fault.take().or(error);
    }

    pub(super) fn reset_children(&mut self, node: NodeId) {
        let tree = self.tree;
        for child in tree.children(node) {
            self.halt_child(child);
        }
    }

    /// Halts `node` if it is RUNNING, children first, and makes it IDLE. A completed node has no live children,
    /// except that SequenceWithMemory keeps its earlier ones done after a failure.
    #[inline]
    pub(super) fn halt_child(&mut self, node: NodeId) {
        if self.slot(node).status == Status::Running {
            self.halt_running(node);
        }
        self.slot(node).status = Status::Idle;
    }

    #[inline(never)]
    fn halt_running(&mut self, node: NodeId) {
        let tree: &'a Tree<L> = self.tree;
        self.halt_kind(node, &tree.nodes()[node.index()].kind);
        if let Some(scripts) = tree.scripts(node)
            && let Some(script) = &scripts.after[3]
            && self.run(node, script).is_err()
        {
            self.tell_later();
        }
        if R::RECORDING {
            self.recorder.halted(node);
        }
    }

    fn halt_kind(&mut self, node: NodeId, kind: &'a Kind<L>) {
        let in_block = self.slot(node).cursor;
        self.reset_children(node);
        match kind {
            Kind::Leaf(leaf) => self.host.halt(node, leaf),
            Kind::SequenceWithMemory => {}
            Kind::Builtin(id) => self.halt_builtin(node, *id, in_block),
            _ => self.slot(node).cursor = 0,
        }
    }
}

fn forced(status: Status, to: Status) -> Status {
    if status.is_completed() { to } else { status }
}
