//! Significance thresholds of the specification search.

/// Thresholds of log p-values, familywise over all tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Thresholds {
    /// Log p-value below which a model error is detected.
    pub detect: f64,
    /// Log p-value below which a hypothesis is rejected.
    pub reject: f64,
}
