//! The least squares alone come back to where the whole fit had ended.

use flight::release::{Vocabulary, built_in, read};
use identify::dataset::Role;
use identify::fit::{FitError, Fitted, fit};
use identify::options::Options;
use identify::report::Estimate;
use identify::synthesize::{Noise, Plan, flights};
use nalgebra::DVector;

/// Throws with outliers, of which the last is held out.
fn fitted() -> Fitted {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let backhand = built_in("backhand").expect("built in");
    let release = read("backhand", backhand, |_| Ok(Vocabulary::of(&model))).expect("a release");
    let plan = Plan {
        flights: 5,
        held_out: 1,
        duration: Some(0.5),
        noise: Noise {
            outliers: 0.01,
            outlier_size: 0.2,
            ..Noise::default()
        },
        seed: 3,
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("made");
    fit(&model, &made.dataset, &Options::default()).expect("a fit")
}

/// The shared unknowns and the initial states of the fit, each so many of its standard errors away, to either side in turn.
fn away(fitted: &Fitted, apart: f64) -> (DVector<f64>, Vec<DVector<f64>>) {
    let moved = |(i, (value, error)): (usize, (f64, f64))| {
        value + apart * error * if i.is_multiple_of(2) { 1.0 } else { -1.0 }
    };
    let each = fitted.setting().shared.iter();
    let each = each.map(|shared| &fitted.report.coefficients[&shared.name]);
    let shared: Vec<f64> = each
        .map(|c| (c.value, c.std_error))
        .enumerate()
        .map(moved)
        .collect();
    let states = &fitted.setting().body.layout().states;
    let of_fit = fitted
        .report
        .flights
        .iter()
        .filter(|flight| flight.role == Role::Fit);
    let own = of_fit.map(|flight| {
        let each = states.iter().map(|name| &flight.initial[name]);
        let each = each.map(|&Estimate { value, std_error }| (value, std_error));
        DVector::from_vec(each.enumerate().map(moved).collect())
    });
    (DVector::from_vec(shared), own.collect())
}

#[test]
fn they_come_back_from_three_standard_errors_away() {
    let fitted = fitted();
    assert!(fitted.report.noise.outliers > 0, "outliers stay out");
    let (shared, own) = away(&fitted, 3.0);
    let found = fitted.solve_from(&shared, &own, fitted.noise(), &Options::default());
    let found = found.expect("a solution");
    assert!(found.converged && found.iterations > 1);
    for (i, shared) in fitted.setting().shared.iter().enumerate() {
        let there = &fitted.report.coefficients[&shared.name];
        let apart = (found.point.shared[i] - there.value) / there.std_error;
        // A last step that nobody saw is a thirtieth of a standard error at most.
        assert!(apart.abs() < 0.04, "{}: {apart}", shared.name);
    }
}

#[test]
fn values_that_are_not_those_of_the_unknowns_are_refused() {
    let fitted = fitted();
    let (shared, mut own) = away(&fitted, 0.0);
    own.pop();
    let refused = fitted.solve_from(&shared, &own, fitted.noise(), &Options::default());
    assert!(matches!(refused, Err(FitError::Mismatch(_))));
}
