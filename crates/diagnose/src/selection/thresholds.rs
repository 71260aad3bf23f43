//! Significance thresholds of the specification search.

/// Thresholds of the natural logarithm of p-values. Under the null hypothesis, the smallest p-value of all tests falls
/// below a threshold with the probability that was chosen as its familywise significance level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Thresholds {
    /// A model error is detected if the log p-value of a candidate effect or library term, tested at the fit of the
    /// model under test, is below this threshold.
    pub detect: f64,
    /// A hypothesis is rejected if, once its effects are included in the model, the log p-value of a further candidate
    /// effect or of a library term is below this threshold.
    pub reject: f64,
}
