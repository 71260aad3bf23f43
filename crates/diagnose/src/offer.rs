//! Fit of the extended model, measurement of its out-of-sample gain, and its addition to the report unless it
//! predicts worse.

use dataset::Role;
use flight::parallel;
use identify::{Fit, FlightEvidence, FlightId, fit};

use crate::context::Context;
use crate::error::{DiagnosisError, if_possible};
use crate::extension::ExtendedModel;
use crate::report::{self, Report};
use crate::validation::{ApplyTo, PredictiveGain, cross_validate, gain_of_fits};
use flight::parallel::join;
use identify::LackOfFit;

/// Model extended by the effects that the diagnosis chose, before its fit and out-of-sample gain are completed.
pub(crate) struct ChosenExtension {
    /// The extended model.
    pub extension: ExtendedModel,
    /// Fit of the extended model; `None` if not yet fitted.
    pub fit: Option<Fit>,
    /// Out-of-sample gain; `None` if not yet measured.
    pub gain: Option<PredictiveGain>,
    /// Decrease of the weighted sum of squares, χ², by effects created from library terms; 0 for other effects.
    pub chi2_decrease: f64,
}

/// An extended model with its fit and its out-of-sample gain.
pub(crate) struct MeasuredExtension<R> {
    extension: ExtendedModel,
    fit: Fit,
    gain: Option<PredictiveGain>,
    chi2_decrease: f64,
    /// Indices, in the dataset, of the held-out flights that are predicted without the added effects, because the first
    /// samples of these flights contradict the effects.
    not_applied: Vec<usize>,
    /// Result of the caller's function `on_extension` for the extended model.
    callback_result: R,
}

/// An extended model and its fit, with the result of the caller's function `on_extension` for the extended model.
pub(crate) type OfferedExtension<R> = ((ExtendedModel, Fit), R);

/// Fits the extended model if it is not yet fitted, measures its out-of-sample gain, and calls `on_extension` with the
/// extended model. If `is_consensus`, flights that contradict the added effects are predicted without them.
/// `noise_floor` is the standard deviation of the noise of one coordinate, m.
///
/// # Errors
/// [`DiagnosisError::Fit`] if the extended model cannot be fitted, or the caller cancelled.
pub(crate) fn measure<R: Send>(
    context: Context<'_>,
    before: &Fit,
    chosen: ChosenExtension,
    (is_consensus, noise_floor): (bool, f64),
    on_extension: &(impl Fn(&ExtendedModel) -> R + Sync),
) -> Result<MeasuredExtension<R>, DiagnosisError> {
    let Context {
        model,
        dataset,
        options,
    } = context;
    let threads = options.fit.threads();
    let apply_to = match is_consensus {
        true => ApplyTo::ConcordantFlights,
        false => ApplyTo::AllFlights,
    };
    let has_held_out = context.has_held_out();
    let ChosenExtension {
        extension,
        fit: known_fit,
        gain: known_gain,
        chi2_decrease,
    } = chosen;
    // The gain, the caller's result and the fit are independent of one another.
    let (cross_validated, (callback_result, after)) = join(
        threads,
        || match has_held_out || known_gain.is_some() || context.is_out_of_time() {
            true => Ok(known_gain.clone()),
            false => {
                let models = [model, &extension.model];
                cross_validate(models, dataset, &options.fit, apply_to, noise_floor)
            }
        },
        || {
            join(
                threads,
                || on_extension(&extension),
                || known_fit.map_or_else(|| fit(&extension.model, dataset, &options.fit), Ok),
            )
        },
    );
    let fit = after?;
    let (not_applied, gain) = match has_held_out {
        true => {
            let not_applied = apply_to.exceptions(before, &fit);
            let gain = gain_of_fits(before, &fit, &not_applied, noise_floor);
            (not_applied, gain)
        }
        false => (Vec::new(), cross_validated?),
    };
    Ok(MeasuredExtension {
        extension,
        fit,
        gain,
        chi2_decrease,
        not_applied,
        callback_result,
    })
}

impl<R> MeasuredExtension<R> {
    /// Why the predictions of flights that were not fitted speak against the added effects; `None` if they do not, or
    /// were not made.
    pub fn objection(&self) -> Option<&'static str> {
        let gain = self.gain.as_ref()?;
        if gain.changes_nothing() {
            return Some("its fit predicts the same as the model without it");
        }
        gain.contradicts()
            .then_some("it predicts other flights worse than the model without it")
    }

    /// Adds the fit of the extended model and its out-of-sample gain to the report. Returns the extended model, its fit
    /// and the result of `on_extension`; `None` if the extended model predicts worse than the model under test.
    ///
    /// # Errors
    /// [`DiagnosisError::Fit`] if the caller cancelled.
    pub fn add_to(
        self,
        report: &mut Report,
        before: &Fit,
        context: Context<'_>,
    ) -> Result<Option<OfferedExtension<R>>, DiagnosisError> {
        let is_worse = self.gain.as_ref().is_some_and(PredictiveGain::is_worse);
        report.predictive_gain = self.gain;
        if is_worse {
            report::note_not_offered(report, &self.extension);
            return Ok(None);
        }
        let (extension, fit) = (self.extension, self.fit);
        report::add_extension(report, (&extension, self.chi2_decrease), before, &fit);
        if report.consensus.is_some() {
            report::use_clustered_errors(report, &fit);
        }
        report::note_not_applied(report, &self.not_applied);
        let [was, is] = [before, &fit].map(|fit| evidence(context, fit));
        report.curves = report::curves(context.model, &was, &is);
        let residuals = LackOfFit::of_fit(&fit, context.options.fit.threads());
        report::add_residuals(report, if_possible(residuals)?.flatten());
        Ok(Some(((extension, fit), self.callback_result)))
    }
}

/// Measured and predicted samples of the flights that were used in the fit `fit`.
fn evidence(context: Context<'_>, fit: &Fit) -> Vec<FlightEvidence> {
    let flights = context.dataset.flights.iter().enumerate();
    let fitted = flights.filter(|(_, flight)| flight.role == Role::Fit);
    let fitted: Vec<FlightId> = fitted.map(|(index, _)| FlightId::new(index)).collect();
    let threads = context.options.fit.threads();
    let each = parallel::each_on(threads, fitted.len(), |k| fit.evidence(fitted[k]));
    each.into_iter().flatten().collect()
}
