//! Tables: the compiler's cubics against the oracle's, and a wrong table in compiled code is found.

use crate::support::QUICK;
use codegen::table::{PiecewiseBicubic, PiecewiseCubic};
use model_spec::load::from_text;
use model_spec::model::{Continuation, Interpolation, Model};
use oracle::Interpolant;
use proptest::prelude::*;
use verify::checks::{derivatives, exact_functions, reference};
use verify::difference::compare;
use verify::engine::Engine;
use verify::engine::Values;
use verify::report::Verdict;
use verify::subject::Subject;

const WAYS: [&str; 6] = [
    "",
    "monotone",
    "constant",
    "monotone, constant",
    "linear",
    "linear, constant",
];

fn with_table(knots: &[(f64, f64)], way: &str) -> Model {
    let knots: Vec<String> = knots.iter().map(|(x, y)| format!("{x:?}: {y:?}")).collect();
    let text = format!(
        "model probe; param tau = 1 s; state a = 0.4; state b = 2; frame N;
         table t(a) = {{ {} }} {way};
         der(a) = t(a + b)*b/tau; der(b) = (cos(a) - t(b)^2)/tau;",
        knots.join(", ")
    );
    from_text("probe.hyz", &text, &[]).unwrap_or_else(|error| panic!("{error}"))
}

fn knots() -> impl Strategy<Value = Vec<(f64, f64)>> {
    let knot = (0.05..2.0_f64, -3.0..3.0_f64);
    let steps = prop::collection::vec(knot, 2..30);
    (-4.0..1.0_f64, steps).prop_map(|(mut x, steps)| {
        let mut next = |(width, y)| {
            x += width;
            (x, y)
        };
        steps.into_iter().map(&mut next).collect()
    })
}

/// Value at `x` of the first table of a model (`order` 0), or of its derivative of the given order, from the piecewise
/// cubic that the compiler uses.
fn compiled(model: &Model, x: f64, order: u8) -> f64 {
    let mut cubic = PiecewiseCubic::of(&model.tables[0]);
    for _ in 0..order {
        cubic = cubic.derivative();
    }
    cubic.eval(x)
}

proptest! {
    #[test]
    fn the_cubics_of_compiler_and_oracle_are_the_same(
        knots in knots(),
        way in 0..WAYS.len(),
        share in prop::collection::vec(-0.3..1.3_f64, 8),
    ) {
        let model = with_table(&knots, WAYS[way]);
        let interpolant = Interpolant::new(&model.tables[0]);
        let (first, last) = (knots[0].0, knots[knots.len() - 1].0);
        for share in share {
            let x = first + share * (last - first);
            for order in 0..3 {
                let (got, wanted) = (compiled(&model, x, order), interpolant.at::<f64>(x, order));
                // Slopes between knots that lie closely are large.
                let size = 1e4_f64.powi(order.into());
                prop_assert!((got - wanted).abs() < 1e-11 * size, "{order} at {x}: {got}, {wanted}");
            }
        }
    }

    #[test]
    fn it_passes_through_the_knots_as_smoothly_as_it_says(knots in knots(), way in 0..WAYS.len()) {
        let model = with_table(&knots, WAYS[way]);
        let table = &model.tables[0];
        let flat = table.continuation == Continuation::Constant;
        let spline = table.interpolation == Interpolation::Spline;
        for (k, &(x, y)) in knots.iter().enumerate() {
            let is_end = k == 0 || k == knots.len() - 1;
            prop_assert!((compiled(&model, x, 0) - y).abs() < 1e-13);
            let below = x - 1e-9 * x.abs().max(1.0);
            let jump = |order| (compiled(&model, x, order) - compiled(&model, below, order)).abs();
            // What a function without a jump changes by over the distance, and rounding.
            let change = |order: u8| {
                let slope = |x| compiled(&model, x, order + 1).abs();
                2.0 * (x - below) * slope(x).max(slope(below)) + 1e-9 * (1.0 + slope(x))
            };
            let is_linear = table.interpolation == Interpolation::Linear;
            for order in 0..if is_linear { 1 } else { 2 } {
                prop_assert!(jump(order) < change(order), "derivative {order} at {x}: {}", jump(order));
            }
            if spline && !(is_end && flat) {
                prop_assert!(jump(2) < change(2), "second derivative at {x}: {}", jump(2));
            }
            if is_end && spline && !flat {
                prop_assert!(compiled(&model, x, 2).abs() < 1e-8);
            }
            if is_end && flat && !is_linear {
                prop_assert!(compiled(&model, x, 1).abs() < 1e-9);
            }
        }
        if !spline {
            for (k, pair) in knots.windows(2).enumerate() {
                let (least, greatest) = (pair[0].1.min(pair[1].1), pair[0].1.max(pair[1].1));
                for part in 0..=10 {
                    let x = pair[0].0 + f64::from(part) / 10.0 * (pair[1].0 - pair[0].0);
                    let y = compiled(&model, x, 0);
                    let within = least - 1e-12 <= y && y <= greatest + 1e-12;
                    prop_assert!(within, "{y} in interval {k} at {x}");
                }
            }
        }
    }
}

const KNOTS: [(f64, f64); 6] = [
    (-1.0, 0.2),
    (-0.2, 0.9),
    (0.4, 1.0),
    (1.0, 0.3),
    (2.0, -0.4),
    (3.0, 0.1),
];

#[test]
fn a_model_with_tables_holds() {
    for way in WAYS {
        let model = with_table(&KNOTS, way);
        let compiled = codegen::compile(&model);
        let engine = Engine::new(&compiled);
        let subject = Subject::new(&model, &engine);
        for row in &derivatives::check(&subject, &compiled, &QUICK)[..3] {
            assert_eq!(
                row.verdict,
                Verdict::Holds,
                "{way}: {} {}",
                row.worst,
                row.detail
            );
        }
        let values = Values::of(&model);
        let row = reference::tree(&Subject::new(&model, &values), &QUICK);
        assert_eq!(
            row.verdict,
            Verdict::Holds,
            "{way}: {} {}",
            row.worst,
            row.detail
        );
    }
}

#[test]
fn the_exact_check_and_the_difference_of_models_tell_tables_apart() {
    let model = with_table(&KNOTS, "");
    let mut knots = KNOTS;
    knots[3].1 += 1e-9;
    let others = [with_table(&knots, ""), with_table(&KNOTS, "constant")];
    let exact = |other: &Model| exact_functions::check(&model, &codegen::compile(other), &QUICK);
    assert_eq!(exact(&model).verdict, Verdict::Holds);
    assert!(!compare(&model, &model).is_changed());
    for other in others {
        let row = exact(&other);
        assert_eq!(row.verdict, Verdict::Refuted, "{}", row.detail);
        assert!(compare(&model, &other).is_changed());
    }
}

/// Checks that code is refuted if it was compiled with another value or argument of a knot, or with another
/// interpolation.
#[test]
fn code_with_another_table_is_refuted() {
    let model = with_table(&KNOTS, "");
    let mut wrong: Vec<(String, Model)> = Vec::new();
    for k in 0..KNOTS.len() {
        let mut knots = KNOTS;
        knots[k].1 += 1e-6;
        wrong.push((format!("value {k}"), with_table(&knots, "")));
        let mut knots = KNOTS;
        knots[k].0 += 1e-6;
        wrong.push((format!("argument {k}"), with_table(&knots, "")));
    }
    for way in &WAYS[1..] {
        wrong.push(((*way).to_owned(), with_table(&KNOTS, way)));
    }
    for (what, other) in wrong {
        let values = Values::of(&other);
        let row = reference::tree(&Subject::new(&model, &values), &QUICK);
        assert_eq!(row.verdict, Verdict::Refuted, "{what}: {}", row.worst);
        let compiled = codegen::compile(&other);
        let engine = Engine::new(&compiled);
        let subject = Subject::new(&model, &engine);
        let rows = derivatives::check(&subject, &compiled, &QUICK);
        assert_eq!(
            rows[0].verdict,
            Verdict::Refuted,
            "{what}: {}",
            rows[0].worst
        );
    }
}

#[test]
fn each_knot_and_the_way_between_them_is_mutated() {
    let model = with_table(&KNOTS, "");
    let file = model_spec::syntax::parse("probe.hyz", &model.sources[0].text).file;
    let mutants = verify::mutants::mutants(&file, &model.sources);
    let of_table = mutants.iter().filter(|m| m.place == "table t").count();
    assert_eq!(of_table, KNOTS.len() + 1);
}

fn of_two(x: &[f64], y: &[f64], values: &[f64], way: &str) -> Model {
    let list = |numbers: &[f64]| {
        let numbers: Vec<String> = numbers.iter().map(|n| format!("{n:?}")).collect();
        numbers.join(", ")
    };
    let rows = x.iter().zip(values.chunks(y.len()));
    let rows: Vec<String> = rows
        .map(|(x, row)| format!("{x:?}: ({})", list(row)))
        .collect();
    let text = format!(
        "model probe; param tau = 1 s; state a = 0.4; state b = 2; frame N;
         table t(x, y) = {{ y: ({}), {} }} {way};
         der(a) = t(a, b)*b/tau; der(b) = (cos(a) - t(b/2, a)^2)/tau;",
        list(y),
        rows.join(", ")
    );
    from_text("probe.hyz", &text, &[]).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

const X: [f64; 4] = [-1.0, 0.2, 0.9, 2.0];
const Y: [f64; 3] = [-0.5, 0.6, 1.4];
const Z: [f64; 12] = [
    0.3, -0.1, 0.8, 1.1, 0.4, 0.2, -0.6, 0.5, 0.9, 0.1, 1.3, -0.2,
];

/// Through the knots, and along a line of knots the table of one argument with these knots.
#[test]
fn a_table_of_two_arguments_is_that_of_one_along_its_knots() {
    for way in ["", "constant", "linear", "linear, constant"] {
        let model = of_two(&X, &Y, &Z, way);
        let surface = PiecewiseBicubic::of(&model.tables[0]);
        for (j, y) in Y.iter().enumerate() {
            let line: Vec<(f64, f64)> = X
                .iter()
                .enumerate()
                .map(|(i, x)| (*x, Z[3 * i + j]))
                .collect();
            let along = with_table(&line, way);
            for part in 0..=40 {
                let x = -2.0 + 0.13 * f64::from(part);
                for order in 0..2 {
                    let (got, wanted) =
                        (surface.eval(x, *y, [order, 0]), compiled(&along, x, order));
                    assert!(
                        (got - wanted).abs() < 1e-12,
                        "{way} {order} at {x}, {y}: {got} {wanted}"
                    );
                }
            }
        }
        let swapped: Vec<f64> = (0..12).map(|k| Z[3 * (k % 4) + k / 4]).collect();
        let swapped = PiecewiseBicubic::of(&of_two(&Y, &X, &swapped, way).tables[0]);
        for part in 0..100 {
            let (x, y) = (
                -1.5 + 0.04 * f64::from(part),
                -1.1 + 0.03 * f64::from(part * 37 % 100),
            );
            let (got, wanted) = (surface.eval(x, y, [0, 1]), swapped.eval(y, x, [1, 0]));
            assert!(
                (got - wanted).abs() < 1e-12,
                "{way} at {x}, {y}: {got} {wanted}"
            );
        }
    }
}

#[test]
fn code_with_another_table_of_two_arguments_is_refuted() {
    let model = of_two(&X, &Y, &Z, "");
    let verdicts = |other: &Model| {
        let compiled = codegen::compile(other);
        let engine = Engine::new(&compiled);
        let subject = Subject::new(&model, &engine);
        let values = Values::of(other);
        [
            reference::tree(&Subject::new(&model, &values), &QUICK).verdict,
            derivatives::check(&subject, &compiled, &QUICK)[0].verdict,
            exact_functions::check(&model, &compiled, &QUICK).verdict,
        ]
    };
    assert_eq!(verdicts(&model), [Verdict::Holds; 3]);
    let (mut x, mut z) = (X, Z);
    x[1] += 1e-6;
    z[7] += 1e-6;
    for other in [
        of_two(&x, &Y, &Z, ""),
        of_two(&X, &Y, &z, ""),
        of_two(&X, &Y, &Z, "constant"),
    ] {
        assert_eq!(verdicts(&other), [Verdict::Refuted; 3]);
    }
    let file = model_spec::syntax::parse("probe.hyz", &model.sources[0].text).file;
    let mutants = verify::mutants::mutants(&file, &model.sources);
    let of_table = mutants.iter().filter(|m| m.place == "table t").count();
    assert_eq!(of_table, Z.len() + 1);
}
