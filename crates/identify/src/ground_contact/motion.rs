//! Free motion over some samples, and free motion that is disturbed between two of them.
//!
//! The position is a polynomial of time with small terms at the rate of the wobble, as lift varies with it. The axis drifts
//! and wobbles. A touch changes the velocity and the drift, and begins another wobble.

use std::ops::Range;

use nalgebra::{SVector, Vector3};

use super::regression::{Regression, Row};

/// Greatest number of points before and after an interval.
pub const SIDES: (usize, usize) = (20, 8);
/// Greatest number of samples that these points span on either side, where some samples show no pose.
const SPANS: (usize, usize) = (26, 16);
/// Least number of points before and after an interval.
const LEAST_SIDES: (usize, usize) = (8, 4);
/// Time that scales the powers of the polynomials, s.
const SCALE: f64 = 0.1;
/// Standard deviation of the fourth derivative of the position, m/s⁴: lift of several g that fades in half a second.
const SNAP: f64 = 300.0;
/// Standard deviation of the position's terms at the rate of the wobble, m.
const WOBBLE: f64 = 0.002;
/// Standard deviation of the axis's third power of time over the scale.
const BEND: f64 = 0.02;
/// Greatest number of points that are left out as outliers.
const MOST_OUTLIERS: usize = 2;
/// Squared residuals of an outlier, in units of the variance.
const OUTLIER: f64 = 40.0;
/// Part of the variance that remains with a touch which the variance of the test is at least: it guards against outliers.
const LOCAL_PART: f64 = 0.25;

/// Position of the body's origin and direction of its steadiest axis in one sample.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Sample number.
    pub sample: usize,
    /// Time, s.
    pub time: f64,
    /// Position, m.
    pub position: Vector3<f64>,
    /// Unit vector along the axis, inertial components.
    pub axis: Vector3<f64>,
}

/// What holds throughout a flight.
#[derive(Clone, Copy, Debug)]
pub struct Character {
    /// Rate of the wobble, rad/s.
    pub rate: f64,
    /// Correlation of the noise of neighbouring samples.
    pub correlation: f64,
    /// Standard deviation of the noise of a position's component, m, and of one of the axis.
    pub noise: [f64; 2],
}

/// Free motion compared with motion that is disturbed at an interval.
#[derive(Clone, Copy, Debug)]
pub struct Comparison {
    /// First point after the interval.
    pub index: usize,
    /// Decrease of the squared residuals of position and axis by a disturbance, in units of the variance of the noise.
    pub gains: [f64; 2],
    /// Variance of position, m², and axis about the disturbed motion.
    pub variances: [f64; 2],
    /// Squared residuals of the disturbed motion, in units of the variance of the noise.
    pub remaining: f64,
    /// Velocity before the interval and its jump, m/s.
    pub velocity: Vector3<f64>,
    pub jump: Vector3<f64>,
}

impl Character {
    fn precision(&self, part: usize, deviation: f64) -> f64 {
        (self.noise[part] / deviation).powi(2)
    }

    /// Free motion of positions about a time.
    pub fn position_row(&self, point: &Point, about: f64) -> Row<7> {
        let u = (point.time - about) / SCALE;
        let (sine, cosine) = (self.rate * (point.time - about)).sin_cos();
        let functions = [1.0, u, u * u, u.powi(3), u.powi(4), cosine, sine];
        Row {
            sample: point.sample,
            functions: functions.into(),
            value: point.position,
        }
    }

    /// Free motion of the axis about a time.
    pub fn axis_row(&self, point: &Point, about: f64) -> Row<6> {
        let u = (point.time - about) / SCALE;
        let (sine, cosine) = (self.rate * (point.time - about)).sin_cos();
        Row {
            sample: point.sample,
            functions: [1.0, u, u * u, u.powi(3), cosine, sine].into(),
            value: point.axis,
        }
    }

    /// Regressions of free motion through points.
    pub fn free(&self, points: &[&Point], about: f64) -> Option<(Regression<7>, Regression<6>)> {
        let positions: Vec<_> = points.iter().map(|p| self.position_row(p, about)).collect();
        let axes: Vec<_> = points.iter().map(|p| self.axis_row(p, about)).collect();
        Some((
            Regression::solve(&positions, &self.position_precisions(), self.correlation)?,
            Regression::solve(&axes, &self.axis_precisions(), self.correlation)?,
        ))
    }

    fn position_precisions(&self) -> [f64; 7] {
        let snap = self.precision(0, SNAP * SCALE.powi(4) / 24.0);
        let wobble = self.precision(0, WOBBLE);
        [0.0, 0.0, 0.0, 0.0, snap, wobble, wobble]
    }

    fn axis_precisions(&self) -> [f64; 6] {
        [0.0, 0.0, 0.0, self.precision(1, BEND), 0.0, 0.0]
    }

    /// Units of the gains of position, m², and axis, of motion with these variances.
    fn units(&self, variances: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|part| self.noise[part].powi(2).max(LOCAL_PART * variances[part]))
    }

    /// Gains that a comparison with another noise would have with this one, if it were the same otherwise.
    pub fn gains(&self, of: &Comparison, other: &Character) -> [f64; 2] {
        let (here, there) = (self.units(of.variances), other.units(of.variances));
        [0, 1].map(|part| of.gains[part] * there[part] / here[part])
    }

    /// Regressions of motion that is disturbed at the time about which it is.
    fn disturbed(&self, points: &[&Point], about: f64) -> Option<(Regression<9>, Regression<9>)> {
        let since = |point: &Point| (point.time - about).max(0.0);
        let position = |point: &&Point| {
            let row = self.position_row(point, about);
            let u = since(point) / SCALE;
            extended(&row, [u, u * u])
        };
        let axis = |point: &&Point| {
            let row = self.axis_row(point, about);
            let (sine, cosine) = (self.rate * since(point)).sin_cos();
            extended(&row, [since(point) / SCALE, sine, 1.0 - cosine])
        };
        let positions: Vec<_> = points.iter().map(position).collect();
        let axes: Vec<_> = points.iter().map(axis).collect();
        let mut of_position = [0.0; 9];
        of_position[..7].copy_from_slice(&self.position_precisions());
        let mut of_axis = [0.0; 9];
        of_axis[..6].copy_from_slice(&self.axis_precisions());
        Some((
            Regression::solve(&positions, &of_position, self.correlation)?,
            Regression::solve(&axes, &of_axis, self.correlation)?,
        ))
    }

    /// Removes the points without which free motion fits far better, which an outlier is and a touch is not; returns the others
    /// and the regressions of free motion through them. None if they do not determine these.
    fn robust<'p>(
        &self,
        points: &'p [Point],
        range: Range<usize>,
        about: f64,
    ) -> Option<(Vec<&'p Point>, (Regression<7>, Regression<6>))> {
        let mut kept: Vec<&Point> = points.get(range)?.iter().collect();
        let mut free = self.free(&kept, about)?;
        for _ in 0..MOST_OUTLIERS {
            let of = |index: usize| {
                free.0.removable[index] / self.noise[0].powi(2)
                    + free.1.removable[index] / self.noise[1].powi(2)
            };
            let worst = (0..kept.len()).max_by(|&a, &b| of(a).total_cmp(&of(b)))?;
            if of(worst) <= OUTLIER || kept.len() <= LEAST_SIDES.0 {
                break;
            }
            kept.remove(worst);
            free = self.free(&kept, about)?;
        }
        Some((kept, free))
    }

    /// Points without outliers of free motion about a time; none if they do not determine it.
    pub fn without_outliers<'p>(
        &self,
        points: &'p [Point],
        range: Range<usize>,
        about: f64,
    ) -> Option<Vec<&'p Point>> {
        Some(self.robust(points, range, about)?.0)
    }

    /// Compares free motion with motion that is disturbed before point `index`, at a time, s, or in the middle of the
    /// interval. None where there are too few points.
    pub fn compare(&self, points: &[Point], index: usize, at: Option<f64>) -> Option<Comparison> {
        let first = points.get(index)?;
        let last = points.get(index.checked_sub(1)?)?;
        let about = at.unwrap_or(0.5 * (last.time + first.time));
        let range = range_before(points, index).start..range_after(points, index).end;
        let (kept, free) = self.robust(points, range, about)?;
        let before = kept
            .iter()
            .filter(|point| point.sample < first.sample)
            .count();
        if before < LEAST_SIDES.0 || kept.len() - before < LEAST_SIDES.1 {
            return None;
        }
        let disturbed = self.disturbed(&kept, about)?;
        let variances = [disturbed.0.variance(), disturbed.1.variance()];
        let noise = self.noise.map(|noise| noise * noise);
        let unit = self.units(variances);
        let slope =
            |row: usize| Vector3::from(disturbed.0.coefficients.row(row).transpose()) / SCALE;
        Some(Comparison {
            index,
            gains: [
                (free.0.squares - disturbed.0.squares) / unit[0],
                (free.1.squares - disturbed.1.squares) / unit[1],
            ],
            variances,
            remaining: disturbed.0.squares / noise[0] + disturbed.1.squares / noise[1],
            velocity: slope(1),
            jump: slope(7),
        })
    }
}

/// The points before point `index` that show the motion there.
pub fn range_before(points: &[Point], index: usize) -> Range<usize> {
    let end = index.min(points.len());
    let from = end.saturating_sub(SIDES.0);
    let last = points[..end].last().map_or(0, |point| point.sample);
    let far = points[from..end].iter();
    let far = far.take_while(|point| point.sample + SPANS.0 <= last);
    from + far.count()..end
}

/// The points from point `index` on that show the motion there.
fn range_after(points: &[Point], index: usize) -> Range<usize> {
    let end = (index + SIDES.1).min(points.len());
    let after = points.get(index..end).unwrap_or_default();
    let first = after.first().map_or(0, |point| point.sample);
    let near = after.iter();
    let near = near.take_while(|point| point.sample < first + SPANS.1);
    index..index + near.count()
}

/// A row with further functions.
fn extended<const N: usize, const K: usize, const M: usize>(
    row: &Row<N>,
    further: [f64; K],
) -> Row<M> {
    let mut functions = SVector::<f64, M>::zeros();
    for (place, value) in functions
        .iter_mut()
        .zip(row.functions.iter().chain(&further))
    {
        *place = *value;
    }
    Row {
        sample: row.sample,
        functions,
        value: row.value,
    }
}
