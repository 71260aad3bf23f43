//! Noise of measured values: a stationary AR(1) process along each axis of each group of channels.

use std::ops::{Deref, DerefMut};

use dataset::levels::MIN_SERIES;

/// Least standard deviation of noise, m or the unit of a sensor: exact residuals, as of motion in a plane of the axes, keep
/// a finite weight.
const LEAST_SIGMA: f64 = 1e-12;

/// Noise of all channels: one AR(1) process per noise group. Dereferences to that of the first group, the markers' if
/// there are any.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseModel {
    groups: Vec<AxesNoise>,
    /// Index in `groups` of each channel; a channel without an entry belongs to group 0.
    group_of: Vec<usize>,
}

/// Noise of one group of channels: a stationary AR(1) process along each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxesNoise {
    /// Standard deviation of the residuals along each axis, m, after [`Channel::scale`](crate::Channel::scale).
    pub sigma: [f64; 3],
    /// Autocorrelation φ at lag `interval` along each axis.
    pub ar1: [f64; 3],
    /// Time between samples to which `ar1` refers, s.
    pub interval: f64,
}

/// Root mean square of the standard deviations along the three axes.
pub(crate) fn overall(sigma: [f64; 3]) -> f64 {
    (sigma.iter().map(|sigma| sigma * sigma).sum::<f64>() / 3.0).sqrt()
}

/// Number of noise groups, given the group of each channel; 1 if there are no channels.
pub fn group_count(group_of: &[usize]) -> usize {
    group_of.iter().max().map_or(1, |last| last + 1)
}

/// Maximum magnitude of the estimated autocorrelation; a higher one indicates model error.
const MAX_AR1: f64 = 0.9;

impl NoiseModel {
    /// White noise of standard deviation `sigma` (m) of every channel, for a sampling interval in s.
    pub fn white(sigma: f64, interval: f64) -> Self {
        AxesNoise::white(sigma, interval).into()
    }

    /// Creates the noise model from the process of each group and the group of each channel.
    ///
    /// # Panics
    ///
    /// Panics if `groups` is empty.
    pub fn of_groups(groups: Vec<AxesNoise>, group_of: Vec<usize>) -> Self {
        assert!(!groups.is_empty(), "noise of at least one group");
        Self { groups, group_of }
    }

    /// Noise of the group to which a channel belongs, given the index of the channel.
    pub fn of(&self, channel: usize) -> &AxesNoise {
        let group = self.group_of.get(channel).copied().unwrap_or(0);
        &self.groups[group]
    }

    /// As [`of`](Self::of), to be changed.
    pub(crate) fn of_mut(&mut self, channel: usize) -> &mut AxesNoise {
        let group = self.group_of.get(channel).copied().unwrap_or(0);
        &mut self.groups[group]
    }

    /// Noise of every group, by group index.
    pub fn groups(&self) -> &[AxesNoise] {
        &self.groups
    }

    /// Least standard deviation, m, of the innovation of a residual after one interval, over groups and axes.
    pub(crate) fn least_innovation(&self) -> f64 {
        let axes = self
            .groups
            .iter()
            .flat_map(|group| [0, 1, 2].map(|axis| group.innovation(axis, Some(group.interval)).1));
        axes.fold(f64::INFINITY, f64::min)
    }

    /// Copy with the same standard deviations and zero autocorrelation.
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

    /// Whether standard deviations agree within the relative, and autocorrelations within the absolute difference
    /// `tolerance`.
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
    /// Creates white noise of standard deviation `sigma` (m) along every axis, for a sampling interval in s.
    pub fn white(sigma: f64, interval: f64) -> Self {
        Self {
            sigma: [sigma; 3],
            ar1: [0.0; 3],
            interval,
        }
    }

    /// Autocorrelation φ of residuals `gap` seconds apart, and the standard deviation (m) of the innovation r − φ
    /// r_previous; of a residual without a previous one, 0 and its standard deviation.
    pub fn innovation(&self, axis: usize, gap: Option<f64>) -> (f64, f64) {
        let Some(gap) = gap else {
            return (0.0, self.sigma[axis]);
        };
        let intervals = gap / self.interval;
        let ar1 = self.ar1[axis];
        let phi = if self.is_one_interval(gap) {
            ar1
        } else if ar1 >= 0.0 {
            ar1.powf(intervals)
        } else {
            // A negative autocorrelation is defined only for a whole number of intervals.
            ar1.powi(intervals.round().clamp(1.0, 1e6) as i32)
        };
        (phi, self.sigma[axis] * (1.0 - phi * phi).sqrt())
    }

    /// Whether the time difference `gap`, s, is within 1 % of `interval`.
    pub fn is_one_interval(&self, gap: f64) -> bool {
        (gap / self.interval - 1.0).abs() < 0.01
    }

    /// Root mean square of the noise standard deviations along the three axes, m.
    pub fn overall(&self) -> f64 {
        overall(self.sigma)
    }

    fn is_within(&self, other: &AxesNoise, tolerance: f64) -> bool {
        let same = |a: f64, b: f64| (a / b - 1.0).abs() < tolerance;
        (0..3).all(|axis| {
            same(self.sigma[axis], other.sigma[axis])
                && (self.ar1[axis] - other.ar1[axis]).abs() < tolerance
        })
    }
}

/// Sums of squares and products of the residuals of one noise group, from which its noise is estimated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moments {
    /// Sum of squared residuals along each axis, m².
    pub squares: [f64; 3],
    /// Sum of products of neighbours, residuals of one channel about one interval apart, along each axis, m².
    pub products: [f64; 3],
    /// Sum of (r² + r_previous²)/2 over the pairs of neighbours along each axis, m².
    pub neighbours: [f64; 3],
    /// Number of residuals along one axis; it is the same for all three axes.
    pub count: usize,
    /// Number of pairs of neighbouring residuals: residuals of one channel that are about one sampling interval apart.
    pub pairs: usize,
}

impl Moments {
    /// Adds the residuals (m) of one channel at `times` (s); `None` marks a missing value. `interval` is in s.
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

    /// Adds the sums of `other`, such as those of other flights, to the sums of `self`.
    pub fn join(&mut self, other: &Moments) {
        for axis in 0..3 {
            self.squares[axis] += other.squares[axis];
            self.products[axis] += other.products[axis];
            self.neighbours[axis] += other.neighbours[axis];
        }
        self.count += other.count;
        self.pairs += other.pairs;
    }

    /// Noise of residuals after a fit of `unknowns` unknowns, for the sampling interval `interval` (s). A `given`
    /// standard deviation (m) replaces the estimated one.
    pub fn noise(&self, unknowns: usize, interval: f64, given: Option<f64>) -> AxesNoise {
        let measured = 3 * self.count;
        let spread = measured as f64 / measured.saturating_sub(unknowns).max(1) as f64;
        let sigma = [0, 1, 2].map(|axis| {
            let estimated = (self.squares[axis] / self.count.max(1) as f64 * spread).sqrt();
            given.unwrap_or(estimated).max(LEAST_SIGMA)
        });
        let ar1 = [0, 1, 2].map(|axis| {
            // Few pairs do not determine an autocorrelation.
            if self.pairs < MIN_SERIES || self.neighbours[axis] <= 0.0 {
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

/// Outlier threshold of a local residual, in standard deviations; noise exceeds it with probability 7 × 10⁻⁶.
pub const OUTLIER_LIMIT: f64 = 4.5;

/// Transition of Huber's loss from quadratic to linear, in units of its scale × √(number of components).
pub const HUBER_LIMIT: f64 = 2.0;

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha12Rng;
    use rand_distr::StandardNormal;

    use super::*;

    /// Simulated stationary AR(1) process of `count` points with standard deviation `sigma` and lag-1 autocorrelation
    /// `ar1`, m.
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
    fn noise_is_the_same_within_a_tolerance_of_its_size_and_its_correlation() {
        let noise = |sigma: f64, ar1: f64| {
            let mut own = AxesNoise::white(sigma, 0.01);
            own.ar1[1] = ar1;
            NoiseModel::from(own)
        };
        let is_within = |sigma, ar1| noise(sigma, ar1).is_within(&noise(1e-3, 0.5), 0.1);
        assert!(is_within(1e-3, 0.5) && is_within(1.09e-3, 0.41) && is_within(0.91e-3, 0.59));
        assert!(!is_within(1.2e-3, 0.5) && !is_within(1e-3, 0.7) && !is_within(1e-3, 0.3));
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
        let (phi, sigma) = noise.innovation(0, Some(2.0 / 120.0));
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
