//! Derivatives of the motion at release, and of the states that have this motion, with respect to the fields of a
//! throw.
//!
//! The state s with the motion of the throw θ satisfies M(s) = W(θ), hence ∂M/∂s · ds/dθ = ∂W/∂θ. The right-hand side
//! is written out below; ∂M/∂s is a sixth-order central difference of the compiled motion, whose error is dominated by
//! rounding.

use nalgebra::{DMatrix, DVector, Vector3};

use super::motion::{BoundMotion, Motion};
use super::{FIELDS, RPM, Throw};

/// Step of a state in the difference formula for the Jacobian, in the unit of the state. A coarse step suffices, since
/// the motion is linear in speeds and rates and polynomial in sines and cosines of angles.
const STEP: f64 = 0.01;
/// Weights of the sixth-order central difference formula, for the differences over 1, 2 and 3 steps to either side.
const WEIGHTS: [f64; 3] = [45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];
/// Minimum ratio of a singular value of the Jacobian to the greatest one. A change of the state with a smaller singular
/// value, such as a change of the length of a quaternion, counts as having no effect on the motion of the body.
const RANK_TOLERANCE: f64 = 1e-9;

impl BoundMotion<'_> {
    /// Jacobian of the motion with respect to the states. Rows: position and velocity, and for a body with attitude
    /// also its three axes and its angular velocity; each has three components in the inertial frame.
    pub fn jacobian(&self, state: &[f64]) -> DMatrix<f64> {
        let rows = stacked(&self.motion(state)).len();
        let mut jacobian = DMatrix::zeros(rows, state.len());
        let mut moved = state.to_vec();
        for (column, &own) in state.iter().enumerate() {
            let mut at = |offset: f64| {
                moved[column] = own + offset;
                let motion = stacked(&self.motion(&moved));
                moved[column] = own;
                motion
            };
            let mut slope = DVector::zeros(rows);
            for (k, weight) in WEIGHTS.into_iter().enumerate() {
                let offset = (k + 1) as f64 * STEP;
                slope += (at(offset) - at(-offset)) * (weight / STEP);
            }
            jacobian.set_column(column, &slope);
        }
        jacobian
    }

    /// Derivatives of `state`, which has the motion of `throw`, with respect to the fields of the throw: one row per
    /// state, one column per entry of [`FIELDS`], in the unit of the state per unit of the field. Columns of fields
    /// that a body without attitude lacks are 0.
    pub fn state_by_throw(&self, throw: &Throw, state: &[f64]) -> DMatrix<f64> {
        let motion = self.motion(state);
        // Angular velocity in body axes for a spin of 1 rad/s, and its derivative with respect to the wobble.
        let turning = motion.turning.as_ref();
        let unit = turning.map(|_| self.rates_of_spin(throw, state));
        let course = throw.course();
        let up = Vector3::z();
        let axes = throw.attitude();
        let turns = [
            ("heading", up),
            ("launch", -(course * Vector3::y())),
            ("hyzer", -(course * Vector3::x())),
            ("nose", -(axes * Vector3::y())),
        ];
        let per_degree = 1f64.to_radians();
        let mut wanted = DMatrix::zeros(stacked(&motion).len(), FIELDS.len());
        for (column, (name, ..)) in FIELDS.into_iter().enumerate() {
            let mut change = Change::default();
            match name {
                "speed" => change.velocity = motion.velocity / throw.speed,
                "height" => change.position = up,
                "spin" => {
                    if let Some((rates, _)) = unit {
                        change.rates = axes * rates * -RPM;
                    }
                }
                "wobble" => {
                    if let Some((_, slope)) = unit {
                        let spin = throw.rotation_rate();
                        change.rates = axes * slope * (spin * per_degree);
                    }
                }
                _ => {
                    let turn = turns.iter().find(|(turn, _)| *turn == name);
                    let about = turn.map_or(Vector3::zeros(), |(_, axis)| axis * per_degree);
                    if name == "heading" || name == "launch" {
                        change.velocity = about.cross(&motion.velocity);
                    }
                    if let Some(turning) = &motion.turning {
                        change.axes =
                            [0, 1, 2].map(|k| about.cross(&turning.axes.column(k).into_owned()));
                        change.rates = about.cross(&turning.rates);
                    }
                }
            }
            let rows = change.stacked(motion.turning.is_some());
            wanted.set_column(column, &rows);
        }
        self.states_moved(state, &wanted)
    }

    /// Minimum-norm changes of the state that cause given changes of the motion. Each column of `wanted` is one change
    /// of the motion, with the rows of [`jacobian`](Self::jacobian); the same column of the result is the change of the
    /// state.
    pub fn states_moved(&self, state: &[f64], wanted: &DMatrix<f64>) -> DMatrix<f64> {
        let mut jacobian = self.jacobian(state);
        let mut wanted = wanted.clone();
        for added in &self.model.added {
            jacobian.column_mut(*added).fill(0.0);
        }
        if self.model.is_revolution {
            // The first two axes are not fixed in the body.
            for row in 6..12 {
                jacobian.row_mut(row).fill(0.0);
                wanted.row_mut(row).fill(0.0);
            }
        }
        let svd = jacobian.svd(true, true);
        let largest = svd.singular_values.max();
        svd.solve(&wanted, RANK_TOLERANCE * largest)
            .unwrap_or_else(|_| DMatrix::zeros(state.len(), wanted.ncols()))
    }

    /// Angular velocity of the body in body axes, rad/s, for a spin of 1 rad/s about the third axis and the wobble of
    /// `throw` (angle between body axis and angular momentum). Also returns the derivative with respect to the wobble,
    /// rad/s per rad.
    fn rates_of_spin(&self, throw: &Throw, state: &[f64]) -> (Vector3<f64>, Vector3<f64>) {
        let axes = throw.attitude();
        let wobble = throw.wobble.unwrap_or(0.0).to_radians();
        let inertia = self
            .inertia(state)
            .unwrap_or_else(nalgebra::Matrix3::identity);
        let own = axes.inverse().matrix() * inertia * axes.matrix();
        let inverse = own
            .try_inverse()
            .unwrap_or_else(nalgebra::Matrix3::identity);
        let along = inverse * Vector3::new(wobble.sin(), 0.0, wobble.cos());
        let slope = inverse * Vector3::new(wobble.cos(), 0.0, -wobble.sin());
        let rates = along / along.z;
        (rates, (slope - rates * slope.z) / along.z)
    }
}

/// Small change of a motion, or its derivative with respect to a field of a throw: position (m), velocity (m/s), the
/// three body axes (unit vectors) and angular velocity (rad/s), all by their components in the inertial frame.
#[derive(Default)]
struct Change {
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    axes: [Vector3<f64>; 3],
    rates: Vector3<f64>,
}

impl Change {
    fn stacked(&self, has_attitude: bool) -> DVector<f64> {
        let mut all = vec![self.position, self.velocity];
        if has_attitude {
            all.extend(self.axes);
            all.push(self.rates);
        }
        DVector::from_iterator(3 * all.len(), all.iter().flat_map(|v| v.iter().copied()))
    }
}

/// Stacks the components of a motion: position and velocity, and for a body with attitude also its three axes and its
/// angular velocity.
fn stacked(motion: &Motion) -> DVector<f64> {
    let change = Change {
        position: motion.position,
        velocity: motion.velocity,
        axes: motion
            .turning
            .as_ref()
            .map_or_else(Default::default, |turning| {
                [0, 1, 2].map(|k| turning.axes.column(k).into_owned())
            }),
        rates: motion
            .turning
            .as_ref()
            .map_or(Vector3::zeros(), |turning| turning.rates),
    };
    change.stacked(motion.turning.is_some())
}
