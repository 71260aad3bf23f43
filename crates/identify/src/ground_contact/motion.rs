//! Models of free motion over some samples, and of free motion that is disturbed between two of them.
//!
//! The position is a polynomial in time plus small terms at the rate of the wobble, with which lift varies. The axis
//! drifts and wobbles. A contact changes the velocity and the drift, and starts an additional wobble.

use std::ops::Range;

use nalgebra::{SVector, Vector3};

use super::regression::{Regression, Row};

/// Maximum numbers of points that are used before and after the tested interval, which is the interval between two
/// successive points in which a contact is assumed.
pub const SIDES: (usize, usize) = (20, 8);
/// Maximum numbers of samples, with or without a pose, that the points used before and after the tested interval may
/// span.
const SPANS: (usize, usize) = (26, 16);
/// Minimum numbers of points that are required before and after the tested interval.
const LEAST_SIDES: (usize, usize) = (8, 4);
/// Unit in which time is expressed in the powers of the polynomials, s.
const SCALE: f64 = 0.1;
/// Prior standard deviation of the fourth time derivative of the position, m/s⁴. The value allows for a lift of several
/// g that decays within half a second.
const SNAP: f64 = 300.0;
/// Prior standard deviation of the amplitudes of the sine and cosine terms in the position, whose frequency is the
/// wobble rate, m.
const WOBBLE: f64 = 0.002;
/// Prior standard deviation of the cubic coefficient in the polynomial of the axis direction in (time / `SCALE`).
const BEND: f64 = 0.02;
/// Maximum number of points around the tested interval that are excluded as outliers.
const MOST_OUTLIERS: usize = 2;
/// Sum of the squared residuals of a point's position and axis, each divided by its noise variance, above which the
/// point is an outlier.
const OUTLIER: f64 = 40.0;
/// Minimum variance by which gains (decreases of a sum of squares) are divided, as a fraction of the residual variance
/// of the disturbed motion. It prevents outliers, which increase that variance, from causing large gains.
const LOCAL_PART: f64 = 0.25;

/// Position of the body's origin and direction of its most steady axis in one sample.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Index of the sample.
    pub sample: usize,
    /// Time of the sample, s.
    pub time: f64,
    /// Position of the body's origin in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Unit vector along the most steady body axis, in inertial components.
    pub axis: Vector3<f64>,
}

/// Wobble rate and noise properties of one flight, which are constant throughout the flight.
#[derive(Clone, Copy, Debug)]
pub struct Character {
    /// Angular rate of the wobble of the axis, rad/s.
    pub rate: f64,
    /// Correlation of the measurement noise between successive samples.
    pub correlation: f64,
    /// Standard deviations of the noise: of a component of the position, m, and of a component of the axis.
    pub noise: [f64; 2],
}

/// Result of testing one interval between two points for a contact: comparison of free motion with motion that is
/// disturbed within the interval, so that its velocity and wobble change.
#[derive(Clone, Copy, Debug)]
pub struct Comparison {
    /// Index of the first point after the tested interval.
    pub index: usize,
    /// Decreases of the sums of squared residuals of position and axis if the disturbance is allowed. Each is divided
    /// by its noise variance, or by `LOCAL_PART` × its residual variance if that is greater.
    pub gains: [f64; 2],
    /// Residual variances of the disturbed motion: of the position, m², and of the axis.
    pub variances: [f64; 2],
    /// Sum of the squared residuals of position and axis for the disturbed motion, each in units of its noise variance.
    pub remaining: f64,
    /// Velocity just before the disturbance (`velocity`) and jump of the velocity at the disturbance (`jump`), m/s.
    pub velocity: Vector3<f64>,
    pub jump: Vector3<f64>,
}

impl Character {
    fn precision(&self, part: usize, deviation: f64) -> f64 {
        (self.noise[part] / deviation).powi(2)
    }

    /// Regression row of free motion for the position of a point, with times relative to `about`, s.
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

    /// Regression row of free motion for the axis of a point, with times relative to `about`, s.
    pub fn axis_row(&self, point: &Point, about: f64) -> Row<6> {
        let u = (point.time - about) / SCALE;
        let (sine, cosine) = (self.rate * (point.time - about)).sin_cos();
        Row {
            sample: point.sample,
            functions: [1.0, u, u * u, u.powi(3), cosine, sine].into(),
            value: point.axis,
        }
    }

    /// Fits free motion to the positions and to the axes of points, with times relative to `about`, s; `None` if the
    /// points do not determine it.
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

    /// Variances by which the gains of position, m², and axis are divided. `variances` are the residual variances of
    /// the disturbed motion.
    fn units(&self, variances: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|part| self.noise[part].powi(2).max(LOCAL_PART * variances[part]))
    }

    /// Gains (see `Comparison::gains`) of the comparison `of`, which was computed with the noise in `other`, converted
    /// to the noise in `self`.
    pub fn gains(&self, of: &Comparison, other: &Character) -> [f64; 2] {
        let (here, there) = (self.units(of.variances), other.units(of.variances));
        [0, 1].map(|part| of.gains[part] * there[part] / here[part])
    }

    /// Fits motion that is disturbed at the time `about`, s: velocity and acceleration change, and so do the drift and
    /// the wobble of the axis. Returns the regressions of the positions and of the axes; `None` if the points do not
    /// determine them.
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

    /// Removes up to `MOST_OUTLIERS` points without which free motion fits far better. An outlier is such a point; a
    /// contact affects all later points, so that the removal of one point does not help. Returns the remaining points
    /// and the regressions of free motion through them; `None` if the points do not determine free motion.
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

    /// Returns the points of `range` that remain after the outliers from free motion are removed; `None` if the points
    /// do not determine free motion.
    pub fn without_outliers<'p>(
        &self,
        points: &'p [Point],
        range: Range<usize>,
        about: f64,
    ) -> Option<Vec<&'p Point>> {
        Some(self.robust(points, range, about)?.0)
    }

    /// Tests the interval before point `index` for a contact: compares free motion with motion that is disturbed at the
    /// time `at`, s; for `None`, in the middle of the interval. Returns `None` if there are too few points.
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

/// Index range of the points to which the motion before point `index` is fitted: at most `SIDES.0` points, which
/// precede that point.
pub fn range_before(points: &[Point], index: usize) -> Range<usize> {
    let end = index.min(points.len());
    let from = end.saturating_sub(SIDES.0);
    let last = points[..end].last().map_or(0, |point| point.sample);
    let far = points[from..end].iter();
    let far = far.take_while(|point| point.sample + SPANS.0 <= last);
    from + far.count()..end
}

/// Index range of the points to which the motion from point `index` on is fitted: at most `SIDES.1` points.
fn range_after(points: &[Point], index: usize) -> Range<usize> {
    let end = (index + SIDES.1).min(points.len());
    let after = points.get(index..end).unwrap_or_default();
    let first = after.first().map_or(0, |point| point.sample);
    let near = after.iter();
    let near = near.take_while(|point| point.sample < first + SPANS.1);
    index..index + near.count()
}

/// Copy of a regression row to which the values `further` of additional basis functions are appended.
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
