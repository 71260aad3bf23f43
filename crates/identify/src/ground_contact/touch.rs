//! Detects the first contact of a body with an attitude: its path and its most steady axis deviate from free motion
//! together.
//!
//! The rim of a disc touches first. This changes the velocity only a little, but the disc starts to wobble until
//! another part of the rim hits the ground a few samples later. The axis shows the contact at once.

use super::PathPoint;
use super::halt::is_stopped;
use super::motion::{Character, Comparison};
use super::motion_fits::{MotionFits, SIDES};
use super::onset::onset;
use super::wobble::{Posed, noise_correlation, points_with_axis, wobble_rate};
use crate::path_noise::path_noise;
use dataset::statistics::{median, median_of};

/// Minimum number of points before an interval that is tested for a ground contact. With fewer points, the model of
/// free motion could follow any curve.
const MIN_BEFORE: usize = 32;
/// Minimum number of points after an interval that is tested for a ground contact; the motion after a contact is fitted
/// to them. Intervals nearer to the end of the flight are not tested.
const MIN_AFTER: usize = 4;
/// Minimum usual gains of the position and of the direction of the most steady body axis; smaller usual gains are
/// raised to these values. The gain of an interval is the decrease of the sum of squared residuals if a ground contact
/// is assumed in it. The usual gain is typical of the intervals of the flight without a contact. The minima differ
/// because a contact adds different numbers of coefficients to the position and to the axis.
const MIN_USUAL: [f64; 2] = [8.0, 12.0];
/// Minimum number of earlier intervals for the usual gain (see `MIN_USUAL`) to be the median of the gains of these
/// intervals. With fewer, the usual gain is the lower quartile over the whole flight.
const EARLIER: usize = 8;
/// Minimum gains of a ground contact, as multiples of the usual gains of intervals without a contact. The first value
/// applies to the gain of the position and to that of the direction of the most steady body axis, the second value to
/// the geometric mean of the two gains.
const MIN_GAINS: (f64, f64) = (3.5, 5.5);
/// Minimum upward velocity jump, m/s, of a ground contact that is detected from both the position and the most steady
/// body axis (see `MIN_GAINS`).
const MIN_JUMP: f64 = 0.15;
/// Minimum ratio of the upward component of a velocity jump at the ground to its magnitude; limited friction limits the
/// horizontal component.
pub(crate) const MIN_UPWARD_PART: f64 = 0.3;
/// Thresholds for a ground contact that is evident from the position alone. The first is the minimum gain (decrease of
/// the sum of squared position residuals) relative to its usual value without a contact. The others are the minimum
/// upward velocity jump, m/s, and its minimum ratio to the descent speed before it.
const MIN_OF_PATH: (f64, f64, f64) = (7.0, 0.8, 0.3);

/// Factor by which the minimum gains and velocity jumps of a ground contact are multiplied in a first, cheap pass with
/// a rough noise estimate. A flight in which no interval exceeds these lower thresholds has no contact.
const ROUGH: f64 = 0.5;

/// Spacing, in points, of the intervals that are tested for a ground contact in the first, cheap pass. Not every
/// interval need be tested, because a contact affects the tests of several neighbouring intervals.
const ROUGH_STEP: usize = 3;

/// A contact of a body with the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Index of the first sample after the contact with the ground, numbered as in `PathPoint::sample`.
    pub sample: usize,
    /// Upward component of the velocity jump at the contact with the ground, fitted to the samples before and after it,
    /// m/s.
    pub jump: f64,
}

/// Finds the first contact with the ground; `None` if the body flies freely, is caught by a hand, has no steady axis
/// (it tumbles), or has too few samples.
pub fn touch(path: &[PathPoint]) -> Option<Touch> {
    let posed = path
        .iter()
        .filter_map(|point| Some((point, point.attitude?)));
    let posed: Vec<Posed<'_>> = posed.collect();
    if posed.len() < MIN_BEFORE + MIN_AFTER {
        return None;
    }
    let points = points_with_axis(&posed)?;
    let interval = median_of(points.windows(2).map(|w| w[1].time - w[0].time))?;
    let rate = wobble_rate(&points, interval);
    let mut character = Character {
        rate,
        correlation: noise_correlation(&points),
        noise: [
            path_noise(points.iter().map(|point| (point.time, point.position))).max(1e-9),
            path_noise(points.iter().map(|point| (point.time, point.axis))).max(1e-9),
        ],
    };
    let indices = MIN_BEFORE..=points.len() - MIN_AFTER;
    let compare = |fits: &mut MotionFits, step: usize| -> Vec<Comparison> {
        let each = indices.clone().step_by(step);
        each.filter_map(|index| fits.compare(&points, index, None))
            .collect()
    };
    // A noise estimate from differences of samples does not include correlated noise.
    let rough = compare(&mut MotionFits::new(character), ROUGH_STEP);
    let noise = |part: usize| quartile(rough.iter().map(|c| c.variances[part])).sqrt();
    let first = character;
    character.noise = [noise(0).max(1e-9), noise(1).max(1e-9)];
    let gains = |of: &Comparison| character.gains(of, &first);
    if !rough.iter().any(|of| may_be_touch(of, gains(of))) {
        return None;
    }
    let mut fits = MotionFits::new(character);
    let comparisons = compare(&mut fits, 1);
    let quartiles = [0, 1].map(|part| quartile(comparisons.iter().map(|c| c.gains[part])));
    let found = comparisons.iter().enumerate().find(|(place, comparison)| {
        let usual = [0, 1].map(|part| {
            let earlier = comparisons[..*place].iter();
            let earlier = earlier.filter(|earlier| earlier.index + SIDES.1 <= comparison.index);
            let mut earlier: Vec<f64> = earlier.map(|earlier| earlier.gains[part]).collect();
            let usual = match earlier.len() < EARLIER {
                true => quartiles[part],
                false => median(&mut earlier),
            };
            usual.max(MIN_USUAL[part])
        });
        is_touch(comparison, usual) && !is_stopped(&points, comparison.index, &comparison.velocity)
    });
    let (_, comparison) = found?;
    Some(Touch {
        sample: onset(&points, comparison, &mut fits)?,
        jump: comparison.jump.z,
    })
}

/// Whether the flight may have a ground contact: `comparison`, a test in the first, cheap pass, exceeds the lower
/// thresholds (see `ROUGH`). `gains` are the decreases of the sums of squares in this test, converted to a better noise
/// estimate.
fn may_be_touch(comparison: &Comparison, gains: [f64; 2]) -> bool {
    let [position, axis] = [0, 1].map(|part| gains[part] / MIN_USUAL[part]);
    let jump = comparison.jump.z;
    let of_both = position.min(axis) > ROUGH * MIN_GAINS.0 && jump > ROUGH * MIN_JUMP;
    let of_path = position > ROUGH * MIN_OF_PATH.0 && jump > ROUGH * MIN_OF_PATH.1;
    of_both || of_path
}

fn is_touch(comparison: &Comparison, usual: [f64; 2]) -> bool {
    let [position, axis] = [0, 1].map(|part| comparison.gains[part] / usual[part]);
    let (velocity, jump) = (comparison.velocity.z, comparison.jump.z);
    let of_both = position.min(axis) > MIN_GAINS.0
        && position * axis > MIN_GAINS.1 * MIN_GAINS.1
        && jump > MIN_JUMP;
    let (gain, least_jump, part) = MIN_OF_PATH;
    let of_path = position > gain && jump > least_jump && jump > -part * velocity;
    let is_upward = jump > MIN_UPWARD_PART * comparison.jump.norm();
    velocity < 0.0 && is_upward && (of_both || of_path)
}

/// Lower quartile (25 % quantile) of the values; 0 if there are none.
fn quartile(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    let quarter = values.len() / 4;
    match values.is_empty() {
        true => 0.0,
        false => *values.select_nth_unstable_by(quarter, f64::total_cmp).1,
    }
}
