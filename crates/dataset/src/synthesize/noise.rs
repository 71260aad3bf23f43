//! Noise of synthetic measurements: AR(1) noise, outliers and dropouts. The same seed gives the same noise on every
//! machine.

use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::StandardNormal;

use super::error::OutOfRange;

/// Measurement errors added to true positions; by default white noise of 1.5 mm without outliers and dropouts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corruption {
    /// Standard deviation of the noise along each axis, m.
    pub sigma: f64,
    /// Lag-1 autocorrelation of the noise, −0.999 to 0.999: a stationary AR(1) process of deviation `sigma`.
    pub ar1: f64,
    /// Fraction of marker positions that are outliers.
    pub outliers: f64,
    /// Standard deviation of the additional error of an outlier along each axis, m.
    pub outlier_size: f64,
    /// Fraction of missing positions, at most 0.9: half of them singly, half in runs of 3 to 12 samples of a marker.
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

const MAX_SIGMA: f64 = 100.0;
const MAX_DROPOUTS: f64 = 0.9;
const RUN: [usize; 2] = [3, 12];
/// Number of initial samples discarded from the dropout process, so that its rate is stationary from the first sample.
const AHEAD: usize = 64;

impl Corruption {
    /// Checks that every value is within its range.
    ///
    /// # Errors
    /// [`OutOfRange`] for the first value that is outside its range.
    #[doc(hidden)]
    pub fn check(&self) -> Result<(), OutOfRange> {
        let within = OutOfRange::check;
        within("noise-sigma", self.sigma, 0.0, MAX_SIGMA)?;
        within("noise-ar1", self.ar1, -0.999, 0.999)?;
        within("outliers", self.outliers, 0.0, 1.0)?;
        within("outlier-size", self.outlier_size, 0.0, MAX_SIGMA)?;
        within("dropouts", self.dropouts, 0.0, MAX_DROPOUTS)
    }
}

/// Purpose for which a stream of random numbers is used: noise, outliers or dropouts of a marker.
#[derive(Clone, Copy)]
enum Purpose {
    /// Noise of a marker along one axis, given by the index of the axis.
    Axis(usize),
    Outliers,
    Dropouts,
}

/// An independent random stream for each marker and purpose, so that a further marker leaves the others' noise alone.
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

/// Adds noise and outliers to `positions[sample][marker]`, m, and replaces dropouts by `None`.
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
        for (point, hidden) in points.iter_mut().zip(dropouts(noise.dropouts, random)) {
            if hidden {
                **point = None;
            }
        }
    }
}

/// Flags, one per sample, whether a marker is missing: in the given fraction, half of it singly and half in runs.
fn dropouts(fraction: f64, mut random: ChaCha12Rng) -> impl Iterator<Item = bool> {
    let [shortest, longest] = RUN;
    let mean = (shortest + longest) as f64 / 2.0;
    // A choice is made at each sample outside a run: a run begins with probability r, and the sample alone is missing
    // with probability s. A choice covers 1 + (mean − 1) r samples on average, of which mean · r and s are missing.
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
