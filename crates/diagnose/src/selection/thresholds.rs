//! Significance thresholds of the search.

/// Limits of log p-values, familywise over all tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Thresholds {
    /// Below it the model is not adequate.
    pub detect: f64,
    /// Below it a hypothesis is rejected.
    pub reject: f64,
}
