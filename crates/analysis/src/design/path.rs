//! The path of a flight: its points, its landing and its nearest approaches to a point, with derivatives.
//!
//! A time that the path itself defines, such as that of the landing or of a nearest approach, is a zero of a function
//! of path and time; its derivatives follow from the implicit function theorem.

use nalgebra::Vector3;
use ode::{SensitivityLayout, Trajectory};

use crate::design::point::Point;
use crate::design::throw_flight::ThrowFlights;

/// Ratio of the duration of a flight to the minimum length of the time intervals in which a nearest approach of the
/// path to a point is searched. The intervals are at most about twice as long as this minimum.
const FINEST: f64 = 128.0;
/// Maximum number of steps of the secant method that determines the time of a nearest approach to a point.
const MAX_STEPS: usize = 40;

/// Flight of a throw, with the derivatives of its path with respect to quantities such as the speed if they were
/// requested.
pub struct Path<'f> {
    flights: &'f ThrowFlights<'f>,
    layout: Option<SensitivityLayout>,
    /// Integrated trajectory. If derivatives were requested, each state vector is followed by the sensitivity matrix S,
    /// the derivatives of the states, row by row and with padding (see [`SensitivityLayout`]).
    pub trajectory: Trajectory,
    /// For each quantity with respect to which the path is differentiated, its column of the sensitivity matrix S, the
    /// derivatives of the states.
    columns: Vec<usize>,
}

/// Landing of a thrown body (end of its flight on the ground), with derivatives with respect to the quantities by which
/// the path is differentiated.
#[derive(Clone, Debug, PartialEq)]
pub struct Landing {
    /// Duration of the flight, s.
    pub time: f64,
    /// Position of the mass centre at landing, m.
    pub position: Vector3<f64>,
    /// Derivatives of the duration, s per unit of each quantity with respect to which the path is differentiated.
    pub time_by: Vec<f64>,
    /// Derivatives of the landing position, m per unit of each quantity with respect to which the path is
    /// differentiated; their z components are 0, because the landing is always on the ground.
    pub position_by: Vec<Vector3<f64>>,
}

impl<'f> Path<'f> {
    pub(crate) fn new(
        flights: &'f ThrowFlights<'f>,
        layout: Option<SensitivityLayout>,
        trajectory: Trajectory,
        columns: Vec<usize>,
    ) -> Path<'f> {
        Path {
            flights,
            layout,
            trajectory,
            columns,
        }
    }

    /// Duration of the flight, s.
    pub fn duration(&self) -> f64 {
        self.trajectory.end
    }

    /// Motion of the mass centre at time `t` (s since release), which is clamped to the duration of the flight.
    pub fn point(&self, t: f64) -> Point {
        let t = t.clamp(self.trajectory.start, self.trajectory.end);
        let x = self.trajectory.sample(t);
        let x = x.unwrap_or_else(|| self.trajectory.end_state.clone());
        let s = self.layout.map(|layout| (layout, &self.columns[..]));
        self.flights.point(t, &x, s)
    }

    /// Position of the mass centre at a time within the flight, m; `t` in s since release.
    pub fn position(&self, t: f64) -> Vector3<f64> {
        let x = self.trajectory.sample(t);
        let x = x.as_ref().unwrap_or(&self.trajectory.end_state);
        self.flights.place(x)
    }

    /// Time and position of the landing, with derivatives with respect to the quantities by which the path is
    /// differentiated.
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

    /// Times, s since release, at which the distance between the path and the point `to` (m) has a local minimum,
    /// including minima at the ends of the flight. If `horizontally`, the distance is that to the vertical line through
    /// the point.
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

    /// Time between `from` and `until`, s, at which the path is nearest to the point `to` (m). It is the time at which
    /// the derivative of the squared distance changes sign from negative to positive; without such a change of sign it
    /// is one of the two ends of the interval.
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
