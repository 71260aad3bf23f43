//! A body that turns about one fixed axis: two markers show how.

use dataset::synthesize::{Corruption, Plan, Spread, flights};
use dataset::{Dataset, Marker};
use flight::release::{Release, Stop};
use identify::{FitError, FitOptions, fit};
use model_spec::model::Model;

const PLATE: &str = "
model plate;
param m = 0.4 kg;
param g = 9.81 m/s^2;
coefficient k = 0.4 kg/s in 0 .. 5;
coefficient d = 2 /s in 0 .. 20;
frame N;
frame A = N turned theta about 2;
state x = 0 m;
state z = 5 m;
state theta = 0.3 rad;
state vx = 1 m/s;
state vz = 0 m/s;
state q = 4 rad/s;
der(x) = vx;
der(z) = vz;
der(theta) = q;
der(vx) = -k/m*vx;
der(vz) = -k/m*vz - g;
der(q) = -d*q;
marker end in A;
observe end = (x, 0, z) in N + in_N(end);
";

fn made(markers: &[[f64; 3]]) -> (Model, Dataset) {
    let model = model_spec::load::from_text("plate.hyz", PLATE, &[]).expect("a model");
    let release = Release {
        stop: Stop::Duration(0.8),
        ..Release::of(&model)
    };
    let named = |(index, position): (usize, &[f64; 3])| Marker {
        name: format!("m{index}"),
        position: *position,
    };
    let plan = Plan {
        flights: 4,
        rate: 100.0,
        markers: markers.iter().enumerate().map(named).collect(),
        spread: Spread::default(),
        noise: Corruption {
            sigma: 1e-3,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let dataset = flights(&model, &[release], &plan)
        .expect("a flight")
        .dataset;
    (model, dataset)
}

#[test]
fn two_markers_show_how_a_body_turns_about_a_fixed_axis() {
    let (model, dataset) = made(&[[0.2, 0.0, 0.0], [-0.2, 0.0, 0.05]]);
    let found =
        fit(&model, &dataset, &FitOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert!(found.report.reliable, "{:?}", found.report.cautions);
    assert!(
        (found.report.rms() / 1e-3 - 1.0).abs() < 0.1,
        "{}",
        found.report.rms()
    );
    for (name, value) in [("k", 0.4), ("d", 2.0)] {
        let own = &found.report.coefficients[name];
        assert!(
            (own.value - value).abs() < 4.0 * own.std_error,
            "{name}: {own:?}"
        );
    }
}

#[test]
fn markers_on_the_axis_do_not_show_it() {
    for markers in [&[[0.0, 0.1, 0.0], [0.0, -0.1, 0.0]][..], &[[0.2, 0.0, 0.0]]] {
        let (model, dataset) = made(markers);
        let found = fit(&model, &dataset, &FitOptions::default());
        let Err(FitError::AttitudeNotObservable { markers: count, .. }) = found else {
            panic!("{markers:?} are taken");
        };
        assert_eq!(count, markers.len());
    }
}
