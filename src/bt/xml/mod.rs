//! The XML of BehaviorTree.CPP, format 4: reading, checking and writing.
//!
//! [`read`] reports every fault of a text at once, each with the line and column where the user typed it; the
//! reference stops at the first one and counts lines in its own copy. [`write()`] gives the canonical form. Import,
//! export and import again give the same document, comments and unknown metadata included.
//!
//! ```
//! use swarm_playground::bt::xml::{Manifest, NodeKind, read, write};
//!
//! let mut manifest = Manifest::default();
//! manifest.register("Kick", NodeKind::Action, vec![])?;
//! let text = r#"<root BTCPP_format="4"><BehaviorTree ID="Play"><Sequnce><Kick/></Sequnce></BehaviorTree></root>"#;
//! let problems = read(text, &manifest).unwrap_err();
//! assert_eq!(problems[0].to_string(), r#"line 1, column 48: unknown node "Sequnce", did you mean "Sequence"?"#);
//!
//! let (document, warnings) = read(&text.replace("Sequnce", "Sequence"), &manifest).expect("no fault is left");
//! assert!(warnings.is_empty());
//! assert!(write(&document, &manifest).contains("<Kick/>"));
//! # Ok::<(), swarm_playground::bt::xml::RegisterError>(())
//! ```

mod check;
mod document;
mod literal;
mod manifest;
mod model;
mod problem;
mod read;
mod recursion;
mod scan;
mod write;

pub use crate::place::Place;
pub use document::{Attribute, Document, Element, FORMAT, Model, ModelPart, ModelPort, Role, TreeDefinition, When};
pub use literal::{Item, PortType, reference};
pub use manifest::{Arity, Direction, Manifest, NodeKind, NodeType, Port, RegisterError, builtin_nodes};
pub use problem::Problem;
pub use read::read;
pub use recursion::MOST_NODES;
pub use scan::{DEEPEST, MOST_ATTRIBUTES, MOST_BYTES};
pub use write::write;
