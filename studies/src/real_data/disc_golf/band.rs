//! Scatter of the landing points of launches drawn within their uncertainties.

use flight::parallel;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};

use super::simulate::Simulator;
use super::throw::{Launch, TRACK_UNCERTAINTY, Throw, UNCERTAINTY, rms_distance};

/// Statistics of simulated flights whose launch quantities are drawn at random with their published uncertainties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Band {
    /// Mean, over the random launches, of the simulated horizontal position (x, y) at the time of the last compared
    /// point of the measured track, m.
    pub(super) mean: [f64; 2],
    /// Standard deviation, over the random launches, of the simulated horizontal position (x, y) at the time of the
    /// last compared point of the measured track, m.
    pub(super) deviation: [f64; 2],
    /// Fraction of the random launches whose simulated path has an RMS difference of less than 1 m per coordinate from
    /// the measured track.
    pub(super) within: f64,
}

/// Simulates `draws` random launches of a throw, and summarises their last positions and their agreement with the
/// measured track. Each launch quantity is drawn from a normal distribution with its published value as mean and its
/// published uncertainty as standard deviation.
pub(super) fn band(simulator: &Simulator<'_>, throw: &Throw, draws: usize, seed: u64) -> Band {
    let points = throw.points();
    let times: Vec<f64> = points.iter().map(|(time, _)| *time).collect();
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let launches = (0..draws).map(|_| -> Launch {
        std::array::from_fn(|k| {
            let normal: f64 = StandardNormal.sample(&mut random);
            throw.launch[k] + UNCERTAINTY[k] * normal
        })
    });
    let launches: Vec<Launch> = launches.collect();
    let tracks = parallel::each(draws, |k| {
        simulator.track(throw, &launches[k], &[1.0; 3], &times)
    });
    let count = draws.max(1) as f64;
    let last = |k: usize| tracks.iter().filter_map(move |t| Some(t.last()?[k]));
    let mean = [0, 1].map(|k| last(k).sum::<f64>() / count);
    let variance = |k: usize| last(k).map(|x| (x - mean[k]).powi(2)).sum::<f64>() / count;
    let is_within = |track: &&Vec<[f64; 2]>| rms_distance(track, &points) < TRACK_UNCERTAINTY;
    Band {
        mean,
        deviation: [0, 1].map(|k| variance(k).sqrt()),
        within: tracks.iter().filter(is_within).count() as f64 / count,
    }
}
