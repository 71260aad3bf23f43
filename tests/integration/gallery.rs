//! The models of papers in examples/gallery: each is verified, flown, and its coefficients are recovered from flights.

use hyzer::{Fit, Model, Plan, Release, Spread, Stop};
use model_spec::load::inspect;
use std::path::PathBuf;
use verify::Options;
use verify::report::Outcome;

/// A flight of a model: name of its file, states at the release that are not their defaults, `omega`, and seconds.
type Case = (&'static str, &'static [(&'static str, f64)], [f64; 3], f64);

const SPIN: [f64; 3] = [20.0, -150.0, 60.0];

#[rustfmt::skip]
const CASES: [Case; 33] = [
    ("aeroplane", &[("gamma", 0.1)], [0.0; 3], 20.0),
    ("arrow", &[("vx", 55.0), ("vz", 6.0), ("z", 1.5), ("q", 0.4)], [0.0; 3], 1.2),
    ("balsa_glider", &[("vx", 6.0), ("z", 4.0), ("p", 0.2)], [0.0; 3], 2.0),
    ("baseball", &[("vx", 40.0), ("vz", 3.0), ("z", 2.0)], SPIN, 1.0),
    ("basketball", &[("vx", 6.0), ("vz", 8.0), ("z", 2.0)], [0.0, -15.0, 0.0], 1.2),
    ("boomerang", &[("vx", 20.0), ("vz", 3.0), ("q0", 0.6), ("q1", 0.8), ("r", 60.0), ("z", 2.0)], [0.0; 3], 1.0),
    ("bullet", &[("vx", 800.0), ("vz", 3.0)], [0.0; 3], 1.5),
    ("coin", &[("vz", 2.4), ("p", 5.0), ("q", 220.0), ("r", 30.0), ("z", 1.0)], [0.0; 3], 0.5),
    ("cricket_ball", &[("vx", 33.0), ("vz", 2.0), ("z", 2.0)], [0.0, 0.0, 80.0], 0.8),
    ("double_pendulum", &[], [0.0; 3], 2.0),
    ("euler_disc", &[], [0.0; 3], 1.0),
    ("falling_plate", &[], [0.0; 3], 0.4),
    ("javelin", &[("vx", 23.0), ("vz", 16.0), ("q0", 0.96), ("q2", -0.28), ("z", 2.0)], [0.0; 3], 3.0),
    ("kite", &[("x", 22.0), ("z", 20.0)], [0.0; 3], 3.0),
    ("knuckleball", &[("vx", 30.0), ("vz", 1.0), ("z", 2.0)], [0.0, 0.0, 4.0], 0.7),
    ("model_rocket", &[], [0.0; 3], 4.0),
    ("paper_aeroplane", &[], [0.0; 3], 2.0),
    ("parachute", &[("vx", 30.0), ("z", 500.0)], [0.0; 3], 5.0),
    ("parachute_payload", &[], [0.0; 3], 4.0),
    ("phugoid", &[("V", 2.6)], [0.0; 3], 4.0),
    ("samara", &[("z", 8.0), ("vz", -1.0), ("q", 2.0), ("s", 60.0)], [0.0; 3], 0.6),
    ("shell", &[], [0.0; 3], 8.0),
    ("shot", &[("vx", 10.0), ("vz", 9.0), ("z", 2.0)], [0.0; 3], 1.8),
    ("shuttlecock", &[("vx", 40.0), ("vz", 20.0), ("z", 2.0)], [0.0; 3], 1.5),
    ("shuttlecock_flip", &[("vx", -20.0), ("vz", 3.0), ("z", 2.0), ("q", 10.0)], [0.0; 3], 0.6),
    ("ski_jumper", &[("vx", 25.0), ("vz", 1.0), ("z", 10.0)], [0.0; 3], 3.5),
    ("soccer_ball", &[("vx", 22.0), ("vz", 9.0), ("z", 0.2)], SPIN, 1.6),
    ("spinning_top", &[], [0.0; 3], 1.0),
    ("taketombo", &[("vz", 1.0), ("r", 120.0), ("z", 1.5)], [0.0; 3], 1.0),
    ("tennis_ball", &[("vx", 30.0), ("vz", 4.0), ("z", 1.0)], SPIN, 1.0),
    ("tethered_kite", &[], [0.0; 3], 3.0),
    ("volleyball", &[("vx", 20.0), ("vz", 4.0), ("z", 2.5)], [0.0, 0.0, 0.5], 1.0),
    ("water_rocket", &[], [0.0; 3], 1.5),
];

/// Greatest distance of a recovered coefficient from the true one, standard errors.
const MAX_DISTANCE: f64 = 5.0;

fn path(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples/gallery");
    folder.join(format!("{name}.hyz"))
}

fn release(model: &model_spec::model::Model, (_, states, omega, duration): Case) -> Release {
    let states = states.iter();
    let mut release = states.fold(Release::of(model), |release, (state, value)| {
        release.with_initial(state, *value)
    });
    release.stop = Stop::Duration(duration);
    if model.inputs.iter().any(|input| input.name == "omega") {
        release.known.push(("omega".to_owned(), omega));
    }
    release
}

#[test]
fn each_model_is_verified_and_its_coefficients_are_recovered() {
    let folder = path("").with_file_name("");
    let files = std::fs::read_dir(folder).expect("the gallery");
    let models = files.filter(|file| {
        let path = file.as_ref().expect("a file").path();
        path.extension().is_some_and(|end| end == "hyz")
    });
    assert_eq!(models.count(), CASES.len());
    flight::parallel::each(CASES.len(), |k| check(CASES[k]));
}

fn check(case: Case) {
    let name = case.0;
    let path = path(name);
    let text = std::fs::read_to_string(&path).expect("a model");
    assert!(text.lines().count() <= 60, "{name} is long");
    let path = path.to_str().expect("a path");
    let loaded = inspect(path, &[]).unwrap_or_else(|error| panic!("{error}"));
    let options = Options {
        cases: 2,
        mutants: false,
        effects: false,
        ..Options::default()
    };
    let report = verify::run(&loaded, &options);
    let outcome = report.outcome();
    assert_eq!(outcome, Outcome::Verified, "{name}\n{}", report.table());

    let model = Model::load(path).unwrap_or_else(|error| panic!("{error}"));
    let release = release(loaded.model.as_ref().expect("a model"), case);
    let observation = loaded
        .model
        .as_ref()
        .and_then(|own| own.observation.as_ref());
    if observation.is_none() {
        let flown = model.fly(&release);
        flown.unwrap_or_else(|e| panic!("{name}: {e}"));
        return;
    }
    let plan = Plan {
        flights: 3,
        rate: 40.0,
        // A bottle's volume is small by any scale.
        spread: Spread {
            angle: 1e-4,
            ..Spread::default()
        },
        ..Plan::default()
    };
    let data =
        hyzer::synthesize(&model, &[release], &plan).unwrap_or_else(|e| panic!("{name}: {e}"));
    let fit = Fit::of(&model)
        .run(&data)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    for (coefficient, estimate) in fit.coefficients() {
        let model = loaded.model.as_ref().expect("a model");
        let own = model
            .coefficients
            .iter()
            .find(|own| own.name == coefficient);
        let distance = (estimate.value - own.expect("its coefficient").value).abs();
        assert!(
            distance <= MAX_DISTANCE * estimate.std_error,
            "{name}: {coefficient} is {} ± {}",
            estimate.value,
            estimate.std_error
        );
    }
}
