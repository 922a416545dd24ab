//! The best order of swarm behaviours: a library, decision points, and a search for the cheapest sequence.
//!
//! Paper: optimal swarm behaviour sequencing. An operator can only tell the whole swarm which behaviour of a library to
//! carry out next, at given decision points. Which sequence brings it into the goal set at the least cost? Algorithm 1
//! searches sequences best first; here it stands word by word beside a search that is faster and loses nothing
//! ([`Search`]).
//!
//! **The model is a fixed discrete-time system**, a 10 Hz controller, not an approximation of a differential equation.
//! Search, replay, tests and drawing share its one step ([`Task::step`]). A plan and its proof hold for this model and
//! its start; trajectories over 150 s part from those of any other integrator or start ([`robustness`]).
//!
//! Where the paper is silent or we differ:
//!
//! | question | choice | reason |
//! |---|---|---|
//! | neighbours in eqs. (14), (15) | all other robots | the centroid property claimed for (15) needs as many neighbours for everyone |
//! | step of time | 0.1 s, command held, heading of the middle | one evaluation a step; nothing is gained by more over a discontinuous right-hand side |
//! | radii of eq. (13) | inclusive upper bounds | arbitrary |
//! | least speed 1 m/s | in flocking only, before saturation | otherwise Stop would move |
//! | obstacle test | segment between step ends, closed obstacles | no corner is cut, and distances stay bounds |
//! | path length | sum of the absolute speed times dt | never below the displacement, so (18) stays a bound |
//! | coverage | every cell that a step passes through | cells entered and left within a step count |
//! | goal | at the horizon's end, which with a free Stop is any decision point | Stops can be moved to the end |
//! | ties in the queue | deeper first, then first in; literally first in, first out | results at w > 1 depend on them |
//! | start, target, obstacles of the figures | drawn from a seed, see `layout.rs` | the paper gives no numbers |
//! | eq. (12) | atan2 of cross and dot | better conditioned than acos near 0 and pi |
//! | charges for time and switches | optional, see [`Costs`] | section VI suggests them |

mod behaviours;
mod cases;
mod costs;
mod cover;
mod dynamics;
mod estimate;
mod geodesic;
mod layout;
mod lists;
mod map;
mod params;
mod parts;
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
pub use parts::{Goal, Parts, TaskError};
pub use replay::{Replay, follow, replay};
pub use robust::{Robustness, jittered, robustness};
pub use schema::parameters;
pub use search::{Counts, Limit, Method, Options, Outcome as SearchOutcome, Plan, Progress, Search, Slot};
pub use tasks::{Collision, Task, Touched};
pub use world::{Fragility, Outcome, Preparation, Solution, State, World, first_interval};
