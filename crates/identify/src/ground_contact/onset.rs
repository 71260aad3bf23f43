//! Finds the first sample after a contact: the first one that free motion up to it does not predict.

use super::motion::{Comparison, Point};
use super::motion_fits::{MotionFits, SIDES, range_before};

/// Numbers of points before and after the interval in which a ground contact was detected, among which the first point
/// after the contact is searched. The test of an interval uses up to `SIDES.1` points after it. A hard contact among
/// these points may therefore be detected in an interval that precedes the contact.
const SOUGHT: (usize, usize) = (7, SIDES.1 + 2);
/// Minimum number of points to which free motion is fitted. They precede the points among which the first point after a
/// ground contact is searched.
const MIN_BEFORE: usize = 8;
/// Neutral squared innovation: three times the expected squared innovation in free motion. A point with a greater
/// squared innovation is evidence of a ground contact; one with a smaller value is evidence of free motion. The squared
/// innovations of position and axis are each divided by their noise variance and added.
const NEUTRAL: f64 = 18.0;
/// Minimum of the neutral squared innovation, above which a point is evidence of a ground contact, as a fraction of the
/// sum of the gains (decreases of the sum of squares) by which the contact was detected. The minimum is high for a
/// strong contact, so that small prediction errors before the contact are not mistaken for it.
const NEUTRAL_PART: f64 = 0.02;
/// Maximum squared innovation that is counted for a sample, so that a single outlier is not mistaken for a ground
/// contact. It is in units of the neutral squared innovation, above which a sample is evidence of a contact.
const MAX_RELATIVE_INNOVATION: f64 = 2.4;

/// Index of the first sample after the ground contact that was detected by `comparison`, the test of one interval;
/// `None` if the points do not determine this sample.
pub fn onset(points: &[Point], comparison: &Comparison, fits: &mut MotionFits) -> Option<usize> {
    let index = first_point(points, comparison, fits)?;
    let (last, next) = (
        points.get(index.checked_sub(1)?)?.sample,
        points.get(index)?.sample,
    );
    match next - last {
        1 => Some(next),
        _ => in_gap(points, index, fits).or(Some((last + 1 + next).div_ceil(2))),
    }
}

/// Index of the first point after the ground contact that the test `found` detected. It is the first point near this
/// contact that free motion, fitted to the preceding points, does not predict. `None` if the points do not determine
/// the free motion.
fn first_point(points: &[Point], found: &Comparison, fits: &mut MotionFits) -> Option<usize> {
    let character = fits.character;
    let base = found.index.saturating_sub(SOUGHT.0).max(MIN_BEFORE);
    let base = base.min(found.index);
    let about = points.get(base)?.time;
    let mut kept = fits.without_outliers(points, range_before(points, base), about)?;
    let neutral = NEUTRAL.max(NEUTRAL_PART * (found.gains[0] + found.gains[1]));
    let (mut sum, mut best) = (0.0, (0.0, base));
    let last = (found.index + SOUGHT.1).min(points.len() - 1);
    for (index, point) in points.iter().enumerate().take(last + 1).skip(base) {
        let previous = *kept.last()?;
        let free = fits.free(&kept, about)?;
        let (from, axis_from) = character.free_rows(previous, about);
        let (to, axis_to) = character.free_rows(point, about);
        let [of_position, of_axis] = character.noise.map(|noise| noise * noise);
        let innovation = free.position.innovation(&from, &to) / of_position
            + free.axis.innovation(&axis_from, &axis_to) / of_axis;
        let most = MAX_RELATIVE_INNOVATION * neutral;
        if innovation < most {
            kept.push(point);
        }
        sum += innovation.min(most) - neutral;
        if sum < best.0 {
            best = (sum, index + 1);
        }
    }
    Some(best.1.min(points.len() - 1))
}

/// Finds the first sample after a ground contact between points `index − 1` and `index`, if the samples between these
/// points have no pose. For each sample in this range, motion that changes just before the sample is fitted to the
/// points; the sample with the smallest residuals is returned. `None` if no fit is possible.
fn in_gap(points: &[Point], index: usize, fits: &mut MotionFits) -> Option<usize> {
    let (last, next) = (&points[index - 1], &points[index]);
    let samples = last.sample + 1..=next.sample;
    let misfits = samples.filter_map(|sample| {
        let part = (sample - last.sample) as f64 - 0.5;
        let part = part / (next.sample - last.sample) as f64;
        let time = last.time + part * (next.time - last.time);
        let compared = fits.compare(points, index, Some(time))?;
        Some((compared.remaining, sample))
    });
    let best = misfits.min_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, sample)| sample)
}
