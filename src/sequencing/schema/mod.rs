//! Bounds, meaning and source of every parameter.

mod planner;
mod task;

use crate::parameter::Parameter;

/// All parameters, in the order in which the page shows them.
#[must_use]
pub fn parameters() -> &'static [&'static [Parameter]] {
    &[task::PARAMETERS, planner::PARAMETERS]
}
