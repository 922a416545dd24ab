//! The one description of a run that the page, its links, the command line and the tests share.
//!
//! A scenario is JSON: `{"world": "geese", "seed": 42, "storage-threshold": 7}`. Fields that are left out have the
//! defaults of the [`schema`]; presets in `scenarios/` give only what differs.

#[cfg(feature = "soccer")]
mod film;
mod read;
#[cfg(feature = "soccer")]
mod replay;
mod run;
mod timeline;

#[cfg(feature = "soccer")]
pub use film::Film;
pub use read::{ScenarioError, schema};
#[cfg(feature = "soccer")]
pub use replay::{Difference, Replay};
pub use run::{Outcome, Run, Start};
pub use timeline::Timeline;

use crate::geese;
use crate::random::Seed;
#[cfg(feature = "sequencing")]
use crate::sequencing;
#[cfg(feature = "soccer")]
use crate::soccer;
use serde_json::Value;

/// A run, described completely: the same scenario gives the same states on every machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// A name for people; empty for a nameless one.
    pub title: String,
    /// One or two sentences on what to watch.
    pub about: String,
    /// The seed of every random stream.
    pub seed: Seed,
    /// The world and its parameters.
    pub world: WorldParams,
    /// Changes made while the run went on, in the order of their ticks.
    pub events: Vec<Event>,
}

/// The worlds.
#[derive(Clone, Debug, PartialEq)]
pub enum WorldParams {
    /// A swarm that forages while it evolves.
    Geese(geese::Params),
    /// A swarm that carries out the best sequence of behaviours that was found for it. Left out of the first engine
    /// file that the page loads.
    #[cfg(feature = "sequencing")]
    Sequencing(sequencing::Params),
    /// A match of robot soccer; left out of the first engine file likewise.
    #[cfg(feature = "soccer")]
    Soccer(Box<soccer::Params>),
}

/// A live parameter changed before the step that follows `tick`, or something done to a match from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// The tick at which the change was made.
    pub tick: u32,
    /// The parameter's key, with its world: `geese.mutation-probability`. Of a match, one of the names of
    /// `soccer::Intervention`, likewise: `soccer.restart`.
    pub key: String,
    /// The new value.
    pub value: Value,
}

impl WorldParams {
    /// The world's name in a scenario, and the first part of its parameters' keys.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Geese(_) => "geese",
            #[cfg(feature = "sequencing")]
            Self::Sequencing(_) => "sequencing",
            #[cfg(feature = "soccer")]
            Self::Soccer(_) => "soccer",
        }
    }

    /// The number of steps after which a run ends.
    #[must_use]
    pub fn steps(&self) -> u32 {
        match self {
            Self::Geese(params) => params.steps,
            #[cfg(feature = "sequencing")]
            Self::Sequencing(params) => params.steps(),
            #[cfg(feature = "soccer")]
            Self::Soccer(params) => params.steps(),
        }
    }
}
