//! Models that are not built in: what their flights hide is found and sited, on flights by an integrator written here.

use std::fmt::Write;
use std::path::PathBuf;

use dataset::Dataset;
use diagnose::{DiagnosisOptions, diagnose};
use model_spec::model::Model;
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, Normal};

type V = Vector3<f64>;

const MASS: f64 = 0.005;
const GRAVITY: f64 = 9.81;
const DRAG: f64 = 1.2 / 2.0 * std::f64::consts::PI / 4.0 * 0.066 * 0.066 * 0.52;
const SIGMA: f64 = 0.0015;

/// Acceleration of the simulated shuttlecock, m/s²: gravity, drag, and `side` to the left of the velocity.
fn acceleration(velocity: V, side: f64) -> V {
    let left = V::z().cross(&velocity).normalize();
    -V::z() * GRAVITY - velocity * (velocity.norm() * DRAG / MASS) + left * side
}

/// Simulated positions at 120 Hz, m, by the classical Runge–Kutta method; `side` is the acceleration to the left, m/s².
fn flown(mut velocity: V, side: f64, samples: usize) -> Vec<V> {
    let (mut position, mut seen) = (V::new(0.0, 0.0, 2.0), Vec::new());
    let steps = 20;
    let h = 1.0 / 120.0 / f64::from(steps);
    for _ in 0..samples {
        seen.push(position);
        for _ in 0..steps {
            let a = acceleration(velocity, side);
            let b = acceleration(velocity + a * (h / 2.0), side);
            let c = acceleration(velocity + b * (h / 2.0), side);
            let d = acceleration(velocity + c * h, side);
            position += velocity * h + (a + b + c) * (h * h / 6.0);
            velocity += (a + b * 2.0 + c * 2.0 + d) * (h / 6.0);
        }
    }
    seen
}

/// Dataset of eight simulated flights of a shuttlecock, written to a folder and read from it. `side` is the
/// acceleration to the left that the model lacks, m/s².
fn shuttlecock(side: f64, seed: u64) -> Dataset {
    let name = format!("hyzer-own-{}-{seed}", std::process::id());
    let folder: PathBuf = std::env::temp_dir().join(name);
    std::fs::create_dir_all(&folder).unwrap();
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let noise = Normal::new(0.0, SIGMA).unwrap();
    let mut manifest = String::from(
        "model = \"shuttlecock\"\n[[markers]]\nname = \"m1\"\nposition = [0.0, 0.0, 0.0]\n",
    );
    for k in 0..8 {
        let heading = f64::from(k) * 0.7;
        let (speed, launch) = (12.0 + 2.0 * f64::from(k), 0.2 + 0.1 * f64::from(k % 4));
        let level = speed * launch.cos();
        let velocity = V::new(
            level * heading.cos(),
            level * heading.sin(),
            speed * launch.sin(),
        );
        let mut table = String::from("t,m1_x,m1_y,m1_z\n");
        for (i, position) in flown(velocity, side, 100).iter().enumerate() {
            let seen = position.map(|p| p + noise.sample(&mut random));
            let time = i as f64 / 120.0;
            writeln!(table, "{time},{},{},{}", seen.x, seen.y, seen.z).unwrap();
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

fn model() -> Model {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/models");
    model_spec::load::load(&format!("{folder}/shuttlecock.hyz"), &[]).unwrap()
}

#[test]
fn a_hidden_side_force_of_a_model_of_ones_own_is_found_at_its_site() {
    let dataset = shuttlecock(0.4 * GRAVITY, 1);
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
    let estimate = &best.effects[0].estimates["side_a"];
    assert!(
        (estimate.value / (0.4 * GRAVITY) - 1.0).abs() < 0.01,
        "{}",
        estimate.value
    );
}

#[test]
fn a_right_model_of_ones_own_gets_no_cause() {
    let dataset = shuttlecock(0.0, 2);
    let found = diagnose(&model(), &dataset, &DiagnosisOptions::default()).unwrap();
    assert!(
        found.report.explanations.is_empty(),
        "{}",
        found.report.summary
    );
}
