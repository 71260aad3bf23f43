//! Goals of a throw: the objective to minimize, the constraints, and their derivatives, from the path of a flight.

use nalgebra::{DMatrix, DVector, Vector2, Vector3};

use crate::design::optimise::Values;
use crate::design::path::Path;

/// Purpose of a throw. Points are in the inertial frame, m; the release is above the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// Pass through a point, or land there if its height is 0; the throw is near the middle of the bounds.
    Hit([f64; 3]),
    /// Fly as far as possible before the landing.
    Range,
    /// Stay in the air as long as possible.
    HangTime,
    /// As [`Hit`](Goal::Hit), past the obstacle of the bounds.
    Curve([f64; 3]),
    /// Arrive at a point in level flight, as slowly as possible.
    Flare([f64; 3]),
    /// Land at a point with the least spread as release, wind and parameters scatter.
    Spread([f64; 2]),
}

/// Names of the goals in files and options, in the order of [`Goal`].
pub const GOALS: [&str; 6] = ["hit", "range", "hangtime", "curve", "flare", "spread"];

/// Side on which the path passes an obstacle, seen in the direction of flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left of the obstacle.
    Left,
    /// Right of the obstacle.
    Right,
}

impl Side {
    /// 1 for left, −1 for right.
    fn sign(self) -> f64 {
        match self {
            Side::Left => 1.0,
            Side::Right => -1.0,
        }
    }

    /// Name of the side in files: `left` or `right`.
    pub fn name(self) -> &'static str {
        match self {
            Side::Left => "left",
            Side::Right => "right",
        }
    }
}

/// Upright cylinder, unbounded upwards, that the path must not enter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle {
    /// Horizontal coordinates x, y of the cylinder's axis, m.
    pub place: Vector2<f64>,
    /// Radius, m, with a margin for the size of the body: the path is that of the mass centre.
    pub radius: f64,
    /// Side on which the path must pass the obstacle; `None` allows either side.
    pub side: Option<Side>,
}

impl Goal {
    /// Name of the goal in files and options, such as `hit`.
    pub(crate) fn name(&self) -> &'static str {
        GOALS[match self {
            Goal::Hit(_) => 0,
            Goal::Range => 1,
            Goal::HangTime => 2,
            Goal::Curve(_) => 3,
            Goal::Flare(_) => 4,
            Goal::Spread(_) => 5,
        }]
    }

    /// Target point of the goal, m; `None` for a goal without a point.
    pub(crate) fn target(&self) -> Option<Vector3<f64>> {
        match *self {
            Goal::Hit(at) | Goal::Curve(at) | Goal::Flare(at) => Some(at.into()),
            Goal::Spread([x, y]) => Some(Vector3::new(x, y, 0.0)),
            Goal::Range | Goal::HangTime => None,
        }
    }

    /// Name and unit of the value by which the goal is judged, such as `range` and `m`.
    pub(crate) fn figure(&self) -> (&'static str, &'static str) {
        match self {
            Goal::Hit(_) | Goal::Curve(_) => ("distance from the target", "m"),
            Goal::Range => ("range", "m"),
            Goal::HangTime => ("time of flight", "s"),
            Goal::Flare(_) => ("speed at the target", "m/s"),
            Goal::Spread(_) => ("root mean square distance of landings from their mean", "m"),
        }
    }

    /// Smallest distance of the path from the target, m; horizontal for a target on the ground, 0 without a target.
    pub(crate) fn miss(&self, path: &Path<'_>) -> f64 {
        self.target().map_or(0.0, |target| {
            let away = path.position(self.time(path)) - target;
            let in_air = target.z > 0.0;
            if in_air {
                away.norm()
            } else {
                away.xy().norm()
            }
        })
    }

    /// Time at which the path is nearest to a target in the air, otherwise the end of the flight, s.
    pub(crate) fn time(&self, path: &Path<'_>) -> f64 {
        match self.target() {
            Some(target) if target.z > 0.0 => {
                let times = path.nearest_times(target, false);
                let away = |t: &f64| (path.position(*t) - target).norm();
                let nearest = times.into_iter().min_by(|a, b| away(a).total_cmp(&away(b)));
                nearest.unwrap_or_else(|| path.duration())
            }
            _ => path.duration(),
        }
    }

    /// Objective and constraints of the goal for a flight, with the derivatives that `path` has. The objective is 0 for
    /// [`Spread`](Goal::Spread), which needs the scatter, and for goals that only constrain the path.
    pub(crate) fn values(&self, path: &Path<'_>, obstacle: Option<(&Obstacle, Side)>) -> Values {
        let landing = path.landing();
        let columns = landing.time_by.len();
        let mut rows: Vec<(f64, Vec<f64>)> = Vec::new();
        let mut objective = (0.0, vec![0.0; columns]);
        if let Some(target) = self.target() {
            let t = self.time(path);
            let is_end = t >= path.duration();
            let point = path.point(t);
            let time_by = if is_end {
                landing.time_by.clone()
            } else {
                point.nearest_time_by(target)
            };
            let is_inside = t > 0.0;
            let shift = |k: usize| if is_inside { time_by[k] } else { 0.0 };
            let axes = if target.z > 0.0 { 3 } else { 2 };
            for axis in 0..axes {
                let by = (0..columns)
                    .map(|k| point.position_by[k][axis] + point.velocity[axis] * shift(k));
                rows.push((point.position[axis] - target[axis], by.collect()));
            }
            if let Goal::Flare(_) = self {
                let by = |k: usize| point.velocity_by[k] + point.acceleration * shift(k);
                rows.push((point.velocity.z, (0..columns).map(|k| by(k).z).collect()));
                let speed = point.velocity.norm();
                let along = point.velocity / speed;
                objective = (speed, (0..columns).map(|k| by(k).dot(&along)).collect());
            }
        }
        match self {
            Goal::Range => {
                let flat = Vector3::new(landing.position.x, landing.position.y, 0.0);
                let along = flat.try_normalize(1e-9).unwrap_or_else(Vector3::x);
                let by = landing.position_by.iter().map(|by| -by.dot(&along));
                objective = (-flat.norm(), by.collect());
            }
            Goal::HangTime => {
                objective = (
                    -landing.time,
                    landing.time_by.iter().map(|by| -by).collect(),
                );
            }
            _ => {}
        }
        let margins = obstacle.map(|(obstacle, side)| clearance(path, obstacle, side));
        let margins: Vec<_> = margins.into_iter().collect();
        let stacked = |rows: &[(f64, Vec<f64>)]| {
            let values = DVector::from_iterator(rows.len(), rows.iter().map(|row| row.0));
            (
                values,
                DMatrix::from_fn(rows.len(), columns, |i, j| rows[i].1[j]),
            )
        };
        let (equalities, equalities_by) = stacked(&rows);
        let (margins, margins_by) = stacked(&margins);
        Values {
            objective: objective.0,
            gradient: DVector::from_vec(objective.1),
            equalities,
            equalities_by,
            margins,
            margins_by,
        }
    }
}

/// Smallest lateral distance of the path from the surface of the obstacle on the given side, m, negative inside or on
/// the other side, with its derivatives. They are those at a fixed time, since the nearest approach is stationary.
fn clearance(path: &Path<'_>, obstacle: &Obstacle, side: Side) -> (f64, Vec<f64>) {
    let place = Vector3::new(obstacle.place.x, obstacle.place.y, 0.0);
    let passes = path.nearest_times(place, true).into_iter().map(|t| {
        let point = path.point(t);
        let left = Vector3::new(point.left().x, point.left().y, 0.0) * side.sign();
        let aside = (point.position - place).dot(&left) - obstacle.radius;
        (
            aside,
            point.position_by.iter().map(|by| by.dot(&left)).collect(),
        )
    });
    // Every flight has a nearest approach, at least at one of its ends.
    let least = passes.min_by(|a: &(f64, Vec<f64>), b| a.0.total_cmp(&b.0));
    least.unwrap_or_default()
}
