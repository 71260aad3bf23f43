//! Lack of fit of poses, whose positions show the spin only where they are not those of the mass centre.

use dataset::pose::pose;
use dataset::synthesize::{Plan, flights};
use dataset::{Dataset, Sensor, SensorKind};
use flight::release::{Vocabulary, built_in, read};
use identify::{FitOptions, fit};
use model_spec::model::Model;
use nalgebra::Vector3;

/// Flights of a disc, recorded as poses of a point `beside` the mass centre, m, in the body.
fn tracked(model: &Model, beside: Vector3<f64>) -> Dataset {
    let text = built_in("backhand").expect("built in");
    let release = read("backhand", text, |_| Ok(Vocabulary::of(model))).expect("a release");
    let plan = Plan {
        flights: 4,
        duration: Some(0.7),
        ..Plan::default()
    };
    let mut dataset = flights(model, &[release], &plan).expect("made").dataset;
    let markers = std::mem::take(&mut dataset.markers);
    let markers: Vec<[f64; 3]> = markers.iter().map(|own| own.position).collect();
    dataset.sensors = vec![Sensor::new("body", SensorKind::Pose, [0.0; 3])];
    for flight in &mut dataset.flights {
        let rows = std::mem::take(&mut flight.positions);
        flight.positions = vec![Vec::new(); rows.len()];
        let rows = rows.iter().map(|row| match pose(&markers, row) {
            None => vec![None, None],
            Some(found) => {
                let [x, y, z] = (found.position + found.attitude * beside).into();
                let [qx, qy, qz, qw] = found.attitude.coords.into();
                vec![Some([x, y, z, 0.0]), Some([qw, qx, qy, qz])]
            }
        });
        flight.readings = rows.collect();
    }
    dataset
}

#[test]
fn poses_beside_the_mass_centre_are_no_noise() {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let tested = |beside: Vector3<f64>| {
        let dataset = tracked(&model, beside);
        let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
        let found = found.with_lack_of_fit(1).expect("a test").report;
        found.lack_of_fit.expect("enough samples")
    };
    let right = tested(Vector3::zeros());
    assert!(right.p_value > 0.01, "{right:?}");
    let beside = tested(Vector3::x() * 0.03);
    assert!(beside.p_value < 1e-6, "{beside:?}");
    assert!(beside.noise_m < 2.0 * right.noise_m, "{beside:?} {right:?}");
}
