//! The best order of swarm behaviours: a library, decision points, and a search for the cheapest sequence.

mod behaviours;
mod cases;
mod cover;
mod dynamics;
mod map;
mod replay;
mod tasks;

pub use behaviours::{Behaviour, LETTERS, Law, Meta, RADII, Shape, library, standard};
pub use cases::Cases;
pub use cover::Cells;
pub use dynamics::{Kernel, SPEED_LIMIT, STEP, STEPS_PER_SECOND, TURN_LIMIT, signed_angle};
pub use map::{Bounds, Form, Obstacle};
pub use replay::{Replay, replay};
pub use tasks::{Collision, Goal, Parts, Task, TaskError, Touched};
