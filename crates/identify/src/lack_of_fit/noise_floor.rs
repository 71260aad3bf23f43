//! Noise floor: the part of the residuals that no smooth motion can follow, an AR(1) process along each axis. Splines
//! with close knots remove everything smooth; restricted maximum likelihood gives variance and autocorrelation of the
//! rest, without bias from the splines' coefficients.

use flight::parallel;

use super::series::{Series, SplineBasis};
use crate::channel::Channel;
use crate::noise::{AxesNoise, NoiseModel, group_count};
use crate::rounding;

/// Range (minimum, maximum) in which the lag-1 autocorrelation of the measurement noise is searched.
const AR1_RANGE: (f64, f64) = (-0.8, 0.95);

/// Number of golden-section steps for the autocorrelation: 10 reduce its range to a hundredth.
const GOLDEN_STEPS: usize = 10;

/// Step of the lag-1 autocorrelation in the finite difference that gives the curvature of the restricted deviance.
const CURVATURE_STEP: f64 = 0.03;

/// Number of residuals of one axis after which no further flight is used.
const MAX_RESIDUALS: usize = 40_000;

/// Residuals of one flight by measurement channel and axis, and the spline basis of the flight.
pub(super) struct FlightSeries {
    /// Residuals as `series[channel][axis]`, where a channel is a marker position or one quantity of a sensor.
    pub series: Vec<[Series; 3]>,
    /// Spline basis whose knots are close enough to follow fast smooth motion; what it cannot follow counts as noise.
    pub fine: SplineBasis,
}

/// Noise floor: noise estimated from the fast changes of the residuals, which no smooth motion can follow.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NoiseFloor {
    pub noise: NoiseModel,
    /// `ar1_std_error[group][axis]`: standard error of the lag-1 autocorrelation of a noise group.
    pub ar1_std_error: Vec<[f64; 3]>,
}

/// Restricted likelihood of the residuals of one axis at a given autocorrelation.
#[derive(Clone, Copy, Debug, Default)]
struct Likelihood {
    /// Restricted deviance: −2 ln of the restricted likelihood, maximized over the variance of each flight.
    deviance: f64,
    /// Sum of squares, m², of the innovations beyond the splines, each over its variance ratio.
    squares: f64,
    degrees_of_freedom: f64,
}

impl NoiseFloor {
    /// Noise of residuals with sampling interval `interval`, s; `None` if they are too few for the splines.
    pub fn estimate(
        flights: &[&FlightSeries],
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
        let used: Vec<&FlightSeries> = used.copied().collect();
        let group_of: Vec<usize> = channels.iter().map(|channel| channel.group).collect();
        let (mut groups, mut ar1_std_error) = (Vec::new(), Vec::new());
        for group in 0..group_count(&group_of) {
            let is_single = |channel: &Channel| channel.group == group && channel.components == 1;
            let components = if channels.iter().any(is_single) { 1 } else { 3 };
            let rounding = rounding::of_group(channels, group);
            let mut own = group_of.iter().enumerate();
            let is_left_out = own.all(|(channel, own)| {
                let mut flights = used.iter().map(|flight| &flight.series[channel][0]);
                *own != group || flights.all(|series| series.times.is_empty())
            });
            if is_left_out && rounding.iter().any(|own| *own > 0.0) {
                groups.push(AxesNoise {
                    sigma: rounding,
                    ..AxesNoise::white(0.0, interval)
                });
                ar1_std_error.push([0.0; 3]);
                continue;
            }
            let axes = parallel::each_on(threads, components, |axis| {
                of_axis(&used, (group, &group_of), axis, interval)
            });
            let (mut noise, mut errors) = (AxesNoise::white(0.0, interval), [0.0; 3]);
            for axis in 0..3 {
                // A channel with one component has the same value for all three axes.
                let (ar1, std_error, sigma) = axes[axis % components]?;
                noise.ar1[axis] = ar1;
                noise.sigma[axis] = sigma.max(rounding[axis]);
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

    /// Relative standard error of the low-frequency noise variance, which AR(1) extrapolates from high frequencies.
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

/// Lag-1 autocorrelation, its standard error, and standard deviation, m, of one group along one axis; `group` is its
/// index and the group of each channel. `None` if there are too few residuals.
fn of_axis(
    flights: &[&FlightSeries],
    (group, group_of): (usize, &[usize]),
    axis: usize,
    interval: f64,
) -> Option<(f64, f64, f64)> {
    let flights = flights.iter().map(|flight| {
        let of_group = flight.series.iter().zip(group_of);
        let of_group = of_group.filter(|(_, own)| **own == group);
        let series = Series::together(of_group.map(|(series, _)| &series[axis]));
        (series, flight.fine)
    });
    let flights: Vec<(Vec<Series>, SplineBasis)> = flights.collect();
    let at = |ar1: f64| likelihood(&flights, axis, ar1, interval);
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
    if !(found.degrees_of_freedom >= 1.0 && found.squares.is_finite()) {
        return None;
    }
    let around = [-1.0, 1.0].map(|side| deviance(ar1 + side * CURVATURE_STEP));
    let curvature =
        (around[0] + around[1] - 2.0 * found.deviance) / (CURVATURE_STEP * CURVATURE_STEP);
    // A flat likelihood does not determine the autocorrelation: its standard error is that of a uniform distribution.
    let widest = (AR1_RANGE.1 - AR1_RANGE.0) / 12.0_f64.sqrt();
    let std_error = match curvature > 0.0 {
        true => (2.0 / curvature).sqrt().min(widest),
        false => widest,
    };
    let sigma = (found.squares / found.degrees_of_freedom)
        .sqrt()
        .max(1e-150);
    Some((ar1, std_error, sigma))
}

/// Restricted likelihood of the residuals of one noise group along one axis at the autocorrelation `ar1`, by flight
/// with its splines; all fields are 0 if every flight has too few residuals for these.
fn likelihood(
    flights: &[(Vec<Series>, SplineBasis)],
    axis: usize,
    ar1: f64,
    interval: f64,
) -> Likelihood {
    let mut noise = AxesNoise::white(1.0, interval);
    noise.ar1[axis] = ar1;
    let mut total = Likelihood::default();
    for (series, fine) in flights {
        let (mut squares, mut degrees_of_freedom, mut ln) = (0.0, 0.0, 0.0);
        for series in series {
            let found = series.whitened(fine, &noise, axis);
            let coordinates = &found.projected.coordinates;
            let count = series.count as f64;
            for side in 0..series.count {
                let of_side = coordinates[side..].iter().step_by(series.count);
                let on_splines: f64 = of_side.map(|c| c * c).sum();
                squares += (found.products[side * (series.count + 1)] - on_splines).max(0.0);
            }
            degrees_of_freedom += count * (found.samples as f64 - found.projected.rank as f64);
            ln += count * (found.ln_variances + found.projected.ln_determinant);
        }
        if degrees_of_freedom > 0.0 {
            total.deviance += degrees_of_freedom * squares.max(1e-300).ln() + ln;
            total.squares += squares;
            total.degrees_of_freedom += degrees_of_freedom;
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

    /// Residuals of simulated flights, with gaps: AR(1) noise of 2 mm, with lag-1 autocorrelation `ar1`, added to a
    /// smooth motion of 50 mm.
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
            kind: crate::channel::ChannelKind::Marker(0),
            position: [0.0; 3],
            components: 3,
            group: 0,
            sigma: None,
            scale: 1.0,
            unit: "m",
            to_si: 1.0,
            is_exact: false,
            assumed: None,
            rounding: [0.0; 3],
            repeats: false,
        }
    }

    #[test]
    fn a_flight_with_as_few_residuals_as_its_splines_have_coefficients_tells_nothing() {
        let mut flights = flights(0.6);
        flights.truncate(2);
        let of = |flights: &[FlightSeries]| {
            let flights = flights.iter();
            let flights = flights.map(|own| (vec![own.series[0][0].clone()], own.fine));
            likelihood(&flights.collect::<Vec<_>>(), 0, 0.6, 1.0 / 120.0)
        };
        let with = of(&flights);
        for series in flights[1].series.iter_mut().flatten() {
            series.times.truncate(2);
            series.sides.truncate(2);
        }
        let (short, without) = (of(&flights), of(&flights[..1]));
        assert!(with.deviance < without.deviance);
        assert_eq!(short.deviance, without.deviance);
        assert_eq!(short.degrees_of_freedom, without.degrees_of_freedom);
    }

    #[test]
    fn noise_is_found_again_whatever_moves_beside_it() {
        for ar1 in [0.0, 0.6] {
            let channels = [marker()];
            let flights = flights(ar1);
            let flights: Vec<&FlightSeries> = flights.iter().collect();
            let found = NoiseFloor::estimate(&flights, &channels, 1.0 / 120.0, 1).unwrap();
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
