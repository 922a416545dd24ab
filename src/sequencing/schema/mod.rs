//! Bounds, meaning and source of every parameter.

mod planner;
mod task;

use crate::parameter::{Kind, Parameter};

const fn int(min: i64, max: i64, hard_max: i64) -> Kind {
    Kind::Int { min, max, hard_max, log: false }
}

const fn real(min: f64, max: f64, hard_max: f64, step: f64) -> Kind {
    Kind::Float { min, max, hard_max, step, log: false }
}

/// All parameters, in the order in which the page shows them.
#[must_use]
pub fn parameters() -> &'static [&'static [Parameter]] {
    &[task::PARAMETERS, planner::PARAMETERS]
}
