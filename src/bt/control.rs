//! The control nodes.

use super::tick::{Broken, Host, Ticking};
use super::{NodeId, Recorder, Source, Status, Value};

impl<L, H: Host<L>, R: Recorder> Ticking<'_, L, H, R> {
    /// Sequence (`decisive` FAILURE) and Fallback (`decisive` SUCCESS), mirror images of each other, and their forms:
    ///
    /// - `yields`: the control is given back after a child that was done at once.
    /// - `keeps_place`: a decisive child is where the next start goes on; the children before it stay done.
    pub(super) fn in_order(
        &mut self,
        node: NodeId,
        decisive: Status,
        yields: bool,
        keeps_place: bool,
    ) -> Result<Status, Broken> {
        let end = self.tree.nodes()[node.index()].end;
        let mut child = self.resume(node);
        while child.0 < end {
            let was_idle = self.slot(child).status == Status::Idle;
            let status = self.tick(child)?;
            let next = self.next_sibling(child);
            match status {
                Status::Running => {
                    self.slot(node).cursor = child.0;
                    return Ok(Status::Running);
                }
                Status::Skipped => self.slot(node).count += 1,
                Status::Success | Status::Failure if status == decisive && keeps_place => {
                    self.slot(node).cursor = child.0;
                    while child.0 < end {
                        self.halt_child(child);
                        child = self.next_sibling(child);
                    }
                    return Ok(decisive);
                }
                Status::Success | Status::Failure if status == decisive => {
                    self.slot(node).cursor = 0;
                    self.reset_children(node);
                    return Ok(decisive);
                }
                Status::Success | Status::Failure => {
                    if yields && was_idle && next.0 < end {
                        self.slot(node).cursor = next.0;
                        self.memory.wake_up = true;
                        return Ok(Status::Running);
                    }
                }
                Status::Idle => debug_assert!(false, "no node returns IDLE"),
            }
            child = next;
        }
        self.slot(node).cursor = 0;
        Ok(self.end_of_list(node, decisive))
    }

    pub(super) fn reactive(&mut self, node: NodeId, decisive: Status) -> Result<Status, Broken> {
        let tree = self.tree;
        let mut all_skipped = true;
        for child in tree.children(node) {
            let status = self.tick(child)?;
            all_skipped &= status == Status::Skipped;
            match status {
                Status::Running => {
                    for other in tree.children(node).filter(|&other| other != child) {
                        self.halt_child(other);
                    }
                    return Ok(Status::Running);
                }
                Status::Skipped => self.halt_child(child),
                Status::Success | Status::Failure => {
                    if status == decisive {
                        self.reset_children(node);
                        return Ok(decisive);
                    }
                }
                Status::Idle => debug_assert!(false, "no node returns IDLE"),
            }
        }
        self.reset_children(node);
        Ok(if all_skipped { Status::Skipped } else { opposite(decisive) })
    }

    /// Ticks what has not completed and compares after each child. The slot counts successes (`count`) and failures
    /// (`cursor`).
    pub(super) fn parallel(&mut self, node: NodeId, success: &Source, failure: &Source) -> Result<Status, Broken> {
        let tree = self.tree;
        let children = tree.children(node).count() as u32;
        let positive = self.number(node, "success_count", success)? >= 0.0;
        let wanted = self.threshold(node, "success_count", success, children)?;
        let fatal = self.threshold(node, "failure_count", failure, children)?;
        let mut skipped = 0;
        for child in tree.children(node) {
            if !self.slot(child).status.is_completed() {
                match self.tick(child)? {
                    Status::Success => self.slot(node).count += 1,
                    Status::Failure => self.slot(node).cursor += 1,
                    Status::Skipped => skipped += 1,
                    Status::Running => {}
                    Status::Idle => debug_assert!(false, "no node returns IDLE"),
                }
            }
            let slot = *self.slot(node);
            let (successes, failures) = (slot.count, slot.cursor);
            let verdict = if successes >= wanted || (!positive && successes + skipped >= wanted) {
                Some(Status::Success)
            } else if children - failures < wanted || failures == fatal {
                Some(Status::Failure)
            } else {
                None
            };
            if let Some(status) = verdict {
                return Ok(self.end(node, status));
            }
        }
        Ok(if skipped == children { Status::Skipped } else { Status::Running })
    }

    fn threshold(&mut self, node: NodeId, port: &str, source: &Source, children: u32) -> Result<u32, Broken> {
        let given = self.number(node, port, source)?;
        let wanted = if given < 0.0 { (f64::from(children) + 1.0 + given).max(0.0) } else { given };
        if wanted <= f64::from(children) {
            return Ok(wanted as u32);
        }
        let cause = format!("port {port}: expected at most {children}, the number of children, found {given}");
        Err(self.error(node, cause))
    }

    /// Waits for all children, then counts. The slot counts failures.
    pub(super) fn parallel_all(&mut self, node: NodeId, max_failures: &Source) -> Result<Status, Broken> {
        let tree = self.tree;
        let children = tree.children(node).count() as u32;
        let given = self.number(node, "max_failures", max_failures)?;
        let most = if given < 0.0 { (f64::from(children) + 1.0 + given).max(0.0) } else { given };
        let (mut skipped, mut waiting) = (0, false);
        for child in tree.children(node) {
            if self.slot(child).status.is_completed() {
                continue;
            }
            match self.tick(child)? {
                Status::Failure => self.slot(node).count += 1,
                Status::Skipped => skipped += 1,
                Status::Running => waiting = true,
                Status::Success => {}
                Status::Idle => debug_assert!(false, "no node returns IDLE"),
            }
        }
        if skipped == children {
            return Ok(Status::Skipped);
        }
        if waiting {
            return Ok(Status::Running);
        }
        let failed = f64::from(self.slot(node).count) >= most;
        Ok(self.end(node, Status::completed(!failed)))
    }

    /// The cursor holds the branch that was chosen.
    pub(super) fn if_then_else(&mut self, node: NodeId) -> Result<Status, Broken> {
        let (condition, then, otherwise) = self.branches(node)?;
        if self.slot(node).cursor == 0 {
            match self.tick(condition)? {
                Status::Running => return Ok(Status::Running),
                Status::Success => self.slot(node).cursor = then.0,
                Status::Failure => match otherwise {
                    Some(otherwise) => self.slot(node).cursor = otherwise.0,
                    None => return Ok(self.end(node, Status::Failure)),
                },
                _ => return Err(self.error(node, "expected a status from the condition, found SKIPPED")),
            }
        }
        let branch = NodeId(self.slot(node).cursor);
        match self.tick(branch)? {
            Status::Running => Ok(Status::Running),
            status => Ok(self.end(node, status)),
        }
    }

    pub(super) fn while_do_else(&mut self, node: NodeId) -> Result<Status, Broken> {
        let (condition, then, otherwise) = self.branches(node)?;
        let (chosen, other) = match self.tick(condition)? {
            Status::Running => return Ok(Status::Running),
            Status::Success => (Some(then), otherwise),
            Status::Failure => (otherwise, Some(then)),
            _ => return Err(self.error(node, "expected a status from the condition, found SKIPPED")),
        };
        if let Some(other) = other {
            self.halt_child(other);
        }
        let status = match chosen {
            Some(branch) => self.tick(branch)?,
            None => Status::Failure,
        };
        Ok(if status == Status::Running { status } else { self.end(node, status) })
    }

    /// The condition, the branch for its SUCCESS and the one for its FAILURE.
    fn branches(&mut self, node: NodeId) -> Result<(NodeId, NodeId, Option<NodeId>), Broken> {
        let mut children = self.tree.children(node);
        if let [Some(condition), Some(then), otherwise, None] = std::array::from_fn(|_| children.next()) {
            return Ok((condition, then, otherwise));
        }
        let found = self.tree.children(node).count();
        Err(self.error(node, format!("expected 2 or 3 children, found {found}")))
    }

    /// The first case that equals the variable selects its child, otherwise the last child. The cursor holds the
    /// child that is RUNNING.
    pub(super) fn switch(&mut self, node: NodeId, variable: &Source, cases: &[Source]) -> Result<Status, Broken> {
        let found = self.tree.children(node).count();
        if found != cases.len() + 1 {
            let cause =
                format!("expected {} children, one for each case and a last one, found {found}", cases.len() + 1);
            return Err(self.error(node, cause));
        }
        let wanted = self.memory.read(variable);
        let chosen = wanted.and_then(|wanted| {
            cases.iter().position(|case| self.memory.read(case).is_some_and(|case| are_equal(wanted, case)))
        });
        let place = chosen.unwrap_or(cases.len());
        let Some(child) = self.tree.children(node).nth(place) else { return Ok(Status::Failure) };
        let running = self.slot(node).cursor;
        if running != 0 && running != child.0 {
            self.halt_child(NodeId(running));
        }
        match self.tick(child)? {
            Status::Running => {
                self.slot(node).cursor = child.0;
                Ok(Status::Running)
            }
            status => Ok(self.end(node, status)),
        }
    }

    /// All but the last child are a Sequence; when it fails, the last one cleans up and the node fails.
    pub(super) fn try_catch(&mut self, node: NodeId) -> Result<Status, Broken> {
        let Some(clean_up) = self.tree.children(node).last() else { return Ok(Status::Failure) };
        let mut child = self.resume(node);
        while child != clean_up {
            match self.tick(child)? {
                Status::Running => {
                    self.slot(node).cursor = child.0;
                    return Ok(Status::Running);
                }
                Status::Failure => {
                    self.reset_children(node);
                    self.slot(node).cursor = clean_up.0;
                    return self.clean_up(node, clean_up);
                }
                Status::Skipped => self.slot(node).count += 1,
                Status::Success => {}
                Status::Idle => debug_assert!(false, "no node returns IDLE"),
            }
            child = self.next_sibling(child);
            if child == clean_up {
                let all_skipped = self.slot(node).count as usize + 1 == self.tree.children(node).count();
                return Ok(self.end(node, if all_skipped { Status::Skipped } else { Status::Success }));
            }
        }
        self.clean_up(node, clean_up)
    }

    fn clean_up(&mut self, node: NodeId, clean_up: NodeId) -> Result<Status, Broken> {
        match self.tick(clean_up)? {
            Status::Running => Ok(Status::Running),
            _ => Ok(self.end(node, Status::Failure)),
        }
    }

    /// The child to continue with.
    fn resume(&mut self, node: NodeId) -> NodeId {
        match self.slot(node).cursor {
            0 => NodeId(node.0 + 1),
            child => NodeId(child),
        }
    }

    fn next_sibling(&self, child: NodeId) -> NodeId {
        NodeId(self.tree.nodes()[child.index()].end)
    }

    /// Ends a node with `status`: its children are reset, its own numbers start afresh.
    fn end(&mut self, node: NodeId, status: Status) -> Status {
        self.reset_children(node);
        let slot = self.slot(node);
        (slot.cursor, slot.count) = (0, 0);
        status
    }

    /// No child was decisive: the opposite status, or SKIPPED when every child was skipped.
    fn end_of_list(&mut self, node: NodeId, decisive: Status) -> Status {
        let tree = self.tree;
        let skipped = self.slot(node).count;
        self.reset_children(node);
        if skipped > 0 && skipped as usize == tree.children(node).count() {
            return Status::Skipped;
        }
        opposite(decisive)
    }
}

fn opposite(decisive: Status) -> Status {
    if decisive == Status::Success { Status::Failure } else { Status::Success }
}

/// Equality of Switch: the same text, or numbers that differ by less than 1.2e-7.
fn are_equal(a: &Value, b: &Value) -> bool {
    let number = |value: &Value| match value {
        Value::Number(number) => Some(*number),
        Value::Text(text) => match Value::literal(text) {
            Value::Number(number) => Some(number),
            _ => None,
        },
        Value::Queue(_) => None,
    };
    match (a, b) {
        (Value::Text(a), Value::Text(b)) if a == b => true,
        _ => number(a).zip(number(b)).is_some_and(|(a, b)| (a - b).abs() < 1.2e-7),
    }
}
