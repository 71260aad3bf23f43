//! Derivatives of the motion at release, and of the states that have this motion, with respect to the fields of a
//! throw.
//!
//! The state s with the motion of the throw θ satisfies M(s) = W(θ), hence ∂M/∂s · ds/dθ = ∂W/∂θ. The right-hand side
//! is written out below; ∂M/∂s is a sixth-order central difference of the compiled motion, whose error is dominated by
//! rounding.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::motion::{BoundMotion, with_offset};
use super::{FIELDS, RPM, Throw};
use crate::moore_penrose;

/// Step of a state in the differences for the Jacobian; coarse, as the motion is linear or polynomial in sines.
const STEP: f64 = 0.01;
/// Weights of the sixth-order central difference formula, for the differences over 1, 2 and 3 steps to either side.
const WEIGHTS: [f64; 3] = [45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];
/// Minimum ratio of a singular value of the Jacobian to the greatest one.
const RANK_TOLERANCE: f64 = 1e-9;

impl BoundMotion<'_> {
    /// Components of the motion: of position, velocity, and with attitude of the three axes and the rates.
    fn components(&self) -> usize {
        if self.model.has_attitude() { 18 } else { 6 }
    }

    /// Jacobian of the motion with respect to the states. Rows: position and velocity, and for a body with attitude
    /// also its three axes and its angular velocity; each has three components in the inertial frame.
    pub fn jacobian(&self, state: &[f64]) -> DMatrix<f64> {
        let rows = self.components();
        let stacked = |state: &[f64]| stacked(rows, &self.vectors(state).0);
        let mut jacobian = DMatrix::zeros(rows, state.len());
        let mut moved = state.to_vec();
        for column in 0..state.len() {
            let mut slope = DVector::zeros(rows);
            for (k, weight) in WEIGHTS.into_iter().enumerate() {
                let offset = (k + 1) as f64 * STEP;
                let ahead = with_offset(&mut moved, column, offset, stacked);
                let behind = with_offset(&mut moved, column, -offset, stacked);
                slope += (ahead - behind) * (weight / STEP);
            }
            jacobian.set_column(column, &slope);
        }
        jacobian
    }

    /// Derivatives of `state`, which has the motion of `throw`, by the fields of the throw: one row per state, one
    /// column per entry of [`FIELDS`], 0 for those that the body lacks.
    pub fn state_by_throw(&self, throw: &Throw, state: &[f64]) -> DMatrix<f64> {
        let [_, velocity, first, second, third, rates, ..] = self.vectors(state).0;
        let (spin, spin_by_wobble) = self.rates_of_spin(throw, state);
        let (course, axes) = (throw.course(), throw.attitude());
        let per_degree = 1f64.to_radians();
        let mut wanted = DMatrix::zeros(self.components(), FIELDS.len());
        for (column, (name, ..)) in FIELDS.into_iter().enumerate() {
            // Change of a motion that turns about an axis, without the body or with it.
            let turned = |axis: Vector3<f64>, velocity: Vector3<f64>| {
                let about = axis * per_degree;
                let turning = [velocity, first, second, third, rates].map(|v| about.cross(&v));
                let [velocity, first, second, third, rates] = turning;
                [Vector3::zeros(), velocity, first, second, third, rates]
            };
            let (none, mut change) = (Vector3::zeros(), [Vector3::zeros(); 6]);
            match name {
                "speed" => change[1] = velocity / throw.speed,
                "height" => change[0] = Vector3::z(),
                "spin" => change[5] = axes * spin * -RPM,
                "wobble" => {
                    change[5] = axes * spin_by_wobble * (throw.rotation_rate() * per_degree);
                }
                "heading" => change = turned(Vector3::z(), velocity),
                "launch" => change = turned(-(course * Vector3::y()), velocity),
                "hyzer" => change = turned(-(course * Vector3::x()), none),
                _ => change = turned(-(axes * Vector3::y()), none),
            }
            wanted.set_column(column, &stacked(self.components(), &change));
        }
        self.states_moved(state, &wanted)
    }

    /// Minimum-norm changes of the state, one column each, for the changes of the motion in the columns of `wanted`,
    /// with the rows of [`jacobian`](Self::jacobian).
    pub fn states_moved(&self, state: &[f64], wanted: &DMatrix<f64>) -> DMatrix<f64> {
        let mut jacobian = self.jacobian(state);
        let mut wanted = wanted.clone();
        for added in &self.model.added {
            jacobian.column_mut(*added).fill(0.0);
        }
        if self.model.has_attitude() {
            // Of a mere axis of revolution, the other two axes are not fixed in the body.
            let free = (0..3).filter(|axis| !self.model.fixed_axes.contains(axis));
            for row in free.flat_map(|axis| 6 + 3 * axis..9 + 3 * axis) {
                jacobian.row_mut(row).fill(0.0);
                wanted.row_mut(row).fill(0.0);
            }
        }
        moore_penrose(&jacobian, RANK_TOLERANCE) * wanted
    }

    /// Angular velocity in body axes, rad/s, for a rate of 1 rad/s about [`Turning::axis`](super::Turning::axis) and the
    /// wobble of `throw`, and its derivative by the wobble.
    fn rates_of_spin(&self, throw: &Throw, state: &[f64]) -> (Vector3<f64>, Vector3<f64>) {
        let axes = throw.attitude();
        let wobble = throw.wobble.unwrap_or(0.0).to_radians();
        let inertia = self.inertia(state).unwrap_or_else(Matrix3::identity);
        let own = axes.inverse().matrix() * inertia * axes.matrix();
        let inverse = own.try_inverse().unwrap_or_else(Matrix3::identity);
        let (sin, cos) = wobble.sin_cos();
        let (along, slope, about) = match self.model.is_along {
            true => (
                Vector3::new(-cos, 0.0, sin),
                Vector3::new(sin, 0.0, cos),
                -Vector3::x(),
            ),
            false => (
                Vector3::new(sin, 0.0, cos),
                Vector3::new(cos, 0.0, -sin),
                Vector3::z(),
            ),
        };
        let (along, slope) = (inverse * along, inverse * slope);
        let whole = along.dot(&about);
        let rates = along / whole;
        (rates, (slope - rates * slope.dot(&about)) / whole)
    }
}

/// The first `rows` components of vectors that follow one another.
fn stacked(rows: usize, vectors: &[Vector3<f64>]) -> DVector<f64> {
    let components = vectors.iter().flat_map(|v| v.iter().copied());
    DVector::from_iterator(rows, components.take(rows))
}
