//! What each flight has of its own: inputs over time, unknown quantities, and those measured with an error.

use std::collections::BTreeMap;

use dataset::synthesize::{Corruption, Plan, Spread, flights};
use dataset::{Dataset, KnownValue};
use flight::release::{Release, Stop};
use flight::{InputInterpolation, InputSeries};
use identify::{FitOptions, FitReport, fit};
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

/// The dataset with noise of standard deviation `sigma` in what was recorded of the inputs.
fn with_noisy_inputs(mut dataset: Dataset, sigma: f64, seed: u64) -> Dataset {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let noise = Normal::new(0.0, sigma).expect("a deviation");
    let interpolation = dataset.input_interpolation;
    for flight in &mut dataset.flights {
        for (_, series) in &mut flight.inputs {
            let samples = series.samples();
            let samples = samples.map(|(t, value)| (t, value + noise.sample(&mut random)));
            *series = InputSeries::new(&samples.collect::<Vec<_>>(), interpolation);
        }
    }
    dataset
}

/// Report of a fit of the drone, tested for lack of fit.
fn tested(dataset: &Dataset) -> FitReport {
    let found = fit(&drone(), dataset, &FitOptions::default()).expect("a fit");
    found.with_lack_of_fit(1).expect("a test").report
}

#[test]
fn noise_of_a_recorded_input_is_named() {
    let dataset = flown(&drone(), InputInterpolation::Linear);
    let clean = tested(&dataset);
    assert!(clean.reliable, "{:?}", clean.cautions);
    let noisy = tested(&with_noisy_inputs(dataset, 0.01, 4));
    let found = noisy.lack_of_fit.and_then(|test| test.input_noise);
    let found = found.expect("noise of an input");
    assert_eq!(found.input, "throttle");
    assert!((found.sigma / 0.01 - 1.0).abs() < 0.2, "{found:?}");
    assert!(found.effect > 1.0 && !noisy.reliable, "{found:?}");
}

/// In one flight noise has few ways to move the predictions, and the fit takes most of them: one draw may move them far
/// more than another.
#[test]
fn noise_of_an_input_is_named_in_single_flights() {
    let mut dataset = flown(&drone(), InputInterpolation::Hold);
    dataset.flights.truncate(1);
    let missed = (0..20).filter(|&seed| {
        let noisy = tested(&with_noisy_inputs(dataset.clone(), 0.02, seed));
        let test = noisy.lack_of_fit.expect("a test");
        test.p_value < 0.01 && test.input_noise.is_none()
    });
    assert_eq!(missed.collect::<Vec<_>>(), Vec::<u64>::new());
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

#[test]
fn an_input_over_time_is_no_number_to_estimate_and_keeps_its_bounds_between_samples() {
    let model = drone();
    let mut dataset = flown(&model, InputInterpolation::Linear);
    let full = [0.0, 0.5, 1.0, 1.5, 2.0, 2.5].map(|t| (t, if t < 1.0 { 0.0 } else { 2.0 }));
    for (flight, kind) in [
        (0, InputInterpolation::Cubic),
        (1, InputInterpolation::Linear),
    ] {
        dataset.flights[flight].inputs[0].1 = InputSeries::new(&full, kind);
    }
    let options = FitOptions {
        trust_data: true,
        ..FitOptions::default()
    };
    let found = fit(&model, &dataset, &options).expect("a fit");
    let told = |flight: usize| found.report.flights[flight].notes.join("; ");
    let (cubic, linear) = (told(0), told(1));
    assert!(
        cubic.contains("the input throttle is −0.262") && cubic.contains("beyond its bounds 0"),
        "{cubic}"
    );
    assert!(!linear.contains("beyond its bounds"), "{linear}");
    let held = [("c".to_owned(), Some(-1.0))];
    let beyond = FitOptions {
        fixed: &held,
        ..options
    };
    let refused = fit(&model, &dataset, &beyond).err().expect("no fit");
    let refused = refused.to_string();
    assert!(refused.contains("the fixed value of c is -1"), "{refused}");
    let free = ["throttle".to_owned()];
    let options = FitOptions {
        free: &free,
        ..options
    };
    let refused = fit(&model, &dataset, &options).err().expect("no fit");
    let refused = refused.to_string();
    assert!(refused.contains("bias_of_throttle"), "{refused}");
}

/// The flights of [`flown`], and a fifth one with a throttle of 0.8 throughout, of which nothing is recorded.
fn flown_with_a_constant(model: &Model) -> Dataset {
    let mut dataset = flown(model, InputInterpolation::Linear);
    let mut release = Release {
        stop: Stop::Duration(2.0),
        ..Release::of(model).with_initial("z", 5.0)
    };
    release.parameters.push(("throttle".into(), 0.8));
    let plan = Plan {
        flights: 1,
        rate: 100.0,
        seed: 50,
        noise: Corruption {
            sigma: 1e-3,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let made = flights(model, &[release], &plan).expect("made").dataset;
    let mut last = made.flights.into_iter().next().expect("one");
    last.file = "last.csv".into();
    last.known.clear();
    dataset.flights.push(last);
    dataset
}

#[test]
fn an_input_may_be_unknown_in_one_flight_and_recorded_in_the_others() {
    let model = drone();
    let mut dataset = flown_with_a_constant(&model);
    let check = |dataset: &Dataset| {
        dataset.validate().expect("a dataset that files hold");
        // A throttle that nobody states looks like another gravity.
        let options = FitOptions {
            trust_data: true,
            ..FitOptions::default()
        };
        let found = fit(&model, dataset, &options).expect("a fit");
        let excluded: Vec<_> = found.report.excluded().map(|own| &own.notes).collect();
        assert!(excluded.is_empty(), "{excluded:?}");
        for (name, value) in [("k", 8.0), ("c", 0.1)] {
            let own = &found.report.coefficients[name];
            assert!(
                (own.value - value).abs() < 4.0 * own.std_error && own.std_error < 0.02 * value,
                "{name}: {own:?}"
            );
        }
        let of_flight = |index: usize| found.report.flights[index].initial["throttle_constant"];
        assert_eq!((of_flight(0).value, of_flight(0).std_error), (0.0, 0.0));
        let own = of_flight(4);
        assert!(
            (own.value - 0.8).abs() < 4.5 * own.std_error && own.std_error < 0.01,
            "{own:?}"
        );
        let drone = model_spec::load::from_text("drone.hyz", DRONE, &[]).expect("a drone");
        let text = found.fitted_text(&drone, dataset, "").expect("a model");
        assert!(text.contains("input throttle = 0.7"), "{text}");
    };
    dataset.flights[4].unknown = vec!["throttle".into()];
    check(&dataset);
    dataset.flights[4].unknown.clear();
    dataset.flights[4].known = BTreeMap::from([
        ("throttle".into(), KnownValue::Scalar(0.85)),
        ("throttle_sigma".into(), KnownValue::Scalar(0.05)),
    ]);
    check(&dataset);
    // In every flight that does not state it.
    dataset.flights[4].known.clear();
    dataset.unknown = vec!["throttle".into()];
    check(&dataset);
    dataset.flights[1].inputs[0].1 =
        InputSeries::new(&[(0.0, 0.7), (3.0, 7.0)], InputInterpolation::Linear);
    let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit of the others");
    let notes = &found.report.flights[1].notes;
    assert!(
        notes[0].contains("expected 0 to 2, its bounds in the model"),
        "{notes:?}"
    );
}

#[test]
fn an_effect_on_a_recorded_input_is_found_beside_a_flight_in_which_it_is_unknown() {
    let late = drone();
    let tree = model_spec::ModelTree::of(&late);
    let late = tree.with_named(["delay_of_throttle"]).expect("a delay");
    let late = late.check().expect("a model");
    let mut dataset = flown_with_a_constant(&drone());
    dataset.flights[4].unknown = vec!["throttle".into()];
    for (_, series) in dataset.flights.iter_mut().flat_map(|own| &mut own.inputs) {
        let times = (0..=206).map(|k| f64::from(k) * 0.01);
        let samples: Vec<(f64, f64)> = times.map(|t| (t, series.at(t + 0.05))).collect();
        *series = InputSeries::new(&samples, InputInterpolation::Linear);
    }
    let found = fit(&late, &dataset, &FitOptions::default()).expect("a fit");
    let own = &found.report.coefficients["k_delay_of_throttle"];
    assert!((own.value - 0.05).abs() < 0.005, "{own:?}");
}

#[test]
fn a_flight_without_the_table_that_others_have_is_told() {
    let model = drone();
    let dataset = flown_with_a_constant(&model);
    let notes_of = |dataset: &Dataset| {
        let found = fit(&model, dataset, &FitOptions::default());
        found.expect("a fit").report.notes
    };
    let told = "the input throttle has no table in last.csv, as it has in other flights: it is taken as 0.7";
    let notes = notes_of(&dataset);
    assert!(notes.iter().any(|own| own.contains(told)), "{notes:?}");
    let mut stated = dataset.clone();
    stated.flights[4].known = BTreeMap::from([("throttle".into(), KnownValue::Scalar(0.8))]);
    assert_eq!(notes_of(&stated), Vec::<String>::new());
    // Beside a flight in which it is unknown, too.
    stated.flights[3].inputs.clear();
    stated.flights[3].unknown = vec!["throttle".into()];
    stated.flights[4].known.clear();
    let notes = notes_of(&stated);
    assert!(notes.iter().any(|own| own.contains(told)), "{notes:?}");
}

#[test]
fn a_constant_that_the_dataset_sets_may_be_unknown_in_a_flight() {
    let model = drone();
    let mut dataset = flown(&model, InputInterpolation::Linear);
    dataset.parameters.insert("g".into(), 9.81);
    let gravity = |dataset: &Dataset, flight: usize| {
        let found = fit(&model, dataset, &FitOptions::default()).expect("a fit");
        found.report.flights[flight].initial["g"]
    };
    dataset.flights[3].unknown = vec!["g".into()];
    let (known, own) = (gravity(&dataset, 0), gravity(&dataset, 3));
    assert_eq!((known.value, known.std_error), (9.81, 0.0));
    assert!((own.value - 9.81).abs() < 4.5 * own.std_error, "{own:?}");
    dataset.parameters.insert("g".into(), 9.7);
    assert_eq!(gravity(&dataset, 0).value, 9.7);
}

/// Flights of a ball with lift by spin, whose spins differ, and the spins.
fn spinning() -> (Model, Dataset, Vec<[f64; 3]>) {
    let model = model_spec::load::load("ball", &["magnus"]).expect("a ball");
    let serve = crate::support::release("serve", &model);
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
    let ball = model_spec::load::load("ball", &["magnus"]).expect("a ball");
    let text = found.fitted_text(&ball, &dataset, "").expect("a model");
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
