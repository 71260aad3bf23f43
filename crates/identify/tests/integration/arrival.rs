//! Fits arrive: one flight that cannot be fitted does not end a fit, a deadline does, and hidden directions are found.

use std::time::Instant;

use crate::support::release;
use dataset::synthesize::{Plan, flights};
use dataset::{Dataset, Role};
use flight::release::Release;
use identify::{FitOptions, FitStatus, FlightOutcome, fit};
use model_spec::model::Model;

fn released(effects: &[&str], changed: &[(&str, f64)]) -> (Model, Model, Release) {
    let base = model_spec::load::load("disc", &[]).expect("a model");
    let release = release("backhand", &base);
    let model = model_spec::load::load("disc", effects).expect("effects");
    let mut truth = model.clone();
    for (name, value) in changed {
        let mut coefficients = truth.coefficients.iter_mut();
        let coefficient = coefficients.find(|coefficient| coefficient.name == *name);
        coefficient.expect("a coefficient").value = *value;
    }
    (model, truth, release)
}

fn made(truth: &Model, release: &Release, plan: &Plan) -> Dataset {
    let made = flights(truth, std::slice::from_ref(release), plan);
    made.expect("made").dataset
}

fn trusting() -> FitOptions<'static> {
    FitOptions {
        trust_data: true,
        ..FitOptions::default()
    }
}

#[test]
fn flights_that_cannot_be_fitted_are_excluded_and_the_others_fitted() {
    let (model, truth, release) = released(&[], &[("C_D0", 0.2)]);
    let plan = Plan {
        flights: 8,
        held_out: 2,
        duration: Some(0.4),
        ..Plan::default()
    };
    let mut dataset = made(&truth, &release, &plan);
    let clean = {
        let mut clean = dataset.clone();
        clean.flights.remove(6);
        clean.flights.remove(3);
        fit(&model, &clean, &trusting()).expect("a fit").report
    };
    // One jumps about, and a held-out one stands still.
    let first = dataset.flights[6].positions[0].clone();
    dataset.flights[6].positions.fill(first);
    for (sample, row) in dataset.flights[3].positions.iter_mut().enumerate() {
        for (marker, point) in row.iter_mut().flatten().enumerate() {
            let phase = 7919.0 * (sample * 3 + marker) as f64;
            *point = [0.0, 1.0, 2.0].map(|axis: f64| 5.0 * (phase + 2.4 * axis).sin());
        }
    }
    let found = fit(&model, &dataset, &trusting()).expect("a fit").report;
    let is_excluded = |flight: usize| {
        matches!(
            found.flights[flight].outcome,
            FlightOutcome::Excluded { .. }
        )
    };
    let excluded: Vec<usize> = (0..8).filter(|&flight| is_excluded(flight)).collect();
    let flights: Vec<_> = found.flights.iter().map(|f| (f.rms(), &f.notes)).collect();
    assert_eq!(excluded, [3], "{flights:?} {:?}", found.iterations);
    assert_eq!(found.used(Role::Fit).count(), 5);
    for (name, coefficient) in &found.coefficients {
        let clean = &clean.coefficients[name];
        let difference = (coefficient.value - clean.value).abs();
        assert!(difference < 0.2 * clean.std_error, "{name}: {difference}");
    }
    assert!(
        found.reliable,
        "one of six flights left out: {:?}",
        found.cautions
    );
}

/// Two short simulated flights of the disc model without effects.
fn two_flights() -> (Model, Dataset) {
    let (model, truth, release) = released(&[], &[]);
    let plan = Plan {
        flights: 2,
        duration: Some(0.3),
        ..Plan::default()
    };
    (model, made(&truth, &release, &plan))
}

#[test]
fn a_fit_without_a_usable_flight_says_why_of_each() {
    let (model, mut dataset) = two_flights();
    for flight in &mut dataset.flights {
        // One marker alone never shows an attitude.
        for row in &mut flight.positions {
            row[1..].fill(None);
        }
    }
    let error = fit(&model, &dataset, &trusting()).err().expect("no fit");
    let text = error.to_string();
    assert!(
        text.contains("flight01.csv") && text.contains("flight02.csv"),
        "{text}"
    );
}

#[test]
fn a_fit_of_bodies_that_never_move_is_not_to_be_relied_on() {
    let (model, mut dataset) = two_flights();
    for flight in &mut dataset.flights {
        let first = flight.positions[0].clone();
        flight.positions.fill(first);
    }
    let error = fit(&model, &dataset, &FitOptions::default()).err();
    assert!(matches!(error, Some(identify::FitError::FaultyData(faults)) if faults.len() == 2));
    // Flights that are used all the same are excluded, or give a fit that says what is wrong with it.
    match fit(&model, &dataset, &trusting()) {
        Ok(found) => assert!(!found.report.reliable && !found.report.cautions.is_empty()),
        Err(error) => assert!(error.to_string().contains("flight02.csv"), "{error}"),
    }
}

#[test]
fn markers_that_are_not_where_they_are_stated_are_named() {
    let (model, mut dataset) = two_flights();
    let right = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    assert_eq!(right.report.marker_distances, []);
    dataset.markers[1].position[0] += 0.005;
    let found = fit(&model, &dataset, &FitOptions::default())
        .expect("a fit")
        .report;
    let pairs: Vec<_> = found
        .marker_distances
        .iter()
        .map(|d| d.markers.join(" "))
        .collect();
    let moved = dataset.markers[1].name.as_str();
    assert!(
        !pairs.is_empty() && pairs.iter().all(|pair| pair.contains(moved)),
        "{pairs:?}"
    );
    assert!(
        !found.reliable
            && found
                .cautions
                .join(" ")
                .contains("correct the positions of the markers")
    );
}

/// Tests the noise floor for ten samples per second, between which the body turns by more than half a turn.
#[test]
fn residuals_of_few_samples_are_held_against_the_rigidity_of_the_markers() {
    let (model, truth, release) = released(&[], &[]);
    let plan = Plan {
        flights: 2,
        duration: Some(1.0),
        ..Plan::default()
    };
    let mut dataset = made(&truth, &release, &plan);
    for flight in &mut dataset.flights {
        flight.times = flight.times.iter().copied().step_by(12).collect();
        flight.positions = flight.positions.iter().step_by(12).cloned().collect();
    }
    let found = fit(&model, &dataset, &FitOptions::default())
        .expect("a fit")
        .report;
    let floor = found.noise["marker"].floor.expect("a noise floor");
    assert!((floor / 0.0015 - 1.0).abs() < 0.3, "{floor}");
    assert!(
        found.reliable && found.rms() < 0.002,
        "{} {:?}",
        found.rms(),
        found.cautions
    );
}

#[test]
fn a_deadline_ends_a_fit_with_an_answer_that_says_so() {
    let (model, truth, release) = released(&[], &[("C_D0", 0.2)]);
    let dataset = made(&truth, &release, &Plan::default());
    let options = FitOptions {
        deadline: Some(Instant::now()),
        ..trusting()
    };
    let report = fit(&model, &dataset, &options).expect("a fit").report;
    assert_eq!(report.iterations.status, FitStatus::Deadline);
    assert!(!report.iterations.converged && !report.reliable);
    assert!(report.cautions.iter().any(|why| why.contains("time limit")));
}

#[test]
fn an_angle_that_has_no_effect_at_a_bound_is_found() {
    // At `C_Da = 0` the angle of least drag has no effect on anything.
    let truth = [("alpha_0", 0.12), ("C_Da", 1.0), ("C_D0", 0.05)];
    let (model, truth, release) = released(&["zero_lift_drag_angle"], &truth);
    let mut model = model;
    for coefficient in &mut model.coefficients {
        if coefficient.name == "C_Da" {
            coefficient.value = 0.0;
        }
    }
    let plan = Plan {
        flights: 6,
        duration: Some(0.5),
        ..Plan::default()
    };
    let dataset = made(&truth, &release, &plan);
    let report = fit(&model, &dataset, &trusting()).expect("a fit").report;
    let alpha_0 = &report.coefficients["alpha_0"];
    assert!(
        (alpha_0.value - 0.12).abs() < 4.0 * alpha_0.std_error,
        "{alpha_0:?}"
    );
    assert!(report.rms() < 1.6e-3, "{}", report.rms());
}
