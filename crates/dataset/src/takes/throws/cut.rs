//! Time of a change of motion: the time of the fitted hinge that best explains the samples on both sides.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use super::follow::Stop;
use super::quadratic::quadratic;
use super::track::Track;
use super::windows::half;

/// Samples outside the flight that are included in the fit of a change of motion at its beginning or end: time span
/// that they cover, s, and their minimum number.
const BEYOND: (f64, usize) = (0.03, 4);
/// Number of instants per sampling interval that are tried as the time of a change of motion (release, impact).
const CANDIDATES: usize = 4;
/// Number of samples next to a change of motion (release, impact) that are excluded from the flight, since the time of
/// the change is accurate to only about one sampling interval.
const MARGIN: usize = 1;
/// Exponents of the hinge terms that are tried for a change of motion. A hinge term is a power of the time from the
/// change outwards, and 0 inside the flight: the exponent 1 represents a jump of the velocity, 2 a jump of the
/// acceleration, and 3 a jump of the derivative of the acceleration.
pub(super) const HINGES: [&[i32]; 4] = [&[2], &[2, 3], &[1], &[1, 2]];
/// Exponents of the hinge terms (powers of the time after the touch, 0 before) that are tried for a touch of the
/// ground: a jump of the velocity, alone or with a jump of the acceleration.
pub(super) const JUMPS: [&[i32]; 2] = [&[1], &[1, 2]];

/// Number of coefficients of the cubic in time that describes the motion in the flight on one axis.
pub(super) const CUBIC: usize = 4;

/// A change of the motion at the beginning or the end of a flight, such as the release or an impact.
#[derive(Clone, Debug)]
pub(super) struct Change {
    /// Sample of the flight next to the change, as index in the track: the flight's first sample at its beginning, its
    /// last sample at its end.
    pub inside: usize,
    /// Time of the change of motion, s, on the time axis of the recording.
    pub time: f64,
    /// Velocity of the body at the time of the change, m/s: the limit from the side of the free flight; 0 if no change
    /// was fitted.
    pub velocity: [f64; 3],
    /// Velocity outside the free flight minus velocity inside, both at the time of the change, m/s; `None` if the
    /// velocity does not jump.
    pub velocity_jump: Option<[f64; 3]>,
    /// Acceleration outside the free flight minus acceleration inside, both at the time of the change, m/s²; zero if
    /// the change was fitted as a jump of the velocity.
    pub acceleration: [f64; 3],
}

/// Determines the change of motion at one end of a free flight: at its beginning if `early` is true, otherwise at its
/// end. `stop` is the reason why the flight was not followed further, `path` the trajectory of a body point, m. A
/// change is fitted only if `stop` is a deviation or a touch of the ground; otherwise it is placed at the last followed
/// sample.
pub(super) fn changes(track: &Track, path: &[[f64; 3]], stop: &Stop, early: bool) -> Change {
    let data = if early { 0 } else { path.len() - 1 };
    let end = FlightEnd::new(track, path, stop.last(data), early);
    let plain = Change {
        inside: end.last,
        time: track.times[end.last],
        velocity: [0.0; 3],
        velocity_jump: None,
        acceleration: [0.0; 3],
    };
    match stop {
        Stop::Deviation { .. } => end.located(&HINGES).unwrap_or(plain),
        Stop::Touch { .. } => end.located(&JUMPS).unwrap_or(plain),
        _ => plain,
    }
}

/// Least-squares fit to the samples around a change of motion at an assumed time: on each axis a cubic in time plus
/// hinge terms, which are powers of the time outside the flight and 0 inside.
pub(super) struct Fit {
    pub time: f64,
    /// Bayesian information criterion of the fit; smaller is better.
    pub criterion: f64,
    /// Coefficients, one column per axis: rows 0 to 3 for the powers 0 to 3 of the time since the field `time`, then
    /// one row per exponent in the field `hinge`.
    pub coefficients: DMatrix<f64>,
    /// Covariance matrix of the coefficients of one axis; it is the same for each axis.
    pub covariance: DMatrix<f64>,
    pub hinge: &'static [i32],
}

/// Beginning or end of a free flight, with the samples around it to which a change of motion is fitted.
pub(super) struct FlightEnd<'t> {
    pub track: &'t Track,
    /// Trajectory of the body point whose motion is examined, m: one position for each sample of the track.
    pub path: &'t [[f64; 3]],
    /// Index in the track of the first sample of the flight if `early` is true, otherwise of its last sample.
    pub last: usize,
    /// Whether this end is the beginning of the flight.
    pub early: bool,
    /// Indices, in the track, of the samples to which a change of motion is fitted.
    pub samples: Range<usize>,
    /// Indices, in the track, of the samples between which the time of the change is searched.
    near: Range<usize>,
}

impl<'t> FlightEnd<'t> {
    pub fn new(track: &'t Track, path: &'t [[f64; 3]], last: usize, early: bool) -> Self {
        let beyond = ((BEYOND.0 / track.step).round() as usize).max(BEYOND.1);
        let within = 2 * half(track) + 2;
        // Deviations are detected with a delay, so the change lies inside of them.
        let (samples, near) = match early {
            true => (
                last.saturating_sub(beyond)..(last + within).min(path.len()),
                last.saturating_sub(1)..(last + beyond + 1).min(path.len()),
            ),
            false => (
                last.saturating_sub(within)..(last + beyond + 1).min(path.len()),
                last.saturating_sub(beyond)..(last + 2).min(path.len()),
            ),
        };
        Self {
            track,
            path,
            last,
            early,
            samples,
            near,
        }
    }

    /// Fits a change of motion (release, impact) for each set of hinge terms in `hinges` and for several times of the
    /// change. Hinge terms are powers of the time outside the flight, 0 inside; each set is the list of their
    /// exponents. Returns the fit with the smallest Bayesian information criterion, or `None` if no fit is possible.
    pub fn best(&self, hinges: &[&'static [i32]]) -> Option<Fit> {
        let mut best: Option<Fit> = None;
        for i in self.near.start..self.near.end.saturating_sub(1) {
            let (a, b) = (self.track.times[i], self.track.times[i + 1]);
            for candidate in 0..CANDIDATES {
                let time = a + (b - a) * candidate as f64 / CANDIDATES as f64;
                for &hinge in hinges {
                    if let Some(fit) = self.fit(time, hinge)
                        && best
                            .as_ref()
                            .is_none_or(|best| fit.criterion < best.criterion)
                    {
                        best = Some(fit);
                    }
                }
            }
        }
        best
    }

    /// Fit of a cubic in time to the samples around this end of the flight, without a change of motion; `None` if no
    /// fit is possible.
    pub fn smooth(&self) -> Option<Fit> {
        self.fit(self.track.times[self.last], &[])
    }

    fn located(&self, hinges: &[&'static [i32]]) -> Option<Change> {
        let best = self.best(hinges)?;
        let row = |k: usize| [0, 1, 2].map(|axis| best.coefficients[(k, axis)]);
        let outward = if self.early { -1.0 } else { 1.0 };
        let jumps = best.hinge[0] == 1;
        let times = &self.track.times;
        let mut samples = self.samples.clone();
        let inside = match self.early {
            true => samples.find(|&i| times[i] >= best.time)? + MARGIN,
            false => samples
                .rfind(|&i| times[i] <= best.time)?
                .checked_sub(MARGIN)?,
        };
        Some(Change {
            inside: inside.min(self.path.len() - 1),
            time: best.time,
            velocity: row(1),
            velocity_jump: jumps.then(|| row(CUBIC).map(|x| outward * x)),
            acceleration: if jumps {
                [0.0; 3]
            } else {
                row(CUBIC).map(|x| 2.0 * x)
            },
        })
    }

    /// Fits to the samples, on each axis, a cubic in the time since `time`, plus hinge terms: powers, with the
    /// exponents `hinge`, of the time outside the flight, which are 0 inside the flight. `None` if there are too few
    /// samples or the equations are singular.
    fn fit(&self, time: f64, hinge: &'static [i32]) -> Option<Fit> {
        let rows = self.samples.len();
        let columns = CUBIC + hinge.len();
        if rows < columns + 2 {
            return None;
        }
        let mut design = DMatrix::zeros(rows, columns);
        let mut values = DMatrix::zeros(rows, 3);
        for (row, i) in self.samples.clone().enumerate() {
            let t = self.track.times[i] - time;
            let out = if self.early {
                (-t).max(0.0)
            } else {
                t.max(0.0)
            };
            let terms = [1.0, t, t * t, t * t * t].into_iter();
            let terms = terms.chain(hinge.iter().map(|&power| out.powi(power)));
            for (column, term) in terms.enumerate() {
                design[(row, column)] = term;
            }
            for axis in 0..3 {
                values[(row, axis)] = self.path[i][axis];
            }
        }
        // Columns of equal norm, so that the normal equations are well scaled.
        let sizes: Vec<f64> = design.column_iter().map(|column| column.norm()).collect();
        // The column of a hinge outside the last sample is zero.
        if sizes.iter().any(|&size| size <= 0.0) {
            return None;
        }
        let scale = DVector::from_iterator(columns, sizes.iter().map(|size| 1.0 / size));
        let scaled = &design * DMatrix::from_diagonal(&scale);
        let normal = scaled.transpose() * &scaled;
        let factor = normal.cholesky()?;
        let solution = factor.solve(&(scaled.transpose() * &values));
        let misfit = (&scaled * &solution - &values).norm_squared();
        let count = (3 * rows) as f64;
        let unscale = DMatrix::from_diagonal(&scale);
        let variance = misfit / (3 * (rows - columns)) as f64;
        Some(Fit {
            time,
            criterion: count * misfit.max(1e-18).ln() + (3 * hinge.len()) as f64 * count.ln(),
            coefficients: &unscale * solution,
            covariance: &unscale * factor.inverse() * &unscale * variance,
            hinge,
        })
    }
}

/// Mean acceleration over the track indices `samples`, m/s², from a quadratic in time fitted to the trajectory `path`;
/// `None` if there are too few samples.
pub(super) fn mean_acceleration(
    track: &Track,
    path: &[[f64; 3]],
    samples: Range<usize>,
) -> Option<[f64; 3]> {
    let t0 = track.times[samples.start];
    let (coefficients, _) = quadratic(track, path, samples, t0, 1.0)?;
    Some([0, 1, 2].map(|axis| 2.0 * coefficients[(2, axis)]))
}
