//! Time of the first contact of a flight, detected with a fitted model. From the contact on, the samples deviate from
//! the fitted free flight as after a jump of the velocity and angular velocity, without an immediate displacement of
//! the markers.
//!
//! Free flights whose initial states are near that of the fit depend linearly on the difference of the initial states.
//! Motion after a contact is another free flight that meets the one before it: at the time of contact, the difference
//! between both flights displaces no marker. This condition holds for any model, independent of its states. A
//! generalised likelihood ratio compares free flight with a flight that jumps, for each sample.

mod jump;
mod outliers;
mod rows;
#[cfg(test)]
mod tests;
mod trajectory;

use std::ops::Range;

use nalgebra::{DVector, Vector3};

use self::jump::{Jump, free_motion, jumps};
use self::outliers::{leave_out_before, leave_out_displaced};
use self::trajectory::Trajectory;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// Number of samples, just before the first sample at which a velocity jump is tried, to which motion without a contact
/// is fitted.
const FREE_SAMPLES: usize = 24;
/// Number of samples at which velocity jumps are tried in addition, just before the range that is searched for a
/// contact with the ground or an object. The decreases of the sum of squares by these jumps show which values are
/// typical of free flight.
const REFERENCE_SAMPLES: usize = 8;
/// Maximum number of samples by which a detected contact with the ground or an object may precede the range searched
/// for it. An earlier deviation is attributed to an inaccurate model, not to a contact.
const MAX_LEAD: usize = 2;
/// Minimum decrease of the whitened sum of squares by a velocity jump for the jump to count as a contact with the
/// ground or an object. Noise exceeds it at one sample in 10⁹.
const MIN_GAIN: f64 = 60.0;
/// Minimum ratio, for a velocity jump to count as a contact with the ground or an object, of the decrease of the sum of
/// squares by this jump to the largest decrease by a jump at an earlier sample. Deviations due to a wrong model grow
/// smoothly and stay below this ratio.
const MIN_GROWTH: f64 = 4.0;
/// Requirements for later samples to confirm a contact with the ground or an object: number of additional samples with
/// which the velocity jump is tested again, and factor by which they must increase the gain of the jump (decrease of
/// the sum of squares) if the gain increased abruptly before (see `OUTLIER_GAIN`). Otherwise, any increase suffices.
/// Additional samples do not increase a gain that an outlier causes.
const CONFIRMING: (usize, f64) = (2, 1.2);
/// Maximum increase of the gain (decrease of the sum of squares by a velocity jump) due to one additional sample. If
/// the increase is greater, that sample is considered to contain an outlier, unless the following samples confirm a
/// contact with the ground or an object (see `CONFIRMING`).
const OUTLIER_GAIN: f64 = 26.0;
/// Maximum number of marker positions before the first tried velocity jump that are excluded as outliers. Also the
/// maximum number of passes of the search for a contact with the ground or an object; a pass that finds an outlier
/// instead of a contact excludes it.
const MAX_OUTLIERS: usize = 12;

/// A contact of the body with the ground or another object, found as a velocity jump.
#[derive(Clone, Debug, PartialEq)]
pub struct Onset {
    /// Index of the first sample after the contact with the ground or the object.
    pub sample: usize,
    /// Jump of the mean velocity of the markers at the contact, m/s.
    pub jump: Vector3<f64>,
}

/// Finds the first contact with the ground or an object within the range `sought` of samples, as a deviation from free
/// flights near the one from `unknowns`, the global parameters and the initial state, which should be near the fit of
/// the samples before the range. `None` if no contact is found. All channels of `problem` must be markers.
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
        let rows = rows::whitened(&observations, trajectory, noise);
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

/// First deviation from free motion at the samples `tried`: a velocity jump or an outlier; `None` if there is none.
/// `tests` contains the jumps that are tested with the samples up to each of them. `is_seen` returns whether any marker
/// is measured in the sample with a given index.
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
        if is_confirmed && found.gain > MIN_GAIN.max(MIN_GROWTH * usual) {
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
