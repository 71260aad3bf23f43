//! The text of every effect agrees with its hand-written formula; one with a changed sign does not.

use model_spec::load::{EFFECTS, from_text, load};
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::scalar::{ErrorBound, Real};
use oracle::{Point, Reference, Tree, derivatives_of};
use studies::seeded::law::{ActiveEffect, Effect, ExtendedLaw, all, by_name};
use verify::random::Random;
use verify::sample;

/// Names of the built-in models that name a law of motion.
const MODELS: [&str; 4] = ["disc", "disc_quaternion", "discus", "ball"];

/// Number of random points at which a text and its formula are compared; far from the ground, some effects vanish.
const POINTS: usize = 12;

/// The law of motion of a model with the hand-written effects, and the values of a point.
fn by_hand<T: Real>(model: &Model, reference: &Reference, point: &Point<T>) -> ExtendedLaw<T> {
    let value = |name: &str| {
        let coefficient = model.coefficients.iter().position(|c| c.name == name);
        let state = || model.states.iter().position(|s| s.name == name);
        coefficient.map_or_else(
            || point.states[state().expect("a value of the effect")],
            |index| point.coefficients[index],
        )
    };
    let effects = model.effects.iter().map(|applied| {
        let effect = by_name(&applied.name).expect("a hand-written formula");
        assert!(effect.laws.contains(&reference.law), "{}", applied.name);
        let names = effect.coefficients.iter().chain(effect.states);
        ActiveEffect {
            effect,
            values: names.map(|name| value(name)).collect(),
        }
    });
    ExtendedLaw {
        law: reference.law,
        constants: reference.values(point),
        wind: reference.wind(point),
        omega: input(model, "omega", point),
        effects: effects.collect(),
    }
}

fn input<T: Real>(model: &Model, name: &str, point: &Point<T>) -> Vector3<T> {
    let index = model.inputs.iter().position(|input| input.name == name);
    index.map_or_else(Vector3::zeros, |index| point.inputs[index])
}

/// Maximum difference between the state derivatives and the observation from the text of a model and from the
/// hand-written formulas, relative to the sum of the magnitudes of the terms.
fn error(model: &Model) -> f64 {
    let reference = Reference::bind(model)
        .expect("a law")
        .expect("its constants");
    let mut random = Random::new(1, "effects by hand");
    let mut worst = 0.0_f64;
    for _ in 0..POINTS {
        let mut point = sample::point(model, &mut random);
        for (index, null_value) in reference.null_values(model) {
            point.coefficients[index] = null_value;
        }
        // Within half of the bounds, because larger values may make the inertia singular.
        for c in model.effects.iter().flat_map(|e| &e.coefficients) {
            let (low, high) = model.coefficients[c.index].bounds.unwrap_or((-1.0, 1.0));
            point.coefficients[c.index] = random.between(low / 2.0, high / 2.0);
        }
        let lifted = point.lift::<ErrorBound>();
        let law = by_hand(model, &reference, &lifted);
        let chart = &reference.chart;
        let at = chart.physical(&lifted.states);
        let rates = chart.derivatives(&lifted.states, &law.motion(&at, lifted.time));
        let clock = law.clock();
        let mut expected: Vec<ErrorBound> = rates.into_iter().map(|rate| rate * clock).collect();
        let which = input(model, "marker_is", &lifted);
        expected.extend(law.observation(&at, lifted.marker, which).iter());
        let tree = Tree::new(model, &point);
        let mut found = derivatives_of(&tree).expect("equations of motion");
        let observed = model.observation.as_ref().expect("an observation");
        found.extend(tree.vector(&observed.value).iter());
        assert_eq!(expected.len(), found.len());
        for (expected, found) in expected.iter().zip(found) {
            worst = worst.max(expected.relative_error(found));
        }
    }
    worst
}

fn effects_of(model: &str) -> Vec<&'static str> {
    let names = all().map(|effect| effect.name);
    names.filter(|name| load(model, &[name]).is_ok()).collect()
}

#[test]
fn every_formula_is_that_of_a_text_of_the_catalogue() {
    for Effect { name, .. } in all() {
        let mut models = 0;
        for model in MODELS {
            let Ok(with) = load(model, &[name]) else {
                continue;
            };
            models += 1;
            let error = error(&with);
            assert!(error < 1e-12, "{name} on {model}: {error:e}");
        }
        assert!(models > 0, "{name} is for none of them");
    }
}

#[test]
fn all_at_once_agree_too() {
    for model in MODELS {
        let names = effects_of(model);
        assert!(names.len() > 10, "{model}: {names:?}");
        let with = load(model, &names).unwrap_or_else(|why| panic!("{model}: {why}"));
        let error = error(&with);
        assert!(error < 1e-12, "{model}: {error:e}");
    }
}

#[test]
fn a_changed_text_is_refuted() {
    // Every sign, and every factor of two, in the text of an effect.
    let mut tried = 0;
    for (name, text) in EFFECTS.iter().filter(|(name, _)| by_name(name).is_some()) {
        for (at, mark) in text.match_indices(['+', '-', '*']) {
            // The law; not documentation, units, bounds.
            let line = &text[text[..at].rfind('\n').map_or(0, |i| i + 1)..at];
            let line = line.trim_start();
            let of_law = ["replace", "let", "force", "cos(", "sin("];
            let of_law = of_law.iter().any(|word| line.starts_with(word));
            if !of_law || line.contains('[') {
                continue;
            }
            let changed = match mark {
                "+" => "-",
                "-" => "+",
                _ => "*2*",
            };
            let changed = format!("{}{changed}{}", &text[..at], &text[at + 1..]);
            for model in MODELS {
                let base = model_text(model);
                let Ok(with) = from_text(model, &(base + &changed), &[name]) else {
                    continue;
                };
                tried += 1;
                let error = error(&with);
                assert!(error > 1e-9, "{model} with\n{changed}\n{error:e}");
                break;
            }
        }
    }
    assert!(tried > 100, "{tried}");
}

fn model_text(name: &str) -> String {
    let found = model_spec::load::MODELS.iter().find(|(n, _)| *n == name);
    found.expect("a built-in model").1.to_owned()
}
