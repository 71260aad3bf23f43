//! Where and when residuals depart from noise.

use identify::{Channel, NoiseModel};
use serde::{Deserialize, Serialize};

use super::noise_floor::FlightSeries;
use super::spline_basis::{SUPPORT, SplineBasis};

/// Departure from which a time belongs to the stretch of greatest departure, as a fraction of the greatest.
const STRETCH: f64 = 0.5;

/// The greatest smooth departure of a flight from its prediction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SmoothMisfit {
    /// File of the flight.
    pub file: String,
    /// Marker or sensor and axis, as the column of the table: `m1_z`.
    pub coordinate: String,
    /// Begin of the stretch where the departure exceeds half its greatest size, s after the first sample.
    pub from_s: f64,
    /// End of that stretch, s after the first sample.
    pub to_s: f64,
    /// Greatest size of the smooth departure, measured − predicted, in `unit`.
    pub size_m: f64,
    /// Unit of the departure: `m` of positions.
    #[serde(default)]
    pub unit: String,
    /// p-value of the flight.
    pub p: f64,
}

/// The greatest departure of a flight, that coordinate first which differs most from noise.
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
        p: 1.0,
    })
}
