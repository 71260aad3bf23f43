//! Poses of another point than the mass centre, told by positions that turn with the body about those of the fit.

use nalgebra::{Matrix3, Vector3};

use super::residual_cache::ResidualCache;
use super::state::State;
use crate::channel::ChannelKind;
use crate::numbers::Digits;
use dataset::AXES;
use dataset::levels::{FAR_ABOVE, NEAR_NOISE, SIGNIFICANT};

/// Millimetres in a metre.
const MM: f64 = 1e3;

/// What a position is off, m, and the axes of the body, in the inertial frame; both less what a shift and a drift of the
/// flight follow.
type Sample = (Vector3<f64>, Matrix3<f64>);

/// Sentences on poses whose positions turn with the body about the mass centre: with the point that they are of.
pub fn offsets(state: &State<'_>, cache: &ResidualCache) -> Vec<String> {
    let problem = state.problem;
    let channels = problem.channels.iter().enumerate();
    let poses = channels.filter(|(_, own)| own.kind == ChannelKind::Position);
    let each = poses.filter_map(|(channel, own)| {
        let flights = (0..state.flights.len()).filter(|_| problem.points.has_attitude);
        let samples = flights.filter_map(|flight| samples(state, cache, flight, channel));
        let found = offset(&samples.flatten().collect::<Vec<_>>())?;
        Some(format!(
            "the positions of {} turn with the body, as of a point beside the mass centre ({}): \
             state `position = \"unknown\"` for it, which estimates that, or its position",
            own.name,
            coordinates(found)
        ))
    });
    each.collect()
}

/// Coordinates of a point with their standard errors; but for those that the motion of the fit takes up, such as that
/// along the axis of the spin.
fn coordinates((point, error): (Vector3<f64>, Vector3<f64>)) -> String {
    let limit = FAR_ABOVE * error.min();
    let axes = AXES.iter().zip(point.iter().zip(error.iter()));
    let parts = axes.filter(|(_, (_, error))| **error <= limit);
    let parts = parts.map(|(axis, (value, error))| {
        let digits = Digits::of(MM * value, MM * error);
        let [value, error] = [value, error].map(|own| digits.one(MM * own));
        format!("{axis} = {value} ± {error} mm")
    });
    parts.collect::<Vec<_>>().join(", ")
}

/// Samples of one flight; `None` if it has no trajectory.
fn samples(
    state: &State<'_>,
    cache: &ResidualCache,
    flight: usize,
    channel: usize,
) -> Option<Vec<Sample>> {
    let (problem, observations) = (state.problem, &state.flights[flight]);
    let path = cache.path(&state.flights, flight).ok()?;
    let bound = observations.bound(problem, &state.global);
    let mut observer = bound.observer();
    let scale = problem.channels[channel].scale;
    let mut found: Vec<(f64, Sample)> = Vec::new();
    for (sample, time, state) in observations.along(&path.states) {
        let residual = path.residual(sample, channel);
        let Some(residual) = residual.filter(|_| observations.inlier(sample, channel).is_some())
        else {
            continue;
        };
        let mut at = |point: [f64; 3]| Vector3::from(observer.position(time, state, &point));
        let origin = at([0.0; 3]);
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let axes = Matrix3::from_columns(&axes.map(|axis| at(axis) - origin));
        found.push((time, (-Vector3::from(residual) / scale, axes)));
    }
    Some(without_drift(found))
}

/// Samples less their mean and their drift in time.
fn without_drift(found: Vec<(f64, Sample)>) -> Vec<Sample> {
    let count = found.len().max(1) as f64;
    let middle = found.iter().map(|(time, _)| time).sum::<f64>() / count;
    let spread: f64 = found.iter().map(|(time, _)| (time - middle).powi(2)).sum();
    let mut mean: Sample = Default::default();
    let mut drift: Sample = Default::default();
    for (time, (off, axes)) in &found {
        let part = (time - middle) / spread;
        mean = (mean.0 + off / count, mean.1 + axes / count);
        drift = (drift.0 + off * part, drift.1 + axes * part);
    }
    let each = found.into_iter().map(|(time, (off, axes))| {
        let past = time - middle;
        (
            off - mean.0 - drift.0 * past,
            axes - mean.1 - drift.1 * past,
        )
    });
    each.collect()
}

/// Point of the body that explains the samples and its standard error, m; `None` if none does clearly.
fn offset(samples: &[Sample]) -> Option<(Vector3<f64>, Vector3<f64>)> {
    let normal: Matrix3<f64> = samples.iter().map(|(_, axes)| axes.tr_mul(axes)).sum();
    let right: Vector3<f64> = samples.iter().map(|(off, axes)| axes.tr_mul(off)).sum();
    let inverse = normal.try_inverse()?;
    let offset = inverse * right;
    let squares = |point: Vector3<f64>| {
        let left = samples.iter().map(|(off, axes)| off - axes * point);
        left.map(|own| own.norm_squared()).sum::<f64>()
    };
    let (before, after) = (squares(Vector3::zeros()), squares(offset));
    let count = 3.0 * samples.len() as f64;
    // Twice the gain of the log-likelihood of noise of unknown size.
    let gain = count * (before / after).ln();
    let is_clear = before > NEAR_NOISE * NEAR_NOISE * after && gain > SIGNIFICANT * SIGNIFICANT;
    let error = (inverse.diagonal() * (after / count)).map(f64::sqrt);
    is_clear.then_some((offset, error))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Rotation3;

    #[test]
    fn a_point_that_turns_with_the_body_is_found_and_a_drift_is_none() {
        let flight = |point: Vector3<f64>, drift: f64| {
            let each = (0..100).map(|k| {
                let time = 0.01 * f64::from(k);
                let error = |k: f64| 0.002 * (1e3 * (time + k)).sin();
                let noise = Vector3::new(error(1.0), error(2.0), error(3.0));
                let axes = Rotation3::from_euler_angles(0.3, 0.1 * time, 40.0 * time).into_inner();
                let off = axes * point + Vector3::new(0.1, drift * time, 0.2) + noise;
                (time, (off, axes))
            });
            without_drift(each.collect())
        };
        let (point, error) = offset(&flight(Vector3::new(0.03, -0.01, 0.0), 0.5)).unwrap();
        assert!(
            (point.x - 0.03).abs() < 5.0 * error.x && error.x < 0.001,
            "{point} {error}"
        );
        assert!((point.y + 0.01).abs() < 5.0 * error.y, "{point} {error}");
        assert_eq!(offset(&flight(Vector3::zeros(), 0.5)), None);
    }

    #[test]
    fn coordinates_have_the_digits_of_their_errors_and_unknown_ones_are_left_out() {
        let point = Vector3::new(0.03, -0.01, 0.5);
        let error = Vector3::new(0.0004, 0.0005, 0.5);
        let told = coordinates((point, error));
        assert_eq!(told, "x = 30.00 ± 0.40 mm, y = −10.00 ± 0.50 mm");
    }
}
