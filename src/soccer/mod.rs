//! Robot soccer, three against three.

pub mod team;
pub mod view;
