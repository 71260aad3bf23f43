//! Compares built-in effects with their reference implementations: derivatives and observation, each effect alone and
//! all together, with random coefficients within half their bounds. Coefficients of the model that the reference law
//! does not contain have their null values, and added states their defaults.

use super::bounded::{compare_observation, compare_rates};
use crate::options::{Options, TOLERANCE};
use crate::random::Random;
use crate::row::{Row, Worst};
use crate::sample;
use crate::subject::Equations;
use crate::values::Values;
use model_spec::load;
use model_spec::model::Model;
use oracle::effect::ExtendedReference;
use oracle::scalar::ErrorBound;
use oracle::{BindError, Point};

/// Name of this check in reports: built-in effects against their reference implementations.
pub const EFFECT_REFERENCE: &str = "effects: reference";

/// Compares the state derivatives and the observation of models with built-in effects with those of their reference
/// implementations. Models with other effects are left out. Each model comes with its compiled state derivatives and
/// observation.
pub fn check(with: &[(Model, Values)], options: &Options) -> Row {
    let catalogued: Vec<&(Model, Values)> =
        with.iter().filter(|(model, _)| catalogued(model)).collect();
    if catalogued.is_empty() {
        return Row::skipped(EFFECT_REFERENCE, "no built-in effects for this model");
    }
    let mut worst = Worst::default();
    for (model, engine) in catalogued.iter().copied() {
        match compare(model, engine, options) {
            Some(Ok(one)) => worst.update(one.error, || one.place),
            Some(Err(why)) => return Row::counted(EFFECT_REFERENCE, 1, &[why.to_string()], ""),
            None => return Row::skipped(EFFECT_REFERENCE, "the model claims no reference"),
        }
    }
    Row::judged(EFFECT_REFERENCE, catalogued.len(), &worst, TOLERANCE)
}

/// Maximum relative difference between the state derivatives and observation of a model with effects and those of its
/// reference implementation; `None` if the model names no reference law.
///
/// # Errors
/// [`BindError`] if the model cannot be bound to the reference, see [`ExtendedReference::bind`].
pub fn compare(
    model: &Model,
    equations: &dyn Equations,
    options: &Options,
) -> Option<Result<Worst, BindError>> {
    let reference = match ExtendedReference::bind(model)? {
        Ok(reference) => reference,
        Err(why) => return Some(Err(why)),
    };
    let names: Vec<&str> = model.effects.iter().map(|e| e.name.as_str()).collect();
    let names = names.join(" with ");
    let of_effects: Vec<usize> = model
        .effects
        .iter()
        .flat_map(|e| e.states.iter().map(|own| own.index))
        .collect();
    let mut own = model.added_states();
    own.retain(|state| !of_effects.contains(state));
    let mut random = Random::new(options.seed, "effects by hand");
    let mut worst = Worst::default();
    for _ in 0..options.cases.div_ceil(10) {
        let mut point = sample::point(model, &mut random);
        // The reference law does not contain terms added by the model's author.
        for (index, null_value) in reference.reference.null_values(model) {
            point.coefficients[index] = null_value;
        }
        for &state in &own {
            point.states[state] = model.states[state].value;
        }
        let point = at_work(model, point, &mut random);
        let lifted = point.lift::<ErrorBound>();
        let got = equations.rates(&point);
        let mut errors = |error, name| worst.update(error, || format!("{name} with {names}"));
        let expected = reference.derivatives(&lifted);
        compare_rates(model, &expected, &got, &own, &mut errors);
        if let Some(observed) = equations.observation(&point) {
            compare_observation(&reference.observation(&lifted), &observed, &mut errors);
        }
    }
    Some(Ok(worst))
}

/// Returns the point with the coefficients of effects set to random values within half of their bounds, because larger
/// values may make the inertia singular.
fn at_work(model: &Model, mut point: Point<f64>, random: &mut Random) -> Point<f64> {
    for c in model.effects.iter().flat_map(|e| &e.coefficients) {
        let (low, high) = model.coefficients[c.index].bounds.unwrap_or((-1.0, 1.0));
        point.coefficients[c.index] = random.between(low / 2.0, high / 2.0);
    }
    point
}

/// Whether every effect of the model is built in. The texts are compared, because a user's effect may have the name of
/// a built-in effect.
fn catalogued(model: &Model) -> bool {
    let built_in = |name: &str| {
        let text = load::EFFECTS.iter().find(|(n, _)| *n == name);
        text.is_some_and(|(_, text)| model.sources.iter().any(|source| source.text == *text))
    };
    model.effects.iter().all(|effect| built_in(&effect.name))
}
