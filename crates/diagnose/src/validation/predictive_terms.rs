//! Number of library terms that improve out-of-sample predictions.

use super::cross_validation::out_of_sample_gain;
use crate::context::Context;
use crate::error::{DiagnosisError, if_possible};
use crate::selection::StepwiseModel;

/// Number of selected library terms that are retained, counted in the order of their selection. The first term is
/// always retained. A further term is retained if it reduces the out-of-sample prediction error by more than the
/// standard error of the reduction; the first term that does not, and all after it, are dropped. `noise_m` is the
/// standard deviation of the noise of one coordinate, m.
///
/// # Errors
/// [`DiagnosisError::Fit`] if the caller cancelled.
pub(crate) fn predictive_terms(
    context: Context<'_>,
    stepwise: &StepwiseModel,
    noise_m: f64,
) -> Result<usize, DiagnosisError> {
    let mut count = stepwise.fitted.len().min(1);
    for pair in stepwise.fitted.windows(2) {
        if context.is_out_of_time() {
            break;
        }
        let models = [&pair[0], &pair[1]].map(|terms| (&terms.extension.model, &terms.fit));
        let gain = if_possible(out_of_sample_gain(context, models, noise_m))?.flatten();
        if !gain.is_some_and(|gain| gain.is_improvement()) {
            break;
        }
        count += 1;
    }
    Ok(count)
}
