//! A point of a path, with derivatives.

use nalgebra::{Vector2, Vector3};

/// Point of a path at a time, SI units, inertial frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Time since release, s.
    pub t: f64,
    /// Position of the mass centre, m.
    pub position: Vector3<f64>,
    /// Velocity of the mass centre, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration of the mass centre, m/s².
    pub acceleration: Vector3<f64>,
    /// Derivatives of the position at this time, m per unit of each quantity.
    pub position_by: Vec<Vector3<f64>>,
    /// Derivatives of the velocity at this time, m/s per unit of each quantity.
    pub velocity_by: Vec<Vector3<f64>>,
}

impl Point {
    /// Derivative of the time at which the path passes nearest to a place, s per unit of each quantity: (P − X)·v = 0 holds there.
    pub fn nearest_time_by(&self, to: Vector3<f64>) -> Vec<f64> {
        let away = self.position - to;
        let slope = self.velocity.norm_squared() + away.dot(&self.acceleration);
        let both = self.position_by.iter().zip(&self.velocity_by);
        both.map(|(p, v)| -(p.dot(&self.velocity) + away.dot(v)) / slope)
            .collect()
    }

    /// Two unit vectors normal to the path: to its left, horizontal, and upwards.
    pub fn normals(&self) -> [Vector3<f64>; 2] {
        let along = self.velocity.normalize();
        let left = Vector3::z().cross(&along);
        let left = match left.norm() {
            size if size > 1e-9 => left / size,
            _ => Vector3::y(),
        };
        [left, along.cross(&left)]
    }

    /// Unit vector to the left of the path over the ground.
    pub fn left(&self) -> Vector2<f64> {
        let left = self.normals()[0];
        Vector2::new(left.x, left.y)
    }
}
