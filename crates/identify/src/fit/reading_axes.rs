//! Axes of instruments beside positions, compared with the motion of the fit: readings with exchanged axes follow it only
//! where they are exchanged back.

use model_spec::compose::Instrument;
use nalgebra::Vector3;

use super::residual_cache::ResidualCache;
use super::state::State;
use crate::channel::ChannelKind;
use crate::levels::{NEAR_NOISE, SIGNIFICANT};
use crate::screening::SignedAxes;

/// Predicted and measured readings of one flight, less their means: instruments have offsets.
type Readings = Vec<[Vector3<f64>; 2]>;

/// Sentences on instruments whose readings follow the motion of the fit clearly better along other axes; none without
/// positions, where the fit turns the body as the readings ask.
pub fn exchanged(state: &State<'_>, cache: &ResidualCache) -> Vec<String> {
    let problem = state.problem;
    if !problem.sees_positions() {
        return Vec::new();
    }
    let channels = problem.channels.iter().enumerate();
    let each = channels.filter_map(|(channel, own)| {
        let ChannelKind::Instrument(place) = own.kind else {
            return None;
        };
        let key = match problem.instruments[place].0 {
            Instrument::Gyroscope => "gyroscope_axes",
            Instrument::Accelerometer => "accelerometer_axes",
            Instrument::Speed => return None,
        };
        let axes = better_axes(&readings(state, cache, channel))?;
        Some(format!(
            "{} follows the motion of the body only with the axes {axes} for x, y, z: state `{key} = {}` in [recording], or turn the readings",
            own.name,
            axes.toml()
        ))
    });
    each.collect()
}

fn readings(state: &State<'_>, cache: &ResidualCache, channel: usize) -> Vec<Readings> {
    let scale = state.problem.channels[channel].scale;
    let of_flight = |(place, flight): (usize, &crate::observations::Observations)| {
        let path = cache.path(&state.flights, place).ok()?;
        let samples = path.residuals[channel].iter().enumerate();
        let pairs = samples.filter_map(|(sample, residual)| {
            let measured = Vector3::from(flight.inlier(sample, channel)?);
            Some([measured + Vector3::from((*residual)?) / scale, measured])
        });
        let mut pairs: Readings = pairs.collect();
        let sums = pairs
            .iter()
            .fold([Vector3::zeros(); 2], |[a, b], [c, d]| [a + c, b + d]);
        let means = sums.map(|sum| sum / pairs.len().max(1) as f64);
        for pair in &mut pairs {
            *pair = [pair[0] - means[0], pair[1] - means[1]];
        }
        Some(pairs)
    };
    state
        .flights
        .iter()
        .enumerate()
        .filter_map(of_flight)
        .collect()
}

/// Axes with which the readings are clearly nearer to the prediction, along the axes that they change.
fn better_axes(flights: &[Readings]) -> Option<SignedAxes> {
    let [own, others @ ..] = &SignedAxes::all()[..] else {
        return None;
    };
    let squares = |axes: &SignedAxes| {
        let each = flights.iter().flatten().map(|[predicted, measured]| {
            let off = axes.turned(*measured) - predicted;
            off.component_mul(&off)
        });
        each.sum::<Vector3<f64>>()
    };
    let as_they_are = squares(own);
    let better = others.iter().map(|axes| (axes, squares(axes)));
    let (axes, found) = better.min_by(|(_, a), (_, b)| a.sum().total_cmp(&b.sum()))?;
    let changed = (0..3).filter(|axis| axes.along(*axis) != own.along(*axis));
    let sum = |squares: &Vector3<f64>| changed.clone().map(|axis| squares[axis]).sum::<f64>();
    let ratio = sum(&as_they_are) / sum(&found);
    let count = flights.iter().map(Vec::len).sum::<usize>() * changed.clone().count();
    // Twice the gain of the log-likelihood of noise of unknown size.
    let gain = count as f64 * ratio.ln();
    (ratio > NEAR_NOISE * NEAR_NOISE && gain > SIGNIFICANT * SIGNIFICANT).then_some(*axes)
}
