//! Significance thresholds of the specification search.

/// Thresholds of the natural logarithm of p-values. Under the null hypothesis, the smallest p-value of all tests falls
/// below a threshold with the probability that was chosen as its familywise significance level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Thresholds {
    /// Log p-value below which a model error is detected.
    pub detect: f64,
    /// Log p-value below which a hypothesis (set of missing effects) is rejected.
    pub reject: f64,
}
