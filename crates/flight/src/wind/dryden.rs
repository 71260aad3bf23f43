//! Sinusoids that approximate the Dryden spectra: wavenumbers, amplitudes and phases.

use std::f64::consts::{PI, TAU};

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Number of sinusoids whose sum represents one component of the gusts.
pub const GUST_TERMS: usize = 24;

/// Upper edges of the first and last wavenumber band of the gust spectrum, times the length scale of the gusts.
const BAND: (f64, f64) = (0.1, 20.0);

/// Components of the gusts: u along the horizontal direction of flight, v across it to the left, w upwards.
pub(super) const COMPONENTS: [&str; 3] = ["u", "v", "w"];

/// Sinusoids of a gust component with variance 1, as pairs of wavenumber (times the length scale L) and amplitude;
/// component 0 is u, along the flight, 1 and 2 are v and w, across it.
///
/// One-sided spectra over the wavenumber Ω, with x = LΩ (MIL-F-8785C): u (2L/π)/(1 + x²); v and w (L/π) (1 + 3x²)/(1 +
/// x²)². The first band is 0 to 0.1/L; the edges of the other bands have equal ratios, up to 20/L. Each band is
/// represented by one sinusoid at the median of the band's variance, with the variance of the band. All sinusoids are
/// scaled by 1.016 (u) and 1.025 (v, w), so that the part of the spectrum above 20/L, 3 % and 5 % of the variance, is
/// not lost.
pub fn gust_spectrum(component: usize) -> [(f64, f64); GUST_TERMS] {
    let part = match component {
        0 => part_along,
        _ => part_across,
    };
    let ratio = (BAND.1 / BAND.0).powf(1.0 / (GUST_TERMS - 1) as f64);
    let edge = |k: usize| match k {
        0 => 0.0,
        _ => BAND.0 * ratio.powi(k as i32 - 1),
    };
    let whole = part(edge(GUST_TERMS));
    std::array::from_fn(|k| {
        let (low, high) = (edge(k), edge(k + 1));
        let variance = (part(high) - part(low)) / whole;
        let middle = (part(high) + part(low)) / 2.0;
        (between(part, middle, low, high), (2.0 * variance).sqrt())
    })
}

/// Fraction of the variance of the gust component u at wavenumbers below x/L, where L is the length scale.
fn part_along(x: f64) -> f64 {
    2.0 / PI * x.atan()
}

/// Fraction of the variance of the gust components v and w at wavenumbers below x/L, where L is the length scale.
fn part_across(x: f64) -> f64 {
    (2.0 * x.atan() - x / (1.0 + x * x)) / PI
}

/// Argument between `low` and `high` at which the increasing function `of` equals `value`, by bisection.
fn between(of: fn(f64) -> f64, value: f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        match of(middle) < value {
            true => low = middle,
            false => high = middle,
        }
    }
    (low + high) / 2.0
}

/// Names and values (rad, uniform from 0 to 2π) of the phases of a flight's gusts, by seed and index of the flight.
pub fn gust_phases(seed: u64, flight: u64) -> Vec<(String, f64)> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(flight);
    random.set_word_pos(0);
    let names = COMPONENTS.iter().flat_map(|component| {
        let terms = 1..=GUST_TERMS;
        terms.map(move |term| phase_name(component, term))
    });
    names
        .map(|name| (name, TAU * random.random::<f64>()))
        .collect()
}

/// Name of the parameter that is the phase of one sinusoid of a gust component.
pub(super) fn phase_name(component: &str, term: usize) -> String {
    format!("gust_phase_{component}_{term}")
}
