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

/// Section, row and column of an output.
type Place = (&'static str, usize, usize);

/// The functions of a compiled model, as tapes.
struct Tapes<'c> {
    compiled: &'c Compiled,
    prepare: Tape,
    functions: Vec<(&'c Function, Tape)>,
}

impl<'c> Tapes<'c> {
    fn new(compiled: &'c Compiled) -> Self {
        let functions = compiled.functions().into_iter().skip(1);
        Self {
            compiled,
            prepare: Tape::new(&compiled.prepare.program),
            functions: functions
                .map(|function| (function, Tape::new(&function.program)))
                .collect(),
        }
    }

    /// Places and values of all outputs of each function at the states `x` and parameters `p`; matrices are written out
    /// with all entries, structural zeros included.
    fn full(&self, x: &[f64], p: &[f64]) -> Vec<(&str, Vec<(Place, f64)>)> {
        let run = |tape: &Tape, prepared: &[f64], outputs: usize| {
            let mut out = vec![0.0; outputs];
            let inputs = Inputs {
                t: 0.3,
                x,
                p,
                prepared,
                marker: &[0.1, -0.03, 0.02],
            };
            tape.eval(inputs, &mut Vec::new(), &mut out);
            out
        };
        let prepare = &self.compiled.prepare.program;
        let prepared = run(&self.prepare, &[], prepare.outputs.len());
        let functions = self.functions.iter().map(|(function, tape)| {
            let values = run(tape, &prepared, function.program.outputs.len());
            (
                function.name,
                written_out(function, &values, x.len(), p.len()),
            )
        });
        functions.collect()
    }
}

fn written_out(
    function: &Function,
    values: &[f64],
    states: usize,
    parameters: usize,
) -> Vec<(Place, f64)> {
    let mut results = Vec::new();
    let mut values = values.iter().copied();
    for section in &function.sections {
        let taken = values.by_ref().take(section.len);
        let Some(pattern) = &section.pattern else {
            results.extend(
                taken
                    .enumerate()
                    .map(|(k, value)| ((section.name, k, 0), value)),
            );
            continue;
        };
        let columns = match section.name {
            "j" | "dy_dx" => states,
            "dy_dmarker" => 3,
            _ => parameters,
        };
        let first = results.len();
        let places =
            (0..states.max(3)).flat_map(|row| (0..columns).map(move |column| (row, column)));
        results.extend(places.map(|(row, column)| ((section.name, row, column), 0.0)));
        for (&(row, column), value) in pattern.iter().zip(taken) {
            results[first + row as usize * columns + column as usize].1 = value;
        }
    }
    results
}

/// Checks that the functions of `at`, compiled with the `fixed` parameters (index, value) as constants, agree with
/// those of `whole` for random states and parameters. Parameters that are not fixed are near their defaults.
fn check(whole: &Compiled, fixed: &[(usize, f64)], at: &Compiled, random: &mut Random) {
    let (at_rest, falling) = singular(whole);
    let tapes = [whole, at].map(Tapes::new);
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
        let (known, got) = (tapes[0].full(&x, &p), tapes[1].full(&x, &unread));
        for ((name, known), (_, got)) in known.into_iter().zip(got) {
            assert_eq!(known.len(), got.len(), "{name}");
            let rows = known.chunk_by(|((a, i, _), _), ((b, j, _), _)| (a, i) == (b, j));
            let sizes = rows.flat_map(|row| {
                let size = row.iter().fold(0.0_f64, |m, (_, v)| m.max(v.abs()));
                row.iter().map(move |_| size)
            });
            for (((place, a), (_, b)), size) in known.iter().zip(&got).zip(sizes) {
                let tolerance = 1e-12 * size.max(a.abs()).max(1e-9);
                // Where loads cancel the weight, of about 10 in SI units, a rounding of theirs is left.
                assert!(
                    (a - b).abs() <= tolerance.max(8.0 * f64::EPSILON),
                    "{name} {place:?}: {a}, but {b} at these values"
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
