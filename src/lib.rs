//! Evolve, search for and coach the behaviour of groups of agents; the same bits natively, in Node and in browsers.
//!
//! Priorities, in order: a reader with the paper open finds each equation and each deviation from it; the same input
//! gives the same bits everywhere; small; fast.
//!
//! ```
//! use swarm_playground::scenario::{Run, Scenario};
//!
//! let scenario = Scenario::read(r#"{"world": "geese", "seed": 42, "agents": 20}"#)?;
//! let mut run = Run::new(scenario)?;
//! assert_eq!(run.advance(100), 100);
//! println!("after {} steps: {:016x}", run.tick(), run.fingerprint());
//! # Ok::<(), swarm_playground::scenario::ScenarioError>(())
//! ```
//!
//! # Map of the modules
//!
//! A module uses what stands above it, never what stands below.
//!
//! - [`random`], [`fingerprint`], [`parameter`], [`place`], [`nearest`], [`verdict`]: streams, state hashes, the form of
//!   a parameter, places in a text, spelling, how a case came out.
//! - [`bt`]: behaviour trees. [`evolution`]: grammatical evolution. Neither knows a world.
//! - [`geese`]: the foraging swarm that evolves its behaviour trees. [`workbench`]: any tree, tick by tick.
//! - [`sequencing`]: a swarm of unicycles, and the search for the cheapest sequence of its behaviours.
//! - [`soccer`]: three robots against three on a pitch with walls, the referee, and teams under two kinds of coach.
//! - [`scenario`]: the one JSON description of a run, and runs that can be sought through.
//! - [`study`]: many runs of a scenario and its variants, their results and the report on them.
//! - `web`: the wasm face. The command line is `src/main.rs`.

pub mod bt;
pub mod evolution;
pub mod fingerprint;
pub mod geese;
pub mod nearest;
pub mod parameter;
pub mod place;
pub mod random;
pub mod scenario;
pub mod sequencing;
pub mod soccer;
pub mod study;
pub mod verdict;
#[cfg(target_arch = "wasm32")]
pub mod web;
pub mod workbench;
