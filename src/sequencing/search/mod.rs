//! The search for the cheapest sequence: Algorithm 1 as the paper has it, and what makes it fast without losing its
//! guarantees.
//!
//! What is exact, and why:
//!
//! - **Stops last.** Stop leaves every state as it is and costs nothing, nothing depends on time, and all intervals are
//!   equally long. So only moving behaviours are searched, a state in the goal set at any depth is a plan, and the rest of
//!   the horizon is filled with Stops. With charges that make this untrue ([`Costs::stop_last_is_exact`]), Stop is a
//!   behaviour like any other; without a Stop in the library the goal must hold at the horizon's end.
//! - **Simulate late.** Expanding a node puts its behaviours into the queue by guessed keys, clamped so that the weight's
//!   promise holds ([`queue::Entry::key`]). A behaviour is simulated when its turn comes, and enters again with its true
//!   key.
//! - **Foresee.** With a forecast a guess comes from a simulation in a few long steps, which sees obstacles and visited
//!   cells. It only orders the search; the clamp keeps the promise.
//! - **Discard by the unweighted bound.** What cannot be cheaper than the best plan goes, at any weight.
//! - **Reach.** Nobody moves faster than 2 m/s: a state from which somebody cannot arrive in time goes.
//! - **First touch.** An integration ends with the first collision.

pub mod nodes;
pub mod queue;
mod run;
mod slot;

pub use run::Search;
pub use slot::Slot;

use super::costs::Costs;

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Algorithm 1 word by word: all behaviours, the goal tested at the horizon's end, ties first in, first out.
    Literal,
    /// With everything above.
    Exact,
    /// The same, and when the weight's promise is kept go on with a smaller one, down to the wanted weight.
    Anytime,
    /// A second queue by an estimate that is no bound, watched by the first (Multi-Heuristic A*).
    ///
    /// A plan costs at most anchor times second times the least cost.
    MultiHeuristic {
        /// Weight of the first queue.
        anchor: f64,
        /// How far the second queue may run ahead of it.
        second: f64,
    },
    /// From both sides in turn: the entry of the least bound, which raises the lower bound, then those that promise good
    /// plans by the weights of [`Method::Anytime`] and by the second estimate, which lower the best plan's cost.
    ///
    /// Ends when the best plan costs at most the weight times the lower bound.
    BothSides,
    /// Of states alike after rounding positions to so many metres only the cheapest is kept. Proves nothing.
    Approximate(f64),
}

/// How to search, and how long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The algorithm.
    pub method: Method,
    /// The weight w of eq. (10), at least 1; for [`Method::Anytime`] the last one, for [`Method::BothSides`] the wanted
    /// ratio of cost and lower bound.
    pub weight: f64,
    /// Simulate every behaviour of a node at once in place of guessing first.
    pub eager: bool,
    /// Let distances to the target go round the obstacles.
    pub geodesic: bool,
    /// Long steps in which the guesses of behaviours not yet simulated are made; 0 to make them by straight lines.
    pub forecast: u32,
    /// Entries taken together. Their results are applied in the order of the entries, so that the plan depends on this
    /// number and never on how many threads there are.
    pub batch: u32,
    /// Integrations after which the search gives up.
    pub integrations: u64,
    /// Nodes at which it gives up.
    pub nodes: u32,
    /// Bytes at which it gives up.
    pub bytes: usize,
    /// Charges besides path length.
    pub costs: Costs,
    /// Keep a list of integrations for drawing.
    pub record: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            method: Method::Exact,
            weight: 1.5,
            eager: false,
            geodesic: false,
            forecast: 0,
            batch: 1,
            integrations: 30_000,
            nodes: 100_000,
            bytes: 256 << 20,
            costs: Costs::default(),
            record: false,
        }
    }
}

/// The weights that [`Method::Anytime`] goes through.
const WEIGHTS: [f64; 7] = [5.0, 3.0, 2.0, 1.5, 1.25, 1.1, 1.0];

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A plan, and the promise of the weight kept.
    Solved,
    /// There is no plan: everything was tried, and nothing left out.
    Infeasible,
    /// A limit came first. There may be a plan, and there is a bound.
    GaveUp(Limit),
    /// Somebody stopped it. As above.
    Cancelled,
}

/// What ended a search early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The number of integrations.
    Integrations,
    /// The number of nodes.
    Nodes,
    /// The memory.
    Memory,
    /// Nothing is left, but rounding left some out.
    Rounding,
}

impl Outcome {
    /// The outcome in words.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Infeasible => "proved infeasible",
            Self::GaveUp(Limit::Integrations) => "gave up at the budget of integrations",
            Self::GaveUp(Limit::Nodes) => "gave up at the budget of nodes",
            Self::GaveUp(Limit::Memory) => "gave up at the memory cap",
            Self::GaveUp(Limit::Rounding) => {
                "gave up: no plan was found, which proves nothing because states were rounded"
            }
            Self::Cancelled => "cancelled",
        }
    }
}

/// A plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Behaviours as indices of the library, one an interval.
    pub sequence: Vec<u8>,
    /// Path length and all charges.
    pub cost: f64,
}

/// Numbers of a search so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Sequences that were extended.
    pub expanded: u64,
    /// Behaviours simulated for one interval; Stops are not simulated.
    pub integrated: u64,
    /// Of these, those that ended in a collision.
    pub collided: u64,
    /// States from which somebody could not arrive in time.
    pub late: u64,
    /// Complete sequences that missed the goal.
    pub missed: u64,
    /// States left out because they were alike after rounding.
    pub alike: u64,
}

/// Where a search stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// How it ended; `None` while it goes on.
    pub outcome: Option<Outcome>,
    /// The best plan's cost.
    pub cost: Option<f64>,
    /// The weight at work.
    pub weight: f64,
    /// The smallest weight whose promise is kept; infinite before the first.
    pub proven_weight: f64,
    /// The numbers.
    pub counts: Counts,
    /// Entries in the queue.
    pub open: usize,
    /// Entries in the queue when they were most.
    pub open_peak: usize,
    /// Nodes stored.
    pub nodes: usize,
    /// Bytes taken, about.
    pub bytes: usize,
}
