//! The search itself, which can be driven in slices.

mod report;
mod take;

use super::super::costs::Past;
use super::super::dynamics::Kernel;
use super::super::estimate::{self, Estimate, Room};
use super::super::tasks::{Collision, Task};
use super::nodes::{Node, Nodes};
use super::queue::{Entry, NONE, Queue, Sides};
use super::{Counts, Limit, Method, Options, Outcome, Plan, Progress, Slot, WEIGHTS};
use crate::fingerprint::Fingerprint;
use report::Fate;
use std::collections::BTreeMap;

/// A search on its way.
#[derive(Clone, Debug)]
pub struct Search {
    task: Task,
    options: Options,
    estimate: Estimate,
    /// Behaviours that were fixed beforehand; the search begins after them.
    prefix: Vec<u8>,
    /// The behaviours it extends sequences by.
    tried: Vec<u8>,
    nodes: Nodes,
    queue: Queue,
    /// Weights still to come, the next one last.
    weights: Vec<f64>,
    weight: f64,
    proven_weight: f64,
    best: Option<Plan>,
    /// Of the best plan; infinite without one.
    best_cost: f64,
    slots: Vec<Slot>,
    /// Slots in use, and those of them that were worked off.
    filled: usize,
    done: usize,
    counts: Counts,
    outcome: Option<Outcome>,
    /// Cost and depth of the cheapest state of each rounded kind.
    alike: BTreeMap<u64, (f64, u16)>,
    /// Entries taken so far, by which [`Method::BothSides`] takes turns.
    taken: u64,
    room: Room,
    drawn: Vec<f32>,
}

impl Search {
    /// Begins a search.
    ///
    /// - `prefix`: behaviours to begin with, indices of the library; at most as many as there are decision points.
    ///
    /// # Errors
    /// Carrying out the prefix ends in this collision, in its interval of this number from 0.
    pub fn new(task: &Task, options: Options, prefix: &[u8]) -> Result<Self, (u32, Collision)> {
        let prefix = &prefix[..prefix.len().min(usize::from(task.decisions()))];
        let literal = options.method == Method::Literal;
        let stop_last = task.stop().is_some() && !literal && options.costs.stop_last_is_exact();
        let tried = (0..task.library().len() as u8).filter(|&at| !stop_last || task.stop() != Some(at)).collect();
        let mut weights: Vec<f64> = match options.method {
            Method::Anytime => WEIGHTS.into_iter().filter(|weight| *weight > options.weight).collect(),
            Method::BothSides => WEIGHTS[..WEIGHTS.len() - 1].to_vec(),
            Method::Literal | Method::Exact | Method::MultiHeuristic { .. } | Method::Approximate(_) => Vec::new(),
        };
        weights.push(match options.method {
            Method::MultiHeuristic { anchor, .. } => anchor,
            Method::BothSides => 1.0,
            Method::Literal | Method::Exact | Method::Anytime | Method::Approximate(_) => options.weight,
        });
        weights.reverse();
        let weight = weights.pop().unwrap_or(options.weight);
        let sides = match options.method {
            Method::MultiHeuristic { .. } => Sides { second: true, bound: false },
            Method::BothSides => Sides { second: true, bound: true },
            Method::Literal | Method::Exact | Method::Anytime | Method::Approximate(_) => Sides::default(),
        };
        let mut search = Self {
            estimate: Estimate::new(task, options.costs, options.geodesic && !literal, options.forecast),
            tried,
            nodes: Nodes::new(3 * task.robots(), task.words()),
            queue: Queue::new(weight, sides, literal),
            weights,
            weight,
            proven_weight: f64::INFINITY,
            best: None,
            best_cost: f64::INFINITY,
            slots: Vec::new(),
            filled: 0,
            done: 0,
            counts: Counts::default(),
            outcome: None,
            alike: BTreeMap::new(),
            taken: 0,
            room: Room::new(task),
            drawn: Vec::new(),
            prefix: prefix.to_vec(),
            options,
            task: task.clone(),
        };
        search.plant()?;
        Ok(search)
    }

    /// Puts the state after the prefix into the queue.
    fn plant(&mut self) -> Result<(), (u32, Collision)> {
        let task = &self.task;
        let mut kernel = Kernel::new(task.robots());
        let mut state = task.start().to_vec();
        let mut marks = vec![0; task.words()];
        let mut visited = task.mark_start(&state, &mut marks);
        let (mut cost, mut past) = (0.0, Past::default());
        for (at, &next) in self.prefix.iter().enumerate() {
            let acted = task.act(next, &mut state, &mut marks, &mut kernel);
            let (path, new) = acted.map_err(|collision| (at as u32, collision))?;
            let is_stop = task.stop() == Some(next);
            cost += path + self.options.costs.charge(past, next, is_stop, task.interval());
            past = past.then(next, is_stop);
            visited += new;
        }
        let depth = self.prefix.len() as u16;
        let rest = self.estimate.rest(task, &state, visited);
        let is_goal = task.is_goal(&state, visited);
        let node = Node { cost, rest: rest.bound, parent: 0, visited, depth, behaviour: NONE, past };
        let second = estimate::second(task, &state, visited);
        let number = self.nodes.push(node, &state, &marks);
        let closed = is_goal && self.options.method != Method::Literal && self.offer(number, None);
        let late = self.is_late(rest.gap, depth) || (depth == self.task.decisions() && !is_goal);
        if !closed && !late {
            self.queue.push(Entry::new(number, NONE, depth, [cost, rest.bound, cost + rest.bound, second]));
        }
        Ok(())
    }

    /// Whether somebody is too far away to arrive in time, `depth` intervals having passed.
    fn is_late(&self, gap: f64, depth: u16) -> bool {
        let left = f64::from(self.task.decisions() - depth);
        self.options.method != Method::Literal && gap > self.task.reach() * left + 1e-9
    }

    /// Takes note of a plan: the sequence of a node, one more behaviour, and Stops to the end. Returns whether nothing
    /// cheaper can come from there.
    fn offer(&mut self, node: u32, last: Option<(u8, f64, Past)>) -> bool {
        let from = self.nodes.get(node);
        let (depth, cost, past) =
            last.map_or((from.depth, from.cost, from.past), |(_, cost, past)| (from.depth + 1, cost, past));
        let missing = usize::from(self.task.decisions() - depth);
        let closing = match (missing, self.task.stop()) {
            (0, _) => 0.0,
            (_, Some(_)) => self.options.costs.closing(past),
            // Without a Stop the goal must hold at the end.
            (_, None) => return false,
        };
        if cost + closing < self.best_cost {
            let mut sequence = Vec::with_capacity(usize::from(self.task.decisions()));
            sequence.extend_from_slice(&self.prefix);
            self.nodes.sequence(node, &mut sequence);
            sequence.extend(last.map(|(behaviour, ..)| behaviour));
            sequence.extend(self.task.stop().into_iter().flat_map(|stop| std::iter::repeat_n(stop, missing)));
            self.best_cost = cost + closing;
            self.best = Some(Plan { sequence, cost: self.best_cost });
        }
        // Filling the horizon without a Stop may avoid a charge for closing.
        closing == 0.0
    }

    /// Goes on for up to `budget` integrations; returns where it stands.
    pub fn advance(&mut self, budget: u64) -> Progress {
        let mut left = budget;
        while self.prepare() {
            while self.done < self.filled {
                if left == 0 {
                    return self.progress();
                }
                self.slots[self.done].integrate(&self.task);
                self.done += 1;
                left -= 1;
            }
            self.apply_all();
        }
        self.progress()
    }

    /// Fills slots unless some are waiting; returns whether there is something to integrate, otherwise the search has ended.
    fn prepare(&mut self) -> bool {
        if self.outcome.is_none() && self.done == self.filled {
            self.collect();
        }
        self.outcome.is_none()
    }

    /// As [`Search::advance`] with the integrations made by `work`, for example on several threads; `budget` is exceeded
    /// by less than one batch.
    ///
    /// - `work`: calls [`Slot::integrate`] once on each slot, in any order.
    pub fn advance_with(&mut self, budget: u64, work: &mut dyn FnMut(&Task, &mut [Slot])) -> Progress {
        let mut left = budget;
        while left > 0 && self.prepare() {
            let slots = &mut self.slots[self.done..self.filled];
            left = left.saturating_sub(slots.len() as u64);
            work(&self.task, slots);
            self.done = self.filled;
            self.apply_all();
        }
        self.progress()
    }

    /// As [`Search::advance`] with the integrations of each batch made on all threads of the present pool of rayon; the
    /// result is the same for any number of them. `budget` is exceeded by less than one batch.
    #[cfg(feature = "cli")]
    pub fn advance_on_threads(&mut self, budget: u64) -> Progress {
        use rayon::iter::{IntoParallelRefMutIterator, ParallelIterator};
        self.advance_with(budget, &mut |task, slots| slots.par_iter_mut().for_each(|slot| slot.integrate(task)))
    }

    /// Stops the search; its best plan and its bound stay.
    pub fn cancel(&mut self) {
        self.outcome.get_or_insert(Outcome::Cancelled);
    }

    /// Lets a search that gave up at its integrations or its memory, or was stopped, go on with more; it is then the search
    /// that would have had as much from the start. One that ended otherwise stays ended.
    ///
    /// - `integrations`, `bytes`: what is added to the limits.
    pub fn extend(&mut self, integrations: u64, bytes: usize) {
        match self.outcome {
            Some(Outcome::GaveUp(Limit::Integrations | Limit::Memory) | Outcome::Cancelled) => {
                self.options.integrations = self.options.integrations.saturating_add(integrations);
                self.options.bytes = self.options.bytes.saturating_add(bytes);
                self.outcome = None;
            }
            Some(Outcome::GaveUp(Limit::Nodes | Limit::Rounding) | Outcome::Solved | Outcome::Infeasible) | None => {}
        }
    }

    fn apply_all(&mut self) {
        // Taken out for the time, so that the rest of the search can be changed.
        let slots = std::mem::take(&mut self.slots);
        for slot in &slots[..self.filled] {
            self.apply(slot);
        }
        self.slots = slots;
        (self.filled, self.done) = (0, 0);
    }

    /// Takes in what came of an integration.
    fn apply(&mut self, slot: &Slot) {
        let parent = *self.nodes.get(slot.node);
        let is_stop = self.task.stop() == Some(slot.behaviour);
        self.counts.integrated += u64::from(!is_stop);
        let Ok((path, new)) = slot.result else {
            self.counts.collided += 1;
            self.draw(slot, f64::INFINITY, Fate::Collided);
            return;
        };
        let task = &self.task;
        let literal = self.options.method == Method::Literal;
        let charge = self.options.costs.charge(parent.past, slot.behaviour, is_stop, task.interval());
        let cost = parent.cost + (path + charge);
        let past = parent.past.then(slot.behaviour, is_stop);
        let depth = parent.depth + 1;
        let visited = parent.visited + new;
        let rest = self.estimate.rest(task, &slot.state, visited);
        let second = estimate::second(task, &slot.state, visited);
        let mut entry = Entry::new(0, NONE, depth, [cost, rest.bound, cost + rest.bound, second]);
        let key = entry.key(self.weight);
        let fate = if literal {
            if key < self.best_cost { Fate::Open } else { Fate::Dropped }
        } else {
            let is_goal = task.is_goal(&slot.state, visited);
            let closed = is_goal && self.offer(slot.node, Some((slot.behaviour, cost, past)));
            if closed {
                Fate::Goal
            } else if depth == self.task.decisions() {
                self.counts.missed += u64::from(!is_goal);
                Fate::Dropped
            } else if self.is_late(rest.gap, depth) {
                self.counts.late += 1;
                Fate::Dropped
            } else if entry.bound >= self.best_cost || self.is_known(slot, cost, depth, visited, past) {
                Fate::Dropped
            } else {
                Fate::Open
            }
        };
        self.draw(slot, key, fate);
        if let Fate::Open = fate {
            let node =
                Node { cost, rest: rest.bound, parent: slot.node, visited, depth, behaviour: slot.behaviour, past };
            entry.node = self.nodes.push(node, &slot.state, &slot.marks);
            self.queue.push(entry);
        }
    }

    /// Whether a state as good was seen in the same rounded places; only for [`Method::Approximate`].
    fn is_known(&mut self, slot: &Slot, cost: f64, depth: u16, visited: u32, past: Past) -> bool {
        let Method::Approximate(rounding) = self.options.method else { return false };
        let mut hash = Fingerprint::default();
        for place in &slot.state[..2 * self.task.robots()] {
            hash.f64(libm::floor(place / rounding + 0.5));
        }
        hash.u32(visited);
        if self.options.costs.depend_on_the_last() {
            hash.u32(u32::from(past.moving.unwrap_or(NONE)));
        }
        let hash = hash.finish();
        if self.alike.get(&hash).is_some_and(|(known, at)| *known <= cost && *at <= depth) {
            self.counts.alike += 1;
            return true;
        }
        self.alike.insert(hash, (cost, depth));
        false
    }

    /// The next weight, when there is one; returns whether there was.
    fn lower_weight(&mut self) -> bool {
        self.proven_weight = match self.options.method {
            Method::MultiHeuristic { anchor, second } => anchor * second,
            Method::BothSides => {
                self.proven_weight = self.options.weight;
                return false;
            }
            Method::Literal | Method::Exact | Method::Anytime | Method::Approximate(_) => self.weight,
        };
        let Some(next) = self.weights.pop() else { return false };
        self.weight = next;
        self.queue.set_weight(next);
        true
    }

    /// What an empty queue means.
    fn exhausted(&mut self) -> Outcome {
        let approximate = matches!(self.options.method, Method::Approximate(_));
        match (&self.best, approximate) {
            (Some(_), _) => {
                // Literally the key is what discards, so the weight is all that is proven.
                self.proven_weight = if self.options.method == Method::Literal { self.weight } else { 1.0 };
                Outcome::Solved
            }
            (None, true) => Outcome::GaveUp(Limit::Rounding),
            (None, false) => Outcome::Infeasible,
        }
    }

    fn limit(&self) -> Option<Limit> {
        if self.counts.integrated >= self.options.integrations {
            Some(Limit::Integrations)
        } else if self.nodes.len() >= self.options.nodes as usize {
            Some(Limit::Nodes)
        } else if self.bytes() >= self.options.bytes {
            Some(Limit::Memory)
        } else {
            None
        }
    }
}
