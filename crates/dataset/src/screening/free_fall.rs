//! Faults that free fall reveals: a z axis that does not point up, times or lengths in another unit. All flights
//! together are compared with gravity, a single one with the loads fitted to all.

use flight::parallel;
use model_spec::model::{Expr, ExprKind, FrameKind, Model};
use model_spec::unit::Unit;
use nalgebra::{Matrix3, Vector3};

use super::Body;
use super::distances::{UNITS, confused, correction, unit};
use super::loads::{Regression, Row, regress, rows};
use super::mirror::{MEND, UPRIGHT, reflection, upright};
use super::track::{Conversion, Track};
use crate::fault::{DataFault, FaultKind};
use crate::levels::{CLEARLY_SMALLER, MIN_POPULATION};
use crate::statistics::{median, median_of, median_vector};
use crate::{Dataset, Flight, KnownValue};

/// Minimum deviation of the fitted constant acceleration from gravity: in units of gravity, in standard errors, and as
/// the ratio of the median residual acceleration with gravity to that with the fitted constant.
const CLEAR: (f64, f64, f64) = (0.5, 8.0, 1.7);

/// Minimum cosine of the angle to gravity of an acceleration that points down: 30°.
const ALONG: f64 = 0.866;
/// Ratios to gravity that loads outside the regression may explain; times wrong by a factor of 2 give 4 or 1/4.
const USUAL_FACTORS: std::ops::Range<f64> = 0.38..2.6;
/// Minimum misfit of a single faulty flight: in units of gravity, and of the median misfit.
const SINGLE_MISFIT: (f64, f64) = (0.25, 4.0);
/// Maximum misfit after a correction: in units of the misfit before it; and in units of the median misfit, or of
/// gravity.
const MENDED_MISFIT: (f64, f64, f64) = (0.3, 2.5, 0.15);
/// Maximum misfit after any correction, in units of gravity: shrinking all lengths makes it tend to gravity.
const MAX_MENDED: f64 = 0.4;
/// Maximum ratio of the residual acceleration to its standard error that noise alone explains.
const NOISE: f64 = 2.5;
/// Weight of the scatter of the accelerations in a misfit.
const SCATTER_PART: f64 = 0.25;

/// For each axis that may point up: its name, the axes to be written as x, y and z, and the matrix that does it.
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

/// Whether the loads may be those of one body with constant coefficients, as the regression assumes.
fn has_steady_loads(model: &Model) -> bool {
    let mut parts = model.expressions().into_iter().flat_map(Expr::nodes);
    let has_time = parts.any(|e| matches!(e.kind, ExprKind::Time));
    let lengths = model
        .states
        .iter()
        .filter(|state| state.unit == Unit::METRE);
    !has_time && lengths.count() <= 3
}

/// Flights whose accelerations are compared with gravity and with each other.
pub struct FreeFall<'a> {
    body: &'a dyn Body,
    dataset: &'a Dataset,
    gravity: Vector3<f64>,
    rows: Vec<Vec<Row>>,
    /// Median vertical component of the markers' normal; `None` for a point mass or without a path.
    upright: Vec<Option<f64>>,
}

impl<'a> FreeFall<'a> {
    /// Regression data of each flight by its track, which is `None` after an earlier fault.
    pub fn new(
        (body, dataset): (&'a dyn Body, &'a Dataset),
        gravity: Vector3<f64>,
        tracks: &[Option<Track>],
        threads: usize,
    ) -> Self {
        let each = parallel::each_on(threads, tracks.len(), |index| match &tracks[index] {
            Some(track) => (
                rows(track, omega(body, &dataset.flights[index])),
                upright(body, track),
            ),
            None => (Vec::new(), None),
        });
        let (rows, upright) = each.into_iter().unzip();
        Self {
            body,
            dataset,
            gravity,
            rows,
            upright,
        }
    }

    /// The fault that all flights have in common, or else those of single flights.
    pub fn check(&self) -> Vec<DataFault> {
        let all: Vec<&Row> = self.rows.iter().flatten().collect();
        if all.is_empty() || !has_steady_loads(self.body.model()) {
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

    /// Fault that all flights have in common: kind, detail and correction. The constant acceleration is gravity in
    /// `fixed` and fitted in `free`.
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
        let is_clear = size > CLEAR.0 * g && size > CLEAR.1 * error;
        if !is_clear || fixed.remaining < CLEAR.2 * free.remaining {
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

    /// Fault of lengths or times where free fall points down but is `ratio` times gravity.
    fn scale(&self, ratio: f64, free: &Regression) -> (FaultKind, String, String) {
        let detail = format!("in all flights free fall is {ratio:.3} times as fast as gravity");
        let length = unit(ratio).or_else(|| {
            let mut near = UNITS[..4].iter().copied();
            near.find(|(length, _)| (ratio * length).ln().abs() < 0.2)
        });
        let named = match (length, confused(ratio)) {
            (Some((length, name)), _) => Some((
                format!("{detail}, as if positions were in {name}"),
                correction("the positions", length),
            )),
            (None, Some((own, read))) => Some((
                format!("{detail}, as if {own} had been read as {read}"),
                format!("state that the recordings are in {own}"),
            )),
            (None, None) => None,
        };
        if let (Some((detail, correction)), false) = (named, self.template_gives_lengths())
            && self.drag_suggests_lengths(ratio, free) != Some(false)
        {
            return (FaultKind::Units, detail, correction);
        }
        let (told, correction) = time_words(ratio);
        (FaultKind::TimeUnit, format!("{detail}{told}"), correction)
    }

    /// With several markers, their distances have shown before that lengths are in metres.
    fn template_gives_lengths(&self) -> bool {
        self.dataset.markers.len() > 1
    }

    /// Whether a unit of length explains `ratio` better than times, by the fitted drag (1/m), which does not depend on
    /// the unit of time; `None` if the drags are unknown or not positive.
    fn drag_suggests_lengths(&self, ratio: f64, free: &Regression) -> Option<bool> {
        let expected = super::loads::drag(self.body)?;
        let found = -*free.coefficients.first()?;
        (expected > 0.0 && found > 0.0).then(|| {
            let by_length = (found * ratio / expected).ln().abs();
            let by_time = (found / expected).ln().abs();
            by_length < by_time
        })
    }

    /// Faults of single flights: their accelerations less the loads of `fixed` deviate from gravity, and a correction
    /// of units, times or axes removes this.
    fn single_faults(&self, fixed: &Regression) -> Vec<DataFault> {
        let g = self.gravity.norm();
        let misfit = |rows: &[Row]| self.misfit(fixed, rows);
        let misfits: Vec<Option<f64>> = self.rows.iter().map(|rows| misfit(rows)).collect();
        let mut known: Vec<f64> = misfits.iter().flatten().copied().collect();
        if known.len() < MIN_POPULATION {
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

    /// Fault of the flight `index` if its body alone is upside down and its mirror image has a clearly smaller misfit
    /// than `before`, m/s².
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
        let track = Track::converted(self.body, flight, &reflection(self.body));
        let rows = rows(&track, omega(self.body, flight));
        let after = self.misfit(fixed, &rows)?;
        (after < CLEARLY_SMALLER * before).then(|| DataFault::new(flight, FaultKind::Mirrored, "unlike in the other flights, the markers show the body turned over, and it flies as its mirror image: the axes seem left-handed, or labels are exchanged", MEND))
    }

    /// Deviation of accelerations less the loads from gravity, m/s²; `None` without windows.
    fn misfit(&self, fixed: &Regression, rows: &[Row]) -> Option<f64> {
        let rest = rows.iter().map(|row| fixed.without_loads(row));
        misfit(&rest.collect::<Vec<_>>(), self.gravity)
    }

    /// Fault of a flight for which a correction reduces the misfit below `enough`, m/s².
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
        // Velocities and accelerations scale with the unit of time such that coefficients do not change.
        let rest: Vec<Vector3<f64>> = rows.iter().map(|row| fixed.without_loads(row)).collect();
        let constant = median_vector(&rest)?;
        let ratio = constant.norm() / self.gravity.norm();
        let is_down = constant.dot(&self.gravity) > ALONG * ratio * self.gravity.norm_squared();
        let scaled: Vec<Vector3<f64>> = rest.iter().map(|rest| rest / ratio).collect();
        let of_time = misfit(&scaled, self.gravity).unwrap_or(f64::INFINITY);
        let omega = omega(self.body, flight);
        let after = |conversion: Conversion| {
            let track = Track::converted(self.body, flight, &conversion);
            self.misfit(fixed, &super::loads::rows(&track, omega))
        };
        let of_space = |space: Matrix3<f64>| Conversion {
            space,
            body: Matrix3::identity(),
        };
        let fits = |conversion: Conversion| after(conversion).is_some_and(|own| own < enough);
        if let Some((misfit, length, name)) = self
            .length(&|space| after(of_space(space)))
            .filter(|(misfit, ..)| *misfit < enough)
            && misfit < of_time
        {
            return Some(fault(
                FaultKind::Units,
                format!("{as_others} its positions seem to be in {name}"),
                &correction(&format!("the positions in {}", flight.file), length),
            ));
        }
        if is_down && !(0.75..1.33).contains(&ratio) && of_time < enough {
            let (told, correction) = time_words(ratio);
            let detail =
                format!("{as_others} free fall is {ratio:.3} times as fast as gravity{told}");
            return Some(fault(FaultKind::TimeUnit, detail, &correction));
        }
        let mirror = reflection(self.body);
        for (axis, change, to_up) in orientations().into_iter().skip(1) {
            if fits(of_space(to_up)) {
                let detail =
                    format!("{as_others} free fall is along the axes as if {axis} pointed up");
                return Some(fault(FaultKind::Axes, detail, &axes_mend(change)));
            }
        }
        for (axis, _, to_up) in orientations() {
            let mirrored = Conversion {
                space: mirror.space * to_up,
                ..mirror
            };
            if fits(mirrored) {
                let up = match axis {
                    "+z" => String::new(),
                    _ => format!(", with {axis} up"),
                };
                let detail = format!(
                    "{as_others} it fits as a mirror image only: its axes seem left-handed{up}"
                );
                return Some(fault(FaultKind::Mirrored, detail, MEND));
            }
        }
        None
    }

    /// Most probable wrong unit of length (misfit, m/s²; length, m; name), where `misfit` is that after multiplication
    /// of the positions by a matrix.
    fn length(
        &self,
        misfit: &impl Fn(Matrix3<f64>) -> Option<f64>,
    ) -> Option<(f64, f64, &'static str)> {
        if self.template_gives_lengths() {
            return None;
        }
        let units = UNITS.iter().filter_map(|&(length, name)| {
            let misfit = misfit(Matrix3::identity() * length)?;
            Some((misfit, length, name))
        });
        units.min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// Distance of the median of accelerations from gravity plus [`SCATTER_PART`] of their scatter, m/s².
fn misfit(accelerations: &[Vector3<f64>], gravity: Vector3<f64>) -> Option<f64> {
    let middle = median_vector(accelerations)?;
    let scatter = median_of(accelerations.iter().map(|a| (a - middle).norm()))?;
    Some((middle - gravity).norm() + SCATTER_PART * scatter)
}

/// Known angular velocity of a point mass, rad/s: its first inertial input in this unit.
fn omega(body: &dyn Body, flight: &Flight) -> Option<Vector3<f64>> {
    let inputs = body.model().inputs.iter();
    let rates = inputs.filter(|input| {
        let is_inertial = matches!(body.model().frames[input.frame].kind, FrameKind::Inertial);
        is_inertial && input.unit == model_spec::unit::Unit::RATE
    });
    let mut known = rates.map(|input| match flight.known.get(&input.name) {
        Some(KnownValue::Vector(value)) => Vector3::from(*value),
        _ => Vector3::from(input.value),
    });
    known.next()
}

/// Probable mistake of the times and its correction, from the ratio of the fitted acceleration to gravity.
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
