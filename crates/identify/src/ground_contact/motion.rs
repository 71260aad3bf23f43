//! Models of free motion over some samples, and of free motion that is disturbed between two of them.
//!
//! The position is a polynomial in time plus small terms at the rate of the wobble, with which lift varies. The axis
//! drifts and wobbles. A contact changes the velocity and the drift, and starts an additional wobble.

use nalgebra::{SVector, Vector3};

use super::regression::Row;

/// Unit of time in the polynomials that describe the motion of a body, s: their variable is time divided by this value.
pub const SCALE: f64 = 0.1;
/// Prior standard deviation of the fourth time derivative of the position, m/s⁴. The value allows for a lift of several
/// g that decays within half a second.
const SNAP: f64 = 300.0;
/// Prior standard deviation, m, of the amplitudes of the sine and cosine terms with the wobble rate in the position.
const WOBBLE: f64 = 0.002;
/// Prior standard deviation, dimensionless, of the cubic coefficient of the polynomial that describes the drift of the
/// most steady body axis. The variable of the polynomial is time / `SCALE`.
const BEND: f64 = 0.02;
/// Minimum variance by which gains are divided, as a fraction of the residual variance of motion that may change within
/// the tested interval. A gain is the decrease of the sum of squared residuals by such a change. The minimum prevents
/// outliers, which increase the residual variance, from causing large gains.
const LOCAL_PART: f64 = 0.25;

/// Position of the body's origin, and direction of the body axis whose direction changes least, in one sample.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Index of the sample.
    pub sample: usize,
    /// Time of the sample, s; its origin is arbitrary, but the same for all points of a flight.
    pub time: f64,
    /// Position of the body's origin in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Unit vector, in inertial components, along the body axis whose direction changes least.
    pub axis: Vector3<f64>,
}

/// Wobble rate and noise properties of one flight, which are assumed constant throughout the flight.
#[derive(Clone, Copy, Debug)]
pub struct Character {
    /// Angular rate at which the most steady body axis wobbles, rad/s.
    pub rate: f64,
    /// Correlation of the measurement noise between successive samples, dimensionless.
    pub correlation: f64,
    /// Standard deviations of the noise: of a component of the position, m, and of a component of the axis.
    pub noise: [f64; 2],
}

/// Result of testing one interval between two successive points for a ground contact: comparison of free motion with
/// motion that is disturbed within the interval, so that its velocity and wobble change.
#[derive(Clone, Copy, Debug)]
pub struct Comparison {
    /// Index of the first point after the interval that is tested for a ground contact.
    pub index: usize,
    /// Decreases of the sums of squared residuals of the position and of the body axis if the motion may change within
    /// the tested interval. Each is divided by its noise variance, or by `LOCAL_PART` × its residual variance if that
    /// is greater.
    pub gains: [f64; 2],
    /// Residual variances of the motion that changes within the interval: of the position, m², and of the axis (a unit
    /// vector, dimensionless).
    pub variances: [f64; 2],
    /// Sum of the squared residuals of the position and of the body axis for motion that changes within the tested
    /// interval, each in units of its noise variance.
    pub remaining: f64,
    /// Velocity of the body's origin in inertial components, just before it changes within the tested interval, m/s.
    pub velocity: Vector3<f64>,
    /// Change of the velocity of the body's origin within the tested interval, in inertial components, m/s.
    pub jump: Vector3<f64>,
}

impl Character {
    fn precision(&self, part: usize, deviation: f64) -> f64 {
        (self.noise[part] / deviation).powi(2)
    }

    /// Regression rows for a point in motion without a ground contact: for the position, and for the direction of the
    /// most steady body axis. The basis functions are powers of time, and a sine and cosine at the wobble rate. `about`
    /// is the origin of time, s.
    pub fn free_rows(&self, point: &Point, about: f64) -> (Row<7>, Row<6>) {
        let u = (point.time - about) / SCALE;
        let (sine, cosine) = (self.rate * (point.time - about)).sin_cos();
        let (square, cube) = (u * u, u * u * u);
        let of_position = [1.0, u, square, cube, square * square, cosine, sine];
        let of_axis = [1.0, u, square, cube, cosine, sine];
        (
            Row {
                sample: point.sample,
                functions: of_position.into(),
                value: point.position,
            },
            Row {
                sample: point.sample,
                functions: of_axis.into(),
                value: point.axis,
            },
        )
    }

    /// Prior precisions of the coefficients with which [`free_rows`](Self::free_rows) describes the position, each as
    /// the ratio of the noise variance to the prior variance; 0 without a prior.
    pub fn position_precisions(&self) -> [f64; 7] {
        let snap = self.precision(0, SNAP * SCALE.powi(4) / 24.0);
        let wobble = self.precision(0, WOBBLE);
        [0.0, 0.0, 0.0, 0.0, snap, wobble, wobble]
    }

    /// Prior precisions of the coefficients with which [`free_rows`](Self::free_rows) describes the direction of the
    /// body axis, each as the ratio of the noise variance to the prior variance; 0 without a prior.
    pub fn axis_precisions(&self) -> [f64; 6] {
        [0.0, 0.0, 0.0, self.precision(1, BEND), 0.0, 0.0]
    }

    /// Variances by which the gains of position, m², and axis are divided: the noise variance, or `LOCAL_PART` × the
    /// residual variance if that is greater. `variances` contains the residual variances of position, m², and axis for
    /// motion that may change within the tested interval.
    pub fn units(&self, variances: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|part| self.noise[part].powi(2).max(LOCAL_PART * variances[part]))
    }

    /// Gains of the test `of` for the position and the direction of the body axis, converted from the noise of `other`
    /// to that of `self`. A gain is the decrease of the sum of squared residuals, divided by the variance that
    /// [`units`](Self::units) returns. The test was made with the variances of `other`.
    pub fn gains(&self, of: &Comparison, other: &Character) -> [f64; 2] {
        let (here, there) = (self.units(of.variances), other.units(of.variances));
        [0, 1].map(|part| of.gains[part] * there[part] / here[part])
    }

    /// Values, at a point, of the functions by which a ground contact at the time `about`, s, changes the position and
    /// the direction of the most steady body axis. The contact changes the velocity and the acceleration of the
    /// position, and the drift and the wobble of the axis.
    pub fn disturbance(&self, point: &Point, about: f64) -> (SVector<f64, 2>, SVector<f64, 3>) {
        let since = (point.time - about).max(0.0);
        let (u, (sine, cosine)) = (since / SCALE, (self.rate * since).sin_cos());
        ([u, u * u].into(), [u, sine, 1.0 - cosine].into())
    }
}
