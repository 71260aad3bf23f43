//! Every built-in effect agrees with its reference implementation; one with a changed sign does not.

use model_spec::load::{EFFECTS, from_text, inspect, load};
use model_spec::model::Model;
use oracle::effect;
use verify::Options;
use verify::checks::effect_reference::{EFFECT_REFERENCE, compare};
use verify::values::Values;

use crate::support::QUICK;

/// Names of the built-in models that are compared with a reference law.
const MODELS: [&str; 4] = ["disc", "disc_quaternion", "discus", "ball"];

fn error(model: &Model, options: &Options) -> f64 {
    let compared = compare(model, &Values::of(model), options).expect("a reference");
    compared.unwrap_or_else(|why| panic!("{why}")).error
}

#[test]
fn every_effect_has_a_reference_that_agrees() {
    for (name, _) in EFFECTS {
        assert!(
            effect::by_name(name).is_some(),
            "{name} has no reference: add its law to crates/oracle/src/effect"
        );
        let mut models = 0;
        for model in MODELS {
            let Ok(with) = load(model, &[name]) else {
                continue;
            };
            models += 1;
            let error = error(&with, &QUICK);
            assert!(error < 1e-12, "{name} on {model}: {error:e}");
        }
        assert!(models > 0, "{name} is for none of them");
    }
}

#[test]
fn all_at_once_agree_too() {
    for model in MODELS {
        let names = EFFECTS.iter().map(|(name, _)| *name);
        let names: Vec<&str> = names.filter(|name| load(model, &[name]).is_ok()).collect();
        assert!(names.len() > 10, "{model}: {names:?}");
        let with = load(model, &names).unwrap_or_else(|why| panic!("{model}: {why}"));
        let error = error(&with, &QUICK);
        assert!(error < 1e-12, "{model}: {error:e}");
    }
}

#[test]
fn the_row_has_each_effect_alone_and_all_together() {
    let load_all = |name: &str| {
        EFFECTS
            .iter()
            .filter(|e| load(name, &[e.0]).is_ok())
            .count()
    };
    for model in ["disc", "ball"] {
        let loaded = inspect(model, &[]).unwrap();
        let report = verify::run(&loaded, &QUICK);
        let row = report
            .rows
            .iter()
            .find(|row| row.check == EFFECT_REFERENCE)
            .unwrap();
        assert_eq!(row.cases, load_all(model) + 1, "{model}");
    }
}

#[test]
fn a_changed_effect_is_refuted() {
    // Every sign, and every factor of two, in the text of an effect.
    let mut tried = 0;
    for (name, text) in EFFECTS {
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
                let error = error(&with, &QUICK);
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
