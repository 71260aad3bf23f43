//! Smooth part of the residuals of one flight: the reduction of the sum of squares by splines, beyond that by the
//! flight's own unknowns.

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use statrs::function::erf::erfc;

use super::noise_floor::FlightSeries;
use super::series::{SUPPORT, Series, SplineBasis};
use crate::channel::Channel;
use crate::noise::{AxesNoise, NoiseModel};
use crate::report::SmoothMisfit;
use dataset::levels::ROUNDING;

/// Lack-of-fit statistics of one flight: reduction of the sum of squares of its residuals by two sets of splines.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FlightMisfit {
    /// By splines that follow slow deviations, such as those of wrong forces.
    pub slow: ScaledStatistic,
    /// By splines that follow fast deviations, such as those of marker positions, attitude and spin.
    pub fine: ScaledStatistic,
}

/// Sums of products over all series of a flight, before and after projecting out one basis.
struct Projection {
    /// Sum of squares of the residuals' projection on the splines.
    squares: f64,
    rank: usize,
    /// Gram matrix of the local columns after the projection, and their products with the residuals.
    left: DMatrix<f64>,
    left_gradient: DVector<f64>,
    /// Sum of squares of the residuals, Gram matrix of the local columns and their products before it.
    total: f64,
    local: DMatrix<f64>,
    gradient: DVector<f64>,
    samples: usize,
}

impl FlightMisfit {
    /// Tests the residuals against the noise floor; `None` for too few samples. The flight's noise is at least
    /// `least_ratio` times the floor, because of integration errors.
    pub fn new(
        flight: &FlightSeries,
        slow: &SplineBasis,
        noise: &NoiseModel,
        least_ratio: f64,
    ) -> Option<Self> {
        let of_fine = Projection::new(flight, &flight.fine, noise);
        let of_slow = Projection::new(flight, slow, noise);
        let scale = of_fine.local.diagonal().map(|value| {
            let root = value.max(0.0).sqrt();
            if root > 0.0 { 1.0 / root } else { 0.0 }
        });
        let (of_locals, locals) = decrease(&of_fine.local, &of_fine.gradient, &scale);
        let statistic = |found: &Projection| {
            let (left, rank) = decrease(&found.left, &found.left_gradient, &scale);
            let degrees_of_freedom = (found.rank + rank).saturating_sub(locals) as f64;
            (found.squares + left, degrees_of_freedom, rank)
        };
        let (fine, fine_dof, rank) = statistic(&of_fine);
        let (slow, slow_dof, _) = statistic(&of_slow);
        let degrees_of_freedom = of_fine.samples as f64 - (of_fine.rank + rank) as f64;
        if degrees_of_freedom < 1.0 {
            return None;
        }
        let remaining = (of_fine.total - fine).max(0.0);
        let variance = (remaining / degrees_of_freedom).max(least_ratio * least_ratio);
        // At the minimum, the flight's own unknowns reduce nothing; what they seem to reduce beyond noise is the linear
        // prediction of a fit that ended elsewhere, as on a chaotic motion, and remains.
        let by_locals = of_locals.min(locals as f64 * variance);
        let (fine, slow) = (fine - by_locals, slow - by_locals);
        let scaled = |value: f64, of: f64| ScaledStatistic {
            value: value.max(0.0) / variance,
            degrees_of_freedom: of,
            noise_variance: of * of * 2.0 / degrees_of_freedom,
        };
        Some(Self {
            slow: scaled(slow, slow_dof),
            fine: scaled(fine, fine_dof),
        })
    }

    /// p-value of the flight; `relative_error` is that of the noise variance at low frequencies.
    pub fn p_value(&self, relative_error: f64) -> f64 {
        least_p(self.slow, self.fine, relative_error)
    }
}

/// Bonferroni-corrected p-value of the more significant of two tests. `relative_error` is that of the noise variance at
/// low frequencies, which widens the null distributions.
pub(super) fn least_p(slow: ScaledStatistic, fine: ScaledStatistic, relative_error: f64) -> f64 {
    let p = [slow, fine].map(|mut statistic| {
        statistic.noise_variance += (statistic.degrees_of_freedom * relative_error).powi(2);
        statistic.p_value()
    });
    (2.0 * p[0].min(p[1])).min(1.0)
}

impl Projection {
    fn new(flight: &FlightSeries, basis: &SplineBasis, noise: &NoiseModel) -> Self {
        let count = flight.series.first().map_or(1, |series| series[0].count);
        let locals = count - 1;
        let mut sum = Self {
            squares: 0.0,
            rank: 0,
            left: DMatrix::zeros(locals, locals),
            left_gradient: DVector::zeros(locals),
            total: 0.0,
            local: DMatrix::zeros(locals, locals),
            gradient: DVector::zeros(locals),
            samples: 0,
        };
        for (channel, axes) in flight.series.iter().enumerate() {
            for (axis, series) in axes.iter().enumerate() {
                sum.add(series, basis, noise.of(channel), axis);
            }
        }
        sum.left = &sum.local - &sum.left;
        sum.left_gradient = &sum.gradient - &sum.left_gradient;
        sum
    }

    fn add(&mut self, series: &Series, basis: &SplineBasis, noise: &AxesNoise, axis: usize) {
        let found = series.whitened(basis, noise, axis);
        let (count, locals) = (series.count, self.gradient.len());
        self.rank += found.projected.rank;
        self.samples += found.samples;
        let whole = DMatrix::from_row_slice(count, count, &found.products);
        self.total += whole[(0, 0)];
        self.gradient += whole.view((1, 0), (locals, 1));
        self.local += whole.view((1, 1), (locals, locals));
        // One column for each column of the basis.
        let coordinates = found.projected.coordinates;
        let on_splines = DMatrix::from_vec(count, coordinates.len() / count, coordinates);
        let on_splines = &on_splines * on_splines.transpose();
        self.squares += on_splines[(0, 0)];
        self.left_gradient += on_splines.view((1, 0), (locals, 1));
        self.left += on_splines.view((1, 1), (locals, locals));
    }
}

/// Reduction of the sum of squares by columns with Gram matrix `matrix` and products `gradient`, multiplied by `scale`,
/// and the number of independent directions.
fn decrease(matrix: &DMatrix<f64>, gradient: &DVector<f64>, scale: &DVector<f64>) -> (f64, usize) {
    let size = gradient.len();
    if size == 0 {
        return (0.0, 0);
    }
    let scaled = DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
    let Some(eigen) = SymmetricEigen::try_new(scaled, 1e-14, 10_000) else {
        return (0.0, 0);
    };
    let products = eigen.eigenvectors.tr_mul(&gradient.component_mul(scale));
    let kept = eigen.eigenvalues.iter().zip(products.iter());
    let kept = kept.filter(|(value, _)| **value > ROUNDING);
    kept.fold((0.0, 0), |(sum, rank), (value, product)| {
        (sum + product * product / value, rank + 1)
    })
}

// Survival function of the F distribution, approximated for large degrees of freedom.

/// Probability that an F variable exceeds `value`, by Paulson's normal approximation of its cube root; 1 if an argument
/// is not positive.
pub(super) fn f_survival(value: f64, (dof1, dof2): (f64, f64)) -> f64 {
    if !(dof1 > 0.0 && dof2 > 0.0 && value > 0.0) {
        return 1.0;
    }
    let (a, b) = (2.0 / (9.0 * dof1), 2.0 / (9.0 * dof2));
    let root = value.cbrt();
    let z = ((1.0 - b) * root - (1.0 - a)) / (b * root * root + a).sqrt();
    erfc(z / std::f64::consts::SQRT_2) / 2.0
}

/// Lack-of-fit statistic, tested as an F variable because the noise is estimated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ScaledStatistic {
    /// Test statistic: sum of squares over the estimated noise variance.
    pub value: f64,
    /// Expectation of the statistic under the null hypothesis: its degrees of freedom.
    pub degrees_of_freedom: f64,
    /// Variance of the statistic beyond that of χ², because the noise is estimated.
    pub noise_variance: f64,
}

impl ScaledStatistic {
    /// Adds `other`, a statistic with an independent estimate of the noise variance, such as from another flight.
    pub fn add(&mut self, other: &Self) {
        self.value += other.value;
        self.degrees_of_freedom += other.degrees_of_freedom;
        self.noise_variance += other.noise_variance;
    }

    /// p-value of the statistic under the null hypothesis, by the F distribution.
    pub fn p_value(&self) -> f64 {
        if self.degrees_of_freedom <= 0.0 {
            return 1.0;
        }
        let relative = self.noise_variance / (self.degrees_of_freedom * self.degrees_of_freedom);
        let dof2 = 2.0 / relative.max(1e-9);
        f_survival(
            self.value / self.degrees_of_freedom,
            (self.degrees_of_freedom, dof2),
        )
    }
}

// Marker coordinate and time interval in which residuals deviate most from noise.

/// Fraction of the largest deviation down to which samples around it belong to the reported interval.
const STRETCH: f64 = 0.5;

/// Largest smooth deviation of a flight: the maximum of the splines of the coordinate for which they explain most
/// beyond noise; `None` without residuals. The caller sets `file` and `p_value`.
pub(super) fn greatest_misfit(
    flight: &FlightSeries,
    basis: &SplineBasis,
    noise: &NoiseModel,
    channels: &[Channel],
) -> Option<SmoothMisfit> {
    let mut best: Option<(f64, usize, usize, Vec<f64>)> = None;
    for (marker, axes) in flight.series.iter().enumerate() {
        let noise = noise.of(marker);
        for (axis, series) in axes.iter().enumerate() {
            let found = series
                .residuals_only()
                .whitened(basis, noise, axis)
                .projected;
            let squares: f64 = found.coordinates.iter().map(|c| c * c).sum();
            let excess = squares - found.rank as f64;
            if best.as_ref().is_none_or(|best| excess > best.0) {
                best = Some((excess, marker, axis, found.coefficients()));
            }
        }
    }
    let (_, marker, axis, coefficients) = best?;
    let times = &flight.series[marker][axis].times;
    // The residuals of the least squares are predicted − measured.
    let curve: Vec<f64> = times
        .iter()
        .map(|&time| {
            let (first, values) = basis.at(time);
            let each = (0..SUPPORT).map(|k| values[k] * coefficients[first + k]);
            -each.sum::<f64>()
        })
        .collect();
    let greatest = (0..curve.len()).max_by(|&a, &b| curve[a].abs().total_cmp(&curve[b].abs()))?;
    let size = curve[greatest];
    let channel = &channels[marker];
    let belongs = |index: usize| curve[index] * size.signum() >= STRETCH * size.abs();
    let from = (0..=greatest).rev().take_while(|&k| belongs(k)).last();
    let to = (greatest..curve.len()).take_while(|&k| belongs(k)).last();
    Some(SmoothMisfit {
        file: String::new(),
        coordinate: match channel.components {
            1 => channel.name.clone(),
            _ => format!("{}_{}", channel.name, ["x", "y", "z"][axis]),
        },
        unit: channel.unit.to_owned(),
        from_s: times[from.unwrap_or(greatest)],
        to_s: times[to.unwrap_or(greatest)],
        size_m: size / channel.scale,
        p_value: 1.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::jitter;

    /// p-value of a flight with noise of 1 mm, and `left`, m, of what its own unknown might take away.
    fn p_value(left: f64) -> f64 {
        let mut random = 0;
        let mut series = || {
            let mut one = Series::new(2);
            for sample in 0..150 {
                let (time, taken) = (f64::from(sample) / 120.0, f64::from(sample) / 150.0);
                let noise = 0.001 * 3.0_f64.sqrt() * jitter(random);
                random += 1;
                one.times.push(time);
                one.sides.extend([noise + left * taken, taken]);
            }
            one
        };
        let of_flight = FlightSeries {
            series: vec![[series(), series(), series()]],
            fine: SplineBasis::new((0.0, 1.25), 0.03),
        };
        let slow = SplineBasis::new((0.0, 1.25), 0.25);
        let noise = NoiseModel::white(0.001, 1.0 / 120.0);
        let misfit = FlightMisfit::new(&of_flight, &slow, &noise, 0.0).unwrap();
        misfit.p_value(0.0)
    }

    #[test]
    fn a_misfit_is_named_by_the_column_of_the_table() {
        let named = |components: usize| {
            let series = |size: f64| {
                let mut one = Series::new(1);
                for sample in 0..150 {
                    let time = f64::from(sample) / 120.0;
                    let noise = 0.001 * 3.0_f64.sqrt() * jitter(sample as usize);
                    one.times.push(time);
                    one.sides.push(noise + size * (4.0 * time).sin());
                }
                one
            };
            let of_flight = FlightSeries {
                series: vec![[series(0.02), series(0.0), series(0.0)]],
                fine: SplineBasis::new((0.0, 1.25), 0.03),
            };
            let channel = Channel {
                name: "radar".to_owned(),
                kind: crate::channel::ChannelKind::Marker(0),
                position: [0.0; 3],
                components,
                group: 0,
                sigma: None,
                scale: 1.0,
                unit: "m/s",
                to_si: 1.0,
                is_exact: false,
                assumed: None,
                rounding: [0.0; 3],
                repeats: false,
            };
            let slow = SplineBasis::new((0.0, 1.25), 0.25);
            let noise = NoiseModel::white(0.001, 1.0 / 120.0);
            greatest_misfit(&of_flight, &slow, &noise, &[channel]).map(|own| own.coordinate)
        };
        assert_eq!(named(1).as_deref(), Some("radar"));
        assert_eq!(named(3).as_deref(), Some("radar_x"));
    }

    #[test]
    fn what_a_flights_own_unknowns_did_not_take_is_a_misfit() {
        assert!(p_value(0.0) > 0.01, "{}", p_value(0.0));
        assert!(p_value(0.01) < 1e-6, "{}", p_value(0.01));
    }

    #[test]
    fn tails_are_those_of_tables() {
        // 1 % and 5 % points of F(10, 20), F(60, 120), F(5, 1e6) = chi squared(5) / 5.
        for (value, degrees_of_freedom, expected) in [
            (3.368, (10.0, 20.0), 0.01),
            (2.348, (10.0, 20.0), 0.05),
            (1.656, (60.0, 120.0), 0.01),
            (3.017, (5.0, 1e9), 0.01),
        ] {
            let found = f_survival(value, degrees_of_freedom);
            assert!((found / expected - 1.0).abs() < 0.06, "{found} {expected}");
        }
        assert_eq!(f_survival(0.0, (3.0, 3.0)), 1.0);
    }
}
