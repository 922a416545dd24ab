//! Robot soccer, three against three: the league's very small size class, with its pitch, robots, ball and referee.
//!
//! [`Match`] is the loop; it knows no teams. A team sees a [`view::View`] in its own frame and answers with wheel speeds,
//! and with a line-up when the referee calls.
//!
//! | part | where it differs from its sources | in the module |
//! |---|---|---|
//! | physics | spin of the ball about the vertical, frictions | [`physics`] |
//! | referee | one rule decides a frame, no pause between halves, the end of a shoot-out | [`referee`] |
//! | placements | a team whose own places are impossible stands by the table alone | `placing` |
//! | camera | one for both teams; velocities without noise | [`noise`] |
//!
//! Source: the league's own programs, VSSSLeague/VSSReferee and VSSSLeague/FIRASim, with rSim; and the paper for which
//! the league's game is the example: Haug, Brandão, Casals, "Coordinating a Robotics Multi-Agent System Using Behavior
//! Trees", SAC 2024.

mod arrangement;
mod game;
mod hand;
pub mod ironcup;
mod moment;
pub mod noise;
mod params;
pub mod physics;
pub mod pitch;
mod placing;
pub mod referee;
mod schema;
mod statistics;
pub mod team;
pub mod tournament;
pub mod view;
mod world;

pub use arrangement::{Arrangement, ArrangementError};
pub use game::{Colour, Ending, Match};
pub use hand::{Driven, Intervention};
pub use moment::{FRAME, Moment, ShownEdge, TeamMoment, machine_edges, machine_states};
pub use params::Params;
pub use schema::parameters;
pub use statistics::Statistics;
pub use world::{Finished, Outcome, State, TeamEvent, TeamReport, World};
