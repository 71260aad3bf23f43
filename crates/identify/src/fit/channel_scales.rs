//! Scales of channels other than markers, from the noise of their samples.

use nalgebra::{UnitQuaternion, Vector3};

use crate::channel::ChannelKind;
use crate::observations::Observations;
use crate::path_noise::path_noise;
use crate::problem::FitProblem;
use dataset::statistics::{median_of, robust_sigma};

/// Minimum noise of a channel relative to the median magnitude of its values; smaller estimates of the noise are raised
/// to it. Without it, a channel whose values were rounded could appear to be noiseless.
const MIN_RELATIVE_NOISE: f64 = 1e-6;

/// Sets the scale of each sensor channel so that the noise of the channel, multiplied by this scale, equals
/// `problem.sigma0`. `sigma0` is the noise standard deviation of a position coordinate, m, and must be set before. If
/// there are no markers, `sigma0` is the noise of the positions of pose sensors; the channels of these positions then
/// retain their scale.
pub fn set_scales<'o>(
    problem: &mut FitProblem,
    flights: impl Iterator<Item = &'o Observations> + Clone,
) {
    for channel in 0..problem.channels.len() {
        let own = &problem.channels[channel];
        // Without markers, `sigma0` is the noise of the positions of the pose sensors.
        if problem.is_scored(channel) && own.is_position() {
            continue;
        }
        let is_attitude = own.kind == ChannelKind::Attitude;
        let noise = own.sigma.or_else(|| {
            let each = flights.clone();
            median_of(each.filter_map(|flight| noise(flight, channel, is_attitude)))
        });
        if let Some(noise) = noise.filter(|noise| *noise > 0.0) {
            problem.channels[channel].scale = problem.sigma0 / noise;
        }
    }
}

/// Standard deviation of the noise of a channel in one flight, estimated from the deviations of its values from smooth
/// curves, in the unit of the channel; `None` for fewer than four values. `is_attitude` states whether the values are
/// attitudes.
fn noise(flight: &Observations, channel: usize, is_attitude: bool) -> Option<f64> {
    let samples = flight.times.iter().enumerate();
    let values = samples.filter_map(|(sample, time)| {
        let value = flight.value(sample, channel)?;
        Some((*time, Vector3::from(value)))
    });
    let values: Vec<(f64, Vector3<f64>)> = values.collect();
    if values.len() < 4 {
        return None;
    }
    let least = MIN_RELATIVE_NOISE * median_of(values.iter().map(|(_, value)| value.norm()))?;
    let noise = match is_attitude {
        true => attitude_noise(&values),
        false => path_noise(values.into_iter()),
    };
    Some(noise.max(least))
}

/// Standard deviation of the noise of an attitude about one axis, rad, estimated from the rotation between each
/// attitude and the interpolation of its neighbours. `values` contains, for each measured attitude, its time, s, and
/// its rotation vector, rad.
fn attitude_noise(values: &[(f64, Vector3<f64>)]) -> f64 {
    let turn = |value: &Vector3<f64>| UnitQuaternion::from_scaled_axis(*value);
    let mut sizes = Vec::new();
    for three in values.windows(3) {
        let [(before, a), (time, b), (after, c)] = [three[0], three[1], three[2]];
        let part = (time - before) / (after - before);
        let between = (turn(&a).inverse() * turn(&c)).scaled_axis();
        let middle = turn(&a) * UnitQuaternion::from_scaled_axis(between * part);
        let off = (middle.inverse() * turn(&b)).scaled_axis();
        let spread = (1.0 + part * part + (1.0 - part).powi(2)).sqrt();
        sizes.extend(off.iter().map(|part| part.abs() / spread));
    }
    robust_sigma(&mut sizes)
}
