//! When a flight first touches something, by a fitted model: from that time on its samples leave the fitted free flight as
//! after a jump of the velocity and the angular velocity, and of nothing that the markers show at once.
//!
//! Free flights whose initial state differs a little from that of the fit are linear in that difference. Motion after a
//! contact is another free flight, which meets the one before it: at the time of contact the difference between both
//! displaces no marker. That holds for any model, whatever its states are. A generalised likelihood ratio compares free
//! flight with a flight that jumps, sample by sample.

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
use self::trajectory::Trajectory;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// Number of samples before those at which contacts are tried that show the free flight.
const BEFORE: usize = 24;
/// Number of samples before those at which a contact is sought that show the usual decrease by a jump.
const USUAL: usize = 8;
/// Greatest number of samples by which a contact may come before those at which it is sought.
const LATE: usize = 2;
/// Least decrease of the whitened sum of squares by a jump that is a contact. Noise exceeds it at one sample in 10⁹.
const MIN_GAIN: f64 = 60.0;
/// Least ratio of this decrease to the greatest one before the contact: departures by a wrong model grow smoothly.
const MIN_GROWTH: f64 = 4.0;
/// Decrease by which a contact may explain less than the likeliest, χ² of one degree of freedom at 90 %, to be taken if it is
/// earlier: a sample too many is worse than one too few.
const UNDECIDED: f64 = 2.71;
/// Number of further samples that confirm a contact, and least ratio by which they increase the decrease: an outlier ends.
const CONFIRMING: (usize, f64) = (2, 1.2);
/// Least increase of the decrease by one sample that is an outlier, if it is not confirmed.
const OUTLIER: f64 = 26.0;
/// Greatest number of points that are left out as outliers.
const MOST_OUTLIERS: usize = 12;

/// A contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Onset {
    /// Number of the first sample after it.
    pub sample: usize,
    /// Jump of the markers' mean velocity, m/s.
    pub jump: Vector3<f64>,
}

/// The first contact before one of the samples `tried`, by the flight that a fit predicts; `None` without one, and where the
/// trajectory cannot be computed.
pub fn contact_time(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    noise: &NoiseModel,
    tried: Range<usize>,
) -> Option<Onset> {
    let sought = tried.start;
    let tried = sought.saturating_sub(USUAL).max(1)..tried.end.min(observations.times.len());
    if tried.is_empty() {
        return None;
    }
    let seen = tried.start.saturating_sub(BEFORE)..tried.end;
    let trajectory = Trajectory::new(problem, observations, unknowns, seen, tried.start).ok()?;
    let mut observations = observations.clone();
    leave_out_displaced(&mut observations, &trajectory, noise);
    leave_out_before(&mut observations, &trajectory, noise, MOST_OUTLIERS);
    for _ in 0..MOST_OUTLIERS {
        let rows = rows::whitened(&observations, &trajectory, noise);
        let jumps = Jumps::new(&trajectory, &rows, noise)?;
        let is_seen = |sample: &usize| !rows[sample - trajectory.first].is_empty();
        match departure(&jumps, tried.clone(), is_seen)? {
            Departure::Contact(sample, found) => {
                let jump = jump_of_velocity(&trajectory, &observations, sample, found);
                // What grows earlier was fitted: it is the misfit of a wrong model.
                return (sample + LATE >= sought).then_some(Onset { sample, jump });
            }
            Departure::Outlier(sample) => {
                let before = jumps.before(sample);
                let points = rows[sample - trajectory.first].iter();
                let worst = points.max_by(|a, b| a.square(before).total_cmp(&b.square(before)))?;
                observations.outlier[sample * observations.markers + worst.marker] = true;
            }
        }
    }
    None
}

/// What free motion does not explain.
enum Departure<'a> {
    /// A jump, with the first sample after it.
    Contact(usize, &'a Comparison),
    /// A single sample.
    Outlier(usize),
}

/// The first departure from free motion.
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
        let is_steady = later > found.gain && found.gain <= previous + OUTLIER;
        let is_confirmed = is_steady || later > CONFIRMING.1 * found.gain;
        let before = contact.checked_sub(tried.start + 1);
        let usual = before.map_or(0.0, |index| greatest[index]);
        if is_confirmed && found.gain > MIN_GAIN.max(MIN_GROWTH * usual) {
            let (contact, found) = jumps.earliest(last, found.gain - UNDECIDED)?;
            return Some(Departure::Contact(contact, found));
        }
        if !is_confirmed && found.gain > previous + OUTLIER {
            return Some(Departure::Outlier(last));
        }
        previous = found.gain;
        greatest.push(found.gain.max(greatest.last().copied().unwrap_or(0.0)));
    }
    None
}

/// Jump of the markers' mean velocity, m/s.
fn jump_of_velocity(
    trajectory: &Trajectory,
    observations: &Observations,
    sample: usize,
    found: &Comparison,
) -> Vector3<f64> {
    let (first, last) = (sample - 1, sample);
    let moved =
        |sample: usize| Vector3::from((trajectory.centre(sample) * &found.change).column(0));
    (moved(last) - moved(first)) / (observations.times[last] - observations.times[first])
}
