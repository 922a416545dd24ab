//! Studies: many runs of a scenario and its variants, their results, and the report on them.
//!
//! A study is JSON, one file for each reproduced figure or table. Its runs are numbered; a run is its number, and its
//! row follows from the study and the number alone, so that neither the order in which runs end, nor how many
//! go on at once, nor where they are made, shows in the results.

mod cells;
mod claims;
mod fields;
mod figure;
mod job;
mod matches;
mod metrics;
mod plan;
mod report;
mod results;
mod row;
mod spec;
pub mod statistics;

pub use cells::{Cell, Presets};
pub use claims::Claims;
pub use fields::StudyError;
pub use job::Job;
pub use matches::PaperMatches;
pub use metrics::{Form, Metric};
pub use plan::{Figure, FigureKind, PaperSeconds, PaperValue, Test, TestKind};
pub use report::{Report, Section, figure, report};
pub use results::{Results, ResultsError};
pub use row::Row;
pub use spec::{Size, Study, VERSION};
