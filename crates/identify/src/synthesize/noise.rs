//! Noise of made measurements: correlated noise, outliers and dropouts, the same for the same seed on every machine.

use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::StandardNormal;

/// What is done to true positions. By default white noise of 1.5 mm and nothing else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corruption {
    /// Standard deviation along each axis, m.
    pub sigma: f64,
    /// Correlation of the noise of one sample with that of the sample before, above -1 and below 1. The noise is
    /// stationary: `sigma` is its standard deviation whatever the correlation.
    pub ar1: f64,
    /// Fraction of marker points that are outliers.
    pub outliers: f64,
    /// Standard deviation of each axis of an outlier, m, beside the noise.
    pub outlier_size: f64,
    /// Fraction of marker points that are not seen: half of them singly, half in runs of 3 to 12 samples in which a
    /// marker is hidden. At most 0.9.
    pub dropouts: f64,
}

impl Default for Corruption {
    fn default() -> Self {
        Self {
            sigma: 0.0015,
            ar1: 0.0,
            outliers: 0.0,
            outlier_size: 0.05,
            dropouts: 0.0,
        }
    }
}

/// Largest standard deviation, m.
const LARGEST: f64 = 100.0;
/// Greatest fraction of dropouts.
const MOST_HIDDEN: f64 = 0.9;
/// Shortest and longest run in which a marker is hidden, samples.
const RUN: [usize; 2] = [3, 12];
/// Samples ahead of the first: then the dropouts there are as many as later.
const AHEAD: usize = 64;

impl Corruption {
    /// Checks every number.
    ///
    /// # Errors
    /// In words: the name, what was found and what was expected.
    pub fn check(&self) -> Result<(), String> {
        let within = |name: &str, value: f64, least: f64, most: f64| {
            if (least..=most).contains(&value) {
                Ok(())
            } else {
                Err(format!("{name}: found {value}, expected {least} to {most}"))
            }
        };
        within("noise-sigma", self.sigma, 0.0, LARGEST)?;
        within("noise-ar1", self.ar1, -0.999, 0.999)?;
        within("outliers", self.outliers, 0.0, 1.0)?;
        within("outlier-size", self.outlier_size, 0.0, LARGEST)?;
        within("dropouts", self.dropouts, 0.0, MOST_HIDDEN)
    }
}

/// What a stream of random numbers is for.
#[derive(Clone, Copy)]
enum Purpose {
    /// The noise along an axis.
    Axis(usize),
    Outliers,
    Dropouts,
}

/// A stream of its own for each marker and purpose, so that one more marker does not change the others.
fn stream(seed: u64, marker: usize, purpose: Purpose) -> ChaCha12Rng {
    let purpose = match purpose {
        Purpose::Axis(axis) => axis,
        Purpose::Outliers => 3,
        Purpose::Dropouts => 4,
    };
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    random.set_stream(8 * marker as u64 + purpose as u64);
    random
}

/// Applies noise to `positions[sample][marker]`, m. What is not seen stays so.
pub fn corrupt(positions: &mut [Vec<Option<[f64; 3]>>], noise: &Corruption, seed: u64) {
    let markers = positions.iter().map(Vec::len).max().unwrap_or(0);
    for marker in 0..markers {
        let mut points: Vec<&mut Option<[f64; 3]>> = positions
            .iter_mut()
            .filter_map(|row| row.get_mut(marker))
            .collect();
        for axis in 0..3 {
            let mut random = stream(seed, marker, Purpose::Axis(axis));
            let fresh = (1.0 - noise.ar1 * noise.ar1).sqrt();
            let mut deviation: f64 = random.sample(StandardNormal);
            for point in &mut points {
                if let Some(point) = point {
                    point[axis] += noise.sigma * deviation;
                }
                let next: f64 = random.sample(StandardNormal);
                deviation = noise.ar1 * deviation + fresh * next;
            }
        }
        let mut random = stream(seed, marker, Purpose::Outliers);
        for point in &mut points {
            let is_outlier = random.random::<f64>() < noise.outliers;
            let jump: [f64; 3] = std::array::from_fn(|_| random.sample(StandardNormal));
            if let (true, Some(point)) = (is_outlier, point) {
                for (axis, jump) in point.iter_mut().zip(jump) {
                    *axis += noise.outlier_size * jump;
                }
            }
        }
        let random = stream(seed, marker, Purpose::Dropouts);
        for (point, hidden) in points.iter_mut().zip(hidden(noise.dropouts, random)) {
            if hidden {
                **point = None;
            }
        }
    }
}

/// Whether a marker is hidden, sample by sample without end: a fraction of the samples in all, half of it singly and
/// half in runs.
fn hidden(fraction: f64, mut random: ChaCha12Rng) -> impl Iterator<Item = bool> {
    let [shortest, longest] = RUN;
    let mean = (shortest + longest) as f64 / 2.0;
    // A choice at each sample that is not in a run: a run begins with probability r, the sample alone is hidden with
    // probability s. A choice takes 1 + (mean - 1) r samples on average; mean r and s of them are hidden.
    let r = fraction / (2.0 * mean - (mean - 1.0) * fraction);
    let s = fraction / 2.0 * (1.0 + (mean - 1.0) * r);
    let mut left = 0;
    let each = std::iter::repeat_with(move || {
        if left > 0 {
            left -= 1;
            return true;
        }
        let choice: f64 = random.random();
        let length = random.random_range(shortest as u32..=longest as u32);
        if choice < r {
            left = length as usize - 1;
            true
        } else {
            choice < r + s
        }
    });
    each.skip(AHEAD)
}
