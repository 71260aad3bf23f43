//! What each flight has of its own: inputs over time, unknown quantities, and those measured with an error.

use std::collections::BTreeMap;

use dataset::synthesize::{Corruption, Plan, Spread, flights};
use dataset::{Dataset, KnownValue};
use flight::release::{Release, Stop, Vocabulary, built_in, read};
use flight::{InputInterpolation, InputSeries};
use identify::{FitOptions, fit};
use model_spec::model::Model;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, Normal};

const DRONE: &str = "
model drone;
param m = 0.5 kg;
param g = 9.81 m/s^2;
coefficient k = 8 N in 0 .. 20;
coefficient c = 0.1 N*s/m in 0 .. 5;
input throttle = 0.7 in 0 .. 2;
frame N;
point drone { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force weight = -m*g*N.3;
force thrust = k*throttle^2*N.3;
force drag = -c*velocity;
marker mark in N;
observe mark = position + mark;
";

fn drone() -> Model {
    model_spec::load::from_text("drone.hyz", DRONE, &[]).expect("a model")
}

/// Four flights of the drone by a throttle that differs between them.
fn flown(model: &Model, interpolation: InputInterpolation) -> Dataset {
    let plan = Plan {
        flights: 1,
        rate: 100.0,
        noise: Corruption {
            sigma: 1e-3,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let made = (0..4).map(|number| {
        let phase = f64::from(number);
        let throttle = |t: f64| 0.75 + 0.1 * (3.0 * t + phase).sin() + 0.05 * (11.0 * t).cos();
        let samples = (0..=110)
            .map(|k| f64::from(k) * 0.02)
            .map(|t| (t, throttle(t)));
        let release = Release {
            stop: Stop::Duration(2.0),
            inputs: vec![(
                "throttle".into(),
                InputSeries::new(&samples.collect::<Vec<_>>(), interpolation),
            )],
            ..Release::of(model)
                .with_initial("z", 5.0)
                .with_initial("vx", 1.0)
        };
        let plan = Plan {
            seed: 40 + number as u64,
            ..plan.clone()
        };
        flights(model, &[release], &plan).expect("made").dataset
    });
    let mut all: Vec<Dataset> = made.collect();
    let mut dataset = all.remove(0);
    dataset.input_interpolation = interpolation;
    for (index, other) in all.into_iter().enumerate() {
        let mut flight = other.flights.into_iter().next().expect("one");
        flight.file = format!("flight{}.csv", index + 2);
        dataset.flights.push(flight);
    }
    dataset
}

#[test]
fn coefficients_are_found_by_inputs_over_time() {
    let model = drone();
    for interpolation in [
        InputInterpolation::Linear,
        InputInterpolation::Hold,
        InputInterpolation::Cubic,
    ] {
        let dataset = flown(&model, interpolation);
        dataset.validate().expect("a dataset that files hold");
        let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
        assert!(found.report.reliable, "{:?}", found.report.cautions);
        for (name, value) in [("k", 8.0), ("c", 0.1)] {
            let own = &found.report.coefficients[name];
            let error = (own.value - value).abs();
            assert!(error < 4.0 * own.std_error, "{name}: {own:?}");
            assert!(own.std_error < 0.01 * value, "{name}: {own:?}");
        }
    }
}

#[test]
fn noise_of_a_recorded_input_is_named() {
    let model = drone();
    let mut dataset = flown(&model, InputInterpolation::Linear);
    let tested = |dataset: &Dataset| {
        let found = fit(&model, dataset, &FitOptions::default()).expect("a fit");
        found.with_lack_of_fit(1).expect("a test").report
    };
    let clean = tested(&dataset);
    assert!(clean.reliable, "{:?}", clean.cautions);
    let mut random = ChaCha12Rng::seed_from_u64(4);
    let noise = Normal::new(0.0, 0.01).expect("a deviation");
    for flight in &mut dataset.flights {
        for (_, series) in &mut flight.inputs {
            let samples = series.samples();
            let samples = samples.map(|(t, value)| (t, value + noise.sample(&mut random)));
            *series = InputSeries::new(&samples.collect::<Vec<_>>(), InputInterpolation::Linear);
        }
    }
    let noisy = tested(&dataset);
    let found = noisy.lack_of_fit.and_then(|test| test.input_noise);
    let found = found.expect("noise of an input");
    assert_eq!(found.input, "throttle");
    assert!((found.sigma / 0.01 - 1.0).abs() < 0.2, "{found:?}");
    assert!(found.effect > 1.0 && !noisy.reliable, "{found:?}");
}

#[test]
fn an_input_that_is_unknown_or_too_short_excludes_the_flight() {
    let model = drone();
    let mut dataset = flown(&model, InputInterpolation::Linear);
    let series = dataset.flights[0].inputs[0].1.clone();
    dataset.flights[0]
        .inputs
        .push(("trottle".into(), series.clone()));
    let samples: Vec<(f64, f64)> = series.samples().filter(|(t, _)| *t < 1.5).collect();
    dataset.flights[1].inputs[0].1 = InputSeries::new(&samples, InputInterpolation::Linear);
    let samples: Vec<(f64, f64)> = series
        .samples()
        .filter(|(t, _)| !(0.5..0.9).contains(t))
        .collect();
    dataset.flights[2].inputs[0].1 = InputSeries::new(&samples, InputInterpolation::Linear);
    let pulses = series.samples().map(|(t, value)| (t, 65_535.0 * value));
    let pulses: Vec<(f64, f64)> = pulses.collect();
    dataset.flights[3].inputs[0].1 = InputSeries::new(&pulses, InputInterpolation::Linear);
    let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit of the others");
    let told: Vec<String> = found
        .report
        .flights
        .iter()
        .map(|own| own.notes.join("; "))
        .collect();
    assert!(
        told[0].contains("trottle") && told[0].contains("it has throttle"),
        "{told:?}"
    );
    assert!(
        told[1].contains("given from 0 to 1.48 s, and the flight lasts from 0 to 2 s"),
        "{told:?}"
    );
    assert!(
        told[3].contains("at 0 s; expected 0 to 2, its bounds in the model"),
        "{told:?}"
    );
    assert!(
        told[2].contains("the input throttle is bridged over 0.42"),
        "{told:?}"
    );
}

/// Flights of a ball with lift by spin, whose spins differ, and the spins.
fn spinning() -> (Model, Dataset, Vec<[f64; 3]>) {
    let model = model_spec::load::load("ball", &["magnus"]).expect("a ball");
    let text = built_in("serve").expect("a release");
    let serve = read("serve", text, |_| Ok(Vocabulary::of(&model))).expect("a release");
    let spins: Vec<[f64; 3]> = (0..8)
        .map(f64::from)
        .map(|k| {
            [
                150.0 * (1.3 * k).sin(),
                200.0 * (2.1 * k).cos(),
                120.0 * (0.7 * k).sin(),
            ]
        })
        .collect();
    let releases = spins.iter().map(|spin| Release {
        known: vec![("omega".into(), *spin)],
        ..serve.clone().with_coefficient("C_Lw", 0.9)
    });
    let plan = Plan {
        flights: spins.len(),
        held_out: 2,
        spread: Spread::default(),
        rate: 200.0,
        noise: Corruption {
            sigma: 3e-4,
            ..Corruption::default()
        },
        seed: 5,
        ..Plan::default()
    };
    let made = flights(&model, &releases.collect::<Vec<_>>(), &plan).expect("made");
    (model, made.dataset, spins)
}

#[test]
fn a_spin_that_is_unknown_in_most_flights_is_found_in_each() {
    let (model, mut dataset, spins) = spinning();
    dataset.unknown = vec!["omega".into()];
    for (index, flight) in dataset.flights.iter_mut().enumerate() {
        match index {
            0 => {}
            // Measured with an error of its own.
            1 => {
                let off = spins[1].map(|rate| rate + 12.0);
                flight.known = BTreeMap::from([
                    ("omega".into(), KnownValue::Vector(off)),
                    ("omega_sigma".into(), KnownValue::Vector([15.0; 3])),
                ]);
            }
            _ => flight.known.clear(),
        }
    }
    dataset.validate().expect("a dataset that files hold");
    let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    let lift = &found.report.coefficients["C_Lw"];
    assert!(
        (lift.value - 0.9).abs() < 4.0 * lift.std_error && lift.std_error < 0.02,
        "{lift:?}"
    );
    for (flight, spin) in found.report.flights.iter().zip(&spins).take(6).skip(1) {
        for (axis, rate) in ["x", "y", "z"].iter().zip(spin) {
            let own = &flight.initial[&format!("omega_{axis}")];
            assert!(
                (own.value - rate).abs() < 4.5 * own.std_error,
                "{} {own:?} {rate}",
                flight.file
            );
            assert!(own.std_error < 100.0, "{own:?}");
        }
    }
    let known = &found.report.flights[0].initial["omega_x"];
    assert_eq!((known.value, known.std_error), (spins[0][0], 0.0));
    // The model that is written has the input, not the states.
    let tree = model_spec::ModelTree::load("ball").expect("a ball");
    let tree = tree.with_named(["magnus"]).expect("lift by spin");
    let text = found.fitted_text(&tree, &dataset, "").expect("a model");
    assert!(text.contains("input omega in N"), "{text}");
}

/// Lift is by the product of coefficient and spin: the data cannot contradict a value of one alone.
#[test]
fn a_coefficient_that_nothing_tells_from_the_spin_may_be_held() {
    let (model, mut dataset, _) = spinning();
    dataset.unknown = vec!["omega".into()];
    dataset
        .flights
        .iter_mut()
        .for_each(|flight| flight.known.clear());
    let options = FitOptions {
        fixed: &[("C_Lw".into(), Some(0.6))],
        ..FitOptions::default()
    };
    let found = fit(&model, &dataset, &options).expect("a fit");
    let conflicts = found.report.conflicts();
    assert!(conflicts.is_empty(), "{conflicts:?}");
}

#[test]
fn a_spin_that_nothing_determines_is_said_to_be_so() {
    let (_, mut dataset, _) = spinning();
    let ball = model_spec::load::load("ball", &[]).expect("a ball");
    dataset.unknown = vec!["omega".into()];
    dataset
        .flights
        .iter_mut()
        .for_each(|flight| flight.known.clear());
    let found = fit(&ball, &dataset, &FitOptions::default()).expect("a fit all the same");
    let note = "omega_x, omega_y, omega_z: not determined by this flight";
    let first = &found.report.flights[0];
    assert!(
        first.notes.iter().any(|own| own.contains(note)),
        "{:?}",
        first.notes
    );
}

#[test]
fn an_unknown_of_another_name_is_told() {
    let (model, mut dataset, _) = spinning();
    dataset.unknown = vec!["omga".into()];
    let error = fit(&model, &dataset, &FitOptions::default())
        .err()
        .expect("refused")
        .to_string();
    assert!(error.contains("did you mean `omega`?"), "{error}");
}
