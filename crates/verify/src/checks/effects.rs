//! Checks effects at null values: a model whose effects have null coefficients and states must have the derivatives of
//! the model without effects. With the null values substituted it must compile to no more operations.

use crate::expressions::{fix_coefficient, fix_state};
use crate::options::{Options, TOLERANCE};
use crate::random::Random;
use crate::row::{Row, Verdict, Worst};
use crate::sample;
use crate::subject::{Equations, carry_by_name};
use crate::values::Values;
use model_spec::compose::{Origin, known_effects};
use model_spec::load::{Loaded, from_text};
use model_spec::model::Model;
use oracle::scalar::ErrorBound;
use oracle::{Point, derivatives};

/// Name of this check in reports: a model with effects at their null values must compute the same as the model without
/// effects.
pub const EFFECTS: &str = "effects at null values";

/// Returns (models with effects, model without effects); effects are optional model extensions. If the loaded model has
/// effects, it is the only model with effects. Otherwise one model is built for each effect that can be added. A
/// further model combines all of these effects that are not declared in the model file. Another one combines only the
/// built-in effects written for the family of models to which this model belongs, such as flying discs: these effects
/// have reference implementations. `None` if the source does not load without effects.
pub fn variants(loaded: &Loaded) -> Option<(Vec<Model>, Model)> {
    let source = loaded.sources.first()?;
    let apply = |with: &[&str]| from_text(&source.name, &source.text, with).ok();
    let without = apply(&[])?;
    if let Some(model) = loaded.model.as_ref().filter(|m| !m.effects.is_empty()) {
        return Some((vec![model.clone()], without));
    }
    // A refused effect is for another kind of model, or is a duplicate of another effect.
    let mut known = known_effects(&without);
    known.retain(|known| known.refused.is_none());
    let models = flight::parallel::each(known.len(), |index| apply(&[known[index].effect.name()]));
    let (mut alone, mut together, mut specific) = (Vec::new(), Vec::new(), Vec::new());
    for (known, model) in known.iter().zip(models) {
        let Some(model) = model else {
            continue;
        };
        alone.push(model);
        let name = known.effect.name().to_owned();
        if known.origin == Origin::Specific {
            specific.push(name.clone());
        }
        if known.origin != Origin::Own {
            together.push(name);
        }
    }
    if specific == together {
        specific.clear();
    }
    for several in [together, specific] {
        let names: Vec<&str> = several.iter().map(String::as_str).collect();
        if names.len() > 1 {
            alone.extend(apply(&names));
        }
    }
    Some((alone, without))
}

/// Checks for each model of `with` that its effects change nothing at their null values. The state derivatives must
/// equal those of the model `without` effects, and be computed with no more operations. Each model comes with its
/// compiled state derivatives and observation.
pub fn check(without: &Model, with: &[(Model, Values)], options: &Options) -> Row {
    if with.is_empty() {
        return Row::skipped(EFFECTS, "no effects for this model");
    }
    let plain = Values::of(without);
    let mut random = Random::new(options.seed, "effects off");
    let mut worst = Worst::default();
    let mut faults = Vec::new();
    for (model, engine) in with {
        let names: Vec<&str> = model.effects.iter().map(|e| e.name.as_str()).collect();
        let names = names.join(" with ");
        for _ in 0..options.cases.div_ceil(10) {
            let point = off(model, sample::point(model, &mut random));
            let Some(bare) = bare(without, model, &point) else {
                faults.push(format!("{names}: the model without it has other names"));
                break;
            };
            let sizes = derivatives(model, &point.lift::<ErrorBound>()).unwrap_or_default();
            let rates = engine.rates(&point);
            let expected = plain.rates(&bare);
            for ((rate, expected), size) in rates.iter().zip(&expected).zip(sizes) {
                let error = ErrorBound {
                    value: *expected,
                    ..size
                }
                .relative_error(*rate);
                worst.update(error, || format!("with {names}"));
            }
        }
        let mut fixed = model.clone();
        for c in model.effects.iter().flat_map(|e| &e.coefficients) {
            fix_coefficient(&mut fixed, c.index, c.null_value);
        }
        for own in model.effects.iter().flat_map(|e| &e.states) {
            fix_state(&mut fixed, own.index, own.null_value);
        }
        let (was, is) = (plain.operations(), Values::of(&fixed).operations());
        if is > was {
            faults.push(format!(
                "{names}: off, it takes {is} operations instead of {was}"
            ));
        }
    }
    let row = Row::judged(EFFECTS, with.len(), &worst, TOLERANCE);
    if faults.is_empty() {
        return row;
    }
    Row {
        verdict: Verdict::Refuted,
        detail: faults.join("\n"),
        ..row
    }
}

/// Returns the point with all coefficients and states of the model's effects at their null values, at which the effects
/// do not act.
fn off(model: &Model, mut point: Point<f64>) -> Point<f64> {
    for c in model.effects.iter().flat_map(|e| &e.coefficients) {
        point.coefficients[c.index] = c.null_value;
    }
    for own in model.effects.iter().flat_map(|e| &e.states) {
        point.states[own.index] = own.null_value;
    }
    point
}

/// Converts a point of the model `with` effects to a point of the model `without` effects, by the names of states,
/// parameters, coefficients and inputs. `None` if a name is missing in the model with effects.
fn bare(without: &Model, with: &Model, point: &Point<f64>) -> Option<Point<f64>> {
    let mut bare = Point::defaults(without);
    bare.time = point.time;
    bare.marker = point.marker;
    if !carry_by_name(with, point, without, &mut bare) {
        return None;
    }
    for (state, to) in without.states.iter().zip(&mut bare.states) {
        *to = point.states[with.states.iter().position(|s| s.name == state.name)?];
    }
    Some(bare)
}
