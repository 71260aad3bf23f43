//! Fits and diagnoses the ball with effects of the catalogue and of this study.

use dataset::Dataset;
use diagnose::Report as Diagnosis;
use diagnose::{DiagnosisError, DiagnosisOptions, diagnose};
use identify::{FitOptions, FitReport, fit};
use model_spec::compose::{EffectTree, ModelTree};
use model_spec::model::Model;

use crate::error::StudyError;

/// Name of the effect that gives each flight its individual, constant lift vector, independent of the spin.
pub(super) const LIFT_OF_EACH_FLIGHT: &str = "lift_of_each_flight";

/// Name of the effect that adds a lift proportional to the square of the advance ratio.
pub(super) const MAGNUS_BY_SQUARE: &str = "magnus_by_square";

/// Names and definitions (in the model language) of the effects that only this study uses.
const OWN_EFFECTS: [(&str, &str); 2] = [
    (
        LIFT_OF_EACH_FLIGHT,
        include_str!("effects/lift_of_each_flight.hyz"),
    ),
    (
        MAGNUS_BY_SQUARE,
        include_str!("effects/magnus_by_square.hyz"),
    ),
];

/// Combines a model with effects, given by name. An effect is defined in [`OWN_EFFECTS`] or in the built-in effects
/// catalogue.
pub(super) fn with_effects(model: &Model, effects: &[&str]) -> Result<Model, StudyError> {
    let mut tree = ModelTree::of(model);
    for name in effects {
        let own = OWN_EFFECTS.iter().find(|(own, _)| own == name);
        let effect = match own {
            Some((name, text)) => EffectTree::parse(name, text)?,
            None => tree.find_effect(name)?,
        };
        tree = tree.with(&effect)?;
    }
    Ok(tree.check()?)
}

/// Fits a ball model, extended by the effects (optional model extensions) named in `effects`, to the flights.
pub(super) fn fitted(
    model: &Model,
    flights: &Dataset,
    effects: &[&str],
) -> Result<FitReport, StudyError> {
    let model = with_effects(model, effects)?;
    Ok(fit(&model, flights, &FitOptions::default())?.report)
}

/// Diagnoses the flights with a ball model that is extended by the effects named in `with`. The outer error means that
/// the model cannot be built; the inner error is that of a failed diagnosis, which is printed on the page of results.
pub(super) fn diagnosed(
    model: &Model,
    flights: &Dataset,
    with: &[String],
) -> Result<Result<Diagnosis, DiagnosisError>, StudyError> {
    let names: Vec<&str> = with.iter().map(String::as_str).collect();
    let model = with_effects(model, &names)?;
    let asked = DiagnosisOptions {
        dataset: "spindoe",
        ..DiagnosisOptions::default()
    };
    Ok(diagnose(&model, flights, &asked).map(|found| found.report))
}
