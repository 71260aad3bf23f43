//! Time of the first contact of a flight, by a generalised likelihood ratio: free flight against a flight whose
//! velocities jump at a sample, without an immediate displacement of the markers.
//!
//! Free flights near that of the fit depend linearly on their initial states. Motion after a contact is another free
//! flight, which meets the one before it. This holds for any model, independent of its states.

mod jump;
#[cfg(test)]
mod tests;
mod trajectory;

use std::ops::Range;

use nalgebra::{DVector, Vector3};

use self::jump::{Jump, free_motion, jumps};
use self::trajectory::Trajectory;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::pose::distance;

/// Number of samples before the first tried jump, to which motion without a contact is fitted.
const FREE_SAMPLES: usize = 24;
/// Number of samples before the searched range at which jumps are tried, too: their gains are those of free flight.
const REFERENCE_SAMPLES: usize = 8;
/// Maximum number of samples by which a contact precedes the searched range; what is earlier is due to the model.
const MAX_LEAD: usize = 2;
/// Minimum gain of a jump, the decrease of the whitened sum of squares, and its ratio to the largest gain of an earlier
/// jump: noise exceeds it at one sample in 10⁹, and deviations due to the model grow smoothly.
const GAIN: (f64, f64) = (60.0, 4.0);

/// Number of later samples that confirm a jump, and the ratio by which they increase its gain if this rose abruptly
/// (see `OUTLIER_GAIN`). Samples after an outlier do not increase its gain.
const CONFIRMING: (usize, f64) = (2, 1.2);
/// Whitened square of a marker position above which it is an outlier, and increase of the gain by one sample, unless
/// later samples confirm a contact; noise exceeds it with probability 10⁻⁵.
const OUTLIER_GAIN: f64 = 26.0;
/// Maximum number of outliers that are left out, before the tried samples and among them.
const MAX_OUTLIERS: usize = 12;
/// Maximum error of the distance of two markers, in units of the noise of a coordinate.
const DISTANCE: f64 = 6.0;

/// A contact of the body with the ground or another object, found as a velocity jump.
#[derive(Clone, Debug, PartialEq)]
pub struct Onset {
    pub sample: usize,
    /// Jump of the mean velocity of the markers at the contact, m/s.
    pub jump: Vector3<f64>,
}

/// Finds the first contact within the range `sought` of samples, as a deviation from free flights near the one from
/// `unknowns`, which should be near the fit of the samples before the range. All channels must be markers.
pub fn contact_time(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    noise: &NoiseModel,
    sought: Range<usize>,
) -> Option<Onset> {
    let first = sought.start.saturating_sub(REFERENCE_SAMPLES).max(1);
    let tried = first..sought.end.min(observations.times.len());
    let seen = sought.start.saturating_sub(FREE_SAMPLES)..tried.end;
    if tried.is_empty() {
        return None;
    }
    let trajectory = &Trajectory::new(problem, observations, unknowns, seen).ok()?;
    let mut observations = observations.clone();
    leave_out_displaced(&mut observations, trajectory, noise);
    leave_out_before(&mut observations, trajectory, noise, tried.start);
    for _ in 0..MAX_OUTLIERS {
        let rows = trajectory::whitened(&observations, trajectory, noise);
        let tests = jumps(trajectory, tried.start, &rows, noise)?;
        let is_seen = |sample: &usize| !rows[sample - trajectory.first].is_empty();
        match departure(&tests, tried.clone(), is_seen)? {
            Departure::Contact(found) => {
                // A deviation that grows earlier was part of the fit: it is the misfit of a wrong model.
                return (found.contact + MAX_LEAD >= sought.start).then(|| Onset {
                    sample: found.contact,
                    jump: jump_of_velocity(trajectory, &observations, found),
                });
            }
            Departure::Outlier(sample) => {
                let (before, after) = rows.split_at(sample - trajectory.first);
                let before = free_motion(before.iter().flatten(), trajectory.dimension)?;
                let points = after[0].iter();
                let worst =
                    points.max_by(|a, b| a.square(&before).total_cmp(&b.square(&before)))?;
                observations.outlier[sample * observations.channels + worst.marker] = true;
            }
        }
    }
    None
}

/// A deviation of the samples from free motion (motion without contact).
enum Departure<'a> {
    /// A velocity jump.
    Contact(&'a Jump),
    /// An outlier in a single sample; contains the index of the sample.
    Outlier(usize),
}

/// First velocity jump or outlier at the samples `tried`. `tests` contains the jumps that are tested with the samples
/// up to each of them; `is_seen` returns whether any marker is measured in a sample.
fn departure(
    tests: &[Vec<Jump>],
    tried: Range<usize>,
    is_seen: impl Fn(&usize) -> bool,
) -> Option<Departure<'_>> {
    let best = |last: usize| {
        let jumps = tests[last - tried.start].iter();
        jumps.max_by(|a, b| a.gain.total_cmp(&b.gain))
    };
    let mut greatest: Vec<f64> = Vec::with_capacity(tried.len());
    let mut previous = 0.0;
    for last in tried.clone() {
        let found = best(last)?;
        let further = (last + 1..tried.end).filter(&is_seen).take(CONFIRMING.0);
        let later = best(further.last()?)?.gain;
        let is_steady = later > found.gain && found.gain <= previous + OUTLIER_GAIN;
        let is_confirmed = is_steady || later > CONFIRMING.1 * found.gain;
        let before = found.contact.checked_sub(tried.start + 1);
        let usual = before.map_or(0.0, |index| greatest[index]);
        if is_confirmed && found.gain > GAIN.0.max(GAIN.1 * usual) {
            return Some(Departure::Contact(found));
        }
        if !is_confirmed && found.gain > previous + OUTLIER_GAIN {
            return Some(Departure::Outlier(last));
        }
        previous = found.gain;
        greatest.push(found.gain.max(greatest.last().copied().unwrap_or(0.0)));
    }
    None
}

/// Jump of the mean velocity of the markers, m/s, computed from the change of the initial state in `found`.
fn jump_of_velocity(
    trajectory: &Trajectory,
    observations: &Observations,
    found: &Jump,
) -> Vector3<f64> {
    let (first, last) = (found.contact - 1, found.contact);
    let moved =
        |sample: usize| Vector3::from((trajectory.centre(sample) * &found.change).column(0));
    (moved(last) - moved(first)) / (observations.times[last] - observations.times[first])
}

/// Marks the marker positions whose distances from most other markers in the sample differ from the predicted ones.
fn leave_out_displaced(
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

/// Marks at most `MAX_OUTLIERS` marker positions that are far from free motion, the farthest first, among the samples
/// before `tried`.
fn leave_out_before(
    observations: &mut Observations,
    trajectory: &Trajectory,
    noise: &NoiseModel,
    tried: usize,
) {
    for _ in 0..MAX_OUTLIERS {
        let rows = trajectory::whitened(observations, trajectory, noise);
        let before = &rows[..tried - trajectory.first];
        let Some(change) = free_motion(before.iter().flatten(), trajectory.dimension) else {
            return;
        };
        let each = (trajectory.first..).zip(before);
        let each =
            each.flat_map(|(sample, points)| points.iter().map(move |point| (sample, point)));
        let squares = each.map(|(sample, point)| (point.square(&change), sample, point.marker));
        match squares.max_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((square, sample, marker)) if square > OUTLIER_GAIN => {
                observations.outlier[sample * observations.channels + marker] = true;
            }
            _ => return,
        }
    }
}
