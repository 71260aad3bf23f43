//! Checks of effects. At null values, a model with effects must have the derivatives of the model without effects, and
//! with the null values substituted it must compile to no more operations. At random values, derivatives and observation
//! must be those of the oracle, which evaluates the text of the effects without the compiler.

use super::precision::{Finding, Tally};
use super::reference;
use crate::engine::Values;
use crate::expressions::fix_effects;
use crate::options::Options;
use crate::pairing::Pairing;
use crate::random::Random;
use crate::row::{Row, Verdict, Worst};
use crate::sample;
use crate::subject::Equations;
use model_spec::Layout;
use model_spec::compose::{Origin, known_effects};
use model_spec::load::{Loaded, from_text};
use model_spec::model::Model;
use oracle::scalar::ErrorBound;
use oracle::{Point, derivatives};

/// Maximum number of further points for an effect with which the law overflows at all points so far.
const FURTHER: usize = 20;

/// Name of this check in reports: effects at their null values change nothing.
pub const EFFECTS: &str = "effects at null values";
/// Name of this check in reports: effects against the oracle's evaluation of their text.
pub const EFFECT_REFERENCE: &str = "effects: reference";

/// A model with effects, and its compiled state derivatives and observation.
pub struct Variant {
    /// The model, with at least one effect.
    pub model: Model,
    /// Compiled state derivatives and observation of the model.
    pub values: Values,
}

impl Variant {
    /// Compiles the state derivatives and the observation of a model with effects.
    pub fn new(model: Model) -> Self {
        let values = Values::of(&model);
        Self { model, values }
    }

    fn names(&self) -> String {
        let names = self.model.effects.iter().map(|e| e.name.as_str());
        names.collect::<Vec<_>>().join(" with ")
    }
}

/// Both checks of effects: of the loaded model if it has effects, else of models with each effect that can be added,
/// and with all of these that are not declared in the model file.
pub fn rows(loaded: &Loaded, options: &Options) -> [Row; 2] {
    let without = loaded
        .sources
        .first()
        .and_then(|source| from_text(&source.name, &source.text, &[]).ok());
    match without {
        Some(without) => {
            let with = variants(loaded, &without);
            let with = flight::parallel::each(with.len(), |k| Variant::new(with[k].clone()));
            [
                check(&without, &with, options),
                against_oracle(&with, options),
            ]
        }
        None => {
            [EFFECTS, EFFECT_REFERENCE].map(|name| Row::unverified(name, "the model is refused"))
        }
    }
}

/// Models with effects that are checked, see [`rows`].
fn variants(loaded: &Loaded, without: &Model) -> Vec<Model> {
    if let Some(model) = loaded.model.as_ref().filter(|m| !m.effects.is_empty()) {
        return vec![model.clone()];
    }
    let source = &loaded.sources[0];
    let apply = |with: &[&str]| from_text(&source.name, &source.text, with).ok();
    // A refused effect is for another kind of model, or is a duplicate of another effect.
    let mut known = known_effects(without);
    known.retain(|known| known.refused.is_none());
    let alone = flight::parallel::each(known.len(), |k| apply(&[known[k].effect.name()]));
    let can_be_added = known
        .iter()
        .zip(&alone)
        .filter(|(_, model)| model.is_some());
    let together = can_be_added.filter(|(known, _)| known.origin != Origin::Own);
    let together: Vec<&str> = together.map(|(known, _)| known.effect.name()).collect();
    let together = (together.len() > 1).then(|| apply(&together));
    let together = together.flatten();
    alone.into_iter().flatten().chain(together).collect()
}

fn check(without: &Model, with: &[Variant], options: &Options) -> Row {
    if with.is_empty() {
        return Row::skipped(EFFECTS, "no effects for this model");
    }
    let plain = Values::of(without);
    let mut random = Random::new(options.seed, "effects off");
    let mut tally = Tally::default();
    let mut faults = Vec::new();
    for variant in with {
        let (model, names) = (&variant.model, variant.names());
        let pairing = Pairing::of(&Layout::new(model), &Layout::new(without));
        for _ in 0..options.cases.div_ceil(10) {
            let point = off(model, sample::point(model, &mut random));
            if !pairing.is_complete() {
                faults.push(format!("{names}: the model without it has other names"));
                break;
            }
            let bare = pairing.carry(&point, &Point::defaults(without));
            let sizes = derivatives(model, &point.lift::<ErrorBound>()).unwrap_or_default();
            let rates = variant.values.rates(&point);
            let expected = plain.rates(&bare);
            let mut errors = Worst::default();
            for ((rate, expected), size) in rates.iter().zip(&expected).zip(sizes) {
                let error = ErrorBound {
                    value: *expected,
                    ..size
                }
                .relative_error(*rate);
                errors.update(error, || format!("with {names}"));
            }
            tally.add_point(model, &point, errors);
        }
        let mut fixed = model.clone();
        fix_effects(&mut fixed);
        let (was, is) = (plain.operations(), Values::of(&fixed).operations());
        if is > was {
            faults.push(format!(
                "{names}: off, it takes {is} operations instead of {was}"
            ));
        }
    }
    let points = options.cases.div_ceil(10) * with.len();
    let row = tally.row(EFFECTS, with.len(), points);
    if faults.is_empty() {
        return row;
    }
    Row {
        verdict: Verdict::Refuted,
        detail: faults.join("\n"),
        ..row
    }
}

/// Compares state derivatives and observation with those of the oracle. Coefficients of effects are within half of
/// their bounds, because larger values may make the inertia singular.
pub fn against_oracle(with: &[Variant], options: &Options) -> Row {
    if with.is_empty() {
        return Row::skipped(EFFECT_REFERENCE, "no effects for this model");
    }
    let mut random = Random::new(options.seed, EFFECT_REFERENCE);
    let mut tally = Tally::default();
    let least = options.cases.div_ceil(10);
    let mut points = least;
    for variant in with {
        let (model, names) = (&variant.model, variant.names());
        let (mut drawn, mut compared) = (0, 0);
        while drawn < least || compared == 0 && drawn < least + FURTHER {
            drawn += 1;
            let mut point = sample::point(model, &mut random);
            for c in model.effects.iter().flat_map(|e| &e.coefficients) {
                let (low, high) = model.coefficients[c.index].bounds.unwrap_or((-1.0, 1.0));
                point.coefficients[c.index] = random.between(low / 2.0, high / 2.0);
            }
            let mut overflows = false;
            let errors = |finding, name| {
                overflows |= matches!(finding, Finding::Overflow);
                tally.add(finding, || format!("{name} with {names}"));
            };
            if let Err(why) = reference::with_tree(model, &variant.values, &point, errors) {
                return Row::unverified(EFFECT_REFERENCE, why.to_string());
            }
            compared += usize::from(!overflows);
        }
        points = points.max(drawn);
    }
    tally.row(EFFECT_REFERENCE, with.len(), points)
}

fn off(model: &Model, mut point: Point<f64>) -> Point<f64> {
    for c in model.effects.iter().flat_map(|e| &e.coefficients) {
        point.coefficients[c.index] = c.null_value;
    }
    for own in model.effects.iter().flat_map(|e| &e.states) {
        point.states[own.index] = own.null_value;
    }
    point
}
