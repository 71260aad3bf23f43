//! Adds extended models and their fits to a report.

use identify::Fit;

use super::report_builder::{add_share, coefficients, note_convergence, verdict};
use super::types::{Estimate, Explanation, ExplanationEffect, Report};
use crate::context::display_name;
use crate::extension::ExtendedModel;
use crate::selection::{FittedTerms, Search};

/// Adds `terms` as a further explanation that the data do not distinguish from the others.
pub(crate) fn add_alternative(report: &mut Report, terms: &FittedTerms, search: &Search) {
    let chi2_decrease = (search.at_base.squares - terms.squares).max(0.0);
    let mut explanation = explanation(&terms.extension, &terms.fit, chi2_decrease);
    if let Some(residuals) = &report.lack_of_fit {
        add_share(&mut explanation, residuals);
    }
    report.explanations.push(explanation);
    report.verdict = verdict(true, &report.explanations);
}

/// Adds the fit of the extended model; without an explanation, its effects become one, with `chi2_decrease`.
pub(crate) fn add_extension(
    report: &mut Report,
    (extension, chi2_decrease): (&ExtendedModel, f64),
    before: &Fit,
    after: &Fit,
) {
    for (flight, after) in report.flights.iter_mut().zip(&after.report.flights) {
        flight.rms_after_m = after.position_rms();
    }
    report.coefficients = coefficients(after, Some(before));
    note_convergence(report, after, "the extended model");
    if report.explanations.is_empty() {
        report
            .explanations
            .push(explanation(extension, after, chi2_decrease));
    }
}

fn explanation(extension: &ExtendedModel, fit: &Fit, chi2_decrease: f64) -> Explanation {
    Explanation {
        effects: extension_effects(extension, fit),
        chi2_decrease,
        ..Explanation::default()
    }
}

fn extension_effects(extension: &ExtendedModel, after: &Fit) -> Vec<ExplanationEffect> {
    let effects = extension.model.effects.iter();
    let added = effects.filter(|effect| extension.effects.contains(&effect.name));
    let effects = added.map(|effect| {
        let estimates = effect.coefficients.iter().filter_map(|own| {
            let coefficient = &extension.model.coefficients[own.index];
            let found = after.report.coefficients.get(&coefficient.name)?;
            let estimate = Estimate {
                value: found.value,
                std_error: found.std_error,
                unit: coefficient.unit_text.clone(),
                smallest_effect_of_interest: own.smallest_effect_of_interest,
            };
            Some((coefficient.name.clone(), estimate))
        });
        ExplanationEffect {
            name: display_name(&effect.name),
            description: effect.doc.clone(),
            site: effect.site.clone(),
            variables: effect.variables.clone(),
            estimates: estimates.collect(),
            ..ExplanationEffect::default()
        }
    });
    effects.collect()
}

/// Uses cluster-robust standard errors where they are larger, as remaining misfit is correlated within a flight, and
/// the estimates of `after` in the first explanation.
pub(crate) fn use_clustered_errors(report: &mut Report, after: &Fit) {
    let fitted = |name: &str| {
        let found = after.report.coefficients.get(name)?;
        let clustered = found.std_error_cluster_robust.unwrap_or(0.0);
        Some((found.value, found.std_error.max(clustered)))
    };
    for (name, coefficient) in &mut report.coefficients {
        if let Some((_, std_error)) = fitted(name) {
            coefficient.std_error = std_error;
        }
    }
    let first = report.explanations.iter_mut().take(1);
    for effect in first.flat_map(|explanation| &mut explanation.effects) {
        for (name, estimate) in &mut effect.estimates {
            if let Some((value, std_error)) = fitted(name) {
                (estimate.value, estimate.std_error) = (value, std_error);
            }
        }
    }
}

/// Notes the held-out flights (dataset indices) that are predicted without the added effects.
pub(crate) fn note_not_applied(report: &mut Report, flights: &[usize]) {
    if flights.is_empty() {
        return;
    }
    for &flight in flights {
        let flight = &mut report.flights[flight];
        flight.rms_after_m = flight.rms_before_m;
    }
    let files = flights
        .iter()
        .map(|&flight| report.flights[flight].file.as_str());
    let files: Vec<&str> = files.collect();
    let note = format!(
        "held-out flights that contradict the extension in the segment on which their initial state is fitted, predicted without it: {}",
        files.join(", ")
    );
    report.notes.push(note);
}
