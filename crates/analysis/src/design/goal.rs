//! Goals of a throw: the objective to minimize, the constraints, and their derivatives, from the path of a flight.

use nalgebra::{DMatrix, DVector, Vector2, Vector3};

use crate::design::optimise::Values;
use crate::design::path::Path;

/// Purpose of a throw, for which the best throw is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// The path passes through the given point (x, y, z in m), or lands there if its height is 0. Of all such throws,
    /// the one nearest the middle of the bounds is preferred.
    Hit(Vector3<f64>),
    /// The horizontal distance from release to landing is as large as possible.
    Range,
    /// The duration of the flight is as long as possible.
    HangTime,
    /// The path passes through the given point (x, y, z in m), or lands there if its height is 0, and avoids the
    /// obstacle specified in [`Bounds`](crate::design::bounds::Bounds).
    Curve(Vector3<f64>),
    /// The path is level at the given point (x, y, z in m), neither falling nor climbing, and passes it as slowly as
    /// possible, like an aircraft that flares.
    Flare(Vector3<f64>),
    /// The throw lands at the given point (x, y, z in m). Of all such throws, the one whose landings spread least if
    /// the release, wind and parameters scatter.
    Spread(Vector3<f64>),
}

/// Name of each goal of a throw in files and options, in the order of [`Goal`].
pub const GOALS: [&str; 6] = ["hit", "range", "hangtime", "curve", "flare", "spread"];

/// Side on which the path passes an obstacle, seen in the direction of flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The path is to the left of the obstacle.
    Left,
    /// The path is to the right of the obstacle.
    Right,
}

impl Side {
    /// Sign of the side as a lateral coordinate, left positive: 1 for left, −1 for right.
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
    /// Radius, m, including a margin for the size of the body: only the path of the mass centre is compared with the
    /// cylinder.
    pub radius: f64,
    /// Side on which the path must pass the obstacle; `None` allows either side.
    pub side: Option<Side>,
}

impl Goal {
    /// Name of the goal in files and options, such as `hit`.
    pub fn name(&self) -> &'static str {
        match self {
            Goal::Hit(_) => "hit",
            Goal::Range => "range",
            Goal::HangTime => "hangtime",
            Goal::Curve(_) => "curve",
            Goal::Flare(_) => "flare",
            Goal::Spread(_) => "spread",
        }
    }

    /// Target point of the goal, m; `None` for a goal without a point.
    pub fn target(&self) -> Option<Vector3<f64>> {
        match *self {
            Goal::Hit(point) | Goal::Curve(point) | Goal::Flare(point) | Goal::Spread(point) => {
                Some(point)
            }
            Goal::Range | Goal::HangTime => None,
        }
    }

    /// Name and unit of the value by which the goal is judged, such as `range` and `m`.
    pub fn figure(&self) -> (&'static str, &'static str) {
        match self {
            Goal::Hit(_) | Goal::Curve(_) => ("distance from the target", "m"),
            Goal::Range => ("range", "m"),
            Goal::HangTime => ("time of flight", "s"),
            Goal::Flare(_) => ("speed at the target", "m/s"),
            Goal::Spread(_) => ("root mean square distance of landings from their mean", "m"),
        }
    }

    /// Distance, m, of the path from the goal's target point at the time at which the path is nearest to it; horizontal
    /// for a point on the ground, 0 for a goal without a point.
    pub(crate) fn miss(&self, path: &Path<'_>) -> f64 {
        self.target().map_or(0.0, |target| {
            let away = path.position(self.time(path)) - target;
            if target.z > 0.0 {
                away.norm()
            } else {
                away.xy().norm()
            }
        })
    }

    /// Time, s, at which the path is nearest to the goal's target point; the end of the flight for a point on the
    /// ground and for a goal without a point.
    pub fn time(&self, path: &Path<'_>) -> f64 {
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

    /// Objective and constraints of the goal for a flight, with derivatives with respect to the same quantities as
    /// those of `path`. The objective is 0 for [`Spread`](Goal::Spread), which needs the scatter, not only the path. It
    /// is also 0 for [`Hit`](Goal::Hit) and [`Curve`](Goal::Curve), which only constrain the path.
    pub fn values(&self, path: &Path<'_>, obstacle: Option<(&Obstacle, Side)>) -> Values {
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
        let mut margins = Vec::new();
        if let Some((obstacle, side)) = obstacle {
            margins.push(clearance(path, obstacle, side));
        }
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

/// Minimum lateral distance, m, of the path from the surface of the obstacle on the given side. It is negative if the
/// path enters the obstacle or passes it on the opposite side. Also returns the derivatives of the distance with
/// respect to the quantities by which the path is differentiated. They are taken at the fixed time of the nearest
/// approach, because the derivative of the distance with respect to time is 0 there.
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
