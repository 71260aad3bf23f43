//! Validation of overflexible hypotheses.
//!
//! A hypothesis with one value for each flight, or with many effects, can fit misfits of any origin. If it is true,
//! it also improves the prediction of flights that were not fitted.

use identify::{Fit, fit};

use super::cross_validation::out_of_sample_gain;
use super::predictive_gain::PredictiveGain;
use crate::context::{ScoreTestModel, identifier};
use crate::error::DiagnosisError;
use crate::extension::ExtendedModel;
use crate::selection::Hypothesis;

/// The model extended by the effects of a hypothesis, with its fit and out-of-sample gain.
pub(crate) struct Validated {
    /// The model extended by the effects of the hypothesis.
    pub extension: ExtendedModel,
    /// Fit of the extended model.
    pub fit: Fit,
    /// Reduction of the out-of-sample prediction error by the effects of the hypothesis; `None` if no flight can be
    /// predicted.
    pub gain: Option<PredictiveGain>,
}

impl Validated {
    /// Fits the model extended by the effects of a hypothesis and measures its out-of-sample gain.
    ///
    /// # Errors
    /// [`DiagnosisError`] if the effects cannot be combined, the flights cannot be fitted, or the caller cancelled.
    pub fn new(
        model: &ScoreTestModel<'_>,
        hypothesis: &Hypothesis,
        before: &Fit,
        noise_m: f64,
    ) -> Result<Self, DiagnosisError> {
        let context = model.context;
        let extension = hypothesis.extension(model)?;
        let fit = fit(&extension.model, context.dataset, &context.options.fit)?;
        let models = [(context.model, before), (&extension.model, &fit)];
        let gain = out_of_sample_gain(context, models, noise_m)?;
        Ok(Self {
            extension,
            fit,
            gain,
        })
    }

    /// Whether the effects of the hypothesis reduce the out-of-sample prediction error by more than the standard error
    /// of the reduction. True if no flight can be predicted.
    pub fn is_accepted(&self) -> bool {
        self.gain
            .as_ref()
            .is_none_or(PredictiveGain::is_improvement)
    }
}

impl Hypothesis {
    /// Extends the model under test by the effects of the hypothesis.
    ///
    /// # Errors
    /// [`DiagnosisError::Load`] if the effects cannot be combined.
    pub fn extension(&self, model: &ScoreTestModel<'_>) -> Result<ExtendedModel, DiagnosisError> {
        let effects = self.effects.iter();
        let names = effects.map(|&id| identifier(&model.candidate(id).name));
        let names: Vec<String> = names.collect();
        Ok(ExtendedModel::new(model.context.model, &names, &[])?)
    }
}
