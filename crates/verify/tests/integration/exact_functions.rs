//! The exact check of f, J and Jp: it holds for right code, and refutes alone every change of the code that changes a value.

use crate::support::{QUICK, built_in, edited, results};
use codegen::Compiled;
use codegen::program::{Binary, Function, Fused, Op, Unary};
use model_spec::load::MODELS;
use model_spec::model::Model;
use verify::checks::exact_functions::check;
use verify::random::Random;
use verify::report::Verdict;
use verify::sample;

#[test]
fn the_code_of_every_model_is_its_law_and_its_jacobians_are_the_derivatives() {
    for (name, _) in MODELS {
        let model = built_in(name).model.unwrap();
        let row = check(&model, &codegen::compile(&model), &QUICK);
        assert_eq!(row.verdict, Verdict::Holds, "{name}: {row:?}");
    }
}

#[test]
fn code_of_another_law_is_refuted_and_its_entries_are_named() {
    let model = built_in("disc").model.unwrap();
    let other = edited("disc", "C_La*alpha", "1.0000000001*C_La*alpha");
    let row = check(&model, &codegen::compile(&other.model.unwrap()), &QUICK);
    assert_eq!(row.verdict, Verdict::Refuted);
    assert!(row.detail.contains("der(u) in f\n"), "{}", row.detail);
    assert!(
        row.detail.contains("∂der(w)/∂C_La in f_jac_par"),
        "{}",
        row.detail
    );
    assert!(!row.detail.contains("der(phidot)"), "{}", row.detail);
}

#[test]
fn what_the_field_cannot_decide_is_said_and_refutes_nothing() {
    let text = "model bent; param h = 2 m; frame N; state z = 1 m; state v = 0 m/s; der(z) = v;
        der(v) = (abs(z)/h - max(z/h, 0.3))*1 [m/s^2];";
    let model = model_spec::load::from_text("bent", text, &[]).unwrap();
    let row = check(&model, &codegen::compile(&model), &QUICK);
    assert_eq!(row.verdict, Verdict::Skipped, "{row:?}");
    assert!(row.detail.contains("functions with branches"), "{row:?}");
}

#[test]
fn functions_of_numbers_are_numbers_and_small_terms_beside_them_refute() {
    let law = |term: &str| {
        let text = format!(
            "model same; param k = 0.7; param s = 1 s; frame N; state w = 0.1; der(w) = (k + {term}*w)/s;"
        );
        model_spec::load::from_text("same", &text, &[]).unwrap()
    };
    let terms = [
        "cos(0)",
        "sin(0)",
        "tanh(w - w)",
        "log(1)",
        "exp(0)",
        "asin(0)",
        "atan(0)",
        "atan2(0, 1)",
        "acos(0)",
        "exp(log(2))",
        "exp(-log(3))",
        "log(exp(1))",
        "log(exp(k))",
        "abs(-1)",
        "abs(-1.35)",
        "sign(-2/3)",
        "step(0)",
        "tan(30 deg)",
    ];
    for term in terms {
        let model = law(term);
        let row = check(&model, &codegen::compile(&model), &QUICK);
        assert_eq!(row.verdict, Verdict::Holds, "{term}: {row:?}");
        let other = law(&format!("({term} + 1e-15*w)"));
        let row = check(&model, &codegen::compile(&other), &QUICK);
        assert_eq!(row.verdict, Verdict::Refuted, "{term}: {row:?}");
    }
}

/// Wrong operations that may replace the operation `op` in a mutant of compiled code.
fn changed(op: Op) -> Vec<Op> {
    match op {
        Op::Unary(Unary::Neg, a) => vec![Op::Binary(Binary::Add, a, a)],
        Op::Unary(_, a) => vec![Op::Unary(Unary::Neg, a)],
        Op::Binary(Binary::Add, a, b) => vec![Op::Binary(Binary::Sub, a, b)],
        Op::Binary(Binary::Sub, a, b) => {
            vec![Op::Binary(Binary::Add, a, b), Op::Binary(Binary::Sub, b, a)]
        }
        Op::Binary(Binary::Mul, a, b) => {
            vec![Op::Binary(Binary::Mul, a, a), Op::Binary(Binary::Add, a, b)]
        }
        Op::Binary(op, a, b) => vec![Op::Binary(op, b, a)],
        Op::Fused(fused, a, b, c) => {
            let other = match fused {
                Fused::MulAdd => Fused::MulSub,
                Fused::MulSub | Fused::NegMulAdd => Fused::MulAdd,
            };
            vec![Op::Fused(other, a, b, c), Op::Fused(fused, a, c, b)]
        }
        Op::IfZero(a, then, otherwise) => vec![Op::IfZero(a, otherwise, then)],
    }
}

/// Replaces every `step`-th operation of a model's compiled code, in turn, by wrong ones. Returns the number of
/// replacements that change a value, and descriptions of those that the exact check of functions does not refute.
fn killed(model: &Model, step: usize) -> (usize, Vec<String>) {
    let compiled = codegen::compile(model);
    let mut random = Random::new(3, "mutants of the code");
    let points: Vec<_> = (0..4).map(|_| sample::point(model, &mut random)).collect();
    let (mut count, mut survivors) = (0, Vec::new());
    let functions: [fn(&mut Compiled) -> &mut Function; 3] =
        [|c| &mut c.f, |c| &mut c.f_jac, |c| &mut c.f_jac_par];
    for function in functions {
        let mut mutant = compiled.clone();
        let right = results(&compiled, function(&mut mutant), &points);
        let size = function(&mut mutant).program.statements.len();
        for k in (0..size).step_by(step) {
            let op = function(&mut mutant).program.statements[k].op;
            for other in changed(op) {
                function(&mut mutant).program.statements[k].op = other;
                let code = function(&mut mutant).clone();
                let wrong = results(&compiled, &code, &points);
                let differs = |(a, b): (&f64, &f64)| {
                    let difference = (a - b).abs();
                    difference.is_nan() || difference > 1e-9 * (a.abs() + b.abs()) + 1e-12
                };
                if right.iter().zip(&wrong).any(differs) {
                    count += 1;
                    if check(model, &mutant, &QUICK).verdict != Verdict::Refuted {
                        survivors.push(format!("{} in {}: {op:?} as {other:?}", k, code.name));
                    }
                }
            }
            function(&mut mutant).program.statements[k].op = op;
        }
    }
    (count, survivors)
}

#[test]
fn every_mutant_of_the_code_that_changes_a_value_is_refuted() {
    let mut all = 0;
    for (name, _) in MODELS {
        let (count, survivors) = killed(&built_in(name).model.unwrap(), 3);
        assert!(
            survivors.is_empty(),
            "{name}: {} of {count}\n{}",
            survivors.len(),
            survivors.join("\n")
        );
        all += count;
    }
    println!("{all} mutants of the code");
    assert!(all >= 2000, "{all} mutants");
}
