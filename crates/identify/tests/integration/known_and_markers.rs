//! Refusals of what is known by halves, and several markers of a point mass.

use std::collections::BTreeMap;

use crate::support::release;
use dataset::synthesize::{Plan, flights};
use dataset::{KnownValue, Marker};
use identify::{FitError, FitOptions, FlightError, fit};

fn made(model: &str, name: &str, plan: &Plan) -> (model_spec::model::Model, dataset::Dataset) {
    let model = model_spec::load::load(model, &[]).expect("a model");
    let mut release = release(name, &model);
    release.stop = flight::release::Stop::Duration(0.5);
    let made = flights(&model, &[release], plan).expect("flights");
    (model, made.dataset)
}

#[test]
fn a_single_component_of_a_quaternion_is_refused() {
    let plan = Plan {
        flights: 1,
        duration: Some(0.5),
        ..Plan::default()
    };
    let (_, mut dataset) = made("disc", "backhand", &plan);
    let model = model_spec::load::load("disc_quaternion", &[]).expect("a model");
    let [first, ..] = model.quaternions().next().expect("a quaternion");
    let name = model.states[first].name.clone();
    dataset.model = model.name.clone();
    dataset.flights[0].known = BTreeMap::from([(name.clone(), KnownValue::Scalar(1.0))]);
    let Err(FitError::Flight { reason, .. }) = fit(&model, &dataset, &FitOptions::default()) else {
        panic!("one component alone is accepted");
    };
    assert!(matches!(reason, FlightError::PartialQuaternion { known, .. } if known == name));
}

#[test]
fn each_marker_of_a_point_mass_has_its_own_offset() {
    let marker = |name: &str, position| Marker {
        name: name.into(),
        position,
    };
    let plan = Plan {
        flights: 3,
        duration: Some(0.5),
        markers: vec![
            marker("front", [0.3, 0.0, 0.0]),
            marker("back", [-0.2, 0.1, 0.05]),
        ],
        ..Plan::default()
    };
    let (model, mut dataset) = made("ball", "serve", &plan);
    // Where the first marker is hidden, the second alone shows the ball.
    for flight in &mut dataset.flights {
        for row in &mut flight.positions[..12] {
            row[0] = None;
        }
    }
    let fitted = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    assert!(
        fitted.report.data_faults.is_empty(),
        "{:?}",
        fitted.report.data_faults
    );
    let start = &fitted.report.flights[0].initial;
    let (_, state) = fitted.flight(identify::FlightId::new(0)).expect("fitted");
    assert!(fitted.report.rms() < 0.002, "rms {}", fitted.report.rms());
    assert_eq!(start.len(), state.len());
}

/// Cautions of the fit of balls with a known side spin that the model lifts, whose coordinates x are multiplied by `x`.
fn cautions_of_spinning_balls(x: f64) -> Vec<String> {
    let mut model = model_spec::load::load("ball", &["magnus"]).expect("a model");
    let lift = model.coefficients.iter_mut().find(|own| own.name == "C_Lw");
    lift.expect("the lift by the spin").value = 0.8;
    let omega = model.inputs.iter_mut().find(|own| own.name == "omega");
    omega.expect("the spin").value = [0.0, 0.0, 250.0];
    let release = release("serve", &model);
    let plan = Plan {
        flights: 4,
        ..Plan::default()
    };
    let mut dataset = flights(&model, &[release], &plan).expect("flights").dataset;
    let rows = dataset
        .flights
        .iter_mut()
        .flat_map(|own| &mut own.positions);
    rows.flatten().flatten().for_each(|point| point[0] *= x);
    let fitted = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    fitted.report.cautions
}

#[test]
fn left_handed_axes_of_a_point_are_told_where_a_known_spin_contradicts_them() {
    assert_eq!(cautions_of_spinning_balls(1.0), Vec::<String>::new());
    let told = cautions_of_spinning_balls(-1.0);
    let is_own = |own: &String| own.starts_with("C_Lw") && own.contains("left-handed");
    assert!(told.iter().any(is_own), "{told:?}");
}

#[test]
fn a_point_that_is_off_in_a_held_out_flight_is_an_outlier() {
    let plan = Plan {
        flights: 4,
        held_out: 1,
        ..Plan::default()
    };
    let (model, mut dataset) = made("ball", "serve", &plan);
    let held_out = dataset.flights.last_mut().expect("held out");
    let point = held_out.positions[40][0].as_mut().expect("seen");
    point[1] += 0.3;
    let fitted = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    let report = fitted.report.flights.last().expect("predicted");
    assert_eq!(report.outliers, 1, "{report:?}");
    assert!(report.rms() < 0.01, "{report:?}");
}
