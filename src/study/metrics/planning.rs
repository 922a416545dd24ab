//! What is measured of the search for a sequence of behaviours, and of its plan. Times are left out: they are the
//! machine's, not the run's.

use super::Form;
use crate::sequencing::{Meta, SearchOutcome, World};

/// A number that a run of behaviour sequencing gives; each is described once, by its help text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Planning {
    Solved,
    ProvedInfeasible,
    GaveUp,
    HasPlan,
    Cost,
    LowerBound,
    ProvenRatio,
    Integrations,
    Expanded,
    Collided,
    FrontierPeak,
    MovingIntervals,
    DistinctBehaviours,
    Changes,
    IdleStops,
    FlockShare,
    GathersLast,
    RobustShare,
}

impl Planning {
    /// Every metric, in the order of the documentation, with the name it has in studies and results.
    pub const ALL: [(&'static str, Self); 18] = [
        ("solved", Self::Solved),
        ("proved_infeasible", Self::ProvedInfeasible),
        ("gave_up", Self::GaveUp),
        ("has_plan", Self::HasPlan),
        ("cost", Self::Cost),
        ("lower_bound", Self::LowerBound),
        ("proven_ratio", Self::ProvenRatio),
        ("integrations", Self::Integrations),
        ("expanded", Self::Expanded),
        ("collided", Self::Collided),
        ("frontier_peak", Self::FrontierPeak),
        ("moving_intervals", Self::MovingIntervals),
        ("distinct_behaviours", Self::DistinctBehaviours),
        ("changes", Self::Changes),
        ("idle_stops", Self::IdleStops),
        ("flock_share", Self::FlockShare),
        ("gathers_last", Self::GathersLast),
        ("robust_share", Self::RobustShare),
    ];

    /// The name in studies and results.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }

    /// The name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::Solved => "Solved",
            Self::ProvedInfeasible => "Proved infeasible",
            Self::GaveUp => "Gave up",
            Self::HasPlan => "Has a plan",
            Self::Cost => "Cost, metres",
            Self::LowerBound => "Lower bound, metres",
            Self::ProvenRatio => "Proven ratio",
            Self::Integrations => "Integrations",
            Self::Expanded => "Sequences expanded",
            Self::Collided => "Collisions",
            Self::FrontierPeak => "Largest frontier",
            Self::MovingIntervals => "Moving intervals",
            Self::DistinctBehaviours => "Distinct behaviours",
            Self::Changes => "Changes of behaviour",
            Self::IdleStops => "Idle Stops",
            Self::FlockShare => "Flocking",
            Self::GathersLast => "Gathers last",
            Self::RobustShare => "Robust replays",
        }
    }

    /// What is measured, in one sentence.
    pub fn help(self) -> &'static str {
        match self {
            Self::Solved => "1 when the search ended with a plan and the promise of its method kept, else 0.",
            Self::ProvedInfeasible => "1 when the search proved that no sequence reaches the goal, else 0.",
            Self::GaveUp => "1 when the search came to its budget, with or without a plan, else 0.",
            Self::HasPlan => "1 when there is a plan, with or without a proof, else 0.",
            Self::Cost => "What the plan costs: metres of all robots together, and charges; empty without a plan.",
            Self::LowerBound => "No plan costs less than this; empty where nothing is proven.",
            Self::ProvenRatio => "Cost over lower bound; empty without a plan, and where nothing is proven.",
            Self::Integrations => "Behaviours simulated for one interval.",
            Self::Expanded => "Sequences that were extended.",
            Self::Collided => "Integrations that ended in a collision.",
            Self::FrontierPeak => "Entries in the queue when they were most.",
            Self::MovingIntervals => "Intervals of the plan in which the swarm moves; empty without a plan.",
            Self::DistinctBehaviours => "Different moving behaviours in the plan; empty without a plan.",
            Self::Changes => {
                "How often the plan goes from one moving behaviour to another, Stops looked through; empty without a plan."
            }
            Self::IdleStops => "Stops in the plan before its last moving behaviour; empty without a plan.",
            Self::FlockShare => "Share of the moving intervals that flock; empty without a plan that moves.",
            Self::GathersLast => {
                "1 when the last moving behaviour is a rendezvous, else 0; empty without a plan that moves."
            }
            Self::RobustShare => {
                "Share of the replays from starts moved a little that stay feasible; empty without a plan or replays."
            }
        }
    }

    /// What numbers it can be.
    pub fn form(self) -> Form {
        match self {
            Self::Solved | Self::ProvedInfeasible | Self::GaveUp | Self::HasPlan | Self::GathersLast => Form::Flag,
            Self::FlockShare | Self::RobustShare => Form::Share,
            Self::Cost
            | Self::LowerBound
            | Self::ProvenRatio
            | Self::Integrations
            | Self::Expanded
            | Self::Collided
            | Self::FrontierPeak
            | Self::MovingIntervals
            | Self::DistinctBehaviours
            | Self::Changes
            | Self::IdleStops => Form::Number,
        }
    }

    /// Its value, which is the same at every tick of the run.
    pub fn of(self, world: &World) -> Option<f64> {
        let solution = world.solution();
        let flag = |holds: bool| Some(f64::from(u8::from(holds)));
        let plan = || Plan::of(world);
        match self {
            Self::Solved => flag(solution.outcome == Some(SearchOutcome::Solved)),
            Self::ProvedInfeasible => flag(solution.outcome == Some(SearchOutcome::Infeasible)),
            Self::GaveUp => flag(matches!(solution.outcome, Some(SearchOutcome::GaveUp(_)))),
            Self::HasPlan => flag(solution.plan.is_some()),
            Self::Cost => solution.cost,
            Self::LowerBound => solution.lower_bound,
            Self::ProvenRatio => solution.proven_ratio,
            Self::Integrations => Some(solution.integrated as f64),
            Self::Expanded => Some(solution.expanded as f64),
            Self::Collided => Some(solution.collided as f64),
            Self::FrontierPeak => Some(solution.open_peak as f64),
            Self::MovingIntervals => Some(plan()?.moving.len() as f64),
            Self::DistinctBehaviours => {
                let mut distinct = plan()?.moving;
                distinct.sort_unstable();
                distinct.dedup();
                Some(distinct.len() as f64)
            }
            Self::Changes => Some(plan()?.moving.windows(2).filter(|pair| pair[0] != pair[1]).count() as f64),
            Self::IdleStops => Some(plan()?.idle as f64),
            Self::FlockShare => {
                let moving = plan()?.moving;
                let flocks = moving.iter().filter(|&&at| matches!(meta(world, at), Meta::Flock { .. })).count();
                (!moving.is_empty()).then(|| flocks as f64 / moving.len() as f64)
            }
            Self::GathersLast => {
                let last = *plan()?.moving.last()?;
                flag(matches!(meta(world, last), Meta::Consensus(gain) if *gain > 0.0))
            }
            Self::RobustShare => {
                let found = solution.robustness?;
                Some(f64::from(found.feasible) / f64::from(found.runs))
            }
        }
    }
}

fn meta(world: &World, behaviour: u8) -> &Meta {
    &world.task().library()[usize::from(behaviour)].meta
}

/// A plan without its Stops.
struct Plan {
    /// Places in the library.
    moving: Vec<u8>,
    /// Stops before the last of them.
    idle: usize,
}

impl Plan {
    /// The plan of a world, if it has one.
    fn of(world: &World) -> Option<Self> {
        world.solution().plan.as_ref()?;
        let moves = |at: &u8| world.task().stop() != Some(*at);
        let end = world.plan().iter().rposition(moves).map_or(0, |last| last + 1);
        let moving: Vec<u8> = world.plan()[..end].iter().copied().filter(moves).collect();
        Some(Self { idle: end - moving.len(), moving })
    }
}
