//! Number of library terms that improve out-of-sample predictions.

use identify::Fit;
use model_spec::model::Model;

use super::cross_validation::cross_validate;
use super::discordant_beginning::ApplyTo;
use super::predictive_gain::{PredictiveGain, held_out_gain};
use crate::context::Context;
use crate::error::{DiagnosisError, if_possible};
use crate::selection::{FittedTerms, StepwiseModel};

/// Number of selected library terms that are retained, counted in the order of their selection. The first term is
/// always retained. A further term is retained if it reduces the out-of-sample prediction error by more than the
/// standard error of the reduction; the first term that does not, and all after it, are dropped.
/// `noise_floor_m` is the noise of one coordinate, m.
///
/// # Errors
/// [`DiagnosisError::Fit`] if the caller cancelled.
pub(crate) fn predictive_terms(
    context: Context<'_>,
    stepwise: &StepwiseModel,
    noise_floor_m: f64,
) -> Result<usize, DiagnosisError> {
    let mut count = stepwise.fitted.len().min(1);
    for pair in stepwise.fitted.windows(2) {
        if context.is_out_of_time() {
            break;
        }
        let [fewer, more] = [&pair[0], &pair[1]].map(model_and_fit);
        let gain = gain(context, fewer, more, noise_floor_m)?;
        if !gain.is_some_and(|gain| gain.is_improvement()) {
            break;
        }
        count += 1;
    }
    Ok(count)
}

fn model_and_fit(terms: &FittedTerms) -> (&Model, &Fit) {
    (&terms.extension.model, &terms.fit)
}

fn gain(
    context: Context<'_>,
    fewer: (&Model, &Fit),
    more: (&Model, &Fit),
    noise_floor_m: f64,
) -> Result<Option<PredictiveGain>, DiagnosisError> {
    if context.has_held_out() {
        return Ok(held_out_gain(
            &fewer.1.report,
            &more.1.report,
            noise_floor_m,
        ));
    }
    let (models, options) = ([fewer.0, more.0], &context.options.fit);
    let all = ApplyTo::AllFlights;
    let found = cross_validate(models, context.dataset, options, all, noise_floor_m);
    Ok(if_possible(found)?.flatten())
}
