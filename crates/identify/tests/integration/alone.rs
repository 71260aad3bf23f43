//! The least squares alone come back to where the whole fit had ended.

use crate::support::release;
use dataset::Role;
use dataset::synthesize::{Corruption, Plan, flights};
use identify::{Estimate, Fit, FitError, FitOptions, fit};
use nalgebra::DVector;

/// Fit of the disc model to simulated flights with outliers; the last flight is held out.
fn fitted() -> Fit {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let release = release("backhand", &model);
    let plan = Plan {
        flights: 5,
        held_out: 1,
        duration: Some(0.5),
        noise: Corruption {
            outliers: 0.01,
            outlier_size: 0.2,
            ..Corruption::default()
        },
        seed: 3,
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("made");
    fit(&model, &made.dataset, &FitOptions::default()).expect("a fit")
}

/// Estimated global parameters and initial states of the fit. Each value is shifted by `apart` times its standard
/// error, with alternating sign.
fn away(fitted: &Fit, apart: f64) -> (DVector<f64>, Vec<DVector<f64>>) {
    let plus = |(i, (value, error)): (usize, (f64, f64))| {
        value + apart * error * if i.is_multiple_of(2) { 1.0 } else { -1.0 }
    };
    let each = fitted.problem().globals.iter();
    let each = each.map(|global| &fitted.report.coefficients[&global.name]);
    let global: Vec<f64> = each
        .map(|c| (c.value, c.std_error))
        .enumerate()
        .map(plus)
        .collect();
    let states = &fitted.problem().body.layout().states;
    let of_fit = fitted
        .report
        .flights
        .iter()
        .filter(|flight| flight.role == Role::Fit);
    let local = of_fit.map(|flight| {
        let each = states.iter().map(|name| &flight.initial[name]);
        let each = each.map(|&Estimate { value, std_error }| (value, std_error));
        DVector::from_vec(each.enumerate().map(plus).collect())
    });
    (DVector::from_vec(global), local.collect())
}

#[test]
fn they_come_back_from_three_standard_errors_away() {
    let fitted = fitted();
    assert!(
        fitted.report.noise["marker"].outliers > 0,
        "outliers stay out"
    );
    let (global, local) = away(&fitted, 3.0);
    let found = fitted.warm_start(&global, &local, fitted.noise(), &FitOptions::default());
    let found = found.expect("a solution");
    assert!(found.converged() && found.iterations > 1);
    for (i, global) in fitted.problem().globals.iter().enumerate() {
        let there = &fitted.report.coefficients[&global.name];
        let apart = (found.iterate.global[i] - there.value) / there.std_error;
        // A last step that nobody saw is a thirtieth of a standard error at most.
        assert!(apart.abs() < 0.04, "{}: {apart}", global.name);
    }
}

#[test]
fn values_that_are_not_those_of_the_unknowns_are_refused() {
    let fitted = fitted();
    let (global, mut local) = away(&fitted, 0.0);
    local.pop();
    let refused = fitted.warm_start(&global, &local, fitted.noise(), &FitOptions::default());
    assert!(matches!(refused, Err(FitError::WarmStartSize { .. })));
}
