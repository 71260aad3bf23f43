//! Noise of measured values: a stationary AR(1) process along each axis of each group of channels.

use std::ops::{Deref, DerefMut};

/// Noise of all channels: one process for each group. It dereferences to that of the first group, which is that of the
/// markers where there are any.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseModel {
    groups: Vec<AxesNoise>,
    /// Group of each channel; channels beyond are of the first.
    group_of: Vec<usize>,
}

/// Noise of one group of channels along each axis: a stationary AR(1) process.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxesNoise {
    /// Standard deviation along each axis, m; of channels other than positions, in their unit over their scale.
    pub sigma: [f64; 3],
    /// Lag autocorrelation at the time `interval`, along each axis.
    pub ar1: [f64; 3],
    /// Time between samples to which `ar1` refers, s.
    pub interval: f64,
}

/// Number of groups of channels, given the group of each channel.
pub fn group_count(group_of: &[usize]) -> usize {
    group_of.iter().max().map_or(1, |last| last + 1)
}

/// Greatest autocorrelation attributed to noise; a greater correlation of residuals indicates model error.
const MAX_AR1: f64 = 0.9;

/// Least number of pairs of neighbouring residuals for an estimate of the autocorrelation.
const MIN_PAIRS: usize = 20;

impl NoiseModel {
    /// White noise of standard deviation `sigma`, m, along every axis of every channel; `interval` in s.
    pub fn white(sigma: f64, interval: f64) -> Self {
        AxesNoise::white(sigma, interval).into()
    }

    /// Noise of groups of channels, and the group of each channel.
    ///
    /// # Panics
    /// Without groups.
    pub fn of_groups(groups: Vec<AxesNoise>, group_of: Vec<usize>) -> Self {
        assert!(!groups.is_empty(), "noise of at least one group");
        Self { groups, group_of }
    }

    /// Noise of a channel.
    pub fn of(&self, channel: usize) -> &AxesNoise {
        let group = self.group_of.get(channel).copied().unwrap_or(0);
        &self.groups[group]
    }

    /// Noise of every group.
    pub fn groups(&self) -> &[AxesNoise] {
        &self.groups
    }

    /// The same standard deviations without correlation.
    pub fn uncorrelated(&self) -> Self {
        let white = self.groups.iter().map(|group| AxesNoise {
            ar1: [0.0; 3],
            ..*group
        });
        Self {
            groups: white.collect(),
            group_of: self.group_of.clone(),
        }
    }

    /// Whether standard deviations agree within 0.5 % and autocorrelations within 0.005.
    pub fn is_close_to(&self, other: &NoiseModel) -> bool {
        self.is_within(other, 0.005)
    }

    /// Whether standard deviations agree within this fraction, and autocorrelations within this number.
    pub fn is_within(&self, other: &NoiseModel, tolerance: f64) -> bool {
        let mut pairs = self.groups.iter().zip(&other.groups);
        self.groups.len() == other.groups.len()
            && pairs.all(|(one, other)| one.is_within(other, tolerance))
    }
}

impl From<AxesNoise> for NoiseModel {
    fn from(noise: AxesNoise) -> Self {
        Self {
            groups: vec![noise],
            group_of: Vec::new(),
        }
    }
}

impl Deref for NoiseModel {
    type Target = AxesNoise;

    fn deref(&self) -> &AxesNoise {
        &self.groups[0]
    }
}

impl DerefMut for NoiseModel {
    fn deref_mut(&mut self) -> &mut AxesNoise {
        &mut self.groups[0]
    }
}

impl AxesNoise {
    /// White noise of standard deviation `sigma`, m, along every axis; `interval` in s.
    pub fn white(sigma: f64, interval: f64) -> Self {
        Self {
            sigma: [sigma; 3],
            ar1: [0.0; 3],
            interval,
        }
    }

    /// Autocorrelation φ of residuals `gap` seconds apart along an axis, and the standard deviation of the innovation
    /// r − φ r_previous, m.
    pub fn innovation(&self, axis: usize, gap: f64) -> (f64, f64) {
        let intervals = gap / self.interval;
        let ar1 = self.ar1[axis];
        let phi = if self.is_one_interval(gap) {
            ar1
        } else if ar1 >= 0.0 {
            ar1.powf(intervals)
        } else {
            // A negative autocorrelation is defined over whole numbers of intervals alone.
            ar1.powi(intervals.round().clamp(1.0, 1e6) as i32)
        };
        (phi, self.sigma[axis] * (1.0 - phi * phi).sqrt())
    }

    /// Whether a time gap, s, is within 1 % of `interval`.
    pub fn is_one_interval(&self, gap: f64) -> bool {
        (gap / self.interval - 1.0).abs() < 0.01
    }

    /// Root mean square of the axes' standard deviations, m.
    pub fn overall(&self) -> f64 {
        (self.sigma.iter().map(|sigma| sigma * sigma).sum::<f64>() / 3.0).sqrt()
    }

    fn is_within(&self, other: &AxesNoise, tolerance: f64) -> bool {
        let same = |a: f64, b: f64| (a / b - 1.0).abs() < tolerance;
        (0..3).all(|axis| {
            same(self.sigma[axis], other.sigma[axis])
                && (self.ar1[axis] - other.ar1[axis]).abs() < tolerance
        })
    }
}

/// Sums over residuals from which the noise is estimated; sums of several flights are added.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moments {
    /// Sum of squares along each axis, m².
    pub squares: [f64; 3],
    /// Sum of products of neighbouring residuals along each axis, m².
    pub products: [f64; 3],
    /// Sum of (r² + r_previous²)/2 over pairs of neighbouring residuals along each axis, m².
    pub neighbours: [f64; 3],
    /// Number of residuals along each axis.
    pub count: usize,
    /// Number of pairs of neighbouring residuals.
    pub pairs: usize,
}

impl Moments {
    /// Adds the residuals of one channel of a flight, m; `None` for a missing value.
    pub fn add(&mut self, times: &[f64], residuals: &[Option<[f64; 3]>], interval: f64) {
        let mut before: Option<(f64, [f64; 3])> = None;
        for (&time, residual) in times.iter().zip(residuals) {
            let Some(residual) = residual else { continue };
            self.count += 1;
            for (sum, residual) in self.squares.iter_mut().zip(residual) {
                *sum += residual * residual;
            }
            if let Some((earlier, last)) = before
                && ((time - earlier) / interval - 1.0).abs() < 0.5
            {
                self.pairs += 1;
                for axis in 0..3 {
                    self.products[axis] += residual[axis] * last[axis];
                    self.neighbours[axis] += (residual[axis].powi(2) + last[axis].powi(2)) / 2.0;
                }
            }
            before = Some((time, *residual));
        }
    }

    /// Adds the sums of other flights.
    pub fn join(&mut self, other: &Moments) {
        for axis in 0..3 {
            self.squares[axis] += other.squares[axis];
            self.products[axis] += other.products[axis];
            self.neighbours[axis] += other.neighbours[axis];
        }
        self.count += other.count;
        self.pairs += other.pairs;
    }

    /// Estimates the noise from residuals after a fit of `unknowns` unknowns; a `given` standard deviation (m)
    /// replaces the estimated one.
    pub fn noise(&self, unknowns: usize, interval: f64, given: Option<f64>) -> AxesNoise {
        let measured = 3 * self.count;
        let spread = measured as f64 / measured.saturating_sub(unknowns).max(1) as f64;
        let sigma = [0, 1, 2].map(|axis| {
            let estimated = (self.squares[axis] / self.count.max(1) as f64 * spread).sqrt();
            given.unwrap_or(estimated).max(f64::MIN_POSITIVE.sqrt())
        });
        let ar1 = [0, 1, 2].map(|axis| {
            // Few pairs do not determine an autocorrelation.
            if self.pairs < MIN_PAIRS || self.neighbours[axis] <= 0.0 {
                return 0.0;
            }
            let correlation = self.products[axis] / self.neighbours[axis];
            correlation.clamp(-MAX_AR1, MAX_AR1)
        });
        AxesNoise {
            sigma,
            ar1,
            interval,
        }
    }
}

/// Outlier threshold of the local-linear residual, in standard deviations: 7 in a million normal residuals exceed it.
pub const OUTLIER_LIMIT: f64 = 4.5;

/// Limit of Huber's loss over its scale: quadratic below, linear above.
pub const HUBER_LIMIT: f64 = 2.0;

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha12Rng;
    use rand_distr::StandardNormal;

    use super::*;

    /// Simulated stationary AR(1) process of `count` points, m.
    fn process(count: usize, sigma: f64, ar1: f64) -> Vec<Option<[f64; 3]>> {
        let mut random = ChaCha12Rng::seed_from_u64(7);
        let mut normal = || -> f64 { random.sample(StandardNormal) };
        let mut state = [0; 3].map(|_| sigma * normal());
        (0..count)
            .map(|_| {
                for value in &mut state {
                    *value = ar1 * *value + sigma * (1.0 - ar1 * ar1).sqrt() * normal();
                }
                Some(state)
            })
            .collect()
    }

    #[test]
    fn scale_and_correlation_are_found_again() {
        let times: Vec<f64> = (0..20_000).map(|i| f64::from(i) / 120.0).collect();
        let mut moments = Moments::default();
        moments.add(&times, &process(20_000, 0.002, 0.6), 1.0 / 120.0);
        let noise = moments.noise(0, 1.0 / 120.0, None);
        for axis in 0..3 {
            assert!((noise.sigma[axis] / 0.002 - 1.0).abs() < 0.03, "{noise:?}");
            assert!((noise.ar1[axis] - 0.6).abs() < 0.02, "{noise:?}");
        }
        let (phi, sigma) = noise.innovation(0, 2.0 / 120.0);
        assert!((phi - noise.ar1[0].powi(2)).abs() < 1e-12);
        assert!((sigma - noise.sigma[0] * (1.0 - phi * phi).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn fitted_unknowns_widen_the_estimate() {
        let moments = Moments {
            squares: [1.0; 3],
            count: 10,
            ..Moments::default()
        };
        let noise = moments.noise(15, 1.0, None);
        assert!((noise.sigma[0].powi(2) - 0.2).abs() < 1e-12);
        assert_eq!(moments.noise(15, 1.0, Some(0.3)).sigma, [0.3; 3]);
    }
}
