//! A model compiled at given values of some parameters is the model, evaluated there.

use crate::support::{Random, point, zoo};
use codegen::program::Function;
use codegen::tape::{Inputs, Tape};
use codegen::{Compiled, Effort, Selection, compile, compile_at};
use model_spec::load::{EFFECTS, load};
use model_spec::model::Model;

/// A built-in model with every applicable built-in effect applied.
fn with_all_effects(name: &str) -> Model {
    let names = EFFECTS.iter().map(|(effect, _)| *effect);
    let names: Vec<&str> = names
        .filter(|effect| load(name, &[effect]).is_ok())
        .collect();
    load(name, &names).expect("they go together")
}

/// For each coefficient that an effect added to the model: its index in the parameter vector, and its null value, at
/// which the effect is absent.
fn vanishing(model: &Model, compiled: &Compiled) -> Vec<(usize, f64)> {
    let own = model.effects.iter().flat_map(|e| &e.coefficients);
    own.map(|c| (compiled.layout.coefficient(c.index).index(), c.null_value))
        .collect()
}

/// Names and values of all outputs of a function at the states `x` and parameters `p`; matrices are written out with
/// all entries, structural zeros included.
fn full(compiled: &Compiled, function: &Function, x: &[f64], p: &[f64]) -> Vec<(String, f64)> {
    let run = |function: &Function, prepared: &[f64]| {
        let mut out = vec![0.0; function.program.outputs.len()];
        let inputs = Inputs {
            t: 0.3,
            x,
            p,
            prepared,
            marker: &[0.1, -0.03, 0.02],
        };
        Tape::new(&function.program).eval(inputs, &mut Vec::new(), &mut out);
        out
    };
    let prepared = run(&compiled.prepare, &[]);
    let values = run(function, &prepared);
    let mut results = Vec::new();
    let mut values = values.into_iter();
    let (states, parameters) = (x.len(), p.len());
    for section in &function.sections {
        let taken: Vec<f64> = values.by_ref().take(section.len).collect();
        let Some(pattern) = &section.pattern else {
            let all = taken.iter().enumerate();
            results.extend(all.map(|(k, &value)| (format!("{} {k}", section.name), value)));
            continue;
        };
        let columns = match section.name {
            "j" | "dy_dx" => states,
            "dy_dmarker" => 3,
            _ => parameters,
        };
        for row in 0..states {
            for column in 0..columns {
                let at = |&(r, c): &(u32, u32)| (r as usize, c as usize) == (row, column);
                let value = pattern.iter().position(at).map_or(0.0, |k| taken[k]);
                results.push((format!("{} ({row}, {column})", section.name), value));
            }
        }
    }
    results
}

/// Checks that the functions of `at`, compiled with the `fixed` parameters (index, value) as constants, agree with
/// those of `whole` for random states and parameters. Parameters that are not fixed are near their defaults.
fn check(whole: &Compiled, fixed: &[(usize, f64)], at: &Compiled, random: &mut Random) {
    let (at_rest, falling) = singular(whole);
    for k in 0..20 {
        let (mut x, mut p) = point(whole, random);
        match k {
            0 => x.clone_from(&at_rest),
            1 => x.clone_from(&falling),
            _ => {}
        }
        // what stands in the places of fixed parameters is not read
        let mut unread = p.clone();
        for &(place, value) in fixed {
            p[place] = value;
            unread[place] = f64::NAN;
        }
        for (known, function) in whole.functions().into_iter().zip(at.functions()).skip(1) {
            let known = full(whole, known, &x, &p);
            let got = full(at, function, &x, &unread);
            assert_eq!(known.len(), got.len(), "{}", function.name);
            let rows = known.chunk_by(|a, b| row(&a.0) == row(&b.0));
            let sizes = rows.flat_map(|row| {
                let size = row.iter().fold(0.0_f64, |m, (_, v)| m.max(v.abs()));
                row.iter().map(move |_| size)
            });
            for (((place, a), (_, b)), size) in known.iter().zip(&got).zip(sizes) {
                assert!(
                    (a - b).abs() <= 1e-12 * size.max(a.abs()).max(1e-9),
                    "{} {place}: {a}, but {b} at these values",
                    function.name
                );
            }
        }
    }
}

/// Two states at which norms, directions and quotients may be singular: the default state, and this state with a
/// vertical velocity of -4 m/s.
fn singular(compiled: &Compiled) -> (Vec<f64>, Vec<f64>) {
    let at_rest: Vec<f64> = compiled.layout.default_states();
    let mut falling = at_rest.clone();
    for (state, name) in falling.iter_mut().zip(&compiled.layout.states) {
        if ["w", "vz"].contains(&name.as_str()) {
            *state = -4.0;
        }
    }
    (at_rest, falling)
}

fn row(place: &str) -> &str {
    place.split(',').next().unwrap_or(place)
}

#[test]
fn effects_that_vanish() {
    let mut random = Random(5);
    for name in ["disc", "disc_quaternion", "discus", "ball"] {
        let model = with_all_effects(name);
        let whole = compile(&model);
        let fixed = vanishing(&model, &whole);
        for effort in [Effort::Full, Effort::Quick] {
            let at = compile_at(&model, &Selection::All, &fixed, effort);
            check(&whole, &fixed, &at, &mut random);
        }
    }
}

#[test]
fn one_effect_that_does_not_vanish() {
    let model = with_all_effects("disc");
    let whole = compile(&model);
    let vanishing = vanishing(&model, &whole);
    for k in 0..vanishing.len() {
        // The same points for each effect: another effect in the catalogue moves none of them.
        let mut random = Random(6);
        let mut fixed = vanishing.clone();
        fixed[k].1 += 0.07;
        let at = compile_at(&model, &Selection::All, &fixed, Effort::Quick);
        check(&whole, &fixed, &at, &mut random);
    }
}

#[test]
fn any_parameter_of_any_function() {
    let mut random = Random(8);
    let model = zoo();
    let whole = compile(&model);
    let defaults = whole.layout.default_parameters();
    for (place, &default) in defaults.iter().enumerate() {
        for value in [0.0, 1.0, -0.4, default] {
            // it is divided by
            if value == 0.0 && whole.layout.parameters[place] == "tau" {
                continue;
            }
            let fixed = [(place, value)];
            let at = compile_at(&model, &Selection::All, &fixed, Effort::Full);
            check(&whole, &fixed, &at, &mut random);
        }
    }
}

#[test]
fn what_vanishes_is_gone() {
    let model = with_all_effects("disc");
    let whole = compile(&model);
    let fixed = vanishing(&model, &whole);
    let at = compile_at(&model, &Selection::All, &fixed, Effort::Quick);
    let plain = compile(&load("disc", &[]).expect("the disc"));
    let operations = |compiled: &Compiled, name| compiled.count(name).total();
    assert!(operations(&at, "f") <= operations(&plain, "f") + 10);
    let (mine, known) = (
        operations(&at, "f_jac_par"),
        operations(&whole, "f_jac_par"),
    );
    assert!(2 * mine < known, "{mine} of {known} operations are left");
}

#[test]
fn nothing_fixed_is_the_model_as_it_is() {
    let model = with_all_effects("disc");
    let (whole, at) = (
        compile(&model),
        compile_at(&model, &Selection::All, &[], Effort::Full),
    );
    assert!(whole.functions().into_iter().eq(at.functions()));
}
