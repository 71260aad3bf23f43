//! Regressions of free motion, and of motion that is disturbed in an interval, in windows of a flight.

use std::ops::Range;

use nalgebra::Vector3;

use super::designs::Designs;
use super::motion::{Character, Comparison, Point, SCALE};
use super::regression::{Design, Extended, Extension, Regression, Residuals};

/// Maximum numbers of points that are used before and after an interval between two successive points that is tested
/// for a ground contact.
pub const SIDES: (usize, usize) = (20, 8);
/// Maximum numbers of samples, with or without a pose, that the points used before and after an interval tested for a
/// ground contact may span.
const SPANS: (usize, usize) = (26, 16);
/// Minimum numbers of points that are required before and after an interval tested for a ground contact.
const MIN_SIDES: (usize, usize) = (8, 4);
/// Maximum number of points around an interval tested for a ground contact that are excluded as outliers.
const MAX_OUTLIERS: usize = 2;
/// Threshold above which a point is an outlier. It applies to the decrease of the sum of squared residuals if the point
/// is removed: that of the position plus that of the direction of the body axis, each divided by its noise variance.
const OUTLIER: f64 = 40.0;

/// Motion without a ground contact that is fitted to the poses in some samples (points).
#[derive(Debug)]
pub struct FreeMotion {
    /// Regression of the position of the body's origin on functions of time.
    pub position: Regression<7>,
    /// Regression of the direction of the most steady body axis on functions of time.
    pub axis: Regression<6>,
    /// Whitened residuals of the position, m, and of the direction of the body axis.
    residuals: [Residuals; 2],
    /// Decreases of the sums of squared residuals if a single point is removed: one vector for the position and one for
    /// the axis direction, each with one entry per point.
    removals: [Vec<f64>; 2],
}

/// Factorised regression matrices (designs) with which motion is fitted to one range of samples: one for the positions
/// of the body, and one for the directions of its most steady axis.
#[derive(Debug)]
struct MotionDesigns {
    position: Design<7>,
    axis: Design<6>,
    /// Additional basis functions by which a ground contact changes the position and the axis direction; `None` if the
    /// samples do not determine their coefficients.
    disturbance: Option<(Extension<7, 2>, Extension<6, 3>)>,
}

impl MotionDesigns {
    /// Factorises the regression matrices for the times of `points`, for motion that a ground contact may change at the
    /// time `about`, s; `None` if the points do not determine motion without a contact.
    fn new(of: &Character, points: &[&Point], about: f64) -> Option<Self> {
        let rows = points.iter().map(|point| of.free_rows(point, about));
        let (positions, axes): (Vec<_>, Vec<_>) = rows.unzip();
        let position = Design::new(&positions, &of.position_precisions(), of.correlation)?;
        let axis = Design::new(&axes, &of.axis_precisions(), of.correlation)?;
        let functions = points.iter().map(|point| of.disturbance(point, about));
        let (positions, axes): (Vec<_>, Vec<_>) = functions.unzip();
        Some(Self {
            disturbance: position.extended(&positions).zip(axis.extended(&axes)),
            position,
            axis,
        })
    }
}

/// Least-squares fits of free motion, and of motion with a velocity jump, to ranges of points of one flight. Ranges
/// with equally spaced times share one factorised regression matrix.
#[derive(Debug)]
pub struct MotionFits {
    /// Wobble rate and noise of the flight that the regressions assume.
    pub character: Character,
    designs: Designs<MotionDesigns>,
}

impl MotionFits {
    /// Creates the fits for a given wobble rate and noise, with an empty store of factorised regression matrices.
    pub fn new(character: Character) -> Self {
        Self {
            character,
            designs: Designs::new(),
        }
    }

    /// Factorised regression matrices for the times of `points`, with times relative to `about`, s; `None` if the
    /// points do not determine motion without a ground contact.
    fn designs(&mut self, points: &[&Point], about: f64) -> Option<&MotionDesigns> {
        let of = &self.character;
        self.designs.of(points.iter().copied(), about, || {
            MotionDesigns::new(of, points, about)
        })
    }

    /// Fits motion without a ground contact to `points`, separately to their positions and to the directions of their
    /// body axes. Times are relative to `about`, s. `None` if the points do not determine the motion.
    pub fn free(&mut self, points: &[&Point], about: f64) -> Option<FreeMotion> {
        let MotionDesigns { position, axis, .. } = self.designs(points, about)?;
        let positions = position.whiten(points.iter().map(|point| point.position));
        let axes = axis.whiten(points.iter().map(|point| point.axis));
        let (of_position, positions) = position.solve(&positions);
        let (of_axis, axes) = axis.solve(&axes);
        Some(FreeMotion {
            position: of_position,
            axis: of_axis,
            removals: [
                position.removals(&positions).collect(),
                axis.removals(&axes).collect(),
            ],
            residuals: [positions, axes],
        })
    }

    /// Fits motion whose velocity and wobble change at the time `about`, s, to the points to which the motion `free`
    /// was fitted, separately to their positions and to the directions of their body axes. `None` if the points do not
    /// determine the motion.
    fn disturbed(
        &mut self,
        points: &[&Point],
        free: &FreeMotion,
        about: f64,
    ) -> Option<(Extended<7, 2>, Extended<6, 3>)> {
        let (position, axis) = self.designs(points, about)?.disturbance.as_ref()?;
        Some((
            position.solve(&free.position, &free.residuals[0]),
            axis.solve(&free.axis, &free.residuals[1]),
        ))
    }

    /// Removes up to `MAX_OUTLIERS` outliers from the points in the index range `range`. An outlier is a point without
    /// which free motion fits the rest far better; a ground contact affects all later points, so that the removal of
    /// one point does not help. Returns the remaining points and the free motion through them; `None` if the points do
    /// not determine free motion.
    fn robust<'p>(
        &mut self,
        points: &'p [Point],
        range: Range<usize>,
        about: f64,
    ) -> Option<(Vec<&'p Point>, FreeMotion)> {
        let mut kept: Vec<&Point> = points.get(range)?.iter().collect();
        let mut free = self.free(&kept, about)?;
        for _ in 0..MAX_OUTLIERS {
            let noise = self.character.noise.map(|noise| noise * noise);
            let [position, axis] = &free.removals;
            let of = |index: usize| position[index] / noise[0] + axis[index] / noise[1];
            let worst = (0..kept.len()).max_by(|&a, &b| of(a).total_cmp(&of(b)))?;
            if of(worst) <= OUTLIER || kept.len() <= MIN_SIDES.0 {
                break;
            }
            kept.remove(worst);
            free = self.free(&kept, about)?;
        }
        Some((kept, free))
    }

    /// Returns the points in the index range `range` without the outliers, which deviate from the motion without a
    /// ground contact that is fitted to the points. `None` if the points do not determine this motion.
    pub fn without_outliers<'p>(
        &mut self,
        points: &'p [Point],
        range: Range<usize>,
        about: f64,
    ) -> Option<Vec<&'p Point>> {
        Some(self.robust(points, range, about)?.0)
    }

    /// Tests the interval before point `index` for a ground contact: compares free motion with motion whose velocity
    /// and wobble change at the time `at`, s; for `None`, in the middle of the interval. Returns `None` if there are
    /// too few points, or if they do not determine the motion.
    pub fn compare(
        &mut self,
        points: &[Point],
        index: usize,
        at: Option<f64>,
    ) -> Option<Comparison> {
        let first = points.get(index)?;
        let last = points.get(index.checked_sub(1)?)?;
        let about = at.unwrap_or(0.5 * (last.time + first.time));
        let range = range_before(points, index).start..range_after(points, index).end;
        let (kept, free) = self.robust(points, range, about)?;
        let before = kept
            .iter()
            .filter(|point| point.sample < first.sample)
            .count();
        if before < MIN_SIDES.0 || kept.len() - before < MIN_SIDES.1 {
            return None;
        }
        let (position, axis) = self.disturbed(&kept, &free, about)?;
        let variances = [position.variance, axis.variance];
        let noise = self.character.noise.map(|noise| noise * noise);
        let unit = self.character.units(variances);
        let velocity = position.coefficients.row(1).transpose();
        let jump = position.further.row(0).transpose();
        Some(Comparison {
            index,
            gains: [position.gain / unit[0], axis.gain / unit[1]],
            variances,
            remaining: position.squares / noise[0] + axis.squares / noise[1],
            velocity: Vector3::from(velocity) / SCALE,
            jump: Vector3::from(jump) / SCALE,
        })
    }
}

/// Index range of the points to which the motion before point `index` is fitted: at most the `SIDES.0` preceding
/// points.
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
