//! Time of the first contact of a flight, detected with a fitted model. From the contact on, the samples deviate from
//! the fitted free flight as after a jump of the velocity and angular velocity, without an immediate displacement of
//! the markers.
//!
//! Free flights whose initial states are near that of the fit depend linearly on the difference of the initial states.
//! Motion after a contact is another free flight that meets the one before it: at the time of contact, the difference
//! between both flights displaces no marker. This condition holds for any model, independent of its states. A
//! generalised likelihood ratio compares free flight with a flight that jumps, for each sample.

mod alternatives;
mod jump;
mod outliers;
mod quadratic;
mod rows;
#[cfg(test)]
mod tests;
mod trajectory;

use std::ops::Range;

use nalgebra::{DVector, Vector3};

use self::jump::{Comparison, Jumps};
use self::outliers::{leave_out_before, leave_out_displaced};
use self::trajectory::Part;
pub use self::trajectory::Trajectory;
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
/// An earlier velocity jump is preferred to the best one if its decrease of the sum of squares is smaller by at most
/// this value, the 90 % quantile of χ² with one degree of freedom. If the contact with the ground is dated too late,
/// disturbed samples remain in the data; this is worse than the loss of undisturbed samples if it is dated too early.
const UNDECIDED_GAIN: f64 = 2.71;
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

/// Predicts the flight in which contacts are searched within the range `tried` of samples, or within parts of it. The
/// flight starts from `unknowns`, the global parameters and the initial state, which should be near the fit of the
/// samples before the range. `None` if it cannot be predicted. All channels of `problem` must be markers.
pub fn predicted(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    tried: &Range<usize>,
) -> Option<Trajectory> {
    let (seen, tried) = searched(observations, tried)?;
    Trajectory::new(problem, observations, unknowns, seen, tried.start).ok()
}

/// Ranges of samples that are seen and tried in a search for a contact within the range `tried`; `None` if the flight
/// has no samples there.
fn searched(
    observations: &Observations,
    tried: &Range<usize>,
) -> Option<(Range<usize>, Range<usize>)> {
    let first = tried.start.saturating_sub(REFERENCE_SAMPLES).max(1);
    let tried = first..tried.end.min(observations.times.len());
    let seen = tried.start.saturating_sub(FREE_SAMPLES)..tried.end;
    (!tried.is_empty()).then_some((seen, tried))
}

/// Finds the first contact with the ground or an object within the range `tried` of samples, as a deviation from free
/// flights near `predicted`, which [`predicted`] has computed for a range that contains this one. `None` if no contact
/// is found. Uses `threads` threads.
pub fn contact_time(
    observations: &Observations,
    predicted: &Trajectory,
    noise: &NoiseModel,
    tried: Range<usize>,
    threads: usize,
) -> Option<Onset> {
    let sought = tried.start;
    let (seen, tried) = searched(observations, &tried)?;
    let trajectory = predicted.part(seen, tried.start);
    let mut observations = observations.clone();
    leave_out_displaced(&mut observations, trajectory, noise);
    leave_out_before(&mut observations, trajectory, noise, MAX_OUTLIERS);
    for _ in 0..MAX_OUTLIERS {
        let rows = rows::whitened(&observations, trajectory, noise);
        let jumps = Jumps::new(trajectory, &rows, noise, threads)?;
        let is_seen = |sample: &usize| !rows[sample - trajectory.first].is_empty();
        match departure(&jumps, tried.clone(), is_seen)? {
            Departure::Contact(sample, found) => {
                let jump = jump_of_velocity(trajectory, &observations, sample, found);
                // A deviation that grows earlier was part of the fit: it is the misfit of a wrong model.
                return (sample + MAX_LEAD >= sought).then_some(Onset { sample, jump });
            }
            Departure::Outlier(sample) => {
                let before = jumps.before(sample)?;
                let points = rows[sample - trajectory.first].iter();
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
    /// A velocity jump; contains the index of the first sample after the jump, and the comparison of free motion with
    /// motion that has this jump.
    Contact(usize, &'a Comparison),
    /// An outlier in a single sample; contains the index of the sample.
    Outlier(usize),
}

/// First deviation from free motion at the samples `tried`: a velocity jump or an outlier; `None` if there is none.
/// `is_seen` returns whether any marker is measured in the sample with a given index.
fn departure(
    jumps: &Jumps,
    tried: Range<usize>,
    is_seen: impl Fn(&usize) -> bool,
) -> Option<Departure<'_>> {
    let mut greatest: Vec<f64> = Vec::with_capacity(tried.len());
    let mut previous = 0.0;
    for last in tried.clone() {
        let (contact, found) = jumps.best(last)?;
        let further = (last + 1..tried.end).filter(&is_seen).take(CONFIRMING.0);
        let until = further.last()?;
        let later = jumps.best(until)?.1.gain;
        let is_steady = later > found.gain && found.gain <= previous + OUTLIER_GAIN;
        let is_confirmed = is_steady || later > CONFIRMING.1 * found.gain;
        let before = contact.checked_sub(tried.start + 1);
        let usual = before.map_or(0.0, |index| greatest[index]);
        if is_confirmed && found.gain > MIN_GAIN.max(MIN_GROWTH * usual) {
            let (contact, found) = jumps.earliest(last, found.gain - UNDECIDED_GAIN)?;
            return Some(Departure::Contact(contact, found));
        }
        if !is_confirmed && found.gain > previous + OUTLIER_GAIN {
            return Some(Departure::Outlier(last));
        }
        previous = found.gain;
        greatest.push(found.gain.max(greatest.last().copied().unwrap_or(0.0)));
    }
    None
}

/// Jump of the mean velocity of the markers just before the sample with the index `sample`, m/s, computed from the
/// change of the initial state in `found`.
fn jump_of_velocity(
    trajectory: Part<'_>,
    observations: &Observations,
    sample: usize,
    found: &Comparison,
) -> Vector3<f64> {
    let (first, last) = (sample - 1, sample);
    let moved =
        |sample: usize| Vector3::from((trajectory.centre(sample) * &found.change).column(0));
    (moved(last) - moved(first)) / (observations.times[last] - observations.times[first])
}
