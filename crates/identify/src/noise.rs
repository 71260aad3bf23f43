//! The noise of measured coordinates: along each axis a stationary first-order process, and outliers beside it.

/// The noise along each axis of the inertial frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoiseModel {
    /// Standard deviation along each axis, m.
    pub sigma: [f64; 3],
    /// Correlation between samples `interval` apart, along each axis.
    pub ar1: [f64; 3],
    /// The time that `ar1` holds for, s.
    pub interval: f64,
}

/// Greatest correlation that is believed: beyond it a residual is a misfit and no noise.
const MOST_CORRELATION: f64 = 0.9;

impl NoiseModel {
    /// White noise of this standard deviation along every axis.
    pub fn white(sigma: f64, interval: f64) -> Self {
        Self {
            sigma: [sigma; 3],
            ar1: [0.0; 3],
            interval,
        }
    }

    /// What a residual keeps of the one before it, `gap` seconds earlier, along an axis; and the standard deviation
    /// of what is new in it, m.
    pub fn innovation(&self, axis: usize, gap: f64) -> (f64, f64) {
        let intervals = gap / self.interval;
        let ar1 = self.ar1[axis];
        let kept = if self.is_one_interval(gap) {
            ar1
        } else if ar1 >= 0.0 {
            ar1.powf(intervals)
        } else {
            // Only a whole number of intervals has a sign.
            ar1.powi(intervals.round().clamp(1.0, 1e6) as i32)
        };
        (kept, self.sigma[axis] * (1.0 - kept * kept).sqrt())
    }

    /// Whether a time, s, is the interval that the correlation holds for.
    pub fn is_one_interval(&self, gap: f64) -> bool {
        (gap / self.interval - 1.0).abs() < 0.01
    }

    /// Root of the mean of the axes' variances, m.
    pub fn overall(&self) -> f64 {
        (self.sigma.iter().map(|sigma| sigma * sigma).sum::<f64>() / 3.0).sqrt()
    }

    /// Whether another estimate of the same noise says the same for all purposes.
    pub fn is_close_to(&self, other: &NoiseModel) -> bool {
        let same = |a: f64, b: f64| (a / b - 1.0).abs() < 0.005;
        (0..3).all(|axis| {
            same(self.sigma[axis], other.sigma[axis])
                && (self.ar1[axis] - other.ar1[axis]).abs() < 0.005
        })
    }
}

/// Sums over residuals from which the noise is estimated; those of several flights are added.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moments {
    /// Sum of squares along each axis, m².
    pub squares: [f64; 3],
    /// Sum of products of neighbours along each axis, m².
    pub products: [f64; 3],
    /// Sum of the mean squares of the same neighbours, m².
    pub neighbours: [f64; 3],
    /// How many residuals along each axis.
    pub count: usize,
    /// How many pairs of neighbours.
    pub pairs: usize,
}

impl Moments {
    /// Adds the residuals of one marker of a flight, m; `None` where there is none.
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

    /// The noise that leaves such residuals where `unknowns` were fitted to them; a standard deviation that is
    /// `given` (m) is taken as it is.
    pub fn noise(&self, unknowns: usize, interval: f64, given: Option<f64>) -> NoiseModel {
        let measured = 3 * self.count;
        let spread = measured as f64 / measured.saturating_sub(unknowns).max(1) as f64;
        let sigma = [0, 1, 2].map(|axis| {
            let estimated = (self.squares[axis] / self.count.max(1) as f64 * spread).sqrt();
            given.unwrap_or(estimated).max(f64::MIN_POSITIVE.sqrt())
        });
        let ar1 = [0, 1, 2].map(|axis| {
            // Few pairs tell nothing of a correlation.
            if self.pairs < 20 || self.neighbours[axis] <= 0.0 {
                return 0.0;
            }
            let correlation = self.products[axis] / self.neighbours[axis];
            correlation.clamp(-MOST_CORRELATION, MOST_CORRELATION)
        });
        NoiseModel {
            sigma,
            ar1,
            interval,
        }
    }
}

/// How far from its neighbours a residual may lie before its point is an outlier, over the standard deviation: of a million
/// normal residuals 7 lie farther.
pub const OUTLIER: f64 = 4.5;

/// How far from 0 a residual counts by its square before the noise is known, over a first guess of it; beyond it
/// counts by its size alone.
pub const HUBER: f64 = 2.0;

/// Standard deviation by the median of the sizes, which outliers do not move; 0 for none.
pub fn robust_sigma(sizes: &mut [f64]) -> f64 {
    1.4826 * median(sizes)
}

/// The median; 0 for none.
pub fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stationary first-order process from a fixed generator.
    fn process(count: usize, sigma: f64, ar1: f64) -> Vec<Option<[f64; 3]>> {
        let mut seed = 7_u64;
        let mut uniform = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
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
        let (kept, fresh) = noise.innovation(0, 2.0 / 120.0);
        assert!((kept - noise.ar1[0].powi(2)).abs() < 1e-12);
        assert!((fresh - noise.sigma[0] * (1.0 - kept * kept).sqrt()).abs() < 1e-12);
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

    #[test]
    fn the_median_is_not_moved_by_outliers() {
        let mut sizes = vec![1.0, 1.1, 0.9, 1e9, 1.0];
        assert_eq!(median(&mut sizes), 1.0);
    }
}
