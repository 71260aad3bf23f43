//! What nobody measured: the spin of each flight, and a wind that is the same in all flights.

use dataset::Dataset;
use dataset::synthesize::{Corruption, Plan, flights};
use diagnose::{Diagnosis, DiagnosisOptions, diagnose};
use flight::release::Release;
use flight::{InputInterpolation, InputSeries};
use model_spec::load::{from_text, load};
use model_spec::model::Model;

/// Names of the effects of the best explanation.
fn named(found: &Diagnosis) -> Vec<&str> {
    let best = found.report.explanations.first();
    let effects = best.into_iter().flat_map(|best| &best.effects);
    effects.map(|effect| effect.name.as_str()).collect()
}

/// Sets states at the start of a release.
fn set(release: &mut Release, values: &[(&str, f64)]) {
    for (name, value) in values {
        let mut states = release.initial.iter_mut();
        let state = states.find(|(own, _)| own == name);
        state.expect("a state").1 = *value;
    }
}

/// Eight flights of a ball, each with a spin of its own that lifts it.
fn spun() -> Dataset {
    let lifted = load("ball", &["magnus"]).unwrap();
    let releases: Vec<Release> = (0..8)
        .map(|k| {
            let wave = |factor: f64| (factor * f64::from(k)).sin();
            let mut release = Release::of(&lifted);
            release.coefficients = vec![("C_Lw".into(), 1.0)];
            set(
                &mut release,
                &[
                    ("z", 2.0),
                    ("vx", 20.0 + 3.0 * wave(1.7)),
                    ("vy", wave(2.3)),
                    ("vz", 5.0 + wave(0.9)),
                ],
            );
            let spin = [60.0 * wave(1.1), 120.0 * wave(1.9), 150.0 * wave(0.7)];
            release.known = vec![("omega".into(), spin)];
            release
        })
        .collect();
    let plan = Plan {
        duration: Some(0.8),
        ..Plan::default()
    };
    let mut dataset = flights(&lifted, &releases, &plan).unwrap().dataset;
    for flight in &mut dataset.flights {
        flight.known.clear();
    }
    dataset
}

#[test]
fn lift_by_spins_that_are_stated_to_be_unknown_is_found() {
    let ball = load("ball", &[]).unwrap();
    let mut dataset = spun();
    for unknown in [vec![], vec!["omega".to_owned()]] {
        dataset.unknown = unknown;
        let found = diagnose(&ball, &dataset, &DiagnosisOptions::default()).unwrap();
        assert_eq!(
            named(&found),
            ["lift-by-unknown-spin"],
            "{}",
            found.report.summary
        );
    }
}

/// A multirotor as a point with a thrust along its tilt.
fn multirotor() -> Model {
    let text = "model multirotor; param m = 1.2 kg; param g = 9.81 m/s^2;
        coefficient k_T = 18 N in 0 .. 100; coefficient k_D = 0.08 kg/m in 0 .. 5;
        input throttle = 0.65; input tilt: rad = 0; input wind in N = (0, 0, 0) m/s; frame N;
        point rotor { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
        let air_velocity = velocity - wind; let V = norm(air_velocity);
        force weight = -m*g*N.3;
        force thrust = k_T*throttle*(sin(tilt)*N.1 + cos(tilt)*N.3);
        force drag = -k_D*V*air_velocity;
        marker mark in N; observe mark = position + mark;";
    from_text("multirotor.hyz", text, &[]).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_wind_of_all_flights_is_not_one_of_each() {
    let model = multirotor();
    for seed in 0..4_i32 {
        let releases: Vec<Release> = (0..5)
            .map(|k| {
                let wave = |factor: f64, t: f64| (factor * (t + f64::from(k + 5 * seed))).sin();
                let table = |value: &dyn Fn(f64) -> f64| {
                    let times = (0..=200).map(|i| f64::from(i) * 0.02);
                    let samples: Vec<(f64, f64)> = times.map(|t| (t, value(t))).collect();
                    InputSeries::new(&samples, InputInterpolation::Linear)
                };
                let mut release = Release::of(&model);
                let start = [
                    ("z", 20.0),
                    ("vx", 3.0 * wave(1.3, 0.0)),
                    ("vz", wave(0.8, 0.0)),
                ];
                set(&mut release, &start);
                release.wind = [3.0, 0.0, 0.0];
                release.inputs = vec![
                    (
                        "throttle".into(),
                        table(&|t| 0.65 + 0.12 * wave(4.3, t) + 0.1 * wave(2.1, t)),
                    ),
                    ("tilt".into(), table(&|t| 0.3 * wave(3.1, t))),
                ];
                release
            })
            .collect();
        let plan = Plan {
            flights: 5,
            duration: Some(3.9),
            rate: 50.0,
            noise: Corruption {
                sigma: 0.003,
                ..Corruption::default()
            },
            seed: seed.unsigned_abs().into(),
            ..Plan::default()
        };
        let mut dataset = flights(&model, &releases, &plan).unwrap().dataset;
        for flight in &mut dataset.flights {
            flight.known.clear();
        }
        let found = diagnose(&model, &dataset, &DiagnosisOptions::default()).unwrap();
        assert_eq!(
            named(&found),
            ["stream-wind"],
            "{seed}: {}",
            found.report.summary
        );
    }
}
