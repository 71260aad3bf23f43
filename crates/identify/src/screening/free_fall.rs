//! Faults that the acceleration of free fall reveals: a z axis that does not point up, and times or lengths in
//! another unit. All flights together are compared with gravity; a single flight is compared with the loads fitted to
//! all flights.

use flight::parallel;
use model_spec::model::{ExprKind, FrameKind, Model};
use model_spec::unit::Unit;
use nalgebra::{Matrix3, Vector3};

use super::distances::{UNITS, unit};
use super::loads::{Regression, Row, regress, rows};
use super::track::Track;
use crate::data_fault::{DataFault, FaultKind};
use crate::problem::FitProblem;
use dataset::statistics::{median, median_of, median_vector};
use dataset::{Dataset, Flight, KnownValue};

/// Minimum deviation of the fitted constant acceleration from gravity at which a fault of all flights is reported, in
/// units of gravity. [`MIN_SIGNIFICANCE`] and [`MIN_RATIO`] must be reached too.
const MIN_DEVIATION: f64 = 0.5;
/// Minimum deviation of the fitted constant acceleration from gravity at which a fault of all flights is reported, in
/// units of the standard error of the deviation.
const MIN_SIGNIFICANCE: f64 = 8.0;
/// Minimum improvement by fitting the constant acceleration at which a fault of all flights is reported. The
/// improvement is the ratio of two median residual accelerations: with the constant fixed at gravity, and with the
/// constant fitted.
const MIN_RATIO: f64 = 1.7;
/// Minimum cosine of the angle between a measured acceleration and gravity at which the acceleration counts as directed
/// downwards: cos 30°.
const ALONG: f64 = 0.866;
/// Range of the ratio of the fitted constant acceleration to gravity in which no wrong unit or time is reported:
/// aerodynamic loads that the regression does not include may explain such a ratio. For comparison, times that are
/// wrong by a factor of 2 give a ratio of 4 or 1/4.
const USUAL_FACTORS: std::ops::Range<f64> = 0.38..2.6;
/// Minimum misfit of a single flight at which corrections of its data are tried: the larger of the first number times
/// gravity and the second number times the median misfit of all flights.
const SINGLE_MISFIT: (f64, f64) = (0.25, 4.0);
/// Limits of the misfit of a single flight after a correction of its data. The correction is accepted if the misfit is
/// less than the first number times the misfit before the correction. It must also be less than the second number times
/// the median misfit of all flights, or less than the third number times gravity.
const MENDED_MISFIT: (f64, f64, f64) = (0.3, 2.5, 0.15);
/// Maximum misfit of a single flight after any accepted correction, in units of gravity. It rejects a correction that
/// merely shrinks all lengths: the accelerations then tend to 0 and the misfit to gravity.
const MAX_MENDED: f64 = 0.4;
/// Minimum magnitude of the vertical component of the unit normal of the markers' plane at which it is clear which side
/// of the body is up.
const UPRIGHT: f64 = 0.3;
/// Limit for reporting a flight as mirrored, which is considered if its body appears upside down: maximum ratio of the
/// misfit of the mirror image of the flight to that of the recorded flight.
const TURNED_MISFIT: f64 = 0.7;
/// Maximum ratio of the median residual acceleration to the median standard error of the measured accelerations at
/// which noise alone explains the residuals. No fault of all flights is then reported.
const NOISE: f64 = 2.5;
/// Weight, in the misfit of a flight, of the scatter of its accelerations about their median; the deviation of the
/// median from gravity has the weight 1.
const SCATTER_PART: f64 = 0.25;
/// Minimum number of flights in the dataset at which the accelerations of each flight are compared with those of all
/// flights.
const MIN_FLIGHTS: usize = 4;

/// For each axis of the recorded coordinates that may point up: its name, such as `-z`; the recorded axes that must be
/// written as x, y and z so that z points up, such as `x, -y, -z`; and the matrix that converts recorded coordinates to
/// these.
fn orientations() -> [(&'static str, &'static str, Matrix3<f64>); 6] {
    let rows =
        |a: [f64; 3], b: [f64; 3], c: [f64; 3]| Matrix3::from_rows(&[a.into(), b.into(), c.into()]);
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let minus = |axis: [f64; 3]| axis.map(|value: f64| -value);
    [
        ("+z", "x, y, z", rows(x, y, z)),
        ("-z", "x, -y, -z", rows(x, minus(y), minus(z))),
        ("+y", "z, x, y", rows(z, x, y)),
        ("-y", "x, z, -y", rows(x, z, minus(y))),
        ("+x", "y, z, x", rows(y, z, x)),
        ("-x", "z, y, -x", rows(z, y, minus(x))),
    ]
}

/// Whether the loads of the model may be those of one body with constant coefficients, as the regression assumes: they
/// depend on the time in no other way, and no other body pulls.
fn has_steady_loads(model: &Model) -> bool {
    let mut has_time = false;
    for root in model.expressions() {
        root.walk(&mut |e| has_time |= matches!(e.kind, ExprKind::Time));
    }
    let lengths = model
        .states
        .iter()
        .filter(|state| state.unit == Unit::METRE);
    !has_time && lengths.count() <= 3
}

/// Flights of a dataset whose measured accelerations are compared with gravity and with each other, to find wrong
/// units, times and axes.
pub struct FreeFall<'a> {
    problem: &'a FitProblem,
    dataset: &'a Dataset,
    gravity: Vector3<f64>,
    /// Measured accelerations and regressors of the aerodynamic loads in the time windows of each flight; empty for a
    /// flight whose path is not available.
    rows: Vec<Vec<Row>>,
    /// Median, over the samples of each flight, of the vertical component of the unit normal of the markers' plane;
    /// `None` for a point mass or if the path is not available.
    upright: Vec<Option<f64>>,
}

impl<'a> FreeFall<'a> {
    /// Computes the regression data of each flight from the path of its body in `tracks`, which is `None` for a flight
    /// in which an earlier check found a fault. Uses `threads` threads.
    pub fn new(
        (problem, dataset): (&'a FitProblem, &'a Dataset),
        gravity: Vector3<f64>,
        tracks: &[Option<Track>],
        threads: usize,
    ) -> Self {
        let each = parallel::each_on(threads, tracks.len(), |index| match &tracks[index] {
            Some(track) => (
                rows(track, omega(problem, &dataset.flights[index])),
                upright(problem, track),
            ),
            None => (Vec::new(), None),
        });
        let (rows, upright) = each.into_iter().unzip();
        Self {
            problem,
            dataset,
            gravity,
            rows,
            upright,
        }
    }

    /// Faults of units, times or axes that the accelerations reveal: the same fault for every flight if the flights
    /// have it in common, otherwise faults of single flights. Empty if the accelerations agree with gravity.
    pub fn check(&self) -> Vec<DataFault> {
        let all: Vec<&Row> = self.rows.iter().flatten().collect();
        if all.is_empty() || !has_steady_loads(&self.problem.model) {
            return Vec::new();
        }
        let Some(fixed) = regress(&all, Some(self.gravity)) else {
            return Vec::new();
        };
        // If the noise of the windows explains the remaining accelerations, gravity is not questioned.
        let error = median_of(all.iter().map(|row| row.motion.error));
        let is_noise = error.is_some_and(|error| fixed.remaining < NOISE * error);
        if !is_noise
            && let Some(free) = regress(&all, None)
            && let Some((fault, detail, correction)) = self.common_fault(&fixed, &free)
        {
            let flights = self.dataset.flights.iter().zip(&self.rows);
            let seen = flights.filter(|(_, rows)| !rows.is_empty());
            let fault =
                |flight: &Flight| DataFault::new(flight, fault, detail.clone(), correction.clone());
            return seen.map(|(flight, _)| fault(flight)).collect();
        }
        self.single_faults(&fixed)
    }

    /// Fault that all flights have in common: kind, description and instruction for correcting it. `None` if the fitted
    /// constant acceleration is not clear evidence of a fault. In the regression `fixed` the constant acceleration is
    /// fixed at gravity, in `free` it is fitted.
    fn common_fault(
        &self,
        fixed: &Regression,
        free: &Regression,
    ) -> Option<(FaultKind, String, String)> {
        let g = self.gravity.norm();
        let deviation = free.gravity - self.gravity;
        let size = deviation.norm();
        let error = (deviation / size)
            .dot(&(free.covariance * deviation / size))
            .sqrt();
        let is_clear = size > MIN_DEVIATION * g && size > MIN_SIGNIFICANCE * error;
        if !is_clear || fixed.remaining < MIN_RATIO * free.remaining {
            return None;
        }
        let ratio = free.gravity.norm() / g;
        let cosine = free.gravity.dot(&self.gravity) / (g * g * ratio);
        if cosine > ALONG {
            if USUAL_FACTORS.contains(&ratio) {
                return None;
            }
            return Some(self.scale(ratio, free));
        }
        let up = orientations().into_iter().find(|(_, _, to_up)| {
            let turned = to_up * free.gravity;
            turned.dot(&self.gravity) > ALONG * g * turned.norm()
        });
        match up {
            Some((axis, change, _)) => Some((
                FaultKind::Axes,
                format!(
                    "in all flights free fall is along the axes as if {axis} pointed up, not +z"
                ),
                axes_mend(change),
            )),
            // In a direction between the axes, a strong constant load may be the reason.
            None if cosine > 0.5 => None,
            None => {
                let unit = free.gravity / free.gravity.norm();
                Some((
                    FaultKind::Axes,
                    format!(
                        "in all flights free fall is along ({:.2}, {:.2}, {:.2}) of the table's axes, not along -z",
                        unit.x, unit.y, unit.z
                    ),
                    "turn the coordinates so that z points up".into(),
                ))
            }
        }
    }

    /// Fault of the unit of length or of the times, if the fitted constant acceleration is directed downwards but is
    /// `ratio` times gravity: kind, description and instruction for correcting it. `free` is the regression in which
    /// the constant acceleration is fitted.
    fn scale(&self, ratio: f64, free: &Regression) -> (FaultKind, String, String) {
        let detail = format!("in all flights free fall is {ratio:.3} times as fast as gravity");
        let length = unit(ratio).or_else(|| {
            let mut near = UNITS[..4].iter().copied();
            near.find(|(length, _)| (ratio * length).ln().abs() < 0.2)
        });
        if let (Some((length, name)), false) = (length, self.template_gives_lengths())
            && self.drag_suggests_lengths(ratio, free) != Some(false)
        {
            return (
                FaultKind::Units,
                format!("{detail}, as if positions were in {name}"),
                format!("multiply the positions by {length}"),
            );
        }
        let (told, correction) = time_words(ratio);
        (FaultKind::TimeUnit, format!("{detail}{told}"), correction)
    }

    /// Whether it is already known that lengths are in metres: with more than one marker, an earlier check has compared
    /// the distances between the markers with the declared ones.
    fn template_gives_lengths(&self) -> bool {
        self.dataset.markers.len() > 1
    }

    /// Whether a wrong unit of length explains an acceleration of `ratio` times gravity better than wrong times do.
    /// This follows from the fitted drag coefficient (1/m), which depends on the unit of length but not on that of
    /// time. `free` is the regression with a fitted constant acceleration. `None` if the drag of the model is unknown,
    /// or if the drag of the model or the fitted drag is not positive.
    fn drag_suggests_lengths(&self, ratio: f64, free: &Regression) -> Option<bool> {
        let expected = super::gravity::drag(self.problem)?;
        let found = -*free.coefficients.first()?;
        (expected > 0.0 && found > 0.0).then(|| {
            let by_length = (found * ratio / expected).ln().abs();
            let by_time = (found / expected).ln().abs();
            by_length < by_time
        })
    }

    /// Data faults of single flights. `fixed` is the regression of the accelerations of all flights on aerodynamic
    /// loads, with the constant acceleration fixed at gravity. A flight is faulty if its accelerations, minus these
    /// loads, deviate from gravity, and a correction of units, times or axes removes the deviation.
    fn single_faults(&self, fixed: &Regression) -> Vec<DataFault> {
        let g = self.gravity.norm();
        let misfit = |rows: &[Row]| self.misfit(fixed, rows);
        let misfits: Vec<Option<f64>> = self.rows.iter().map(|rows| misfit(rows)).collect();
        let mut known: Vec<f64> = misfits.iter().flatten().copied().collect();
        if known.len() < MIN_FLIGHTS {
            return Vec::new();
        }
        let usual = median(&mut known);
        let limit = (SINGLE_MISFIT.0 * g).max(SINGLE_MISFIT.1 * usual);
        let mut faults = Vec::new();
        for (index, flight) in self.dataset.flights.iter().enumerate() {
            let Some(before) = misfits[index] else {
                continue;
            };
            if before <= limit {
                faults.extend(self.turned_over(fixed, index, before));
                continue;
            }
            let most = (MENDED_MISFIT.1 * usual).max(MENDED_MISFIT.2 * g);
            let enough = (MENDED_MISFIT.0 * before).min(most).min(MAX_MENDED * g);
            let mended = self.correctable_fault(fixed, flight, &self.rows[index], enough);
            faults.extend(mended.or_else(|| self.turned_over(fixed, index, before)));
        }
        faults
    }

    /// Data fault of the flight with the index `index`, if the body is upside down in this flight alone and the flight
    /// appears mirrored. Upside down: the normal of the plane of its markers points up and that of all other flights
    /// down, or vice versa. Mirrored: the misfit (deviation of the accelerations from gravity) of its mirror image is
    /// clearly smaller than `before`, m/s², the misfit of the recorded flight. `fixed` is the regression over all
    /// flights with the constant acceleration fixed at gravity; its aerodynamic loads are subtracted for the misfit.
    fn turned_over(&self, fixed: &Regression, index: usize, before: f64) -> Option<DataFault> {
        let own = self.upright[index]?;
        let others = self
            .upright
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index);
        let mut others = others.filter_map(|(_, upright)| *upright);
        if own.abs() < UPRIGHT || !others.all(|other| other * own < 0.0 && other.abs() > UPRIGHT) {
            return None;
        }
        let flight = &self.dataset.flights[index];
        let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
        let track = transformed_track(self.problem, flight, &mirror);
        let rows = rows(&track, omega(self.problem, flight));
        let after = self.misfit(fixed, &rows)?;
        (after < TURNED_MISFIT * before).then(|| DataFault::new(flight, FaultKind::Mirrored, "unlike in the other flights, the markers show the body turned over, and it flies as its mirror image: the axes seem left-handed, or labels are exchanged", super::mirror::MEND))
    }

    /// Misfit of a flight, m/s²: how much its accelerations in the time windows `rows`, after subtraction of the
    /// aerodynamic loads fitted to all flights, deviate from gravity. It is the deviation of the median over the
    /// windows plus [`SCATTER_PART`] times the median distance of the accelerations from this median; `None` without
    /// windows. The loads are those of the regression `fixed`, in which the constant acceleration is fixed at gravity.
    fn misfit(&self, fixed: &Regression, rows: &[Row]) -> Option<f64> {
        let rest = rows.iter().map(|row| fixed.without_loads(row));
        misfit(&rest.collect::<Vec<_>>(), self.gravity)
    }

    /// Data fault of a flight for which a correction of its units, times or axes reduces the misfit below `enough`,
    /// m/s²; `None` if no correction does.
    fn correctable_fault(
        &self,
        fixed: &Regression,
        flight: &Flight,
        rows: &[Row],
        enough: f64,
    ) -> Option<DataFault> {
        let fault = |fault, detail: String, correction: &str| {
            DataFault::new(flight, fault, detail, correction)
        };
        let as_others = "unlike in the other flights,";
        // Velocities and accelerations both scale with the unit of time such that the coefficients of the loads are
        // unchanged.
        let rest: Vec<Vector3<f64>> = rows.iter().map(|row| fixed.without_loads(row)).collect();
        let constant = median_vector(&rest)?;
        let ratio = constant.norm() / self.gravity.norm();
        let is_down = constant.dot(&self.gravity) > ALONG * ratio * self.gravity.norm_squared();
        let scaled: Vec<Vector3<f64>> = rest.iter().map(|rest| rest / ratio).collect();
        let of_time = misfit(&scaled, self.gravity).unwrap_or(f64::INFINITY);
        let omega = omega(self.problem, flight);
        let after = |matrix: &Matrix3<f64>| {
            let track = transformed_track(self.problem, flight, matrix);
            self.misfit(fixed, &super::loads::rows(&track, omega))
        };
        let fits = |matrix: &Matrix3<f64>| after(matrix).is_some_and(|misfit| misfit < enough);
        if let Some((misfit, length, name)) =
            self.length(&after).filter(|(misfit, ..)| *misfit < enough)
            && misfit < of_time
        {
            return Some(fault(
                FaultKind::Units,
                format!("{as_others} its positions seem to be in {name}"),
                &format!("multiply the positions in {} by {length}", flight.file),
            ));
        }
        if is_down && !(0.75..1.33).contains(&ratio) && of_time < enough {
            let (told, correction) = time_words(ratio);
            let detail =
                format!("{as_others} free fall is {ratio:.3} times as fast as gravity{told}");
            return Some(fault(FaultKind::TimeUnit, detail, &correction));
        }
        let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
        for (axis, change, to_up) in orientations().into_iter().skip(1) {
            if fits(&to_up) {
                let detail =
                    format!("{as_others} free fall is along the axes as if {axis} pointed up");
                return Some(fault(FaultKind::Axes, detail, &axes_mend(change)));
            }
        }
        for (axis, _, to_up) in orientations() {
            if fits(&(mirror * to_up)) {
                let up = match axis {
                    "+z" => String::new(),
                    _ => format!(", with {axis} up"),
                };
                let detail = format!(
                    "{as_others} it fits as a mirror image only: its axes seem left-handed{up}"
                );
                return Some(fault(FaultKind::Mirrored, detail, super::mirror::MEND));
            }
        }
        None
    }

    /// Most probable wrong unit of length of a flight: (misfit, m/s²; length of the unit, m; name). Of all units other
    /// than the metre, it is the one whose correction gives the smallest misfit. The function `misfit` returns the
    /// misfit after multiplication of the positions by a matrix. `None` if the distances between markers have already
    /// shown that lengths are in metres.
    fn length(
        &self,
        misfit: &impl Fn(&Matrix3<f64>) -> Option<f64>,
    ) -> Option<(f64, f64, &'static str)> {
        if self.template_gives_lengths() {
            return None;
        }
        let units = UNITS.iter().filter_map(|&(length, name)| {
            let misfit = misfit(&(Matrix3::identity() * length))?;
            Some((misfit, length, name))
        });
        units.min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// Path of a body up to the first ground contact, computed after multiplication of all measured marker positions by
/// `matrix`.
pub fn transformed_track(problem: &FitProblem, flight: &Flight, matrix: &Matrix3<f64>) -> Track {
    let change = |point: [f64; 3]| <[f64; 3]>::from(matrix * Vector3::from(point));
    let rows: Vec<Vec<Option<[f64; 3]>>> = flight
        .positions
        .iter()
        .map(|row| row.iter().map(|point| point.map(change)).collect())
        .collect();
    Track::until_contact(problem, &flight.times, &rows).0
}

/// Median over the samples of the vertical component of the unit normal of the markers' plane; `None` for a point mass
/// or without attitudes.
pub fn upright(problem: &FitProblem, track: &Track) -> Option<f64> {
    let normal = problem
        .has_attitude
        .then(|| super::mirror::normal(&problem.markers))?;
    let each = track
        .points
        .iter()
        .filter_map(|point| Some((point.attitude? * normal).z));
    median_of(each)
}

/// Distance of the component-wise median of accelerations from gravity, plus [`SCATTER_PART`] times their median
/// distance from it, m/s²; `None` for an empty slice.
fn misfit(accelerations: &[Vector3<f64>], gravity: Vector3<f64>) -> Option<f64> {
    let middle = median_vector(accelerations)?;
    let scatter = median_of(accelerations.iter().map(|a| (a - middle).norm()))?;
    Some((middle - gravity).norm() + SCATTER_PART * scatter)
}

/// Known angular velocity, in one flight, of a body modelled as a point mass, rad/s, in inertial components: the value
/// of the first vector input that the model declares in the inertial frame with the unit of an angular velocity. `None`
/// if the model has no such input.
fn omega(problem: &FitProblem, flight: &Flight) -> Option<Vector3<f64>> {
    let inputs = problem.model.inputs.iter();
    let rates = inputs.filter(|input| {
        let is_inertial = matches!(problem.model.frames[input.frame].kind, FrameKind::Inertial);
        is_inertial && input.unit == model_spec::unit::Unit::RATE
    });
    let mut known = rates.map(|input| match flight.known.get(&input.name) {
        Some(KnownValue::Vector(value)) => Vector3::from(*value),
        _ => Vector3::from(input.value),
    });
    known.next()
}

/// Two texts for a fault report on wrong times, from the ratio of the fitted acceleration to gravity: the probable
/// mistake, and the instruction for correcting it.
fn time_words(ratio: f64) -> (String, String) {
    let factor = ratio.sqrt();
    for (divisor, unit) in [(1e3, "milliseconds"), (1e6, "microseconds")] {
        if (factor * divisor).ln().abs() < 0.2 {
            return (
                format!(", as if times were in {unit}"),
                format!("divide the times by {divisor}"),
            );
        }
    }
    (
        format!(", as if the true times were {factor:.3} times those of the table"),
        format!("check the frame rate, or multiply the times by {factor:.3}"),
    )
}

fn axes_mend(change: &str) -> String {
    format!("write ({change}) for (x, y, z), so that z points up")
}
