//! The best order of swarm behaviours: a library, decision points, and a search for the cheapest sequence.

mod behaviours;
mod cases;
mod costs;
mod cover;
mod dynamics;
mod estimate;
mod geodesic;
mod layout;
mod map;
mod params;
mod replay;
mod robust;
mod schema;
mod search;
mod tasks;
mod world;

pub use behaviours::{Behaviour, LETTERS, Law, Meta, RADII, Shape, library, standard};
pub use cases::Cases;
pub use costs::{Costs, Past, Switches};
pub use cover::Cells;
pub use dynamics::{Kernel, SPEED_LIMIT, STEP, STEPS_PER_SECOND, TURN_LIMIT, signed_angle};
pub use map::{Bounds, Form, Obstacle};
pub use params::{MethodKind, Params, SwitchRule, TaskKind};
pub use replay::{Replay, replay};
pub use robust::{Robustness, jittered, robustness};
pub use schema::parameters;
pub use search::{Counts, Limit, Method, Options, Outcome as SearchOutcome, Plan, Progress, Search, Slot};
pub use tasks::{Collision, Goal, Parts, Task, TaskError, Touched};
pub use world::{Fragility, Outcome, Solution, State, World, first_interval};
