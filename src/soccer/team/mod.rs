//! A team: seven roles, a Coach of one of two kinds, and the organisation that both keep to.
//!
//! Paper: Haug, Brandao, Casals, "Coordinating a Robotics Multi-Agent System Using Behavior Trees", section 4 for the
//! roles, the organisation and the state machine, section 5 for the tree. The paper prints neither conditions nor motion;
//! those are ours, and the same for both coaches, so that only the architecture differs.
//!
//! - [`organisation`]: MOISE+ as data, and the checker that refuses what breaks it.
//! - [`conditions`], [`start`]: when roles change, and who plays what at a start.
//! - [`coach`]: the state machine and the behaviour tree.
//! - [`roles`], [`motion`]: what a robot does in its role, and how it drives.
//! - [`Team`]: all of it, as a match needs it.

pub mod coach;
pub mod conditions;
mod duties;
pub mod geometry;
mod kind;
mod margins;
pub mod motion;
pub mod organisation;
pub mod roles;
mod roster;
mod shown;
mod squad;
pub mod start;
mod watch;

pub use duties::{Duties, Formation, Mode, Pair, Role};
pub use kind::{Coached, TeamKind};
pub use margins::{Margins, MarginsError};
pub use roster::{Event, EventKind, Roster, Snapshot};
pub use shown::{ShownNode, coach_nodes, coach_problems, role_nodes, role_problems};
pub use squad::{Team, TeamError};
pub use watch::{Statuses, Watch};
