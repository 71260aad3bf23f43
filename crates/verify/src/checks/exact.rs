//! Exact arithmetic: with a free force and moment, the derivatives of a rigid body are rational functions of states,
//! sines and cosines of angles, and constants. The compiled program and the oracle's derivation are compared at random
//! points of the field of integers modulo 2^61 − 1. Equality at all points proves equality up to the stated probability
//! (Schwartz–Zippel lemma).

use crate::evaluation::results;
use crate::field::FieldPoint;
use crate::options::Options;
use crate::random::Random;
use crate::row::Row;
use crate::subject::Subject;
use crate::symbolic::evaluate;
use codegen::Compiled;
use model_spec::diagnostic::Span;
use model_spec::model::{Expr, ExprKind, Input, Load, Model, Shape};
use model_spec::unit::Unit;
use oracle::derivatives;
use oracle::scalar::Dual;

/// Name of this check in reports: derivatives of a rigid body under an arbitrary force and moment, in exact arithmetic.
pub const EXACT: &str = "rigid body, exact";

/// Number of random points of the prime field; functions of degree d agree at one by chance with d / 2^61.
pub const POINTS: usize = 8;
/// Upper bound of the total degree of the state derivatives.
const DEGREE: f64 = 1e3;

/// Compares the compiled derivatives of the body, under one arbitrary force and moment, with those of the oracle.
pub fn check(subject: &Subject<'_>, options: &Options) -> Row {
    if subject.model.body.is_none() {
        return match &subject.reference {
            Some(_) => Row::skipped(EXACT, "its equations are stated"),
            None => subject.without_reference(EXACT),
        };
    }
    let model = free_loads(subject.model);
    compare(&model, &codegen::compile(&model), options)
}

/// Compares the state derivatives of a compiled model of [`free_loads`] with those of the oracle.
pub fn compare(model: &Model, compiled: &Compiled, options: &Options) -> Row {
    let mut random = Random::new(options.seed, EXACT);
    let mut faults = Vec::new();
    for _ in 0..POINTS {
        let spot = FieldPoint::random(model, &mut random);
        let rates = evaluate(&spot, false, |point| {
            let found = results(compiled, [&compiled.f], point).swap_remove(0).1;
            // Dual numbers, as those of the comparison of derivatives: another scalar type would be compiled for this alone.
            let constant = point.map(Dual::constant);
            derivatives(model, &constant).map(|expected| found.into_iter().zip(expected))
        });
        let rates = match rates {
            Ok(rates) => rates,
            Err(why) => return Row::skipped(EXACT, why.to_string()),
        };
        for ((found, expected), state) in rates.zip(&model.states) {
            let (Some(found), Some(expected)) = (found.0, expected.value.0) else {
                return Row::skipped(EXACT, format!("der({}) is not rational", state.name));
            };
            let fault = format!("der({}) is another function", state.name);
            if found != expected && !faults.contains(&fault) {
                faults.push(fault);
            }
        }
    }
    let chance = POINTS as f64 * (DEGREE / 2f64.powi(61)).log10();
    let says = format!("identical but for a chance below 1e{chance:.0}");
    Row::counted(EXACT, POINTS, &faults, &says)
}

/// The model without stated equations and clock, under a force and a moment that are its last two inputs.
pub fn free_loads(model: &Model) -> Model {
    let mut model = model.clone();
    let mut load = |name: &str| {
        let index = model.inputs.len();
        model.inputs.push(Input {
            name: name.to_owned(),
            ..Input::default()
        });
        let value = Expr {
            kind: ExprKind::Input(index),
            shape: Shape::Vector(0),
            unit: Unit::default(),
            span: Span::default(),
        };
        vec![Load {
            name: name.to_owned(),
            value,
            span: Span::default(),
            effect: None,
        }]
    };
    let (force, moment) = (load("free_force"), load("free_moment"));
    model.forces = force;
    // Stated equations of added states and the clock are checked by the vector tree instead.
    model.equations.clear();
    model.clock = None;
    model.moments = if model.has_rotating_body() {
        moment
    } else {
        Vec::new()
    };
    model
}
