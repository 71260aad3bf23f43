//! Noise floor: the part of the residuals that no smooth motion can follow, as an AR(1) process along each axis.
//!
//! Splines with knots close together take everything smooth out of the residuals, whatever its cause; restricted maximum
//! likelihood gives the variance and the autocorrelation of what they leave, without the bias of the splines' coefficients.

use flight::batch;
use identify::{AxesNoise, Channel, NoiseModel, group_count};

use super::series::Series;
use super::spline_basis::SplineBasis;

/// Range of autocorrelations from sample to sample.
const AR1_RANGE: (f64, f64) = (-0.8, 0.95);

/// Steps of the golden-section search, which leave a hundredth of the range.
const GOLDEN_STEPS: usize = 10;

/// Distance of the autocorrelations from which the curvature of the likelihood is taken.
const CURVATURE_STEP: f64 = 0.03;

/// Greatest number of residuals of one axis from which the autocorrelation is estimated.
const MAX_RESIDUALS: usize = 40_000;

/// Residuals of one flight, by channel and axis, and its splines.
pub(super) struct FlightSeries {
    /// `series[channel][axis]`.
    pub series: Vec<[Series; 3]>,
    /// Splines that follow every smooth motion.
    pub fine: SplineBasis,
}

/// Noise that no smooth motion follows.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NoiseFloor {
    /// The noise.
    pub noise: NoiseModel,
    /// Standard errors of the autocorrelations of each group of channels.
    pub ar1_std_error: Vec<[f64; 3]>,
}

/// Restricted likelihood of one axis at one autocorrelation.
#[derive(Clone, Copy, Debug, Default)]
struct Likelihood {
    /// −2 ln of the likelihood, each flight's variance profiled.
    deviance: f64,
    /// Sum of squares over the innovations' relative variances, m².
    squares: f64,
    /// Number of residuals less that of the splines.
    dof: f64,
}

impl NoiseFloor {
    /// Estimates the noise of residuals `interval` seconds apart; `None` if there are fewer residuals than splines need.
    pub fn estimate(
        flights: &[FlightSeries],
        channels: &[Channel],
        interval: f64,
        threads: usize,
    ) -> Option<Self> {
        let mut count = 0;
        let used = flights.iter().take_while(|flight| {
            let before = count;
            count += flight
                .series
                .iter()
                .map(|s| s[0].times.len())
                .sum::<usize>();
            before < MAX_RESIDUALS
        });
        let used: Vec<&FlightSeries> = used.collect();
        let group_of: Vec<usize> = channels.iter().map(|channel| channel.group).collect();
        let (mut groups, mut ar1_std_error) = (Vec::new(), Vec::new());
        for group in 0..group_count(&group_of) {
            let is_single = |channel: &Channel| channel.group == group && channel.components == 1;
            let components = if channels.iter().any(is_single) { 1 } else { 3 };
            let axes = batch::each_on(threads, components, |axis| {
                of_axis(&used, (group, &group_of), axis, interval)
            });
            let (mut noise, mut errors) = (AxesNoise::white(0.0, interval), [0.0; 3]);
            for axis in 0..3 {
                // A single number stands there three times.
                let (ar1, std_error, sigma) = axes[axis % components]?;
                noise.ar1[axis] = ar1;
                noise.sigma[axis] = sigma;
                errors[axis] = std_error;
            }
            groups.push(noise);
            ar1_std_error.push(errors);
        }
        Some(Self {
            noise: NoiseModel::of_groups(groups, group_of),
            ar1_std_error,
        })
    }

    /// Standard deviation of the ratio of slow to fast noise power, relative, averaged over the axes: the error with which
    /// the noise of slow motions is extrapolated from that of fast ones.
    pub fn relative_error(&self) -> f64 {
        let axes = 3.0 * self.ar1_std_error.len() as f64;
        let pairs = self.noise.groups().iter().zip(&self.ar1_std_error);
        let squares = pairs.flat_map(|(noise, errors)| {
            (0..3).map(move |axis| {
                let ar1 = noise.ar1[axis];
                (errors[axis] * (2.0 / (1.0 - ar1) + 1.0 / (1.0 + ar1)) / axes).powi(2)
            })
        });
        squares.sum::<f64>().sqrt()
    }
}

/// Autocorrelation, its standard error, and standard deviation (m) along an axis.
fn of_axis(
    flights: &[&FlightSeries],
    group: (usize, &[usize]),
    axis: usize,
    interval: f64,
) -> Option<(f64, f64, f64)> {
    let at = |ar1: f64| likelihood(flights, group, axis, ar1, interval);
    let deviance = |ar1: f64| at(ar1).deviance;
    let ratio = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut low, mut high) = AR1_RANGE;
    let (mut a, mut b) = (high - ratio * (high - low), low + ratio * (high - low));
    let (mut of_a, mut of_b) = (deviance(a), deviance(b));
    for _ in 0..GOLDEN_STEPS {
        if of_a < of_b {
            (high, b, of_b) = (b, a, of_a);
            a = high - ratio * (high - low);
            of_a = deviance(a);
        } else {
            (low, a, of_a) = (a, b, of_b);
            b = low + ratio * (high - low);
            of_b = deviance(b);
        }
    }
    let ar1 = (low + high) / 2.0;
    let found = at(ar1);
    if !(found.dof >= 1.0 && found.squares.is_finite()) {
        return None;
    }
    let around = [-1.0, 1.0].map(|side| deviance(ar1 + side * CURVATURE_STEP));
    let curvature =
        (around[0] + around[1] - 2.0 * found.deviance) / (CURVATURE_STEP * CURVATURE_STEP);
    // A flat likelihood leaves the autocorrelation open over its whole range.
    let widest = (AR1_RANGE.1 - AR1_RANGE.0) / 12.0_f64.sqrt();
    let std_error = match curvature > 0.0 {
        true => (2.0 / curvature).sqrt().min(widest),
        false => widest,
    };
    let sigma = (found.squares / found.dof).sqrt().max(1e-150);
    Some((ar1, std_error, sigma))
}

/// Likelihood of the channels of a group, along an axis.
fn likelihood(
    flights: &[&FlightSeries],
    (group, group_of): (usize, &[usize]),
    axis: usize,
    ar1: f64,
    interval: f64,
) -> Likelihood {
    let mut noise = AxesNoise::white(1.0, interval);
    noise.ar1[axis] = ar1;
    let mut total = Likelihood::default();
    for flight in flights {
        let (mut squares, mut dof, mut ln) = (0.0, 0.0, 0.0);
        let of_group = flight.series.iter().zip(group_of);
        for (series, _) in of_group.filter(|(_, own)| **own == group) {
            let found = series[axis].whitened(&flight.fine, &noise, axis);
            let on_splines: f64 = found.projected.coordinates.iter().map(|c| c * c).sum();
            squares += (found.products[0] - on_splines).max(0.0);
            dof += found.samples as f64 - found.projected.rank as f64;
            ln += found.ln_variances + found.projected.ln_determinant;
        }
        if dof > 0.0 {
            total.deviance += dof * squares.max(1e-300).ln() + ln;
            total.squares += squares;
            total.dof += dof;
        }
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha12Rng;
    use rand_distr::StandardNormal;

    /// Flights of AR(1) noise of 2 mm beside a smooth motion of 50 mm, with gaps.
    fn flights(ar1: f64) -> Vec<FlightSeries> {
        let mut random = ChaCha12Rng::seed_from_u64(3);
        let mut series = || {
            let mut one = Series::new(1);
            let mut state = 0.0;
            for sample in 0..150 {
                let normal: f64 = random.sample(StandardNormal);
                state = ar1 * state + 0.002 * (1.0 - ar1 * ar1).sqrt() * normal;
                let time = f64::from(sample) / 120.0;
                if sample % 11 != 3 {
                    one.times.push(time);
                    one.sides.push(state + 0.05 * (4.0 * time).sin());
                }
            }
            one
        };
        (0..12)
            .map(|_| FlightSeries {
                series: vec![[series(), series(), series()]],
                fine: SplineBasis::new((0.0, 150.0 / 120.0), 0.03),
            })
            .collect()
    }

    fn marker() -> Channel {
        Channel {
            name: "m1".to_owned(),
            kind: identify::ChannelKind::Marker(0),
            position: [0.0; 3],
            components: 3,
            group: 0,
            sigma: None,
            scale: 1.0,
            unit: "m",
        }
    }

    #[test]
    fn noise_is_found_again_whatever_moves_beside_it() {
        for ar1 in [0.0, 0.6] {
            let channels = [marker()];
            let found = NoiseFloor::estimate(&flights(ar1), &channels, 1.0 / 120.0, 1).unwrap();
            for axis in 0..3 {
                let error = found.ar1_std_error[0][axis];
                assert!(error > 0.01 && error < 0.2, "{found:?}");
                assert!(
                    (found.noise.ar1[axis] - ar1).abs() < 3.0 * error,
                    "{found:?}"
                );
                let relative = found.noise.sigma[axis] / 0.002;
                assert!((relative - 1.0).abs() < 0.25, "{found:?}");
            }
        }
    }
}
