//! The tree workbench: any BehaviorTree.CPP document, run tick by tick on leaves that answer as a script says.
//!
//! A [`Setup`] decides everything: the text, what the leaves answer and from when on, what is written by hand, how
//! time passes. A [`Bench`] computes the timeline that follows from it and shows any [`Moment`] of it.
//!
//! ```
//! use serde_json::json;
//! use swarm_playground::workbench::{Bench, Setup};
//!
//! let xml = r#"<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence><Near/><Grasp/></Sequence></BehaviorTree>
//!   <TreeNodesModel><Condition ID="Near"/><Action ID="Grasp"/></TreeNodesModel></root>"#;
//! let script = json!([{"tick": 0, "leaf": "Grasp", "running": 2, "then": "FAILURE"}]);
//! let setup = Setup::from_value(&json!({"xml": xml, "script": script, "length": 3, "at": 3}))?;
//! let mut bench = Bench::default();
//! assert!(bench.open(&setup).problems.is_empty());
//! assert_eq!(bench.timeline(1, 3).roots, ["R", "R", "F"]);
//! # Ok::<(), swarm_playground::workbench::SetupError>(())
//! ```

mod bench;
mod headless;
mod leaves;
mod moment;
mod record;
mod setup;
mod shown;
mod variants;

pub use bench::Bench;
pub use headless::{Headless, tick_headless};
pub use moment::{Moment, Stopped, Timeline};
pub use setup::{Answer, Event, EventKind, Mode, Setup, SetupError};
pub use shown::{Opened, ShownNode, ShownTree, models};
pub use variants::{Variant, format, variants};
