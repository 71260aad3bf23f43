//! Sudden changes of the motion, which end a flight unless the model predicts them.

use dataset::Dataset;
use dataset::synthesize::{Corruption, Plan, flights};
use flight::release::{Release, Stop};
use identify::{FitError, FitOptions, fit};
use model_spec::model::Model;

/// A stone whose force `push` is stated.
fn stone(push: &str) -> Model {
    let text = format!(
        "model stone;
param m = 1 kg;
param g = 9.81 m/s^2;
coefficient c = 3000 N/m in 0 .. 20000;
coefficient k = 0.01 kg/m in 0 .. 1;
frame N;
point stone {{ mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }}
let depth = max(-z, 0);
force weight = -m*g*N.3;
force push = {push};
force drag = -k*norm(velocity)*velocity;
marker mark in N;
observe mark = position + mark;
"
    );
    model_spec::load::from_text("stone.hyz", &text, &[]).expect("a model")
}

/// Three flights of a stone that falls from 2 m, onto z = 0 after 0.6 s.
fn falls(model: &Model) -> Dataset {
    let release = Release {
        stop: Stop::Duration(1.2),
        ..Release::of(model)
            .with_initial("z", 2.0)
            .with_initial("vx", 2.0)
    };
    let plan = Plan {
        flights: 3,
        rate: 120.0,
        noise: Corruption {
            sigma: 1e-3,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    flights(model, &[release], &plan).expect("made").dataset
}

const FLOOR: &str = "c*depth*N.3";

#[test]
fn a_contact_that_the_model_states_ends_no_flight() {
    let model = stone(FLOOR);
    let found = fit(&model, &falls(&model), &FitOptions::default()).expect("a fit");
    for flight in &found.report.flights {
        assert_eq!(flight.cut, None, "{}", flight.file);
    }
    let own = &found.report.coefficients["c"];
    assert!(own.std_error < 0.01 * own.value, "{own:?}");
    assert!((own.value - 3000.0).abs() < 4.0 * own.std_error, "{own:?}");
}

#[test]
fn a_touch_that_the_model_does_not_predict_ends_the_flight_whatever_it_switches() {
    let dataset = falls(&stone(FLOOR));
    let model = stone("c*(1e-9 m)*step(time - 0.3 s)*N.3");
    for trust_data in [false, true] {
        let options = FitOptions {
            trust_data,
            ..FitOptions::default()
        };
        let found = fit(&model, &dataset, &options).expect("a fit");
        for flight in &found.report.flights {
            assert!(flight.cut.is_some(), "{}", flight.file);
        }
    }
}

#[test]
fn a_push_is_a_hand_unless_the_model_predicts_it() {
    // Hands are looked for where bodies turn.
    let pushed_by = |metres: &str| {
        let text = format!(
            "model stone;
param m = 1 kg;
param I = 0.01 kg*m^2;
param g = 9.81 m/s^2;
coefficient c = 3000 N/m in 0 .. 20000;
coefficient k = 0.01 kg/m in 0 .. 1;
frame N;
frame A = N turned phi about 1;
frame B = A turned theta about 2;
frame C = B turned gamma about 3;
body stone {{
  mass m;
  inertia diag(I, I, I) in C;
  fixed in C;
  position (x, y, z) in N;
  velocity (vx, vy, vz) in N;
}}
force weight = -m*g*N.3;
force push = c*({metres})*step(0.4 s - time)*N.1;
force drag = -k*norm(velocity)*velocity;
marker mark in C;
observe mark = position + in_N(mark);
"
        );
        model_spec::load::from_text("stone.hyz", &text, &[]).expect("a model")
    };
    let model = pushed_by("1e-2 m");
    let dataset = falls(&model);
    let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    let own = &found.report.coefficients["c"];
    assert!(own.std_error < 0.01 * own.value, "{own:?}");
    assert!((own.value - 3000.0).abs() < 4.0 * own.std_error, "{own:?}");
    match fit(&pushed_by("1e-9 m"), &dataset, &FitOptions::default()) {
        Err(FitError::FaultyData(faults)) => assert_eq!(faults.len(), 3),
        other => panic!("{:?}", other.map(|fit| fit.report.cautions)),
    }
}
