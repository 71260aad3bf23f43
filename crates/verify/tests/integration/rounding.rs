//! Rounding: every backend is within some ulp of arithmetic of 256 bits, and a statement that loses digits is named.

use crate::support::{QUICK, built_in};
use codegen::Compiled;
use codegen::program::Operand;
use model_spec::load::{MODELS, from_text};
use model_spec::model::Model;
use verify::checks::backends::{self, Run};
use verify::engine::Engine;
use verify::random::Random;
use verify::report::Verdict;
use verify::rounding::statements::REPORTED_BITS;
use verify::rounding::{ALLOWED, Effort, Rounding, errors, measure, row};
use verify::sample;
use verify::subject::Subject;

fn measured(model: &Model) -> Rounding {
    let compiled = codegen::compile(model);
    let engine = Engine::new(&compiled);
    measure(
        &Subject::new(model, &engine),
        &compiled,
        &QUICK,
        Effort::ROW,
    )
}

fn own(text: &str) -> Model {
    from_text("own.hyz", text, &[]).unwrap()
}

/// Rounding errors of the results `runs`: differences from the results of the program `compiled` in 256-bit arithmetic.
fn of_runs(compiled: &Compiled, runs: &[Run], points: &[oracle::Point<f64>]) -> Rounding {
    let (errors, left_out) = errors(compiled, points, runs);
    Rounding {
        measure: "",
        points: [points.len(), 0],
        left_out,
        errors,
        losses: Vec::new(),
    }
}

fn points(model: &Model) -> Vec<oracle::Point<f64>> {
    let mut random = Random::new(1, "points");
    (0..8).map(|_| sample::point(model, &mut random)).collect()
}

#[test]
fn every_backend_of_every_model_rounds_well_and_no_statement_loses_digits() {
    for (name, _) in MODELS {
        let model = built_in(name).model.unwrap();
        let found = measured(&model);
        let row = row(&found);
        assert_eq!(row.verdict, Verdict::Holds, "{name}: {row:?}");
        assert!(row.remark.is_none(), "{name}: {row:?}");
        assert!(0.0 < row.worst && row.worst < ALLOWED / 4.0, "{row:?}");
        assert!(found.points[0] > 0 && found.points[1] > 0, "{name}");
        let mut backends = vec!["tape", "tape on portable"];
        // The program has the code of some models; the others run on the tape.
        if generated::model(name).is_some() {
            backends.extend(["generated", "generated on portable"]);
        }
        for backend in backends {
            let errors = found.errors.iter().filter(|e| e.backend == backend);
            let values: Vec<&str> = errors.map(|e| e.values).collect();
            assert!(
                ["f", "J", "Jp"].iter().all(|v| values.contains(v)),
                "{name}"
            );
        }
    }
}

/// Model of a pendulum whose height above its lowest point is defined by the expression `height`.
fn pendulum(height: &str) -> Model {
    own(&format!(
        "model pendulum;
param L = 2 m;
param g0 = 9.81 m/s^2;
frame N;
state phi = 0.1 rad;
state rate = 0 rad/s;
let c = cos(phi);
let height = {height};
der(phi) = rate;
der(rate) = -g0/L*sin(phi)*(1 + height/L)*1 rad;
"
    ))
}

#[test]
fn a_statement_that_loses_digits_is_named_with_its_line_and_bits() {
    for height in [
        "L*(1 - cos(phi))",
        "L*(1 - c)",
        "L*(sqrt(1 + sin(phi)^2) - 1)",
    ] {
        let found = measured(&pendulum(height));
        let worst = &found.losses[0];
        assert_eq!(
            (worst.name.as_str(), worst.line),
            ("height", 8),
            "{worst:?}"
        );
        assert_eq!(worst.text, format!("let height = {height};"));
        // 1 − cos φ is φ²/2, next to 1: at 1e-7 rad 47 bits are lost.
        assert!(worst.bits > 40.0, "{height}: {worst:?}");
        let row = row(&found);
        assert_eq!(row.verdict, Verdict::Holds);
        let remark = row.remark.unwrap();
        assert!(
            remark.starts_with("own.hyz, line 8: `height` loses 4"),
            "{remark}"
        );
        assert_eq!(remark.lines().count(), 1, "{remark}");
    }
}

#[test]
fn the_same_value_without_cancellation_is_not_named() {
    let found = measured(&pendulum("2*L*sin(phi/2)^2"));
    assert!(row(&found).remark.is_none(), "{:?}", found.losses);
}

#[test]
fn loads_and_effects_are_named_as_the_statements_that_they_are() {
    let text = built_in("ball").sources[0].text.clone()
        + "force lift_off = 1 [N]*(1 - cos(z/h_0))*N.3; param h_0 = 1 m;";
    let model = from_text("ball", &text, &[]).unwrap();
    let found = measured(&model);
    assert_eq!(found.losses[0].name, "lift_off", "{:?}", found.losses);
    assert!(found.losses[0].bits > REPORTED_BITS);
}

#[test]
fn a_constant_of_the_code_that_is_off_by_1e_13_is_refuted() {
    // The other checks allow 1e-12.
    let model = pendulum("2*L*sin(phi/2)^2");
    let compiled = codegen::compile(&model);
    let points = points(&model);
    let right = backends::runs(&model, &compiled, &points);
    assert_eq!(
        row(&of_runs(&compiled, &right, &points)).verdict,
        Verdict::Holds
    );
    let mut mutant = compiled.clone();
    let mut changed = 0;
    for statement in &mut mutant.f_jac.program.statements {
        statement.op.for_operands(|operand| {
            if let Operand::Constant(c) = operand {
                *c *= 1.0 + 1e-13;
                changed += 1;
            }
        });
    }
    assert!(changed > 0);
    let wrong = backends::runs(&model, &mutant, &points);
    assert_eq!(backends::check(&mutant, &wrong).verdict, Verdict::Holds);
    assert_eq!(
        backends::check_fma(&mutant, &[], &wrong).verdict,
        Verdict::Holds
    );
    let row = row(&of_runs(&compiled, &wrong, &points));
    assert_eq!(row.verdict, Verdict::Refuted, "{row:?}");
}

#[test]
fn a_result_that_is_off_by_hundreds_of_ulp_or_not_finite_is_refuted() {
    let model = built_in("disc").model.unwrap();
    let compiled = codegen::compile(&model);
    let points = points(&model);
    let right = backends::runs(&model, &compiled, &points);
    let place = compiled.prepare.program.outputs.len() + 5;
    for wrong in [|v: f64| v * (1.0 + 1e-13), |_| f64::NAN] {
        let mut runs = right.clone();
        for result in &mut runs[0].results {
            result[place] = wrong(result[place]);
        }
        let row = row(&of_runs(&compiled, &runs, &points));
        assert_eq!(row.verdict, Verdict::Refuted, "{row:?}");
        let name = &compiled.f.results[5];
        assert!(
            row.detail.starts_with(&format!("{name} by tape;")),
            "{row:?}"
        );
    }
}

#[test]
fn points_at_which_rounding_decides_a_branch_are_left_out() {
    let text = "model bent; param h = 2 m; frame N; state z = 1 m; state v = 0 m/s; der(z) = v;
        der(v) = (abs(z)/h - max(z/h, 0.3))*1 [m/s^2];";
    let found = measured(&own(text));
    assert_eq!(row(&found).verdict, Verdict::Holds, "{found:?}");
    // exp(log(x)) − x is a rounding error above 0, and of either sign.
    let near = text.replace("max(z/h, 0.3)", "sign(exp(log(z/h)) - z/h)");
    let found = measured(&own(&near));
    assert!(found.left_out > 0, "{found:?}");
    assert_eq!(row(&found).verdict, Verdict::Holds, "{found:?}");
}

#[test]
fn the_measurement_is_the_same_again() {
    let model = built_in("discus").model.unwrap();
    assert_eq!(measured(&model), measured(&model));
}
