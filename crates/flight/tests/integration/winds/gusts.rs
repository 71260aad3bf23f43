//! Gusts against Dryden's formulae.

use super::{compiled, released, vector};
use flight::wind::{GUST_TERMS, gust_phases, gust_spectrum};

/// Gust components of variance 1 at the distance `at`, in units of the length scale, from the sinusoids and their
/// phases in a flight.
fn waves(seed: u64, flight: u64, at: f64) -> [f64; 3] {
    waves_of(&[0, 1, 2].map(gust_spectrum), seed, flight, at)
}

fn waves_of(spectra: &[[(f64, f64); GUST_TERMS]; 3], seed: u64, flight: u64, at: f64) -> [f64; 3] {
    let phases = gust_phases(seed, flight);
    std::array::from_fn(|k| {
        let terms = spectra[k].into_iter().enumerate();
        let wave = |(term, (wavenumber, amplitude)): (usize, (f64, f64))| {
            amplitude * (wavenumber * at + phases[k * GUST_TERMS + term].1).sin()
        };
        terms.map(wave).sum()
    })
}

/// Autocorrelation of a gust component at the distance `lag`, in units of the length scale (Dryden form, MIL-F-8785C).
fn dryden(component: usize, lag: f64) -> f64 {
    match component {
        0 => (-lag).exp(),
        _ => (1.0 - lag / 2.0) * (-lag).exp(),
    }
}

/// Variance of a gust component between two wavenumbers, in units of 1/L, by Simpson's rule for the one-sided spectrum;
/// L is the length scale.
fn power(component: usize, low: f64, high: f64) -> f64 {
    let density = |x: f64| match component {
        0 => 2.0 / std::f64::consts::PI / (1.0 + x * x),
        _ => (1.0 + 3.0 * x * x) / (1.0 + x * x).powi(2) / std::f64::consts::PI,
    };
    let steps = 2000;
    let h = (high - low) / f64::from(steps);
    let weight = |k: i32| match k {
        0 => 1.0,
        k if k == steps => 1.0,
        k if k % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=steps)
        .map(|k| weight(k) * density(low + f64::from(k) * h))
        .sum::<f64>()
        * h
        / 3.0
}

#[test]
fn the_sinusoids_have_drydens_spectrum() {
    for component in 0..3 {
        let terms = gust_spectrum(component);
        let variance = |terms: &[(f64, f64)]| terms.iter().map(|(_, a)| a * a / 2.0).sum::<f64>();
        assert!((variance(&terms) - 1.0).abs() < 1e-12);
        assert!(terms.windows(2).all(|pair| pair[0].0 < pair[1].0));
        assert!(terms[0].0 > 0.0 && terms[GUST_TERMS - 1].0 < 20.0);
        // Octave by octave: the part of the variance below each wavenumber is the spectrum's, to half a term and the part beyond the band.
        for k in 1..GUST_TERMS {
            let below = variance(&terms[..k]) + terms[k].1.powi(2) / 4.0;
            let expected = power(component, 0.0, terms[k].0);
            assert!(
                (below - expected).abs() < 0.055,
                "{component} {k} {below} {expected}"
            );
        }
    }
}

#[test]
fn variance_and_autocorrelation_over_many_seeds_are_drydens() {
    const SEEDS: u64 = 4000;
    let lags = [0.0, 0.2, 0.5, 1.0, 2.0, 4.0];
    let mut sums = [[0.0; 6]; 3];
    let (mut means, mut crossed) = ([0.0; 3], 0.0);
    let spectra = [0, 1, 2].map(gust_spectrum);
    for seed in 0..SEEDS {
        let first = waves_of(&spectra, seed, 0, 3.7);
        crossed += first[0] * first[1];
        for (k, lag) in lags.iter().enumerate() {
            let then = waves_of(&spectra, seed, 0, 3.7 + lag);
            for component in 0..3 {
                sums[component][k] += first[component] * then[component];
                means[component] += if k == 0 { first[component] } else { 0.0 };
            }
        }
    }
    let n = SEEDS as f64;
    // Four standard errors of the mean of a product of standard normal numbers.
    let sampling = 4.0 * (2.0 / n).sqrt();
    assert!((crossed / n).abs() < sampling);
    for component in 0..3 {
        assert!((means[component] / n).abs() < sampling);
        for (k, lag) in lags.iter().enumerate() {
            let found = sums[component][k] / n;
            let of_terms: f64 = spectra[component]
                .iter()
                .map(|(wavenumber, a)| a * a / 2.0 * (wavenumber * lag).cos())
                .sum();
            assert!(
                (found - of_terms).abs() < sampling,
                "{component} {lag} {found} {of_terms}"
            );
            // What the bands leave of the formula: least at short distances.
            let left = if *lag < 3.0 { 0.065 } else { 0.09 };
            let expected = dryden(component, *lag);
            assert!(
                (of_terms - expected).abs() < left,
                "{component} {lag} {of_terms} {expected}"
            );
        }
    }
}

#[test]
fn a_seed_and_a_flight_have_gusts_of_their_own() {
    assert_eq!(waves(7, 3, 1.5), waves(7, 3, 1.5));
    assert_ne!(waves(7, 3, 1.5), waves(8, 3, 1.5));
    assert_ne!(waves(7, 3, 1.5), waves(7, 4, 1.5));
    let phases = gust_phases(7, 0);
    assert_eq!(phases.len(), 3 * GUST_TERMS);
    assert!(
        phases
            .iter()
            .all(|(_, phase)| (0.0..std::f64::consts::TAU).contains(phase))
    );
}

#[test]
fn the_models_gusts_are_the_sinusoids_with_the_strength_of_the_standard() {
    // Low-altitude model of MIL-F-8785C, feet and knots replaced by SI where they cancel.
    let (height, heading, wind): (f64, f64, [f64; 3]) = (6.0, 25.0, [3.0, -1.0, 0.0]);
    let text = format!(
        "model = \"ball\"\nduration = 1.0\n[throw]\nspeed = 1.0\n[wind]\nconstant = {wind:?}\n[wind.gusts]\nmodel = \"dryden\"\nseed = 5\nflight = 2\nheight = {height:?}\nheading = {heading:?}\nintensity = 1.5\n"
    );
    let (release, model) = released(&text);
    let parameters = compiled(&model).release_parameters(&release).constants;
    let (t, place) = (0.8, [12.0, 4.0, 1.1]);
    let state = [place[0], place[1], place[2], 9.0, 1.0, 0.0];
    let gust = vector(&model, &parameters, "gust_velocity", t, &state);
    let feet = height / 0.3048;
    let shape: f64 = 0.177 + 0.000823 * feet;
    let sd_w = 0.1 * wind[0].hypot(wind[1]);
    let sd_u = sd_w / shape.powf(0.4);
    let length_u = feet / shape.powf(1.2) * 0.3048;
    let (sin, cos) = heading.to_radians().sin_cos();
    let distance = cos * (place[0] - wind[0] * t) + sin * (place[1] - wind[1] * t);
    let at = |length: f64| waves(5, 2, distance / length);
    let u = 1.5 * sd_u * at(length_u)[0];
    let v = 1.5 * sd_u * at(length_u)[1];
    let w = 1.5 * sd_w * at(height)[2];
    let expected = [cos * u - sin * v, sin * u + cos * v, w];
    for k in 0..3 {
        assert!(
            (gust[k] - expected[k]).abs() < 1e-12,
            "{gust:?} {expected:?}"
        );
    }
}
