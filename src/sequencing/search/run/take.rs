//! What is simulated next: entries are taken from the queue, and become slots of a batch.

use super::super::queue::{Entry, Heap, NONE};
use super::super::{Method, Outcome, Slot};
use super::Search;
use crate::sequencing::estimate::Stand;

impl Search {
    /// Takes entries from the queue until a batch is full, or ends the search.
    pub(super) fn collect(&mut self) {
        (self.filled, self.done) = (0, 0);
        let mut taken = 0;
        while taken < self.options.batch {
            let waiting = self.filled > 0;
            let Some(least) = self.queue.least(Heap::Anchor) else {
                if !waiting {
                    self.outcome = Some(self.exhausted());
                }
                return;
            };
            let (heap, limit) = match self.options.method {
                Method::MultiHeuristic { second, .. } => {
                    let limit = second * least;
                    let key = self.queue.least(Heap::Second).unwrap_or(f64::INFINITY);
                    (if key <= limit && key < self.best_cost { Heap::Second } else { Heap::Anchor }, limit)
                }
                Method::BothSides => self.turn(least),
                Method::Literal | Method::Exact | Method::Anytime | Method::Approximate(_) => (Heap::Anchor, least),
            };
            if self.best_cost <= limit {
                if !waiting && !self.lower_weight() {
                    self.outcome = Some(Outcome::Solved);
                }
                if waiting || self.outcome.is_some() {
                    return;
                }
                continue;
            }
            if !waiting {
                self.outcome = self.limit().map(Outcome::GaveUp);
                if self.outcome.is_some() {
                    return;
                }
            }
            let Some(entry) = self.queue.pop(heap) else { return };
            if self.take(entry) {
                taken += 1;
                self.taken += 1;
            }
        }
    }

    /// Whose turn it is in [`Method::BothSides`], and what the best plan may cost at most for the search to end.
    ///
    /// - `least`: the smallest key of the anchor, at the weight at work. Where no key promises anything better than the best
    ///   plan, the next weight comes to work.
    fn turn(&mut self, mut least: f64) -> (Heap, f64) {
        let bound = self.queue.least(Heap::Bound).unwrap_or(f64::INFINITY);
        while least >= self.best_cost
            && let Some(next) = self.weights.pop()
        {
            self.weight = next;
            self.queue.set_weight(next);
            least = self.queue.least(Heap::Anchor).unwrap_or(f64::INFINITY);
        }
        let key = self.queue.least(Heap::Second).unwrap_or(f64::INFINITY);
        let heap = match self.taken % 3 {
            1 if least < self.best_cost => Heap::Anchor,
            2 if key < self.best_cost => Heap::Second,
            _ => Heap::Bound,
        };
        (heap, self.options.weight * bound)
    }

    /// Expands an entry or fills slots for it; returns whether slots were filled.
    fn take(&mut self, entry: Entry) -> bool {
        let literal = self.options.method == Method::Literal;
        if entry.behaviour != NONE {
            if entry.bound >= self.best_cost {
                return false;
            }
            self.fill(entry.node, entry.behaviour, entry.bound);
            return true;
        }
        let node = *self.nodes.get(entry.node);
        if node.depth == self.task.decisions() {
            // Only Algorithm 1 keeps complete sequences in the queue: its lines 11 to 14.
            let state = self.nodes.state(entry.node);
            if self.task.is_goal(state, node.visited) {
                self.offer(entry.node, None);
            } else {
                self.counts.missed += 1;
            }
            return false;
        }
        if !literal && entry.bound >= self.best_cost {
            return false;
        }
        self.counts.expanded += 1;
        let eager = self.options.eager || literal;
        for at in 0..self.tried.len() {
            let next = self.tried[at];
            let bound = node.cost + self.estimate.through(&self.task, node.rest, node.past, next);
            if eager {
                self.fill(entry.node, next, bound);
            } else if bound < self.best_cost {
                let (state, marks) = (self.nodes.state(entry.node), self.nodes.marks(entry.node));
                let from = Stand { state, marks, visited: node.visited, past: node.past, rest: node.rest };
                let second = matches!(self.options.method, Method::MultiHeuristic { .. } | Method::BothSides);
                let guess = self.estimate.guess(&self.task, &from, next, second, &mut self.room);
                let numbers = [node.cost + guess.cost, guess.rest, bound, guess.second];
                self.queue.push(Entry::new(entry.node, next, node.depth + 1, numbers));
            }
        }
        eager
    }

    fn fill(&mut self, node: u32, behaviour: u8, bound: f64) {
        if self.filled == self.slots.len() {
            self.slots.push(Slot::new(&self.task));
        }
        let slot = &mut self.slots[self.filled];
        (slot.node, slot.behaviour, slot.bound) = (node, behaviour, bound);
        slot.state.copy_from_slice(self.nodes.state(node));
        slot.marks.copy_from_slice(self.nodes.marks(node));
        self.filled += 1;
    }
}
