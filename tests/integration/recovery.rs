//! What the project promises of a diagnosis: an effect of any site, hidden in flights that share nothing with the compiler
//! or its integrators, is among the explanations, and a complete model is left alone.

use dataset::synthesize::{Corruption, corrupt};
use hyzer::{DatasetBuilder, Diagnosis, Model, Role, Verdict};
use nalgebra::Vector3;
use oracle::{Point, Tree, derivatives};

/// Positions of the markers on the disc, m.
const MARKERS: [[f64; 3]; 3] = [
    [0.1, 0.0, 0.01],
    [-0.05, 0.0866, 0.01],
    [-0.05, -0.0866, 0.01],
];
const FLIGHTS: usize = 10;
const SAMPLES: usize = 100;
/// Time between samples, s.
const INTERVAL: f64 = 0.01;
/// Steps of the integration between two samples: at 100 rad/s of nutation the error stays below 1e-5 m, 1/150 of the noise.
const STEPS: usize = 6;

/// Effects, one or more of each site, with values (SI) of their coefficients that are common in practice.
#[rustfmt::skip]
const HIDDEN: [(&str, &[f64]); 17] = [
    ("zero_lift_drag_angle", &[-0.07]),
    ("drag_by_spin", &[0.05]),
    ("stall", &[5.0]),
    ("lift_by_spin", &[0.1]),
    ("side_force_by_spin", &[0.05]),
    ("roll_damping", &[-0.01]),
    ("rolling_moment_by_angle", &[0.03]),
    ("constant_pitching_moment", &[-0.015]),
    ("cubic_pitching_moment", &[-1.5]),
    ("spin_down_by_pressure", &[-0.005]),
    ("wind", &[0.7, -0.4]),
    ("gravity", &[0.005]),
    ("tilted_vertical", &[0.02, 0.01]),
    ("scale", &[0.01]),
    ("mass_imbalance", &[3e-5, 2e-5]),
    ("marker_1_misplaced", &[0.004, 0.003, -0.002]),
    ("marker_radius", &[0.03]),
];

/// Uniform pseudo-random numbers in −1 … 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// One classic Runge–Kutta step of `h` seconds.
fn step(model: &model_spec::model::Model, point: &mut Point<f64>, h: f64) {
    let start = point.clone();
    let mut sum = vec![0.0; start.states.len()];
    let mut at = start.clone();
    for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
        let rates = derivatives(model, &at).expect("a tree that the oracle evaluates");
        for ((total, rate), (state, first)) in sum
            .iter_mut()
            .zip(&rates)
            .zip(at.states.iter_mut().zip(&start.states))
        {
            *total += weight * rate;
            *state = first + next * h * rate;
        }
        at.time = start.time + next * h;
    }
    for (state, total) in point.states.iter_mut().zip(sum) {
        *state += h / 6.0 * total;
    }
    point.time += h;
}

/// Positions of the markers at the samples of one random throw, as `[sample][marker]`, m.
fn observed(
    model: &model_spec::model::Model,
    values: &[f64],
    random: &mut Random,
) -> Vec<Vec<Option<[f64; 3]>>> {
    let mut point = Point::defaults(model);
    let first = point.coefficients.len() - values.len();
    point.coefficients[first..].copy_from_slice(values);
    // Other coefficients than those of the file, with which a fit begins.
    for coefficient in &mut point.coefficients[..first] {
        *coefficient *= 1.2;
    }
    let spin = if random.next() < -0.5 { 50.0 } else { -50.0 };
    let throw = [
        ("z", 1.5),
        ("u", 13.5 + 4.5 * random.next()),
        ("v", 3.0 * random.next()),
        ("w", 1.5 + 1.5 * random.next()),
        ("phi", 0.35 * random.next()),
        ("theta", -0.1 + 0.2 * random.next()),
        ("gammadot", spin + 15.0 * random.next()),
        ("phidot", 1.5 * random.next()),
        ("thetadot", 1.5 * random.next()),
    ];
    for (name, value) in throw {
        let state = model.states.iter().position(|state| state.name == name);
        point.states[state.expect("a state of the disc")] = value;
    }
    let observation = model.observation.as_ref().expect("the disc is observed");
    // By this input the observation knows which marker it sees.
    let number = model
        .inputs
        .iter()
        .position(|input| input.name == "marker_is");
    let mut samples = Vec::with_capacity(SAMPLES);
    for _ in 0..SAMPLES {
        let seen = [0, 1, 2].map(|index| {
            let mut at = Point {
                marker: Vector3::from(MARKERS[index]),
                ..point.clone()
            };
            if let Some(number) = number {
                at.inputs[number][index] = 1.0;
            }
            Some(Tree::new(model, &at).vector(&observation.value).into())
        });
        samples.push(seen.to_vec());
        for _ in 0..STEPS {
            step(model, &mut point, INTERVAL / STEPS as f64);
        }
    }
    samples
}

fn diagnosed(effect: Option<(&str, &[f64])>, seed: u64) -> Diagnosis {
    let names: Vec<&str> = effect.iter().map(|(name, _)| *name).collect();
    let world = model_spec::load::load("disc", &names).expect("the disc with the effect");
    let mut random = Random(seed);
    let times: Vec<f64> = (0..SAMPLES).map(|k| k as f64 * INTERVAL).collect();
    let mut dataset = DatasetBuilder::new("disc").markers(&MARKERS);
    let noise = Corruption {
        sigma: 0.0015,
        ..Corruption::default()
    };
    for flight in 0..FLIGHTS {
        let values = effect.map_or(&[][..], |(_, values)| values);
        let mut positions = observed(&world, values, &mut random);
        corrupt(&mut positions, &noise, 100 * seed + flight as u64);
        dataset = dataset.flight(&format!("throw{flight}"), Role::Fit, &times, positions);
    }
    let dataset = dataset.build().expect("a dataset");
    let disc = Model::load("disc").expect("the built-in disc");
    Diagnosis::of(&disc).run(&dataset).expect("a diagnosis")
}

#[test]
fn a_hidden_effect_of_any_site_is_among_the_explanations() {
    let mut missed = Vec::new();
    for (seed, (effect, values)) in HIDDEN.into_iter().enumerate() {
        let found = diagnosed(Some((effect, values)), 1 + seed as u64);
        let name = effect.replace('_', "-");
        let explanations = found.explanations();
        let is_found = explanations
            .iter()
            .any(|explanation| matches!(&explanation.effects[..], [only] if only.name == name));
        if !is_found || found.verdict() == Verdict::Adequate {
            missed.push(format!(
                "{effect}: {:?} {}",
                found.verdict(),
                found.summary()
            ));
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
}

#[test]
fn a_complete_model_is_left_alone() {
    for seed in 101..109 {
        let found = diagnosed(None, seed);
        assert_eq!(
            found.verdict(),
            Verdict::Adequate,
            "{seed}: {}",
            found.summary()
        );
        assert!(found.is_reliable(), "{seed}: {:?}", found.cautions());
    }
}
