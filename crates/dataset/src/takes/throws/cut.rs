//! Time of a change of motion: the time of the fitted hinge that best explains the samples on both sides.

use std::ops::Range;

use nalgebra::{DMatrix, DVector, Vector3};

use super::path::Path;
use super::track::Track;
use super::windows::half;

/// Samples outside the flight in the fit of a change at its beginning or end: their time span, s, and minimum number.
const BEYOND: (f64, usize) = (0.03, 4);
/// Number of instants per sampling interval that are tried as the time of a change of motion.
const CANDIDATES: usize = 4;
/// Samples next to a change of motion that are left out, as its time is accurate to about one sampling interval.
const MARGIN: usize = 1;
/// Exponents of the hinge terms tried for a change of motion, powers of the time from the change outwards, 0 inside the
/// flight: 1 is a jump of the velocity, 2 of the acceleration, and 3 of its derivative.
pub(super) const HINGES: [&[i32]; 4] = [&[2], &[2, 3], &[1], &[1, 2]];
/// Exponents that are tried for a touch of the ground: a jump of the velocity, alone or with one of the acceleration.
pub(super) const JUMPS: [&[i32]; 2] = [&[1], &[1, 2]];

/// Number of coefficients of the cubic in time that describes the motion in the flight on one axis.
pub(super) const CUBIC: usize = 4;

/// A change of the motion at the beginning or the end of a flight, such as the release or an impact. Differences are
/// those of the motion outside the free flight from the motion inside, at the time of the change.
#[derive(Clone, Debug)]
pub(super) struct Change {
    pub inside: usize,
    pub time: f64,
    /// Velocity, m/s: the limit from the side of the free flight; 0 if no change was fitted.
    pub velocity: Vector3<f64>,
    /// Difference of the velocities, m/s; `None` if the velocity does not jump.
    pub velocity_jump: Option<Vector3<f64>>,
    /// Difference of the accelerations, m/s²; zero if the change was fitted as a jump of the velocity.
    pub acceleration: Vector3<f64>,
}

/// Least-squares fit to the samples around a change at an assumed time: on each axis a cubic in time plus hinge terms.
pub(super) struct Fit {
    pub time: f64,
    /// Bayesian information criterion of the fit; smaller is better.
    pub criterion: f64,
    /// Coefficients, one column per axis: of the powers 0 to 3 of the time since `time`, then of those in `hinge`.
    coefficients: DMatrix<f64>,
    /// Covariance matrix of the coefficients of one axis; it is the same for each axis.
    pub covariance: DMatrix<f64>,
    pub hinge: &'static [i32],
}

impl Fit {
    /// Coefficient of one term on the three axes.
    pub fn coefficient(&self, term: usize) -> Vector3<f64> {
        self.coefficients.fixed_view::<1, 3>(term, 0).transpose()
    }

    /// Weighted sum of the coefficients on the three axes, and its standard error on one axis.
    pub fn sum(&self, weights: &DVector<f64>) -> (Vector3<f64>, f64) {
        let value = self.coefficients.tr_mul(weights);
        let variance = weights.dot(&(&self.covariance * weights));
        (value.fixed_rows::<3>(0).into(), variance.max(0.0).sqrt())
    }
}

/// Beginning or end of a free flight, with the samples around it to which a change of motion is fitted.
pub(super) struct FlightEnd<'p> {
    pub path: &'p Path<'p>,
    /// Index in the track of the first sample of the flight if `early` is true, otherwise of its last sample.
    pub last: usize,
    pub early: bool,
    pub samples: Range<usize>,
    /// Samples between which the time of the change is searched.
    near: Range<usize>,
}

/// Number of samples outside the flight in the fit of a change at its beginning or end.
pub(super) fn beyond(track: &Track) -> usize {
    ((BEYOND.0 / track.step).round() as usize).max(BEYOND.1)
}

impl<'p> FlightEnd<'p> {
    pub fn new(path: &'p Path<'p>, last: usize, early: bool) -> Self {
        let (beyond, within) = (beyond(path.track), 2 * half(path.track) + 2);
        let count = path.points.len();
        let around = |before: usize, after: usize| {
            last.saturating_sub(before)..(last + after + 1).min(count)
        };
        Self {
            path,
            last,
            early,
            samples: match early {
                true => around(beyond, within - 1),
                false => around(within, beyond),
            },
            // A change is detected late, by what deviates after it, or early: a sample that a wobble keeps from its
            // prediction is examined with those beyond it.
            near: around(beyond, beyond),
        }
    }

    /// Best fit over several times of the change and the exponents `hinges`, by the Bayesian information criterion.
    pub fn best(&self, hinges: &[&'static [i32]]) -> Option<Fit> {
        let times = &self.path.track.times;
        let intervals = self.near.start..self.near.end.saturating_sub(1);
        let candidates = intervals.flat_map(|i| {
            let part = (times[i + 1] - times[i]) / CANDIDATES as f64;
            (0..CANDIDATES).map(move |k| times[i] + part * k as f64)
        });
        let fits = candidates.flat_map(|time| {
            hinges
                .iter()
                .filter_map(move |&hinge| self.fit(time, hinge))
        });
        fits.min_by(|a, b| a.criterion.total_cmp(&b.criterion))
    }

    /// Fit of a cubic in time to the samples around this end of the flight, without a change of motion.
    pub fn smooth(&self) -> Option<Fit> {
        self.fit(self.path.track.times[self.last], &[])
    }

    fn located(&self, hinges: &[&'static [i32]]) -> Option<Change> {
        let best = self.best(hinges)?;
        let outward = if self.early { -1.0 } else { 1.0 };
        let jumps = best.hinge[0] == 1;
        let times = &self.path.track.times;
        let mut samples = self.samples.clone();
        let inside = if self.early {
            samples.find(|&i| times[i] >= best.time)? + MARGIN
        } else {
            let last = samples.rfind(|&i| times[i] <= best.time)?;
            last.checked_sub(MARGIN)?
        };
        let hinge = best.coefficient(CUBIC);
        Some(Change {
            inside: inside.min(times.len() - 1),
            time: best.time,
            velocity: best.coefficient(1),
            velocity_jump: jumps.then(|| hinge * outward),
            acceleration: hinge * if jumps { 0.0 } else { 2.0 },
        })
    }

    /// Fits a cubic in the time since `time` plus the hinge terms `hinge`; `None` if that is not determined.
    fn fit(&self, time: f64, hinge: &'static [i32]) -> Option<Fit> {
        flight::cancellation::stop_if_cancelled();
        let rows = self.samples.len();
        let columns = CUBIC + hinge.len();
        if rows < columns + 2 {
            return None;
        }
        let at = |row: usize| self.samples.start + row;
        let mut design = DMatrix::from_fn(rows, columns, |row, column| {
            let t = self.path.track.times[at(row)] - time;
            let outside = if self.early { -t } else { t };
            match column.checked_sub(CUBIC) {
                None => t.powi(column as i32),
                Some(term) => outside.max(0.0).powi(hinge[term]),
            }
        });
        let values = DMatrix::from_fn(rows, 3, |row, axis| self.path.points[at(row)][axis]);
        // Columns of equal norm, so that the normal equations are well scaled.
        let sizes: Vec<f64> = design.column_iter().map(|column| column.norm()).collect();
        // The column of a hinge outside the last sample is zero.
        if sizes.iter().any(|&size| size <= 0.0) {
            return None;
        }
        for (mut column, size) in design.column_iter_mut().zip(&sizes) {
            column /= *size;
        }
        let factor = design.tr_mul(&design).cholesky()?;
        let solution = factor.solve(&design.tr_mul(&values));
        let misfit = (&design * &solution - &values).norm_squared();
        let count = (3 * rows) as f64;
        let variance = misfit / (3 * (rows - columns)) as f64;
        let inverse = factor.inverse();
        Some(Fit {
            time,
            criterion: count * misfit.max(1e-18).ln() + (3 * hinge.len()) as f64 * count.ln(),
            coefficients: DMatrix::from_fn(columns, 3, |k, axis| solution[(k, axis)] / sizes[k]),
            covariance: DMatrix::from_fn(columns, columns, |k, l| {
                variance * inverse[(k, l)] / (sizes[k] * sizes[l])
            }),
            hinge,
        })
    }
}

/// Why a flight was not followed further. Indices are those of the track; followed backwards, "after" means earlier.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Stop {
    Data,
    /// The body is not seen between the samples `from` and `to`, neighbours in the track. The gap is longer than
    /// [`ThrowOptions::longest_gap`], or the samples after it do not continue the flight and it is longer than the
    /// samples among which a change of motion is located.
    Gap {
        from: usize,
        to: usize,
    },
    /// The samples after `last` deviate from their prediction.
    Deviation {
        last: usize,
    },
    Touch {
        last: usize,
    },
}

impl Path<'_> {
    /// Change of motion at the beginning (if `early`) or end of a flight that was not followed further because of
    /// `stop`: fitted after a deviation or a touch of the ground, otherwise at the last followed sample.
    pub fn change(&self, stop: &Stop, early: bool) -> Change {
        let (last, hinges) = match stop {
            Stop::Data => (if early { 0 } else { self.points.len() - 1 }, None),
            Stop::Gap { from, .. } => (*from, None),
            Stop::Deviation { last } => (*last, Some(&HINGES[..])),
            Stop::Touch { last } => (*last, Some(&JUMPS[..])),
        };
        let end = FlightEnd::new(self, last, early);
        let fitted = hinges.and_then(|hinges| end.located(hinges));
        fitted.unwrap_or_else(|| Change {
            inside: last,
            time: self.track.times[last],
            velocity: Vector3::zeros(),
            velocity_jump: None,
            acceleration: Vector3::zeros(),
        })
    }
}
