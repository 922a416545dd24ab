//! The decorators and leaves among the built-in nodes.

use super::builtin::{BoundScript, Builtin, Key, LoopType, Source};
use super::tick::{Broken, Host, Ticking};
use super::tree::BuiltinId;
use super::{NodeId, Recorder, Status, Tree, Value};

impl<'a, L, H: Host<L>, R: Recorder> Ticking<'a, L, H, R> {
    /// Apart from the other kinds, whose ticks stay short without it.
    #[inline(never)]
    pub(super) fn tick_builtin(&mut self, node: NodeId, id: BuiltinId) -> Result<Status, Broken> {
        let tree: &'a Tree<L> = self.tree;
        let Some(builtin) = tree.builtin(id) else { return Err(self.error(node, "expected a node of this tree")) };
        let starts = self.slot(node).status != Status::Running;
        // Decorators that may return without a tick of their child must not count as started then.
        let marks_itself = !matches!(
            builtin,
            Builtin::RunOnce { .. }
                | Builtin::Precondition { .. }
                | Builtin::Loop { .. }
                | Builtin::SkipUnlessUpdated { .. }
                | Builtin::WaitValueUpdate { .. }
                | Builtin::Sleep { .. }
        );
        if marks_itself && starts {
            self.slot(node).status = Status::Running;
            if builtin.arity().1 != Some(1) {
                self.slot(node).count = 0;
            }
        }
        match builtin {
            Builtin::AsyncSequence => self.in_order(node, Status::Failure, true, false),
            Builtin::AsyncFallback => self.in_order(node, Status::Success, true, false),
            Builtin::Parallel { success_count, failure_count } => self.parallel(node, success_count, failure_count),
            Builtin::ParallelAll { max_failures } => self.parallel_all(node, max_failures),
            Builtin::IfThenElse => self.if_then_else(node),
            Builtin::WhileDoElse => self.while_do_else(node),
            Builtin::Switch { variable, cases } => self.switch(node, variable, cases),
            Builtin::TryCatch { .. } => self.try_catch(node),
            Builtin::Repeat { num_cycles } => self.repeat(node, num_cycles),
            Builtin::RetryUntilSuccessful { num_attempts } => self.retry(node, num_attempts),
            Builtin::KeepRunningUntilFailure => Ok(match self.only_child(node)? {
                Status::Failure => Status::Failure,
                _ => Status::Running,
            }),
            Builtin::Delay { delay_msec } => self.delay(node, delay_msec),
            Builtin::Timeout { msec } => self.timeout(node, msec),
            Builtin::RunOnce { then_skip } => self.run_once(node, then_skip),
            Builtin::Precondition { condition, otherwise } => {
                let condition = self.given(node, "if", condition.as_ref())?;
                self.precondition(node, condition, *otherwise)
            }
            Builtin::Loop { of, queue, value, if_empty } => self.pop_loop(node, *of, queue, value, *if_empty),
            Builtin::SkipUnlessUpdated { entry } => self.when_updated(node, *entry, Status::Skipped),
            Builtin::WaitValueUpdate { entry } => self.when_updated(node, *entry, Status::Running),
            Builtin::SubTree => self.only_child(node),
            Builtin::AlwaysSuccess => Ok(Status::Success),
            Builtin::AlwaysFailure => Ok(Status::Failure),
            Builtin::Script { code } => {
                let code = self.given(node, "code", code.as_ref())?;
                self.run(node, code).map(|_| Status::Success)
            }
            Builtin::ScriptCondition { code } => {
                let code = self.given(node, "code", code.as_ref())?;
                self.is_true(node, code).map(Status::completed)
            }
            Builtin::SetBlackboard { output_key, value } => self.set_blackboard(node, output_key, value),
            Builtin::UnsetBlackboard { key } => {
                if let Some(entry) = self.memory.find_key(key) {
                    self.memory.entry_mut(entry).value = None;
                }
                Ok(Status::Success)
            }
            Builtin::Sleep { msec } => self.sleep(node, msec),
            Builtin::WasEntryUpdated { entry } => {
                let writes = self.memory.entry(*entry).writes;
                let exists = self.memory.entry(*entry).value.is_some();
                let seen = std::mem::replace(&mut self.slot(node).cursor, writes);
                Ok(Status::completed(exists && seen != writes))
            }
        }
    }

    /// What halting does besides halting the children. `in_block` is the cursor as it was before.
    pub(super) fn halt_builtin(&mut self, node: NodeId, id: BuiltinId, in_block: u32) {
        let tree: &'a Tree<L> = self.tree;
        let Some(builtin) = tree.builtin(id) else { return };
        match builtin {
            // They remember for ever.
            Builtin::RunOnce { .. } | Builtin::WasEntryUpdated { .. } => {}
            Builtin::SkipUnlessUpdated { .. } | Builtin::WaitValueUpdate { .. } => self.slot(node).count = 0,
            Builtin::TryCatch { catch_on_halt } => {
                self.slot(node).cursor = 0;
                let clean_up = self.tree.children(node).last();
                let in_clean_up = clean_up.is_some_and(|child| child.0 == in_block);
                let wanted = self.number(node, "catch_on_halt", catch_on_halt);
                self.broken = None;
                let wanted = wanted.is_ok_and(|number| number != 0.0);
                if let Some(clean_up) = clean_up.filter(|_| wanted && !in_clean_up) {
                    if self.tick(clean_up).is_err() {
                        self.tell_later();
                    }
                    self.halt_child(clean_up);
                }
            }
            _ => {
                self.memory.stop_timer(node);
                let slot = self.slot(node);
                (slot.cursor, slot.count) = (0, 0);
            }
        }
    }

    /// The script of a mandatory port.
    fn given<'b>(
        &mut self,
        node: NodeId,
        port: &str,
        script: Option<&'b BoundScript>,
    ) -> Result<&'b BoundScript, Broken> {
        script.ok_or_else(|| self.error(node, format!("port {port}: expected a script, found no value")))
    }

    /// Counts successes in the slot.
    fn repeat(&mut self, node: NodeId, num_cycles: &Source) -> Result<Status, Broken> {
        let child = NodeId(node.0 + 1);
        let cycles = self.number(node, "num_cycles", num_cycles)?;
        loop {
            if cycles >= 0.0 && f64::from(self.slot(node).count) >= cycles {
                self.slot(node).count = 0;
                return Ok(Status::Success);
            }
            let was_idle = self.slot(child).status == Status::Idle;
            match self.only_child(node)? {
                Status::Success => {
                    self.slot(node).count += 1;
                    let more = cycles < 0.0 || f64::from(self.slot(node).count) < cycles;
                    if was_idle && more {
                        self.memory.wake_up = true;
                        return Ok(Status::Running);
                    }
                }
                Status::Failure => {
                    self.slot(node).count = 0;
                    return Ok(Status::Failure);
                }
                other => return Ok(other),
            }
        }
    }

    /// Counts failures in the slot; the port is read again after each.
    fn retry(&mut self, node: NodeId, num_attempts: &Source) -> Result<Status, Broken> {
        let child = NodeId(node.0 + 1);
        let mut attempts = self.number(node, "num_attempts", num_attempts)?;
        loop {
            if attempts >= 0.0 && f64::from(self.slot(node).count) >= attempts {
                self.slot(node).count = 0;
                return Ok(Status::Failure);
            }
            let was_idle = self.slot(child).status == Status::Idle;
            match self.only_child(node)? {
                Status::Failure => {
                    self.slot(node).count += 1;
                    attempts = self.number(node, "num_attempts", num_attempts)?;
                    let more = attempts < 0.0 || f64::from(self.slot(node).count) < attempts;
                    if was_idle && more {
                        self.memory.wake_up = true;
                        return Ok(Status::Running);
                    }
                }
                Status::Success => {
                    self.slot(node).count = 0;
                    return Ok(Status::Success);
                }
                other => return Ok(other),
            }
        }
    }

    /// Milliseconds of a port as a point in time from now.
    fn due(&mut self, node: NodeId, port: &str, source: &Source) -> Result<u64, Broken> {
        let milliseconds = self.number(node, port, source)?;
        if milliseconds >= 0.0 {
            return Ok(self.memory.now.saturating_add(milliseconds as u64));
        }
        Err(self.error(node, format!("port {port}: expected milliseconds of at least 0, found {milliseconds}")))
    }

    fn delay(&mut self, node: NodeId, delay_msec: &Source) -> Result<Status, Broken> {
        let due = if let Some(due) = self.memory.timer(node) {
            due
        } else {
            let due = self.due(node, "delay_msec", delay_msec)?;
            self.memory.start_timer(node, due);
            due
        };
        if self.memory.now < due {
            return Ok(Status::Running);
        }
        let status = self.only_child(node)?;
        if status.is_completed() {
            self.memory.stop_timer(node);
        }
        Ok(status)
    }

    /// The slot's count is 1 once the child was halted by the timer.
    fn timeout(&mut self, node: NodeId, msec: &Source) -> Result<Status, Broken> {
        if self.slot(node).cursor == 0 {
            let due = self.due(node, "msec", msec)?;
            let slot = self.slot(node);
            (slot.cursor, slot.count) = (1, 0);
            if due > self.memory.now {
                self.memory.start_timer(node, due);
            }
        }
        if self.slot(node).count == 1 {
            self.end_timeout(node);
            return Ok(Status::Failure);
        }
        let status = self.only_child(node)?;
        if status.is_completed() {
            self.end_timeout(node);
        }
        Ok(status)
    }

    fn end_timeout(&mut self, node: NodeId) {
        self.memory.stop_timer(node);
        let slot = self.slot(node);
        (slot.cursor, slot.count) = (0, 0);
    }

    /// The cursor holds the first result: 1 SUCCESS, 2 FAILURE.
    fn run_once(&mut self, node: NodeId, then_skip: &Source) -> Result<Status, Broken> {
        let skips = self.number(node, "then_skip", then_skip)? != 0.0;
        match self.slot(node).cursor {
            0 => {}
            _ if skips => return Ok(Status::Skipped),
            first => return Ok(Status::completed(first == 1)),
        }
        self.slot(node).status = Status::Running;
        let status = self.only_child(node)?;
        if status.is_completed() {
            self.slot(node).cursor = if status == Status::Success { 1 } else { 2 };
        }
        Ok(status)
    }

    fn precondition(&mut self, node: NodeId, condition: &BoundScript, otherwise: Status) -> Result<Status, Broken> {
        let continues = self.memory.status(NodeId(node.0 + 1)) == Status::Running;
        if !continues && !self.is_true(node, condition)? {
            return Ok(otherwise);
        }
        self.slot(node).status = Status::Running;
        self.only_child(node)
    }

    /// One value for each run of the child. The cursor counts the values taken from a literal queue.
    fn pop_loop(
        &mut self,
        node: NodeId,
        of: LoopType,
        queue: &Source,
        value: &Source,
        if_empty: Status,
    ) -> Result<Status, Broken> {
        if self.slot(node).status != Status::Running {
            self.slot(node).cursor = 0;
        }
        if self.memory.status(NodeId(node.0 + 1)) != Status::Running {
            let Some(next) = self.pop(node, of, queue)? else { return Ok(if_empty) };
            if let Source::Entry(entry) = value {
                let written = self.memory.entry_mut(*entry).write(next, Some(node));
                written.map_err(|cause| self.error(node, format!("port value: {cause}")))?;
            }
        }
        self.slot(node).status = Status::Running;
        Ok(if self.only_child(node)? == Status::Failure { Status::Failure } else { Status::Running })
    }

    fn pop(&mut self, node: NodeId, of: LoopType, queue: &Source) -> Result<Option<Value>, Broken> {
        let mut values = match self.memory.read(queue) {
            None => return Ok(None),
            Some(Value::Queue(values)) => values.clone(),
            Some(Value::Number(number)) => vec![Value::Number(*number)],
            Some(Value::Text(text)) if text.is_empty() => return Ok(None),
            Some(Value::Text(text)) => text.split(';').map(|item| Value::Text(item.to_owned())).collect(),
        };
        let place = if matches!(queue, Source::Entry(_)) { 0 } else { self.slot(node).cursor as usize };
        if place >= values.len() {
            return Ok(None);
        }
        let next = values.remove(place);
        if let Source::Entry(entry) = queue {
            // The queue changes its form with the first pop: from a text to values.
            let entry = self.memory.entry_mut(*entry);
            entry.value = Some(Value::Queue(values));
            entry.writer = Some(node);
        } else {
            self.slot(node).cursor += 1;
        }
        let typed = match (of, next) {
            (LoopType::String, value) => Some(Value::Text(value.to_string())),
            (LoopType::Bool, Value::Text(text)) if text == "true" => Some(Value::Number(1.0)),
            (LoopType::Bool, Value::Text(text)) if text == "false" => Some(Value::Number(0.0)),
            (_, Value::Text(text)) => Some(Value::literal(&text)).filter(|value| matches!(value, Value::Number(_))),
            (_, value) => Some(value),
        };
        match typed {
            Some(value) => Ok(Some(value)),
            None => Err(self.error(node, "port queue: expected numbers, found a text")),
        }
    }

    /// The cursor holds the writes seen; the count is 1 while the child is RUNNING.
    fn when_updated(
        &mut self,
        node: NodeId,
        entry: super::blackboard::EntryId,
        otherwise: Status,
    ) -> Result<Status, Broken> {
        if self.slot(node).count == 0 {
            let writes = self.memory.entry(entry).writes;
            let exists = self.memory.entry(entry).value.is_some();
            if !exists || std::mem::replace(&mut self.slot(node).cursor, writes) == writes {
                return Ok(otherwise);
            }
        }
        self.slot(node).status = Status::Running;
        let status = self.only_child(node)?;
        self.slot(node).count = u32::from(status == Status::Running);
        Ok(status)
    }

    fn sleep(&mut self, node: NodeId, msec: &Source) -> Result<Status, Broken> {
        let due = match self.memory.timer(node) {
            Some(due) => due,
            None => self.due(node, "msec", msec)?,
        };
        if self.memory.now < due {
            self.memory.start_timer(node, due);
            return Ok(Status::Running);
        }
        self.memory.stop_timer(node);
        Ok(Status::Success)
    }

    /// Writes a literal as text, or copies an entry with its type; an empty source fails.
    fn set_blackboard(&mut self, node: NodeId, output_key: &Key, value: &Source) -> Result<Status, Broken> {
        let copied = match value {
            Source::Literal(literal) => Some(Value::Text(literal.to_string())),
            other => self.memory.read(other).cloned(),
        };
        let Some(copied) = copied else { return Ok(Status::Failure) };
        let Some(entry) = self.memory.find_key(output_key) else {
            return Err(self.error(node, "port output_key: expected the name of an entry, found no value"));
        };
        let written = self.memory.entry_mut(entry).write(copied, Some(node));
        written.map_err(|cause| self.error(node, format!("port output_key: {cause}")))?;
        Ok(Status::Success)
    }
}
