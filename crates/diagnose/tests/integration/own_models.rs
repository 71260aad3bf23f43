//! Models that are not built in: what their flights hide is found and sited, on flights by an integrator written here.

use std::fmt::Write;
use std::path::PathBuf;

use dataset::Dataset;
use diagnose::{DiagnosisOptions, Verdict, diagnose};
use model_spec::model::Model;
use nalgebra::{Rotation3, Vector3};
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, Normal};

type V = Vector3<f64>;

const MASS: f64 = 0.005;
const GRAVITY: f64 = 9.81;
const DRAG: f64 = 1.2 / 2.0 * std::f64::consts::PI / 4.0 * 0.066 * 0.066 * 0.52;
const SIGMA: f64 = 0.0015;

/// Positions of a body at 100 samples of 120 Hz, m, by the classical Runge–Kutta method, from its acceleration, m/s², as a
/// function of its velocity.
fn flown(mut velocity: V, acceleration: impl Fn(V) -> V) -> Vec<V> {
    let (mut position, mut seen) = (V::new(0.0, 0.0, 2.0), Vec::new());
    let steps = 20;
    let h = 1.0 / 120.0 / f64::from(steps);
    for _ in 0..100 {
        seen.push(position);
        for _ in 0..steps {
            let a = acceleration(velocity);
            let b = acceleration(velocity + a * (h / 2.0));
            let c = acceleration(velocity + b * (h / 2.0));
            let d = acceleration(velocity + c * h);
            position += velocity * h + (a + b + c) * (h * h / 6.0);
            velocity += (a + b * 2.0 + c * 2.0 + d) * (h / 6.0);
        }
    }
    seen
}

/// Dataset of flights with noise, written to a folder and read from it: the positions of the markers `on_body`, m, as
/// `flights[flight][sample][marker]`.
fn dataset(model: &str, on_body: &[V], flights: &[Vec<Vec<V>>], seed: u64) -> Dataset {
    let name = format!("hyzer-own-{}-{model}-{seed}", std::process::id());
    let folder: PathBuf = std::env::temp_dir().join(name);
    std::fs::create_dir_all(&folder).unwrap();
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let noise = Normal::new(0.0, SIGMA).unwrap();
    let mut manifest = format!("model = \"{model}\"\n");
    let mut header = String::from("t");
    for (k, at) in (1..).zip(on_body) {
        let at = [at.x, at.y, at.z];
        writeln!(manifest, "[[markers]]\nname = \"m{k}\"\nposition = {at:?}").unwrap();
        write!(header, ",m{k}_x,m{k}_y,m{k}_z").unwrap();
    }
    for (k, flight) in flights.iter().enumerate() {
        let mut table = header.clone();
        for (i, markers) in flight.iter().enumerate() {
            write!(table, "\n{}", i as f64 / 120.0).unwrap();
            for coordinate in markers.iter().flat_map(|marker| marker.iter()) {
                let seen = coordinate + noise.sample(&mut random);
                write!(table, ",{seen}").unwrap();
            }
        }
        let file = format!("flight{k}.csv");
        std::fs::write(folder.join(&file), table).unwrap();
        writeln!(manifest, "[[flights]]\nfile = \"{file}\"").unwrap();
    }
    std::fs::write(folder.join("dataset.toml"), manifest).unwrap();
    let dataset = dataset::load(&folder).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    dataset
}

/// Velocity at the start of flight `k`, m/s.
fn thrown(k: i32, slowest: f64) -> V {
    let heading = f64::from(k) * 0.7;
    let (speed, launch) = (slowest + 2.0 * f64::from(k), 0.2 + 0.1 * f64::from(k % 4));
    let level = speed * launch.cos();
    V::new(
        level * heading.cos(),
        level * heading.sin(),
        speed * launch.sin(),
    )
}

/// Eight simulated flights of a shuttlecock from `slowest`, m/s; `lacked` returns the acceleration that the model lacks, m/s².
fn shuttlecock(slowest: f64, lacked: impl Fn(V) -> V, seed: u64) -> Dataset {
    let acceleration = |velocity: V| {
        -V::z() * GRAVITY - velocity * (velocity.norm() * DRAG / MASS) + lacked(velocity)
    };
    let flights = (0..8).map(|k| {
        let path = flown(thrown(k, slowest), acceleration);
        path.into_iter().map(|position| vec![position]).collect()
    });
    dataset(
        "shuttlecock",
        &[V::zeros()],
        &flights.collect::<Vec<_>>(),
        seed,
    )
}

/// Acceleration to the left, m/s².
fn leftward(side: f64) -> impl Fn(V) -> V {
    move |velocity| V::z().cross(&velocity).normalize() * side
}

/// Eight simulated flights of a rigid ball whose spin, constant in the inertial frame, is inclined differently in each;
/// `lift` times the spin times the velocity is the acceleration that the model lacks.
fn rigid_ball(lift: f64, seed: u64) -> Dataset {
    let on_body = [V::x() * 0.037, V::y() * 0.037, V::z() * 0.037];
    let flights = (0..8).map(|k| {
        let wave = (1.7 * f64::from(k)).sin();
        let spin = V::new(10.0, -150.0 + 12.0 * wave, 80.0 - 10.0 * wave);
        let drag = 1.2 / 2.0 * std::f64::consts::PI * 0.037 * 0.037 * 0.45 / 0.145;
        let path = flown(V::new(30.0 + 2.0 * wave, 0.5 * wave, 3.0), |velocity| {
            -V::z() * GRAVITY - velocity * (velocity.norm() * drag) + spin.cross(&velocity) * lift
        });
        let seen = path.iter().enumerate().map(|(i, position)| {
            let turned = Rotation3::new(spin * (i as f64 / 120.0));
            on_body.iter().map(|at| position + turned * at).collect()
        });
        seen.collect()
    });
    dataset("rigid_ball", &on_body, &flights.collect::<Vec<_>>(), seed)
}

fn model() -> Model {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/models");
    model_spec::load::load(&format!("{folder}/shuttlecock.hyz"), &[]).unwrap()
}

#[test]
fn a_lift_by_the_spin_of_a_rigid_body_is_found() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/integration/rigid_ball.hyz"
    );
    let model = model_spec::load::load(path, &[]).unwrap();
    let found = diagnose(&model, &rigid_ball(0.004, 3), &DiagnosisOptions::default()).unwrap();
    let report = found.report;
    let best = report.explanations.first().expect("an explanation");
    let names: Vec<&str> = best
        .effects
        .iter()
        .map(|effect| effect.name.as_str())
        .collect();
    assert_eq!(names, ["spin-force"], "{}", report.summary);
    let estimate = &best.effects[0].estimates["spin_k"];
    assert!(
        (estimate.value / 0.004 - 1.0).abs() < 0.03,
        "{}",
        estimate.value
    );
}

#[test]
fn a_hidden_side_force_of_a_model_of_ones_own_is_found_at_its_site() {
    let dataset = shuttlecock(12.0, leftward(0.4 * GRAVITY), 1);
    let found = diagnose(&model(), &dataset, &DiagnosisOptions::default()).unwrap();
    let report = found.report;
    let best = report.explanations.first().expect("a explanation");
    let sites: Vec<&str> = best
        .effects
        .iter()
        .map(|effect| effect.site.as_str())
        .collect();
    assert_eq!(sites, ["side"], "{}", report.summary);
    assert_eq!(best.effects[0].name, "side-force");
    let is_doubted = |own: &String| own.contains("the residuals are not noise");
    assert!(
        !report.cautions.iter().any(is_doubted),
        "{:?}",
        report.cautions
    );
    let gain = report.gain_sentences();
    assert!(
        gain.starts_with("By cross-validation over 8 flights the RMS"),
        "{gain}"
    );
    let estimate = &best.effects[0].estimates["side_a"];
    assert!(
        (estimate.value / (0.4 * GRAVITY) - 1.0).abs() < 0.01,
        "{}",
        estimate.value
    );
}

#[test]
fn a_right_model_of_ones_own_gets_no_cause() {
    let dataset = shuttlecock(12.0, leftward(0.0), 2);
    let found = diagnose(&model(), &dataset, &DiagnosisOptions::default()).unwrap();
    assert!(
        found.report.explanations.is_empty(),
        "{}",
        found.report.summary
    );
    assert_eq!(found.report.gain_sentences(), "The model is not extended.");
}

#[test]
fn effects_that_stand_in_for_another_law_of_drag_are_no_cause() {
    // By a missing term in the faster flights, by the number of effects in the slower ones.
    for slowest in [20.0, 40.0] {
        let slope = |velocity: V| 0.0133 * (velocity.norm() - 20.0);
        let drag = |velocity: V| -velocity * (velocity.norm() * slope(velocity) * DRAG / MASS);
        let dataset = shuttlecock(slowest, drag, 4);
        let found = diagnose(&model(), &dataset, &DiagnosisOptions::default()).unwrap();
        let report = found.report;
        assert_eq!(report.verdict, Verdict::Unattributed, "{}", report.summary);
        assert!(report.summary.contains("stand in"), "{}", report.summary);
    }
}
