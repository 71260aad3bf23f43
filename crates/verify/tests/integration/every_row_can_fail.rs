//! Every row of a report can fail: for each check a breakage of the code or of the model, of a built-in model and of one of
//! a user's own, that this very check lets through no longer. A row without a breakage fails the test.

use crate::support::{QUICK, built_in, row as row_of};
use codegen::Compiled;
use model_spec::load::{Loaded, inspect_text};
use model_spec::model::Model;
use std::collections::BTreeSet;
use verify::Options;
use verify::checks::backends::{self, Run};
use verify::checks::claim::CLAIM;
use verify::checks::{cases, effects, exact, exact_functions, identities};
use verify::checks::{derivatives, metamorphic, reference, singular, units};
use verify::engine::Values;
use verify::flights::{INVARIANTS, MOMENTA};
use verify::mutants::MutationMatrix;
use verify::random::Random;
use verify::report::{Row, Verdict};
use verify::rounding::{self, ROUNDING, Rounding};
use verify::sample;

/// Text of the ball model as a user might change it: another name and an additional side force.
fn own_text() -> String {
    let ball = built_in("ball").sources[0].text.clone();
    let ball = ball.replacen("model ball;", "model pellet;", 1);
    ball + "coefficient C_Y = 0.1 s in -1 .. 1;
        force side = C_Y*drag*cross(omega, unit(air_velocity));"
}

/// Model under test, given by its text.
#[derive(Clone)]
struct Base {
    name: &'static str,
    text: String,
}

impl Base {
    fn disc() -> Self {
        Self {
            name: "disc",
            text: built_in("disc").sources[0].text.clone(),
        }
    }

    fn own() -> Self {
        Self {
            name: "pellet",
            text: own_text(),
        }
    }

    /// The glider model, which writes its equations explicitly and declares their physical meaning in a `claim` block.
    fn claimed() -> Self {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../studies/models/glider.hyz"
        );
        Self {
            name: "glider",
            text: std::fs::read_to_string(path).unwrap(),
        }
    }

    fn loaded(&self) -> Loaded {
        inspect_text(self.name, &self.text, &[]).unwrap()
    }

    fn model(&self) -> Model {
        let loaded = self.loaded();
        loaded
            .model
            .unwrap_or_else(|| panic!("{:#?}", loaded.diagnostics))
    }

    /// Copy of the model in which the first occurrence of `from` is replaced by `to`.
    fn edited(&self, from: &str, to: &str) -> Self {
        assert!(self.text.contains(from), "{} has no `{from}`", self.name);
        Self {
            text: self.text.replacen(from, to, 1),
            ..self.clone()
        }
    }
}

/// A defect of a model or of its compiled code that makes one check of the report fail.
enum Breakage {
    /// Defect in the model file, so that the model itself is wrong.
    Text(&'static str, &'static str),
    /// Defect in the text from which the code is compiled: the code is wrong, but the model is correct.
    Code(&'static str, &'static str),
    /// Function that introduces a defect into the model, its code or the results of its code, and returns the result of
    /// the check that should fail.
    By(fn(&Base) -> Row),
}

use Breakage::{By, Code, Text};

/// Results of the numerical checks of a model with code that was compiled from another model.
fn of_code(model: &Model, compiled: &Compiled) -> Vec<Row> {
    verify::rows_of_code(model, compiled, &QUICK)
}

fn find(rows: Vec<Row>, check: &str) -> Row {
    let found = rows.into_iter().find(|row| row.check == check);
    found.unwrap_or_else(|| panic!("no check is called `{check}`"))
}

impl Breakage {
    fn row(&self, base: &Base, check: &str) -> Row {
        match self {
            Text(from, to) => {
                let report = verify::run(&base.edited(from, to).loaded(), &QUICK);
                row_of(&report, check).clone()
            }
            Code(from, to) => {
                let compiled = codegen::compile(&base.edited(from, to).model());
                find(of_code(&base.model(), &compiled), check)
            }
            By(row) => row(base),
        }
    }
}

/// Results of all backends at one random point. In one backend, with fused multiply-add (`fuses` true) or without it,
/// `change` is applied to the last nonzero result.
fn changed_run(base: &Base, fuses: bool, change: fn(f64) -> f64) -> (Compiled, Vec<Run>) {
    let model = base.model();
    let compiled = codegen::compile(&model);
    let point = sample::point(&model, &mut Random::new(0, "one point"));
    let mut runs = backends::runs(&model, &compiled, &[point]);
    let run = runs.iter_mut().find(|run| run.fuses == fuses).unwrap();
    let result = run.results[0]
        .iter_mut()
        .rfind(|v| **v != 0.0 && v.is_finite());
    let result = result.unwrap();
    *result = change(*result);
    (compiled, runs)
}

/// Result of the backend comparison if one backend differs in the last bit of one result.
fn last_bit_changed(base: &Base) -> Row {
    let next = |v: f64| f64::from_bits(v.to_bits() + 1);
    let (compiled, runs) = changed_run(base, false, next);
    backends::check(&compiled, &runs)
}

/// Result of the comparison of backends with and without fused multiply-add if one result is wrong by 1.
fn off_by_one(base: &Base) -> Row {
    let (compiled, runs) = changed_run(base, false, |v| v + 1.0);
    backends::check_fma(&compiled, &[], &runs)
}

/// Result of the exact rigid-body check for code that was compiled with `from` replaced by `to` in the model text.
fn exact_of(base: &Base, from: &str, to: &str) -> Row {
    let of = |base: &Base| exact::free_loads(&base.model());
    let old = codegen::compile(&of(&base.edited(from, to)));
    exact::compare(&of(base), &old, &QUICK)
}

/// Result of the rounding check if all results of one backend have a relative error of 1e-13, which other checks allow.
fn rounded_badly(base: &Base) -> Row {
    let model = base.model();
    let compiled = codegen::compile(&model);
    let mut random = Random::new(0, "rounded badly");
    let points: Vec<_> = (0..4).map(|_| sample::point(&model, &mut random)).collect();
    let mut runs = backends::runs(&model, &compiled, &points);
    let results = runs[0].results.iter_mut().flatten();
    results.for_each(|value| *value *= 1.0 + 1e-13);
    let (errors, left_out) = rounding::errors(&compiled, &points, &runs);
    rounding::row(&Rounding {
        measure: "",
        points: [points.len(), 0],
        left_out,
        errors,
        losses: Vec::new(),
    })
}

/// Defects by check: name of the check, defect in the disc model, and defect in the user's variant of the ball model.
fn breakages() -> Vec<(&'static str, Breakage, Breakage)> {
    let mut all = vec![
        (
            units::UNITS,
            Text("rho_air*V^2/2", "rho_air*V/2"),
            Text("rho_air*V^2/2", "rho_air*V/2"),
        ),
        (
            reference::REFERENCE,
            Text("-m*g_here*N.3", "m*g_here*N.3"),
            Text("-m*g_here*N.3", "m*g_here*N.3"),
        ),
        (
            reference::TREE,
            Code("cross(d3, d1)", "cross(d1, d3)"),
            Code("cross(omega, unit", "-cross(omega, unit"),
        ),
        (
            identities::IDENTITIES,
            Text("mass m;", "mass 2*m;"),
            Text("mass m;", "mass 2*m;"),
        ),
        (
            INVARIANTS,
            Text("diag(I_d, I_d, I_a)", "diag(I_d, I_d, I_a/2)"),
            Code("-m*g_here*N.3", "-1.01*m*g_here*N.3 - 0.1 [kg/s]*velocity"),
        ),
        (
            MOMENTA,
            Text("-m*g_here*N.3", "-1.001*m*g_here*N.3"),
            Text("-m*g_here*N.3", "-1.001*m*g_here*N.3"),
        ),
        (
            metamorphic::METAMORPHIC,
            Text("-m*g_here*N.3", "-m*g_here*N.3 + 0.1 [N]*N.1"),
            Text("-m*g_here*N.3", "-m*g_here*N.3 + 0.1 [N]*N.1"),
        ),
        (
            exact::EXACT,
            By(|base| exact_of(base, "mass m;", "mass 1.0000000001*m;")),
            By(|base| exact_of(base, "mass m;", "mass 1.0000000001*m;")),
        ),
        (
            exact_functions::FUNCTIONS,
            Code("C_La*alpha", "1.0000000001*C_La*alpha"),
            Code("C_Y*drag", "1.0000000001*C_Y*drag"),
        ),
        (
            backends::BACKENDS,
            By(last_bit_changed),
            By(last_bit_changed),
        ),
        (backends::FMA, By(off_by_one), By(off_by_one)),
        (ROUNDING, By(rounded_badly), By(rounded_badly)),
        (
            singular::SINGULAR,
            Text(
                "-m*g_here*N.3",
                "-m*g_here*N.3*exp(1e5 [1/m]*abs(z - 3 [m]))",
            ),
            Text(
                "-m*g_here*N.3",
                "-m*g_here*N.3*exp(1e5 [1/m]*abs(z - 3 [m]))",
            ),
        ),
        (
            cases::CASES,
            Text("expect alpha = 0.0996", "expect alpha = -0.0996"),
            Text("expect der(vz) = -9.81", "expect der(vz) = -9.82"),
        ),
        (
            effects::EFFECTS,
            By(|base| effect_row(base, "C_L = C_L0 + C_La*alpha + 0.001*cos(C_x)")),
            By(|base| effect_row(base, "drag = rho_air*V^2/2*A*C_D*(1 + 0.001*cos(C_x))")),
        ),
        (
            effects::EFFECT_REFERENCE,
            By(|base| code_of_effect(base, "C_L", "C_L0 + C_La*alpha + C_x")),
            By(|base| code_of_effect(base, "drag", "rho_air*V^2/2*A*C_D*(1 + C_x)")),
        ),
        ("mutants", By(|_| a_survivor()), By(|_| a_survivor())),
    ];
    let of_code = || Code("C_La*alpha", "1.01*C_La*alpha");
    let of_own = || Code("A*C_D", "A*1.01*C_D");
    all.extend(derivatives::CHECKS.map(|check| (check, of_code(), of_own())));
    all
}

/// Result of the check of effects at their null values, for an effect that replaces a quantity by `law` although its
/// coefficient has its null value, 0.
fn effect_row(base: &Base, law: &str) -> Row {
    let effect = format!(
        "effect shift {{ site drag; coefficient C_x = 0 in -1 .. 1; negligible C_x 0.001; replace {law}; }}"
    );
    let with = Base {
        text: base.text.clone() + &effect,
        ..base.clone()
    };
    row_of(&verify::run(&with.loaded(), &QUICK), effects::EFFECTS).clone()
}

/// Result of the comparison of effects with the oracle, for an effect that replaces the quantity `name` by `law`, if its
/// code was compiled from a text in which its coefficient counts a millionth more.
fn code_of_effect(base: &Base, name: &str, law: &str) -> Row {
    let model = |law: &str| {
        let effect = format!(
            "effect shift {{ site drag; coefficient C_x = 0 in -1 .. 1; negligible C_x 0.001; replace {name} = {law}; }}"
        );
        let text = base.text.clone() + &effect;
        inspect_text(base.name, &text, &["shift"])
            .unwrap()
            .model
            .unwrap()
    };
    let row = |code: &str| {
        let variant = effects::Variant {
            model: model(law),
            values: Values::of(&model(code)),
        };
        effects::against_oracle(&[variant], &QUICK)
    };
    assert_eq!(row(law).verdict, Verdict::Holds);
    row(&law.replace("C_x", "1.000001*C_x"))
}

fn a_survivor() -> Row {
    let matrix = MutationMatrix {
        survivors: vec![String::from("der(z): 0 in place of vz")],
        ..MutationMatrix::default()
    };
    matrix.row()
}

/// Names of the checks that no defect in this file refutes, because they report a problem only in a remark.
const STALE: [&str; 1] = [backends::GENERATED];

#[test]
fn every_row_has_a_breakage_that_it_alone_is_asked_about() {
    let all = Options {
        mutants: true,
        ..QUICK
    };
    let breakages = breakages();
    let known: BTreeSet<&str> = breakages
        .iter()
        .map(|(check, ..)| *check)
        .chain(STALE)
        .collect();
    assert_eq!(
        known.len(),
        breakages.len() + STALE.len(),
        "one row, one breakage"
    );
    for base in [Base::disc(), Base::own()] {
        let report = verify::run(&base.loaded(), &all);
        let rows: BTreeSet<&str> = report.rows.iter().map(|row| row.check).collect();
        assert_eq!(rows, known, "{}", base.name);
        assert!(report.holds(), "{}", report.table());
        let fuses = lanes::Isa::ALL
            .into_iter()
            .any(|isa| isa.is_supported() && isa.fuses());
        for (check, of_disc, of_own) in &breakages {
            if *check == backends::FMA && !fuses {
                continue;
            }
            let right = row_of(&report, check);
            assert_eq!(right.verdict, Verdict::Holds, "{}: {right:?}", base.name);
            let breakage = if base.name == "disc" { of_disc } else { of_own };
            let wrong = breakage.row(&base, check);
            assert_eq!(wrong.check, *check);
            assert_eq!(wrong.verdict, Verdict::Refuted, "{}: {wrong:?}", base.name);
        }
    }
}

/// Defects by check, for a model with explicitly written equations and a `claim` block that declares their meaning.
fn breakages_of_claimed() -> Vec<(&'static str, Breakage)> {
    let mut all = vec![
        (units::UNITS, Text("-drag/m", "-drag")),
        (CLAIM, Text("der(height) = V*sin", "der(height) = V*cos")),
        (reference::TREE, Code("lift/(m*V)", "-lift/(m*V)")),
        (
            identities::IDENTITIES,
            Text("- g*sin(gamma)", "+ g*sin(gamma)"),
        ),
        (INVARIANTS, Text("- g*sin(gamma)", "- 1.01*g*sin(gamma)")),
        (MOMENTA, Text("- g*cos(gamma)/V", "- 1.001*g*cos(gamma)/V")),
        (
            metamorphic::METAMORPHIC,
            Text("- g*sin(gamma)", "- g*(1 + time/1 [s])*sin(gamma)"),
        ),
        (
            exact_functions::FUNCTIONS,
            Code("lift/(m*V)", "1.0000000001*lift/(m*V)"),
        ),
        (backends::BACKENDS, By(last_bit_changed)),
        (backends::FMA, By(off_by_one)),
        (ROUNDING, By(rounded_badly)),
        (
            singular::SINGULAR,
            Text("-drag/m", "-drag/m*exp(1e5 [1/m]*abs(range - 3 [m]))"),
        ),
        (
            cases::CASES,
            Text("expect der(V) = -1.635", "expect der(V) = -1.636"),
        ),
        (
            effects::EFFECTS,
            By(|base| effect_row(base, "drag = pressure_force*C_D*(1 + 0.001*cos(C_x))")),
        ),
        (
            effects::EFFECT_REFERENCE,
            By(|base| code_of_effect(base, "drag", "pressure_force*C_D*(1 + C_x)")),
        ),
    ];
    let of_code = || Code("lift/(m*V)", "1.01*lift/(m*V)");
    all.extend(derivatives::CHECKS.map(|check| (check, of_code())));
    all
}

#[test]
fn every_row_that_holds_of_claimed_equations_has_a_breakage() {
    let base = Base::claimed();
    let report = verify::run(&base.loaded(), &QUICK);
    let holds = report
        .rows
        .iter()
        .filter(|row| row.verdict == Verdict::Holds);
    let holds: BTreeSet<&str> = holds.map(|row| row.check).collect();
    let breakages = breakages_of_claimed();
    let known: BTreeSet<&str> = breakages.iter().map(|(check, _)| *check).collect();
    let without: Vec<_> = holds.difference(&known).collect();
    assert!(without.is_empty(), "{without:?}");
    for (check, breakage) in &breakages {
        if !holds.contains(check) {
            continue;
        }
        let wrong = breakage.row(&base, check);
        // A model without a reference may break a relation on purpose: it is said.
        let expected = match *check {
            metamorphic::METAMORPHIC => Verdict::Skipped,
            _ => Verdict::Refuted,
        };
        assert_eq!(wrong.verdict, expected, "{wrong:?}");
    }
}

#[test]
fn code_of_another_text_is_not_said_to_be_of_this_one() {
    let disc = Base::disc();
    let right = verify::run(&disc.loaded(), &QUICK);
    assert_eq!(row_of(&right, backends::GENERATED).verdict, Verdict::Holds);
    let stale = verify::run(&disc.edited("C_D0 + C_Da", "C_Da + C_D0").loaded(), &QUICK);
    let row = row_of(&stale, backends::GENERATED);
    assert_eq!(row.verdict, Verdict::Skipped);
    assert!(row.remark.as_ref().unwrap().starts_with("STALE"), "{row:?}");
    let own = verify::run(&Base::own().loaded(), &QUICK);
    assert_eq!(row_of(&own, backends::GENERATED).verdict, Verdict::Skipped);
}
