//! The built-in nodes that read ports, run scripts or watch the clock.

use super::blackboard::EntryId;
use super::script::Script;
use super::{Status, Value};

/// Where a port's value comes from.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Source {
    /// The port is not given and has no default.
    #[default]
    Missing,
    /// It stands in the tree.
    Literal(Value),
    /// It is read from, or written to, a blackboard entry.
    Entry(EntryId),
}

impl From<i32> for Source {
    fn from(number: i32) -> Self {
        Self::Literal(Value::Number(f64::from(number)))
    }
}

/// A script with the entries that its names stand for.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundScript {
    /// The script.
    pub script: Script,
    /// The entry of each of the script's names.
    pub entries: Vec<EntryId>,
}

/// What a loop's values are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopType {
    /// Whole numbers.
    Int,
    /// 1 and 0.
    Bool,
    /// Reals.
    Double,
    /// Texts.
    String,
}

/// A built-in node with its ports, named as in `BehaviorTree.CPP`.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are the ports, which the manifest describes")]
pub enum Builtin {
    AsyncSequence,
    AsyncFallback,
    Parallel { success_count: Source, failure_count: Source },
    ParallelAll { max_failures: Source },
    IfThenElse,
    WhileDoElse,
    Switch { variable: Source, cases: Vec<Source> },
    TryCatch { catch_on_halt: Source },
    Repeat { num_cycles: Source },
    RetryUntilSuccessful { num_attempts: Source },
    KeepRunningUntilFailure,
    Delay { delay_msec: Source },
    Timeout { msec: Source },
    RunOnce { then_skip: Source },
    Precondition { condition: Option<BoundScript>, otherwise: Status },
    Loop { of: LoopType, queue: Source, value: Source, if_empty: Status },
    SkipUnlessUpdated { entry: EntryId },
    WaitValueUpdate { entry: EntryId },
    SubTree,
    AlwaysSuccess,
    AlwaysFailure,
    Script { code: Option<BoundScript> },
    ScriptCondition { code: Option<BoundScript> },
    SetBlackboard { output_key: Key, value: Source },
    UnsetBlackboard { key: Key },
    Sleep { msec: Source },
    WasEntryUpdated { entry: EntryId },
}

/// The name of an entry, given as a literal or as the text of another entry.
#[derive(Clone, Debug, PartialEq)]
pub enum Key {
    /// A known entry.
    Entry(EntryId),
    /// The entry of this board whose name stands in another entry.
    Named {
        /// The board on which the name is looked up.
        board: u32,
        /// The entry that holds the name.
        by: EntryId,
    },
}

impl Builtin {
    /// The registered name in `BehaviorTree.CPP`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::AsyncSequence => "AsyncSequence",
            Self::AsyncFallback => "AsyncFallback",
            Self::Parallel { .. } => "Parallel",
            Self::ParallelAll { .. } => "ParallelAll",
            Self::IfThenElse => "IfThenElse",
            Self::WhileDoElse => "WhileDoElse",
            Self::Switch { cases, .. } => match cases.len() {
                2 => "Switch2",
                3 => "Switch3",
                4 => "Switch4",
                5 => "Switch5",
                _ => "Switch6",
            },
            Self::TryCatch { .. } => "TryCatch",
            Self::Repeat { .. } => "Repeat",
            Self::RetryUntilSuccessful { .. } => "RetryUntilSuccessful",
            Self::KeepRunningUntilFailure => "KeepRunningUntilFailure",
            Self::Delay { .. } => "Delay",
            Self::Timeout { .. } => "Timeout",
            Self::RunOnce { .. } => "RunOnce",
            Self::Precondition { .. } => "Precondition",
            Self::Loop { of: LoopType::Int, .. } => "LoopInt",
            Self::Loop { of: LoopType::Bool, .. } => "LoopBool",
            Self::Loop { of: LoopType::Double, .. } => "LoopDouble",
            Self::Loop { of: LoopType::String, .. } => "LoopString",
            Self::SkipUnlessUpdated { .. } => "SkipUnlessUpdated",
            Self::WaitValueUpdate { .. } => "WaitValueUpdate",
            Self::SubTree => "SubTree",
            Self::AlwaysSuccess => "AlwaysSuccess",
            Self::AlwaysFailure => "AlwaysFailure",
            Self::Script { .. } => "Script",
            Self::ScriptCondition { .. } => "ScriptCondition",
            Self::SetBlackboard { .. } => "SetBlackboard",
            Self::UnsetBlackboard { .. } => "UnsetBlackboard",
            Self::Sleep { .. } => "Sleep",
            Self::WasEntryUpdated { .. } => "WasEntryUpdated",
        }
    }

    /// How many children the node takes: least and most (`None`: no bound).
    ///
    /// Counts that the reference checks only when it ticks (IfThenElse, WhileDoElse, Switch) are free here.
    #[must_use]
    pub fn arity(&self) -> (usize, Option<usize>) {
        match self {
            Self::AsyncSequence
            | Self::AsyncFallback
            | Self::Parallel { .. }
            | Self::ParallelAll { .. }
            | Self::IfThenElse
            | Self::WhileDoElse
            | Self::Switch { .. } => (1, None),
            Self::TryCatch { .. } => (2, None),
            Self::Repeat { .. }
            | Self::RetryUntilSuccessful { .. }
            | Self::KeepRunningUntilFailure
            | Self::Delay { .. }
            | Self::Timeout { .. }
            | Self::RunOnce { .. }
            | Self::Precondition { .. }
            | Self::Loop { .. }
            | Self::SkipUnlessUpdated { .. }
            | Self::WaitValueUpdate { .. }
            | Self::SubTree => (1, Some(1)),
            Self::AlwaysSuccess
            | Self::AlwaysFailure
            | Self::Script { .. }
            | Self::ScriptCondition { .. }
            | Self::SetBlackboard { .. }
            | Self::UnsetBlackboard { .. }
            | Self::Sleep { .. }
            | Self::WasEntryUpdated { .. } => (0, Some(0)),
        }
    }
}

/// What a node has besides its kind: a name, scripts around its tick, and the ports of a host leaf.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extra {
    /// The instance name.
    pub name: String,
    /// `None` for the many nodes that have none, so that their ticks look at one place only.
    pub scripts: Option<Box<Scripts>>,
    /// Ports of a host leaf, by name.
    pub ports: Vec<(String, Source)>,
}

/// The scripts around a node's tick.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scripts {
    /// `_failureIf`, `_successIf`, `_skipIf`, `_while`, in the order in which they are looked at.
    pub before: [Option<BoundScript>; 4],
    /// `_onSuccess`, `_onFailure`, `_post`, `_onHalted`.
    pub after: [Option<BoundScript>; 4],
}
