//! Studies: many runs of a scenario and its variants, their results, and the report on them.

pub mod statistics;
