//! Markers of which one is far noisier than the others.

use crate::support::release;
use dataset::synthesize::{Corruption, Plan, flights};
use dataset::{Dataset, Marker};
use identify::{FitOptions, fit};
use model_spec::model::Model;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

/// Noise of the quiet markers, and what is added to that of the other one, m.
const NOISE: (f64, f64) = (0.0005, 0.005);

fn discs(seed: u64) -> (Model, Dataset) {
    let model = model_spec::load::load("disc", &[]).expect("a model");
    let release = release("backhand", &model);
    let plan = Plan {
        flights: 4,
        duration: Some(0.8),
        rate: 200.0,
        noise: Corruption {
            sigma: NOISE.0,
            ..Corruption::default()
        },
        seed,
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("flights");
    (model, made.dataset)
}

/// Adds noise to the marker at the place `marker`, as of a reflective spot that glints.
fn glint(dataset: &mut Dataset, marker: usize) {
    let mut random = ChaCha12Rng::seed_from_u64(11);
    let rows = dataset
        .flights
        .iter_mut()
        .flat_map(|own| &mut own.positions);
    for point in rows.filter_map(|row| row[marker].as_mut()) {
        for axis in point {
            let normal: f64 = random.sample(StandardNormal);
            *axis += NOISE.1 * normal;
        }
    }
}

#[test]
fn a_marker_that_glints_has_its_own_noise_and_the_fit_is_right() {
    for (seed, marker) in [(1, 1), (2, 0), (3, 2)] {
        let (model, mut dataset) = discs(seed);
        glint(&mut dataset, marker);
        let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
        let report = &found.report;
        assert_eq!(report.cautions, Vec::<String>::new(), "seed {seed}");
        for coefficient in &model.coefficients {
            let own = &report.coefficients[&coefficient.name];
            let off = (own.value - coefficient.value).abs() / own.std_error;
            assert!(off < 3.5, "seed {seed}, {}: {off}", coefficient.name);
        }
        let sigma = |channel: usize| found.noise().of(channel).overall();
        for channel in 0..3 {
            let is_noisy = channel == marker;
            let expected = if is_noisy { NOISE.1 } else { NOISE.0 };
            let ratio = sigma(channel) / expected;
            assert!((ratio - 1.0).abs() < 0.1, "seed {seed}, {channel}: {ratio}");
        }
        let Marker { name, .. } = &dataset.markers[marker];
        let told = |note: &String| note.contains(&format!("marker {name}"));
        assert_eq!(report.notes.iter().filter(|note| told(note)).count(), 1);
    }
}

#[test]
fn markers_with_like_noise_share_it() {
    let (model, dataset) = discs(4);
    let found = fit(&model, &dataset, &FitOptions::default()).expect("a fit");
    assert_eq!(found.noise().groups().len(), 1);
    assert_eq!(found.report.notes, Vec::<String>::new());
}
