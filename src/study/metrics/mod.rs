//! What is measured of a run when it has ended. Each world has metrics of its own.

mod foraging;
#[cfg(feature = "sequencing")]
mod planning;
#[cfg(feature = "soccer")]
mod soccer;

use crate::geese::Measure;
use crate::scenario::{Run, WorldParams};
use foraging::{Foraging, Reached as Delivered};
#[cfg(feature = "sequencing")]
use planning::Planning;
#[cfg(feature = "soccer")]
pub(super) use soccer::Soccer;

/// A number that a run gives; see [`Metric::all`] for all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// Of the foraging swarm.
    Foraging(Foraging),
    /// Of the search for a sequence of behaviours.
    #[cfg(feature = "sequencing")]
    Planning(Planning),
    /// Of a match.
    #[cfg(feature = "soccer")]
    Soccer(Soccer),
}

/// What numbers a metric can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// 1 or 0: the report counts successes.
    Flag,
    /// A real number from 0 to 1, shown in per cent.
    Share,
    /// Any other number.
    Number,
}

impl Metric {
    /// Every metric, in the order of the documentation, with the name it has in studies and results.
    #[must_use]
    pub fn all() -> Vec<(&'static str, Self)> {
        let all = Foraging::ALL.iter().map(|&(name, metric)| (name, Self::Foraging(metric)));
        #[cfg(feature = "sequencing")]
        let all = all.chain(Planning::ALL.iter().map(|&(name, metric)| (name, Self::Planning(metric))));
        #[cfg(feature = "soccer")]
        let all = all.chain(Soccer::ALL.iter().map(|&(name, metric)| (name, Self::Soccer(metric))));
        all.collect()
    }

    /// The metrics of a world, with their names.
    #[must_use]
    pub fn of_world(world: &WorldParams) -> Vec<(&'static str, Self)> {
        Self::all().into_iter().filter(|(_, metric)| metric.world() == world.name()).collect()
    }

    /// The name of the world that it measures.
    #[must_use]
    pub fn world(self) -> &'static str {
        match self {
            Self::Foraging(_) => "geese",
            #[cfg(feature = "sequencing")]
            Self::Planning(_) => "sequencing",
            #[cfg(feature = "soccer")]
            Self::Soccer(_) => "soccer",
        }
    }

    /// The name in studies and results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Foraging(metric) => metric.name(),
            #[cfg(feature = "sequencing")]
            Self::Planning(metric) => metric.name(),
            #[cfg(feature = "soccer")]
            Self::Soccer(metric) => metric.name(),
        }
    }

    /// The name for people.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Foraging(metric) => metric.label(),
            #[cfg(feature = "sequencing")]
            Self::Planning(metric) => metric.label(),
            #[cfg(feature = "soccer")]
            Self::Soccer(metric) => metric.label(),
        }
    }

    /// What is measured, in one sentence.
    #[must_use]
    pub fn help(self) -> &'static str {
        match self {
            Self::Foraging(metric) => metric.help(),
            #[cfg(feature = "sequencing")]
            Self::Planning(metric) => metric.help(),
            #[cfg(feature = "soccer")]
            Self::Soccer(metric) => metric.help(),
        }
    }

    /// What numbers it can be.
    #[must_use]
    pub fn form(self) -> Form {
        match self {
            Self::Foraging(metric) => metric.form(),
            #[cfg(feature = "sequencing")]
            Self::Planning(metric) => metric.form(),
            #[cfg(feature = "soccer")]
            Self::Soccer(metric) => metric.form(),
        }
    }

    /// Whether nothing that can still happen in the run changes it.
    fn is_settled(self, run: &Run, reached: &Reached) -> bool {
        match self {
            Self::Foraging(metric) => metric.is_settled(run, &reached.delivered),
            // The search is over when the run begins, and carrying the plan out tells nothing new.
            #[cfg(feature = "sequencing")]
            Self::Planning(_) => true,
            // The last second can still change everything.
            #[cfg(feature = "soccer")]
            Self::Soccer(_) => false,
        }
    }
}

/// What has to be noted of a run on its way, because its end does not show it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Reached {
    delivered: Delivered,
}

/// Makes up to `steps` steps of a run; returns whether it is over: it has ended, or nothing more can change `metrics`.
///
/// - `reached`: what was noted of the run so far; at its start, the default.
pub(super) fn advance(run: &mut Run, metrics: &[Metric], reached: &mut Reached, steps: u32) -> bool {
    for _ in 0..steps {
        let counts = !run.geese().is_some_and(crate::geese::World::awaits_test);
        if counts && run.geese().is_some() {
            reached.delivered.note(run);
        }
        let is_settled = counts && metrics.iter().all(|metric| metric.is_settled(run, reached));
        if is_settled || run.advance(1) == 0 {
            return true;
        }
    }
    false
}

/// The metrics of a run as it stands, in their order; `None` for what has not come about.
pub(super) fn measure(run: &Run, metrics: &[Metric], reached: &Reached) -> Vec<Option<f64>> {
    let measure = run.geese().map(Measure::of);
    #[cfg(feature = "soccer")]
    let outcome = run.soccer().map(crate::soccer::World::outcome);
    let value = |metric: &Metric| match metric {
        Metric::Foraging(metric) => metric.of(run, measure.as_ref()?, &reached.delivered),
        #[cfg(feature = "sequencing")]
        Metric::Planning(metric) => metric.of(run.sequencing()?),
        #[cfg(feature = "soccer")]
        Metric::Soccer(metric) => metric.of(run.soccer()?, outcome.as_ref()?),
    };
    metrics.iter().map(value).collect()
}
