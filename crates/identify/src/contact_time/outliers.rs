//! Outlier detection: marks marker positions that agree neither with free motion nor with a contact.

use super::MAX_OUTLIERS;
use super::jump::free_motion;
use super::rows::whitened;
use super::trajectory::Trajectory;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use dataset::pose::distance;

/// Squared whitened residual of a marker position, summed over its coordinates, above which it is an outlier; noise
/// exceeds it with probability 10⁻⁵.
const LIMIT: f64 = 26.0;
/// Maximum difference between the measured and the predicted distance of two markers, in units of the noise standard
/// deviation of a coordinate. A marker with larger differences to most other markers is an outlier.
const DISTANCE: f64 = 6.0;

/// Marks as outliers the marker positions whose measured distances from most other markers in the same sample differ
/// from the predicted distances by more than `DISTANCE`.
pub fn leave_out_displaced(
    observations: &mut Observations,
    trajectory: &Trajectory,
    noise: &NoiseModel,
) {
    let limit = DISTANCE * noise.overall();
    for (sample, predicted) in (trajectory.first..).zip(&trajectory.samples) {
        let seen: Vec<(usize, [f64; 3])> = observations
            .points(sample)
            .iter()
            .enumerate()
            .filter_map(|(marker, point)| Some((marker, (*point)?)))
            .collect();
        for &(marker, point) in &seen {
            let others = seen.iter().filter(|(other, _)| *other != marker);
            let wrong = others.filter(|&&(other, at)| {
                let of_body = distance(predicted[marker].position, predicted[other].position);
                (distance(point, at) - of_body).abs() > limit
            });
            if 2 * wrong.count() > seen.len() - 1 {
                observations.outlier[sample * observations.channels + marker] = true;
            }
        }
    }
}

/// Marks as outliers at most `MAX_OUTLIERS` marker positions that are far from the fitted motion without contact, one
/// after another, each time the farthest one. Examines only samples before `tried`, the first sample before which a
/// velocity jump is tried.
pub fn leave_out_before(
    observations: &mut Observations,
    trajectory: &Trajectory,
    noise: &NoiseModel,
    tried: usize,
) {
    for _ in 0..MAX_OUTLIERS {
        let rows = whitened(observations, trajectory, noise);
        let before = &rows[..tried - trajectory.first];
        let Some(change) = free_motion(before.iter().flatten(), trajectory.dimension) else {
            return;
        };
        let each = (trajectory.first..).zip(before);
        let each =
            each.flat_map(|(sample, points)| points.iter().map(move |point| (sample, point)));
        let squares = each.map(|(sample, point)| (point.square(&change), sample, point.marker));
        match squares.max_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((square, sample, marker)) if square > LIMIT => {
                observations.outlier[sample * observations.channels + marker] = true;
            }
            _ => return,
        }
    }
}
