//! How one case of a cases file came out.

/// The verdict on one case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaseVerdict {
    /// The case's name.
    pub id: String,
    /// What was expected and what came out, when they differ.
    pub fault: Option<String>,
}
