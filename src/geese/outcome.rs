//! How a run stands: its state at the steps kept for charts, and what came of it.

use serde::Serialize;

/// The state of the task at one of the steps that are kept for charts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Sample {
    /// Items delivered.
    pub delivered: u32,
    /// Items carried.
    pub carrying: u32,
    /// Distinct programs ticked in the step.
    pub programs: u32,
    /// Programs replaced since the sample before.
    pub swaps: u32,
}

/// How a run stands, as results and the page show it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// Items delivered.
    pub delivered: u32,
    /// All items.
    pub items: u32,
    /// Delivered over all.
    pub share: f64,
    /// Whether the share is above the success threshold.
    pub success: bool,
    /// Why the run ended; `None` while it can go on.
    pub finished: Option<Finished>,
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Finished {
    /// All steps were made.
    #[serde(rename = "tick limit")]
    TickLimit,
    /// Nothing is left to do.
    #[serde(rename = "all food delivered")]
    AllDelivered,
    /// No debris is left inside the boundary.
    #[serde(rename = "all debris removed")]
    AllRemoved,
    /// Every agent has touched a trap.
    #[serde(rename = "all robots dead")]
    AllDead,
}

impl Finished {
    /// The reason in words, as results and the page show it.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::TickLimit => "tick limit",
            Self::AllDelivered => "all food delivered",
            Self::AllRemoved => "all debris removed",
            Self::AllDead => "all robots dead",
        }
    }
}
