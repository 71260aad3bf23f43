//! Time of the first contact of a flight, detected with a fitted model. From the contact on, the samples deviate from
//! the fitted free flight as after a jump of the velocity and angular velocity, without an immediate displacement of
//! the markers.
//!
//! Free flights whose initial states are near that of the fit depend linearly on the difference of the initial states.
//! Motion after a contact is another free flight that meets the one before it: at the time of contact, the difference
//! between both flights displaces no marker. This condition holds for any model, independent of its states. A
//! generalised likelihood ratio compares free flight with a flight that jumps, for each sample.

mod jump;
mod rows;
#[cfg(test)]
mod tests;
mod trajectory;

use std::ops::Range;

use nalgebra::{DVector, Vector3};

use self::jump::{Jump, JumpTests};
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
/// Maximum number of samples from a velocity jump to the last sample with which it is tested. A jump that so many
/// samples do not show is not one of the velocity.
const MAX_SAMPLES_AFTER: usize = 16;
/// Number of further samples that must support a velocity jump for it to count as a contact.
const CONFIRMING_SAMPLES: usize = 2;
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
/// Part of the decrease of the sum of squares by a velocity jump above which a single marker position that deviates
/// from free motion by this amount is an outlier instead.
const OUTLIER_PART: f64 = 0.5;
/// Maximum number of marker positions that are excluded as outliers.
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
    let tried_end = tried.end.min(observations.times.len());
    let seen = tried.start.saturating_sub(FREE_SAMPLES)..tried.end;
    (first < tried_end).then_some((seen, first..tried_end))
}

/// Finds the first contact with the ground or an object within the range `tried` of samples, as a deviation from free
/// flights near `predicted`, which [`predicted`] has computed for a range that contains this one. `None` if no contact
/// is found.
pub fn contact_time(
    observations: &Observations,
    predicted: &Trajectory,
    noise: &NoiseModel,
    tried: Range<usize>,
) -> Option<Onset> {
    let sought = tried.start;
    let (seen, tried) = searched(observations, &tried)?;
    let trajectory = predicted.part(seen, tried.start);
    let mut observations = observations.clone();
    for _ in 0..=MAX_OUTLIERS {
        let rows = rows::whitened(&observations, trajectory, noise);
        let tests = JumpTests::new(trajectory, &rows, noise);
        if !may_jump(&tests, tried.clone()) {
            return None;
        }
        let is_seen = |sample: &usize| !rows[sample - trajectory.first].is_empty();
        let (jump, end) = first_jump(&tests, tried.clone(), is_seen)?;
        let later = (end..tried.end).filter(is_seen).take(CONFIRMING_SAMPLES);
        let until = later.last()? + 1;
        let confirmed = best_jump(&tests, tried.start, until)?;
        let free = tests.free_motion(until)?;
        let points = (trajectory.first..until).zip(&rows);
        let points =
            points.flat_map(|(sample, points)| points.iter().map(move |point| (sample, point)));
        let squares = points.map(|(sample, point)| (point.square(&free), sample, point.marker));
        let (square, sample, marker) = squares.max_by(|a, b| a.0.total_cmp(&b.0))?;
        if square > OUTLIER_PART * confirmed.gain {
            observations.outlier[sample * observations.channels + marker] = true;
            continue;
        }
        // A deviation that grows earlier was part of the fit: it is the misfit of a wrong model.
        let is_sought = jump.sample + MAX_LEAD >= sought;
        return is_sought.then(|| Onset {
            sample: jump.sample,
            jump: jump_of_velocity(trajectory, &observations, &jump),
        });
    }
    None
}

/// Whether a velocity jump at any of the samples `tried`, each tested once with all samples that may show it, explains
/// as much as a contact. Most flights without a contact need no further test.
fn may_jump(tests: &JumpTests<'_>, tried: Range<usize>) -> bool {
    tried.clone().any(|sample| {
        let end = tried.end.min(sample + MAX_SAMPLES_AFTER);
        let jump = tests.jump(sample, end);
        jump.is_some_and(|jump| jump.gain > MIN_GAIN)
    })
}

/// First velocity jump at the samples `tried` that the samples up to one of them show, and the end of these samples;
/// `None` if there is none. `is_seen` returns whether any marker is measured in the sample with a given index.
fn first_jump(
    tests: &JumpTests<'_>,
    tried: Range<usize>,
    is_seen: impl Fn(&usize) -> bool,
) -> Option<(Jump, usize)> {
    let mut greatest: Vec<f64> = Vec::with_capacity(tried.len());
    for last in tried.clone() {
        let found = is_seen(&last)
            .then(|| best_jump(tests, tried.start, last + 1))
            .flatten();
        let gain = found.as_ref().map_or(0.0, |found| found.gain);
        if let Some(found) = found {
            let before = found.sample.checked_sub(tried.start + 1);
            let usual = before.map_or(0.0, |index| greatest[index]);
            if gain > MIN_GAIN.max(MIN_GROWTH * usual) {
                return Some((found, last + 1));
            }
        }
        greatest.push(gain.max(greatest.last().copied().unwrap_or(0.0)));
    }
    None
}

/// Earliest of the velocity jumps, just before the samples from `first` on, that decrease the sum of squares over the
/// samples before `end` most, or by almost as much.
fn best_jump(tests: &JumpTests<'_>, first: usize, end: usize) -> Option<Jump> {
    let from = first.max(end.saturating_sub(MAX_SAMPLES_AFTER));
    let jumps: Vec<Jump> = (from..end)
        .filter_map(|sample| tests.jump(sample, end))
        .collect();
    let most = jumps.iter().map(|jump| jump.gain).fold(0.0, f64::max);
    let mut jumps = jumps.into_iter();
    jumps.find(|jump| jump.gain >= most - UNDECIDED_GAIN)
}

/// Jump of the mean velocity of the markers, m/s, computed from the change of the initial state.
fn jump_of_velocity(
    trajectory: Part<'_>,
    observations: &Observations,
    jump: &Jump,
) -> Vector3<f64> {
    let (first, last) = (jump.sample - 1, jump.sample);
    let moved = |sample: usize| Vector3::from((trajectory.centre(sample) * &jump.change).column(0));
    (moved(last) - moved(first)) / (observations.times[last] - observations.times[first])
}
