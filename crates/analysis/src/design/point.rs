//! A point of a path, with derivatives.

use nalgebra::{Vector2, Vector3};

/// Motion of the mass centre at a point of its path, SI units, inertial frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Time since release, s.
    pub t: f64,
    /// Position of the mass centre in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Velocity of the mass centre in the inertial frame, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration of the mass centre in the inertial frame, m/s².
    pub acceleration: Vector3<f64>,
    /// Derivatives of the position at fixed time, m per unit of each quantity with respect to which the path is
    /// differentiated.
    pub position_by: Vec<Vector3<f64>>,
    /// Derivatives of the velocity at fixed time, m/s per unit of each quantity with respect to which the path is
    /// differentiated.
    pub velocity_by: Vec<Vector3<f64>>,
}

impl Point {
    /// Derivatives of the time at which the path is nearest to the point `to`, s per unit of each quantity with respect
    /// to which the path is differentiated. They follow from the condition that the vector from `to` to the path is
    /// normal to the velocity; `self` must be the nearest point of the path.
    pub fn nearest_time_by(&self, to: Vector3<f64>) -> Vec<f64> {
        let away = self.position - to;
        let slope = self.velocity.norm_squared() + away.dot(&self.acceleration);
        let both = self.position_by.iter().zip(&self.velocity_by);
        both.map(|(p, v)| -(p.dot(&self.velocity) + away.dot(v)) / slope)
            .collect()
    }

    /// Two unit vectors normal to the path: the horizontal one to its left, and the one that points upwards.
    pub fn normals(&self) -> [Vector3<f64>; 2] {
        let along = self.velocity.normalize();
        let left = Vector3::z().cross(&along);
        let left = match left.norm() {
            size if size > 1e-9 => left / size,
            _ => Vector3::y(),
        };
        [left, along.cross(&left)]
    }

    /// Horizontal components of the unit vector to the left of the path.
    pub fn left(&self) -> Vector2<f64> {
        let left = self.normals()[0];
        Vector2::new(left.x, left.y)
    }
}
