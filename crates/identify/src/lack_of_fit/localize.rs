//! Marker coordinate and time interval in which residuals deviate most from noise.

use crate::channel::Channel;
use crate::noise::NoiseModel;
use crate::report::SmoothMisfit;

use super::noise_floor::FlightSeries;
use super::spline_basis::{SUPPORT, SplineBasis};

/// Fraction of a flight's largest smooth deviation that bounds the reported time interval: the interval contains the
/// samples around the maximum at which the deviation is at least this fraction of it.
const STRETCH: f64 = 0.5;

/// Largest smooth deviation of a flight. Splines are fitted to the residuals of each measured coordinate; the result is
/// the maximum of the splines of the coordinate for which they explain most beyond noise. `None` if there is no
/// residual. The caller must set the fields `file` and `p` of the result.
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
