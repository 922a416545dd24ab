//! Robot soccer, three against three: the league's very small size class.

pub mod physics;
pub mod pitch;
pub mod view;
