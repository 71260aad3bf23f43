//! Flights without a fault, of many kinds.

use ::flight::release::{Release, Stop};

use super::{ball, calm_disc, discs, found, model, plan, release};
use crate::synthesize::{Plan, Spread, flights};

#[test]
fn clean_flights_have_no_fault() {
    let (model, datasets) = discs(6, 1);
    assert!(datasets.len() > 4);
    for (k, dataset) in datasets.iter().enumerate() {
        assert_eq!(found(&model, dataset), [], "dataset {k}");
    }
    let (model, dataset) = ball(2);
    assert_eq!(found(&model, &dataset), []);
}

#[test]
fn flights_whose_markers_are_often_hidden_have_no_fault() {
    for seed in 0..6 {
        let (model, mut dataset) = calm_disc(seed);
        let mut state = seed;
        let points = dataset
            .flights
            .iter_mut()
            .flat_map(|own| &mut own.positions);
        for point in points.flatten() {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            if (state >> 40) as f64 / f64::from(1 << 24) < 0.4 {
                *point = None;
            }
        }
        assert_eq!(found(&model, &dataset), [], "seed {seed}");
    }
}

/// Tests that no fault is reported for many flights of a disc and a ball without mistakes in the data; run with
/// `--ignored` in a release build.
#[test]
#[ignore = "takes long"]
fn two_thousand_clean_flights_have_no_fault() {
    let (mut count, mut alarms) = (0, 0);
    for seed in 0..30 {
        let (model, datasets) = discs(12, 1000 * seed);
        for dataset in datasets {
            let faults = found(&model, &dataset);
            count += dataset.flights.len();
            alarms += faults.len();
            for fault in faults {
                eprintln!("disc {seed} {fault}");
            }
        }
        let (model, dataset) = ball(seed);
        let faults = found(&model, &dataset);
        count += dataset.flights.len();
        alarms += faults.len();
        for fault in faults {
            eprintln!("ball {seed} {fault}");
        }
    }
    eprintln!("{alarms} alarms in {count} flights");
    assert_eq!(alarms, 0);
}

#[test]
fn measured_flights_and_examples_have_no_fault() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = [
        "../shared/data/spindoe",
        "examples/ball",
        "examples/disc",
        "examples/mystery",
    ];
    for folder in folders {
        let path = root.join(folder);
        if !path.exists() {
            eprintln!("skipped: {folder} is absent");
            continue;
        }
        let dataset = crate::load(&path).expect("a dataset");
        assert_eq!(found(&model(&dataset.model), &dataset), [], "{folder}");
    }
}

#[test]
fn throws_that_are_upside_down_are_no_mirror_images() {
    let model = model("disc");
    let mut usual = release(&model, "backhand");
    usual.stop = Stop::Duration(0.8);
    for (name, value) in &mut usual.initial {
        match name.as_str() {
            "phi" => *value += std::f64::consts::PI,
            "v" | "w" => *value = -*value,
            _ => {}
        }
    }
    let plan = Plan {
        duration: Some(0.8),
        ..plan(8, 11)
    };
    let made = flights(&model, &[usual], &plan).expect("flights");
    assert_eq!(found(&model, &made.dataset), []);
}

/// Tests that no fault is reported for flights without mistakes in the data, simulated with models that are not built
/// in.
#[test]
fn flights_of_other_models_have_no_fault() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/models");
    // Model name, and initial states other than the defaults.
    let cases: [(&str, &[(&str, f64)]); 6] = [
        ("shuttlecock", &[("vx", 40.0), ("vz", 10.0), ("z", 2.0)]),
        (
            "spinning_ball",
            &[("vx", 20.0), ("vz", 6.0), ("z", 2.0), ("p", 40.0)],
        ),
        (
            "quaternion_dart",
            &[("vx", 15.0), ("vz", 2.0), ("z", 2.0), ("p", 5.0)],
        ),
        ("glider", &[]),
        ("pendulum", &[("x", 1.5), ("z", -2.0)]),
        ("kite", &[]),
    ];
    for (name, initial) in cases {
        let path = root.join(format!("{name}.hyz"));
        let model = model(path.to_str().expect("a path"));
        let states = model.states.iter().map(|state| {
            let value = initial.iter().find(|(name, _)| *name == state.name);
            (
                state.name.clone(),
                value.map_or(state.value, |(_, value)| *value),
            )
        });
        let release = Release {
            model: model.name.clone(),
            stop: Stop::Duration(1.0),
            parameters: Vec::new(),
            coefficients: Vec::new(),
            initial: states.collect(),
            wind: [0.0; 3],
            wind_field: None,
            known: Vec::new(),
            inputs: Vec::new(),
        };
        for seed in 0..5 {
            let plan = Plan {
                spread: Spread {
                    fraction: 0.05,
                    ..Spread::default()
                },
                ..plan(8, seed)
            };
            match flights(&model, std::slice::from_ref(&release), &plan) {
                Ok(made) => assert_eq!(found(&model, &made.dataset), [], "{name}"),
                Err(error) => eprintln!("skipped: {name}: {error}"),
            }
        }
    }
}
