//! Residual diagnostics of many flights: autocorrelation and distribution of the residuals.

use std::collections::BTreeMap;

use statrs::distribution::{ContinuousCDF, Normal};

use super::AxisResiduals;
use crate::noise::AxesNoise;
use dataset::AXES;

/// Number of lags, in samples, for which the autocorrelation is computed.
const LAGS: usize = 25;

/// Number of bins of the histogram of whitened residuals, and its limit in standard deviations; residuals beyond it are
/// in the outermost bins.
const HISTOGRAM: (usize, f64) = (2000, 10.0);

/// Number of quantiles in the report, for a Q–Q plot.
const QUANTILES: usize = 61;

/// Sums of lagged products along each axis, and histograms of whitened residuals; those of flights can be added.
#[derive(Clone, Debug)]
pub struct ResidualPool {
    axes: [Axis; 3],
}

#[derive(Clone, Debug)]
struct Axis {
    /// Sum (m²) and number of the products of two residuals of a channel, by lag.
    raw: Vec<(f64, usize)>,
    whitened: Vec<(f64, usize)>,
    /// Histogram of the whitened residuals: number of values per bin.
    bins: Vec<u32>,
}

impl Default for ResidualPool {
    fn default() -> Self {
        let axis = || Axis {
            raw: vec![(0.0, 0); LAGS],
            whitened: vec![(0.0, 0); LAGS],
            bins: Vec::new(),
        };
        Self {
            axes: [axis(), axis(), axis()],
        }
    }
}

impl ResidualPool {
    /// Adds the residuals (m) of one channel at `times` (s), which `noise` whitens.
    pub fn add(&mut self, times: &[f64], residuals: &[Option<[f64; 3]>], noise: &AxesNoise) {
        for (k, axis) in self.axes.iter_mut().enumerate() {
            let series: Vec<Option<f64>> = residuals.iter().map(|r| r.map(|r| r[k])).collect();
            let mut whitened = vec![None; series.len()];
            let mut before: Option<(f64, f64)> = None;
            for (sample, residual) in series.iter().enumerate() {
                let Some(residual) = *residual else { continue };
                let gap = before.map(|(time, _)| times[sample] - time);
                let (kept, fresh) = noise.innovation(k, gap);
                let last = before.map_or(0.0, |(_, last)| last);
                whitened[sample] = Some((residual - kept * last) / fresh);
                before = Some((times[sample], residual));
            }
            products(&series, &mut axis.raw);
            products(&whitened, &mut axis.whitened);
            axis.bins.resize(HISTOGRAM.0, 0);
            for value in whitened.into_iter().flatten() {
                let place = (value / HISTOGRAM.1 + 1.0) / 2.0 * HISTOGRAM.0 as f64;
                axis.bins[(place.max(0.0) as usize).min(HISTOGRAM.0 - 1)] += 1;
            }
        }
    }

    /// Adds the sums and histograms of `other`, such as those of other flights, to those of `self`.
    pub fn join(&mut self, other: ResidualPool) {
        for (axis, other) in self.axes.iter_mut().zip(other.axes) {
            for (sums, others) in [
                (&mut axis.raw, other.raw),
                (&mut axis.whitened, other.whitened),
            ] {
                for (sum, other) in sums.iter_mut().zip(others) {
                    *sum = (sum.0 + other.0, sum.1 + other.1);
                }
            }
            axis.bins.resize(HISTOGRAM.0, 0);
            for (bin, other) in axis.bins.iter_mut().zip(other.bins) {
                *bin += other;
            }
        }
    }

    /// Residual diagnostics of each axis, keyed by the names `x`, `y` and `z`.
    pub fn axes(&self) -> BTreeMap<String, AxisResiduals> {
        let names = AXES.into_iter().map(str::to_owned);
        names.zip(self.axes.iter().map(Axis::report)).collect()
    }
}

impl Axis {
    fn report(&self) -> AxisResiduals {
        AxisResiduals {
            autocorrelation: correlations(&self.raw),
            whitened_autocorrelation: correlations(&self.whitened),
            band: 1.96 / (self.raw[0].1.max(1) as f64).sqrt(),
            quantiles: quantiles(&self.bins),
        }
    }
}

fn products(series: &[Option<f64>], sums: &mut [(f64, usize)]) {
    let seen: Vec<bool> = series.iter().map(Option::is_some).collect();
    let values: Vec<f64> = series.iter().map(|value| value.unwrap_or(0.0)).collect();
    let gaps = seen.contains(&false);
    for (lag, sum) in sums.iter_mut().enumerate().take(values.len()) {
        let pairs = values.iter().zip(&values[lag..]);
        sum.0 += pairs.map(|(earlier, later)| earlier * later).sum::<f64>();
        sum.1 += match gaps {
            false => values.len() - lag,
            true => {
                let pairs = seen.iter().zip(&seen[lag..]);
                pairs
                    .filter(|(earlier, later)| **earlier && **later)
                    .count()
            }
        };
    }
}

fn correlations(sums: &[(f64, usize)]) -> Vec<f64> {
    let mean = |(sum, count): (f64, usize)| sum / count.max(1) as f64;
    let variance = mean(sums[0]);
    if variance <= 0.0 {
        return Vec::new();
    }
    let seen = sums.iter().take_while(|(_, count)| *count > 0);
    seen.map(|&sum| mean(sum) / variance).collect()
}

/// Quantile pairs (normal, observed) of the binned values, for a Q–Q plot.
fn quantiles(bins: &[u32]) -> Vec<[f64; 2]> {
    let total: u64 = bins.iter().map(|&count| u64::from(count)).sum();
    if total == 0 {
        return Vec::new();
    }
    // Evenly spaced normal quantiles, up to the largest one that the number of values allows.
    let normal = Normal::standard();
    let most = normal.inverse_cdf(1.0 - 0.5 / total as f64).min(4.0);
    let mut from = (0, 0.0);
    let each = (0..QUANTILES).map(|k| {
        let expected = most * (2.0 * k as f64 / (QUANTILES - 1) as f64 - 1.0);
        let wanted = normal.cdf(expected) * total as f64;
        [expected, binned_quantile(bins, wanted, &mut from)]
    });
    each.collect()
}

/// Quantile, in standard deviations, below which `wanted` residuals are, interpolated within its bin. The search
/// resumes at `from` (bin, number of values below it).
fn binned_quantile(bins: &[u32], wanted: f64, from: &mut (usize, f64)) -> f64 {
    let width = 2.0 * HISTOGRAM.1 / HISTOGRAM.0 as f64;
    for (index, &count) in bins.iter().enumerate().skip(from.0) {
        let (count, below) = (f64::from(count), from.1);
        if count > 0.0 && below + count >= wanted {
            return -HISTOGRAM.1
                + width * (index as f64 + ((wanted - below) / count).clamp(0.0, 1.0));
        }
        *from = (index + 1, below + count);
    }
    HISTOGRAM.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha12Rng;
    use rand_distr::StandardNormal;

    #[test]
    fn even_normal_values_lie_on_the_diagonal() {
        let mut bins = vec![0; HISTOGRAM.0];
        for k in 0..20_000 {
            let value = Normal::standard().inverse_cdf((f64::from(k) + 0.5) / 20_000.0);
            bins[((value / HISTOGRAM.1 + 1.0) / 2.0 * HISTOGRAM.0 as f64) as usize] += 1;
        }
        for [expected, found] in quantiles(&bins) {
            assert!((expected - found).abs() < 0.1, "{expected} {found}");
        }
    }

    #[test]
    fn products_are_those_of_pairs_that_were_seen() {
        let value = |i: usize| (i as f64 * 0.7).sin();
        for missing in [None, Some(7), Some(30)] {
            let series: Vec<Option<f64>> = (0..31)
                .map(|i| Some(value(i)).filter(|_| Some(i) != missing))
                .collect();
            let mut sums = vec![(1.0, 1); 40];
            products(&series, &mut sums);
            for (lag, (sum, count)) in sums.into_iter().enumerate() {
                let pairs = (lag..31).filter(|&i| Some(i) != missing && Some(i - lag) != missing);
                let expected: f64 = pairs.clone().map(|i| value(i) * value(i - lag)).sum();
                assert!((sum - 1.0 - expected).abs() < 1e-12, "lag {lag}");
                assert_eq!(count, 1 + pairs.count());
            }
        }
    }

    #[test]
    fn alternating_residuals_are_anticorrelated() {
        let times: Vec<f64> = (0..100).map(f64::from).collect();
        let residuals: Vec<_> = (0..100)
            .map(|i| Some([if i % 2 == 0 { 1.0 } else { -1.0 }; 3]))
            .collect();
        let mut pool = ResidualPool::default();
        pool.add(&times, &residuals, &AxesNoise::white(1.0, 1.0));
        let axes = pool.axes();
        assert!((axes["x"].autocorrelation[1] + 1.0).abs() < 1e-12);
        assert!((axes["z"].autocorrelation[2] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn noise_that_is_known_leaves_independent_residuals_of_its_size() {
        let mut random = ChaCha12Rng::seed_from_u64(5);
        let mut noise = AxesNoise::white(0.002, 0.01);
        noise.ar1 = [0.7; 3];
        let mut last = 0.0;
        let residuals = (0..20_000).map(|_| {
            let fresh: f64 = random.sample(StandardNormal);
            last = 0.7 * last + 0.002 * (1.0_f64 - 0.49).sqrt() * fresh;
            Some([last; 3])
        });
        let residuals: Vec<_> = residuals.collect();
        let times: Vec<f64> = (0..20_000).map(|sample| 0.01 * f64::from(sample)).collect();
        let mut pool = ResidualPool::default();
        pool.add(&times, &residuals, &noise);
        let found = &pool.axes()["y"];
        assert!((found.autocorrelation[1] - 0.7).abs() < 0.03);
        assert!(
            found.whitened_autocorrelation[1..]
                .iter()
                .all(|own| own.abs() < 0.04)
        );
        for [expected, found] in found.quantiles.iter().filter(|own| own[0].abs() < 2.0) {
            assert!((expected - found).abs() < 0.15, "{expected} {found}");
        }
    }
}
