//! What a search says of itself: numbers, bounds, and rows for drawing.

use super::super::{Method, Options, Plan, Progress, Slot};
use super::Search;
use crate::sequencing::tasks::Task;

/// Reals of one row of [`Search::drawn`].
const ROW: usize = 6;
/// The most rows kept for drawing.
const MOST_ROWS: usize = 1 << 16;

/// What became of an integration, as the last real of its row.
#[derive(Clone, Copy)]
pub enum Fate {
    /// It waits to be extended.
    Open = 0,
    /// It ran into something.
    Collided = 1,
    /// It cannot lead to a better plan.
    Dropped = 2,
    /// It is a plan.
    Goal = 3,
}

impl Search {
    /// Bytes taken by nodes, queue and the table of rounded states, about.
    pub(super) fn bytes(&self) -> usize {
        self.nodes.len() * self.nodes.bytes_each() + self.queue.bytes() + self.alike.len() * 32
    }

    /// Where it stands.
    #[must_use]
    pub fn progress(&self) -> Progress {
        Progress {
            outcome: self.outcome,
            cost: self.best.as_ref().map(|best| best.cost),
            weight: self.weight,
            proven_weight: self.proven_weight,
            counts: self.counts,
            open: self.queue.open(),
            open_peak: self.queue.peak(),
            nodes: self.nodes.len(),
            bytes: self.bytes(),
        }
    }

    /// The best plan so far.
    #[must_use]
    pub fn best(&self) -> Option<&Plan> {
        self.best.as_ref()
    }

    /// What is searched for.
    #[must_use]
    pub fn task(&self) -> &Task {
        &self.task
    }

    /// Whether Stops are kept for the end of the sequence.
    #[must_use]
    pub fn stop_last(&self) -> bool {
        self.task.stop().is_some_and(|stop| !self.tried.contains(&stop))
    }

    /// How it is searched for.
    #[must_use]
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// No plan costs less than this; `None` when the method proves nothing. Infinite when there is no plan.
    ///
    /// Looks at every open entry.
    #[must_use]
    pub fn lower_bound(&self) -> Option<f64> {
        match self.options.method {
            Method::Approximate(_) => None,
            // Its discard by weighted keys leaves only this: keys are at most w times what completions cost.
            Method::Literal => {
                let keys = self.queue.each().map(|entry| entry.key(self.weight)).fold(f64::INFINITY, f64::min);
                Some(self.waiting_bound().min(keys.min(self.best_cost) / self.weight))
            }
            Method::Exact | Method::Anytime | Method::BothSides | Method::MultiHeuristic { .. } => {
                Some(self.queue.bound().min(self.waiting_bound()).min(self.best_cost))
            }
        }
    }

    /// The least bound of the integrations that were taken from the queue and not applied yet.
    fn waiting_bound(&self) -> f64 {
        self.slots[..self.filled].iter().map(|slot| slot.bound).fold(f64::INFINITY, f64::min)
    }

    /// The best plan's cost over the lower bound, at least 1; exactly 1 when the plan is proven to be the cheapest.
    #[must_use]
    pub fn proven_ratio(&self) -> Option<f64> {
        let cost = self.best.as_ref()?.cost;
        let bound = self.lower_bound()?;
        Some(if bound >= cost { 1.0 } else { cost / bound })
    }

    /// Rows of six reals for drawing, one an integration in the order made: the swarm's centroid before and after, the
    /// key, and what became of it (0 open, 1 collided, 2 dropped, 3 in the goal). Empty unless the options ask for it.
    #[must_use]
    pub fn drawn(&self) -> &[f32] {
        &self.drawn
    }

    /// Keeps a row for drawing, when that is wanted.
    pub(super) fn draw(&mut self, slot: &Slot, key: f64, fate: Fate) {
        if !self.options.record || self.drawn.len() >= MOST_ROWS * ROW {
            return;
        }
        let robots = self.task.robots();
        let middle = |state: &[f64]| {
            let count = robots as f64;
            let [x, y] = [0, robots].map(|from| state[from..from + robots].iter().sum::<f64>() / count);
            [x as f32, y as f32]
        };
        let ([x0, y0], [x1, y1]) = (middle(self.nodes.state(slot.node)), middle(&slot.state));
        self.drawn.extend([x0, y0, x1, y1, key as f32, f32::from(fate as u8)]);
    }
}
