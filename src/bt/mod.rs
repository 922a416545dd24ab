//! Behaviour trees: flat arenas in preorder, ticked with the semantics of `BehaviorTree.CPP` 4.10.
//!
//! The engine knows no world. A world brings a leaf type and a [`Host`] that runs leaves; a [`Recorder`] sees
//! what each node returned, and [`Silent`] makes headless runs pay nothing for that.
//!
//! ```
//! use swarm_playground::bt::{tick_once, Builder, Kind, Memory, Host, NodeId, Ports, Silent, Status};
//!
//! struct World { hungry: bool }
//! impl Host<&'static str> for World {
//!     fn tick(&mut self, _node: NodeId, leaf: &&'static str, _ports: &mut Ports) -> Status {
//!         match *leaf {
//!             "is hungry" => Status::completed(self.hungry),
//!             _ => { self.hungry = false; Status::Success }
//!         }
//!     }
//! }
//!
//! let mut builder = Builder::default();
//! builder.open(Kind::Sequence);
//! builder.leaf("is hungry");
//! builder.leaf("eat");
//! builder.close();
//! let tree = builder.finish()?;
//! let mut memory = Memory::for_tree(&tree);
//! let mut world = World { hungry: true };
//! assert_eq!(tick_once(&tree, &mut memory, &mut world, &mut Silent), Ok(Status::Success));
//! assert_eq!(tick_once(&tree, &mut memory, &mut world, &mut Silent), Ok(Status::Failure));
//! # Ok::<(), swarm_playground::bt::BuildError>(())
//! ```

pub mod blackboard;
mod builtin;
mod cases;
mod compile;
mod control;
mod decorator;
mod drawing;
mod instant;
mod memory;
mod recorder;
pub mod script;
mod tick;
mod tree;
mod value;
pub mod xml;

pub use builtin::{BoundScript, Builtin, Extra, Key, LoopType, Source};
pub use cases::Cases;
pub use compile::{HostLeaf, compile};
pub use drawing::draw_svg;
pub use instant::tick_instant;
pub use memory::{Memory, Ports};
pub use recorder::{Recorder, Silent};
pub use tick::{Host, TickError, halt_tree, pass_time, tick_exactly_once, tick_once};
pub use tree::{BuildError, Builder, BuiltinId, Children, Kind, Node, NodeId, Tree};
pub use value::Value;

/// What a node returned, or IDLE when it returned nothing since its parent was reset.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Status {
    /// Not ticked since the last reset; no node returns it.
    #[default]
    Idle,
    /// Not done yet: tick again.
    Running,
    /// Done, with the goal reached.
    Success,
    /// Done, without the goal.
    Failure,
    /// Not executed at all; the parent treats the node as absent.
    Skipped,
}

impl Status {
    /// SUCCESS for true and FAILURE for false.
    #[must_use]
    pub fn completed(success: bool) -> Self {
        if success { Self::Success } else { Self::Failure }
    }

    /// True for SUCCESS and FAILURE.
    #[must_use]
    pub fn is_completed(self) -> bool {
        matches!(self, Self::Success | Self::Failure)
    }

    /// The name as `BehaviorTree.CPP` writes it, in capitals.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Idle => "IDLE",
            Self::Running => "RUNNING",
            Self::Success => "SUCCESS",
            Self::Failure => "FAILURE",
            Self::Skipped => "SKIPPED",
        }
    }
}
