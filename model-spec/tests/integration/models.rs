//! The models and effects of the repository are right, or wrong exactly where they are meant to be.

use model_spec::diagnostic::Kind;
use model_spec::load::{self, EFFECTS, MODELS, REFUTED};
use model_spec::model::{ExprKind, FrameKind, Model};
use model_spec::syntax::{self, ast::ItemKind};

fn states(model: &Model) -> Vec<&str> {
    model.states.iter().map(|s| s.name.as_str()).collect()
}

#[test]
fn every_model_is_right() {
    for (name, _) in MODELS {
        let model = load::load(name, &[]).unwrap_or_else(|e| panic!("{name}:\n{e}"));
        assert_eq!(model.name, *name);
        assert!(!model.checks.is_empty(), "{name} states no cases");
        assert!(model.observation.is_some());
    }
}

#[test]
fn every_effect_applies_to_some_model() {
    for (name, text) in EFFECTS {
        let parsed = syntax::parse(name, text);
        let [item] = &parsed.file.items[..] else {
            panic!("{name} is not one effect")
        };
        let ItemKind::Effect(effect) = &item.kind else {
            panic!("{name} is no effect")
        };
        assert_eq!(effect.name.text, *name);
        // By what a model has, and not by its name.
        assert!(effect.on.is_empty(), "{name}");
        let mut models = 0;
        for (model, _) in MODELS {
            let Ok(with) = load::load(model, &[name]) else {
                continue;
            };
            models += 1;
            let without = load::load(model, &[]).unwrap();
            assert_eq!(with.effects.len(), 1);
            let numbers = |model: &Model| model.coefficients.len() + model.states.len();
            assert!(numbers(&with) > numbers(&without));
            assert!(!with.effects[0].doc.is_empty());
        }
        assert!(models > 0, "{name} is for none");
    }
}

/// Names of the built-in effects that are applicable to the built-in model `model`.
fn effects_on(model: &str) -> Vec<&'static str> {
    let names = EFFECTS.iter().map(|(name, _)| *name);
    names
        .filter(|name| load::load(model, &[name]).is_ok())
        .collect()
}

#[test]
fn all_effects_apply_together_in_any_order() {
    for model in ["disc", "disc_quaternion", "discus", "ball"] {
        let mut names = effects_on(model);
        assert!(names.len() > 8, "{model}: {names:?}");
        for _ in 0..2 {
            let with = load::load(model, &names).unwrap_or_else(|e| panic!("{model}:\n{e}"));
            for effect in &with.effects {
                assert!(!effect.variables.is_empty(), "{}", effect.name);
                assert!(!effect.citation.is_empty(), "{}", effect.name);
                for own in &effect.states {
                    let name = &with.states[own.index].name;
                    assert!(
                        own.smallest_effect_of_interest.is_some_and(|n| n > 0.0),
                        "{name}"
                    );
                }
                for c in &effect.coefficients {
                    let name = &with.coefficients[c.index].name;
                    assert_eq!(c.null_value, 0.0, "{name}");
                    assert!(
                        c.smallest_effect_of_interest.is_some_and(|n| n > 0.0),
                        "{name}"
                    );
                }
            }
            names.reverse();
        }
    }
}

#[test]
fn the_printed_appendix_is_refused_for_four_equations() {
    let (name, _) = REFUTED[0];
    let loaded = load::inspect(name, &[]).unwrap();
    let lines: Vec<&str> = loaded
        .diagnostics
        .iter()
        .map(|d| {
            assert_eq!(d.kind, Kind::Unit);
            let text = &loaded.sources[0].text;
            let start = text[..d.span.range().start].rfind("der(").unwrap();
            &text[start..start + text[start..].find(" =").unwrap()]
        })
        .collect();
    assert_eq!(lines, ["der(u)", "der(v)", "der(w)", "der(phidot)"]);
    // What can still be said about it is said.
    let model = loaded.model.unwrap();
    assert_eq!(model.equations.len(), 12);
    assert!(load::load(name, &[]).is_err());
}

#[test]
fn states_come_in_the_order_that_is_promised() {
    let disc = load::load("disc", &[]).unwrap();
    let expected = [
        "x", "y", "z", "u", "v", "w", "phi", "theta", "gamma", "phidot", "thetadot", "gammadot",
    ];
    assert_eq!(states(&disc), expected);
    assert_eq!(states(&load::load("disc_appendix", &[]).unwrap()), expected);
    let quaternion = load::load("disc_quaternion", &[]).unwrap();
    let expected = [
        "x", "y", "z", "vx", "vy", "vz", "q0", "q1", "q2", "q3", "p", "q", "r",
    ];
    assert_eq!(states(&quaternion), expected);
    assert_eq!(quaternion.states[6].value, 1.0);
    assert!(quaternion.limits.is_empty());
}

#[test]
fn frames_know_their_states() {
    for name in ["disc", "disc_appendix"] {
        let model = load::load(name, &[]).unwrap();
        assert_eq!(
            model.frames[2].kind,
            FrameKind::Turned {
                parent: 1,
                angle: 7,
                rate: Some(10),
                axis: 2
            },
            "{name}"
        );
    }
}

#[test]
fn numbers_without_a_unit_are_pure_numbers() {
    let disc = load::load("disc", &[]).unwrap();
    let lift = disc.coefficients.iter().find(|c| c.name == "C_L0").unwrap();
    assert!(!lift.inferred);
    assert_eq!(lift.unit_text, "1");
    let force = disc
        .aux_variables
        .iter()
        .find(|l| l.name == "lift")
        .unwrap();
    assert_eq!(force.value.unit.tidy().to_string(), "kg*m/s^2");
}

#[test]
fn what_has_one_name_is_written_as_one_quantity() {
    // `der(phidot)` in the equation for `gammadot` is the same expression, not a copy of it.
    let model = load::load("disc_appendix", &[]).unwrap();
    let index = model
        .aux_variables
        .iter()
        .position(|l| l.name == "der_phidot")
        .unwrap();
    assert!(matches!(model.equations[9].value.kind, ExprKind::AuxVariable(i) if i == index));
}

#[test]
fn an_effect_keeps_its_vanishing_value() {
    let model = load::load("disc", &["zero-lift-drag-angle"]).unwrap();
    let effect = &model.effects[0];
    assert_eq!(
        (effect.name.as_str(), effect.site.as_str()),
        ("zero_lift_drag_angle", "drag")
    );
    let coefficient = effect.coefficients[0];
    assert_eq!(model.coefficients[coefficient.index].name, "alpha_0");
    assert_eq!(
        (
            coefficient.null_value,
            coefficient.smallest_effect_of_interest
        ),
        (0.0, Some(2e-4))
    );
    let drag = model
        .aux_variables
        .iter()
        .find(|l| l.name == "C_D")
        .unwrap();
    assert_eq!((drag.effect, drag.span.source), (Some(0), 1));
}

#[test]
fn loading_and_checking_is_quick() {
    let start = std::time::Instant::now();
    for (name, _) in MODELS {
        load::load(name, &[]).unwrap();
    }
    // A couple of milliseconds in release; this is only to catch something quadratic.
    assert!(start.elapsed().as_millis() < 1000);
}
