//! The path of a flight: its points, its landing and its nearest approaches to a point, with derivatives.
//!
//! A time that the path itself defines, such as that of the landing or of a nearest approach, is a zero of a function
//! of path and time; its derivatives follow from the implicit function theorem.

use nalgebra::Vector3;
use ode::{SensitivityLayout, Trajectory};

use crate::design::throw_flight::{Point, ThrowFlights};

/// Flights are divided into intervals of at least the duration over this number to search nearest approaches.
const FINEST: f64 = 128.0;
/// Maximum number of secant steps to a nearest approach.
const MAX_STEPS: usize = 40;

/// Flight of a throw, with the derivatives of its path if they were requested.
pub struct Path<'f> {
    pub(crate) flights: &'f ThrowFlights<'f>,
    pub(crate) layout: Option<SensitivityLayout>,
    /// Trajectory; with derivatives, the padded sensitivity matrix follows each state (see [`SensitivityLayout`]).
    pub trajectory: Trajectory,
    /// Column of S of each quantity with respect to which the path is differentiated.
    pub(crate) columns: Vec<usize>,
}

/// End of a flight on the ground, with derivatives with respect to the quantities by which the path is differentiated.
#[derive(Clone, Debug, PartialEq)]
pub struct Landing {
    /// Duration of the flight, s.
    pub time: f64,
    /// Position of the mass centre at landing, m.
    pub position: Vector3<f64>,
    /// Derivatives of the duration, s per unit of each quantity.
    pub time_by: Vec<f64>,
    /// Derivatives of the landing position, m per unit of each quantity; their z components are 0.
    pub position_by: Vec<Vector3<f64>>,
}

impl Path<'_> {
    /// Duration of the flight, s.
    pub fn duration(&self) -> f64 {
        self.trajectory.end
    }

    /// Motion of the mass centre at time `t`, s, which is clamped to the duration of the flight.
    pub fn point(&self, t: f64) -> Point {
        let t = t.clamp(self.trajectory.start, self.trajectory.end);
        let x = self.trajectory.sample(t);
        let x = x.unwrap_or_else(|| self.trajectory.end_state.clone());
        let s = self.layout.map(|layout| (layout, &self.columns[..]));
        self.flights.point(t, &x, s)
    }

    /// Position of the mass centre at a time within the flight, m.
    pub fn position(&self, t: f64) -> Vector3<f64> {
        let x = self.trajectory.sample(t);
        let x = x.as_ref().unwrap_or(&self.trajectory.end_state);
        self.flights.place(x)
    }

    /// Time and position of the landing, with derivatives.
    pub fn landing(&self) -> Landing {
        let end = self.point(self.trajectory.end);
        // From z(T) = 0: dT = −dz / ż.
        let time = |by: &Vector3<f64>| -by.z / end.velocity.z;
        let time_by: Vec<f64> = end.position_by.iter().map(time).collect();
        let moved = end.position_by.iter().zip(&time_by);
        Landing {
            time: end.t,
            position: end.position,
            position_by: moved.map(|(by, dt)| by + end.velocity * *dt).collect(),
            time_by,
        }
    }

    /// Times, s, at which the distance of the path from a point (or, if `horizontally`, from the vertical line through
    /// it) has a local minimum, those at the ends of the flight among them.
    pub fn nearest_times(&self, to: Vector3<f64>, horizontally: bool) -> Vec<f64> {
        let flat = |v: Vector3<f64>| {
            if horizontally {
                Vector3::new(v.x, v.y, 0.0)
            } else {
                v
            }
        };
        let away = |t: f64| flat(self.position(t) - to).norm_squared();
        let mut times = vec![self.trajectory.start];
        let finest = self.trajectory.end / FINEST;
        for &(t, h) in self.trajectory.steps() {
            let end = (t + h).min(self.trajectory.end);
            let last = times[times.len() - 1];
            let parts = ((end - last) / finest).floor() as usize;
            times.extend((1..=parts).map(|k| last + (end - last) * k as f64 / parts as f64));
        }
        times.retain(|t| *t < self.trajectory.end);
        times.push(self.trajectory.end);
        let distances: Vec<f64> = times.iter().map(|t| away(*t)).collect();
        let last = times.len() - 1;
        let mut found = Vec::new();
        for k in 0..=last {
            let lower = k > 0 && distances[k - 1] < distances[k];
            let then = k < last && distances[k + 1] < distances[k];
            if !lower && !then {
                let (from, until) = (times[k.saturating_sub(1)], times[(k + 1).min(last)]);
                found.push(self.refined(from, until, to, flat));
            }
        }
        found
    }

    /// Time in an interval, s, at which the squared distance from the point `to` begins to grow, or an end of it.
    fn refined(
        &self,
        mut from: f64,
        mut until: f64,
        to: Vector3<f64>,
        flat: impl Fn(Vector3<f64>) -> Vector3<f64>,
    ) -> f64 {
        let rate = |t: f64| {
            let h = 1e-5 * self.trajectory.end;
            let (a, b) = ((t - h).max(0.0), (t + h).min(self.trajectory.end));
            let velocity = (self.position(b) - self.position(a)) / (b - a);
            flat(self.position(t) - to).dot(&flat(velocity))
        };
        let (low, high) = (rate(from), rate(until));
        if low >= 0.0 || high <= 0.0 {
            return if low >= 0.0 { from } else { until };
        }
        // The Illinois variant of the secant method, which maintains the bracket.
        let (mut low, mut high) = (low, high);
        let mut side = 0;
        for _ in 0..MAX_STEPS {
            let middle = (from * high - until * low) / (high - low);
            let value = rate(middle);
            if until - from < 1e-12 * self.trajectory.end || value.abs() < 1e-14 {
                return middle;
            }
            if value < 0.0 {
                (from, low) = (middle, value);
                high *= if side < 0 { 0.5 } else { 1.0 };
                side = -1;
            } else {
                (until, high) = (middle, value);
                low *= if side > 0 { 0.5 } else { 1.0 };
                side = 1;
            }
        }
        0.5 * (from + until)
    }
}
