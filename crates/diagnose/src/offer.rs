//! Fit of the extended model, its out-of-sample gain, and its addition to the report unless it predicts worse.

use dataset::Role;
use flight::parallel;
use identify::{Fit, FlightEvidence, FlightId, fit};

use crate::context::Context;
use crate::error::DiagnosisError;
use crate::extension::ExtendedModel;
use crate::report::{self, Report};
use crate::validation::{ApplyTo, ChosenExtension, PredictiveGain, cross_validate, gain_of_fits};
use identify::LackOfFit;

/// An extended model with its fit and its out-of-sample gain.
pub(crate) struct MeasuredExtension {
    extension: ExtendedModel,
    fit: Fit,
    gain: Option<PredictiveGain>,
    chi2_decrease: f64,
    /// Held-out flights that are predicted without the added effects, which their first samples contradict.
    not_applied: Vec<usize>,
}

/// Fits the extended model and measures its gain. If `is_consensus`, flights that contradict the
/// effects are predicted without them. `noise_floor` is that of a coordinate, m.
pub(crate) fn measure(
    context: Context<'_>,
    before: &Fit,
    chosen: ChosenExtension,
    (is_consensus, noise_floor): (bool, f64),
) -> Result<MeasuredExtension, DiagnosisError> {
    let Context {
        model,
        dataset,
        options,
    } = context;
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
    let fit = match known_fit {
        Some(known) => known,
        None => fit(&extension.model, dataset, &options.fit)?,
    };
    let (mut not_applied, mut gain) = (Vec::new(), known_gain);
    if has_held_out {
        not_applied = apply_to.exceptions(before, &fit);
        gain = gain_of_fits(before, &fit, &not_applied, noise_floor);
    } else if gain.is_none() && !context.is_out_of_time() {
        let models = [(model, before), (&extension.model, &fit)];
        gain = cross_validate(models, dataset, &options.fit, apply_to, noise_floor);
    }
    Ok(MeasuredExtension {
        extension,
        fit,
        gain,
        chi2_decrease,
        not_applied,
    })
}

impl MeasuredExtension {
    /// Why predictions speak against the added effects; `None` if they do not. Weak effects, which are not significant
    /// themselves, must improve the predictions of most flights.
    pub fn objection(&self, is_weak: bool) -> Option<&'static str> {
        let gain = self.gain.as_ref()?;
        if gain.changes_nothing() {
            return Some("its fit predicts the same as the model without it");
        }
        if gain.contradicts() {
            return Some("it predicts other flights worse than the model without it");
        }
        let improves = gain.is_improvement() && gain.improved > gain.worsened;
        (is_weak && !improves).then_some(
            "it is not significant itself, and does not predict most other flights better",
        )
    }

    /// Adds fit and gain to the report. `None` if the extended model predicts worse.
    pub fn add_to(
        self,
        report: &mut Report,
        before: &Fit,
        context: Context<'_>,
    ) -> Option<(ExtendedModel, Fit)> {
        let is_worse = self.gain.as_ref().is_some_and(PredictiveGain::is_worse);
        report.predictive_gain = self.gain;
        if is_worse {
            report::note_not_offered(report, &self.extension);
            return None;
        }
        let (extension, fit) = (self.extension, self.fit);
        report::add_extension(report, (&extension, self.chi2_decrease), before, &fit);
        if report.consensus.is_some() {
            report::use_clustered_errors(report, &fit);
        }
        report::note_not_applied(report, &self.not_applied);
        let [was, is] = [before, &fit].map(|fit| evidence(context, fit));
        report.curves = report::curves(context.model, &was, &is);
        let residuals = LackOfFit::with_missing_term(&fit, context.options.fit.threads());
        report::add_residuals(report, residuals.ok().flatten());
        Some((extension, fit))
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
