//! Lack of fit of poses, whose positions show the spin only where they are not those of the mass centre.

use crate::support::release;
use dataset::pose::pose;
use dataset::synthesize::{Plan, flights};
use dataset::{Dataset, Sensor, SensorKind};
use identify::{FitError, FitOptions, fit};
use model_spec::model::Model;
use nalgebra::{UnitQuaternion, Vector3};

/// Flights of a disc, recorded as poses of a point `beside` the mass centre, m, in the body, with attitudes in a frame turned
/// about the vertical, rad.
fn tracked(model: &Model, beside: Vector3<f64>, turned: f64) -> Dataset {
    let turn = UnitQuaternion::from_scaled_axis(Vector3::z() * turned);
    let release = release("backhand", model);
    let plan = Plan {
        flights: 4,
        duration: Some(0.7),
        ..Plan::default()
    };
    let mut dataset = flights(model, &[release], &plan).expect("made").dataset;
    let markers = std::mem::take(&mut dataset.markers);
    let markers: Vec<[f64; 3]> = markers.iter().map(|own| own.position).collect();
    dataset.sensors = vec![Sensor::new("tag", SensorKind::Pose, [0.0; 3])];
    for flight in &mut dataset.flights {
        let rows = std::mem::take(&mut flight.positions);
        flight.positions = vec![Vec::new(); rows.len()];
        let rows = rows.iter().map(|row| match pose(&markers, row) {
            None => vec![None, None],
            Some(found) => {
                let [x, y, z] = (found.position + found.attitude * beside).into();
                let [qx, qy, qz, qw] = (turn * found.attitude).coords.into();
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
        let dataset = tracked(&model, beside, 0.0);
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

#[test]
fn attitudes_in_a_turned_frame_are_estimated_or_named() {
    let tilted = model_spec::load::load("disc", &["attitude_turned"]).expect("built in");
    let dataset = tracked(&tilted, Vector3::zeros(), 0.1);
    let report = fit(&tilted, &dataset, &FitOptions::default())
        .expect("a fit")
        .report;
    let turn = &report.coefficients["turned_3"];
    let expected = 2.0 * 0.05_f64.tan();
    assert!(
        (turn.value - expected).abs() < 4.0 * turn.std_error,
        "{turn:?}"
    );
    assert!(turn.std_error < 0.01, "{turn:?}");

    let told = |change: fn(&mut Dataset), turned: f64| {
        let model = model_spec::load::load("disc", &[]).expect("built in");
        let mut dataset = tracked(&model, Vector3::zeros(), turned);
        change(&mut dataset);
        match fit(&model, &dataset, &FitOptions::default()) {
            Err(FitError::FaultyData(faults)) => faults[0].correction.clone(),
            Err(error) => error.to_string(),
            Ok(_) => "fitted".to_owned(),
        }
    };
    assert_eq!(told(|_| (), 0.0), "fitted");
    assert_eq!(told(|_| (), 1.6), "turn the attitudes by -92° about z");
    let negated = |dataset: &mut Dataset| {
        let rows = dataset.flights.iter_mut().flat_map(|own| &mut own.readings);
        rows.flat_map(|row| &mut row[0])
            .for_each(|own| own[2] = -own[2]);
    };
    assert_eq!(told(negated, 0.0), "change the sign of tag_z");
}

#[test]
fn tilted_axes_of_poses_are_estimated_and_no_other_convention() {
    let model = model_spec::load::load("disc", &["template_tilt"]).expect("built in");
    for degrees in [10.0_f64, 30.0] {
        let tilt = UnitQuaternion::from_scaled_axis(Vector3::x() * degrees.to_radians());
        let mut dataset = tracked(&model, Vector3::zeros(), 0.0);
        let rows = dataset.flights.iter_mut().flat_map(|own| &mut own.readings);
        for own in rows.flat_map(|row| &mut row[1]) {
            let [x, y, z, w] = (dataset::attitude(*own) * tilt).coords.into();
            *own = [w, x, y, z];
        }
        let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
        let found = &found.report.coefficients["tilt_1"];
        let expected = 2.0 * f64::tan(degrees.to_radians() / 2.0);
        let error = (found.value - expected).abs();
        assert!(error < 4.0 * found.std_error, "{degrees}: {found:?}");
    }
}
