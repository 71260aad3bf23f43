//! When a touch begins: the first sample that free motion up to there does not predict.

use super::motion::{Character, Comparison, Point, SIDES, range_before};

/// Number of points before and after the interval of the comparison among which the touch is sought: a hard touch shows in
/// the comparison at the first interval whose points after it reach it.
const SOUGHT: (usize, usize) = (7, SIDES.1 + 2);
/// Least number of points before these.
const LEAST_BEFORE: usize = 8;
/// Squared innovation of position and axis, in units of the variance, at which a sample speaks neither for free motion
/// nor against it: three times what is expected.
const NEUTRAL: f64 = 18.0;
/// That innovation in units of the gain of the comparison: small errors of the prediction are no strong touch.
const NEUTRAL_PART: f64 = 0.02;
/// Greatest innovation that counts, in units of the neutral one: a single outlier is no touch.
const MOST: f64 = 2.4;

/// Number of the first sample after a touch that a comparison shows.
pub fn onset(points: &[Point], comparison: &Comparison, character: &Character) -> Option<usize> {
    let index = first_point(points, comparison, character)?;
    let (last, next) = (
        points.get(index.checked_sub(1)?)?.sample,
        points.get(index)?.sample,
    );
    match next - last {
        1 => Some(next),
        _ => in_gap(points, index, character).or(Some((last + 1 + next).div_ceil(2))),
    }
}

/// Index of the first point that does not continue free motion.
fn first_point(points: &[Point], found: &Comparison, character: &Character) -> Option<usize> {
    let base = found.index.saturating_sub(SOUGHT.0).max(LEAST_BEFORE);
    let base = base.min(found.index);
    let about = points.get(base)?.time;
    let mut kept = character.without_outliers(points, range_before(points, base), about)?;
    let neutral = NEUTRAL.max(NEUTRAL_PART * (found.gains[0] + found.gains[1]));
    let (mut sum, mut best) = (0.0, (0.0, base));
    let last = (found.index + SOUGHT.1).min(points.len() - 1);
    for (index, point) in points.iter().enumerate().take(last + 1).skip(base) {
        let previous = *kept.last()?;
        let (position, axis) = character.free(&kept, about)?;
        let rows = |point: &Point| {
            (
                character.position_row(point, about),
                character.axis_row(point, about),
            )
        };
        let ((from, axis_from), (to, axis_to)) = (rows(previous), rows(point));
        let [of_position, of_axis] = character.noise.map(|noise| noise * noise);
        let innovation = position.innovation(&from, &to) / of_position
            + axis.innovation(&axis_from, &axis_to) / of_axis;
        let most = MOST * neutral;
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

/// The first sample after a touch between points `index − 1` and `index`, where no samples show all markers: the time at
/// which the motions before and after meet.
fn in_gap(points: &[Point], index: usize, character: &Character) -> Option<usize> {
    let (last, next) = (&points[index - 1], &points[index]);
    let samples = last.sample + 1..=next.sample;
    let misfits = samples.filter_map(|sample| {
        let part = (sample - last.sample) as f64 - 0.5;
        let part = part / (next.sample - last.sample) as f64;
        let time = last.time + part * (next.time - last.time);
        let compared = character.compare(points, index, Some(time))?;
        Some((compared.remaining, sample))
    });
    let best = misfits.min_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, sample)| sample)
}
