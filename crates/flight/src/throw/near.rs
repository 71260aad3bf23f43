//! States of many throws of one model, each found from the state of a nearby throw: Newton's method for the attitude,
//! then a linear system for the other states. Throws for which this fails are left to the general search.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::motion::{MotionModel, POINT_VECTORS, VECTORS};
use super::{Throw, ThrowError, ThrownModel};
use crate::functions::{EvaluationPoint, Workspace};

/// Maximum number of unknowns of a linear system in the search for the state of a throw: all states of a rigid body
/// whose attitude is a quaternion (3 of position, 4 of attitude, 6 of velocities).
const UNKNOWNS: usize = 13;
/// Maximum number of steps of Newton's method in the search for the attitude states.
const MAX_STEPS: usize = 20;
/// Maximum angle of a rotation of the body that Newton's method is to find at once, rad; greater rotations are split.
const WIDEST_TURN: f64 = 0.5;
/// Offset of an attitude state to either side in the central differences of the body axes, rad for an angle,
/// dimensionless for a quaternion component.
const DIFFERENCE_STEP: f64 = 1e-5;
/// Tolerance for a state to have the wanted motion. It applies to each component of the body axes, and to each
/// component of position, velocity and angular velocity after division by a scale. The scale is 1 plus the sum of the
/// magnitudes of these vectors in SI units.
const SAME: f64 = 1e-9;

/// Finds the model states for throws that are near a throw whose state is known.
pub struct NearThrows<'m> {
    thrown: &'m ThrownModel,
    /// State of the known throw, from which the search for the state of a similar throw starts.
    near: Vec<f64>,
    /// Indices of the attitude states. The field `linear` contains the indices of the states on which the motion
    /// depends linearly.
    attitude: Vec<usize>,
    linear: Vec<usize>,
    parameters: Vec<f64>,
    prepared: Vec<f64>,
    quantities: Vec<f64>,
    margins: Vec<f64>,
    workspace: Workspace,
}

/// Vectors that describe the motion of the body at a state (position, velocity, body axes, angular velocity and
/// inertia), in the order listed at [`VECTORS`].
#[derive(Clone, Copy)]
struct Vectors([Vector3<f64>; VECTORS]);

impl<'m> NearThrows<'m> {
    /// Prepares the search for the states of throws near a known throw. Newton's method starts at `near`, the state of
    /// the known throw.
    pub fn new(thrown: &'m ThrownModel, near: &[f64]) -> NearThrows<'m> {
        let motion = &thrown.motion;
        let mut attitude = motion.angles.clone();
        attitude.extend(motion.quaternions.iter().flatten());
        let is_linear = |k: &usize| !attitude.contains(k) && !motion.added.contains(k);
        let functions = &motion.compiled.functions;
        NearThrows {
            thrown,
            near: near.to_vec(),
            linear: (0..near.len()).filter(is_linear).collect(),
            attitude,
            // NaN equals no value, so that the first parameters are prepared.
            parameters: vec![f64::NAN],
            prepared: vec![0.0; functions.prepared_len()],
            quantities: vec![0.0; motion.compiled.layout.quantities.len()],
            margins: vec![0.0; motion.compiled.limits.len()],
            workspace: Workspace::default(),
        }
    }

    /// Writes to `state` the state in which the body has the motion of `throw` and its mass centre is above the point
    /// `ground` (x, y), m.
    ///
    /// # Errors
    /// [`ThrowError`] as for [`ThrownModel::state`].
    pub fn state(
        &mut self,
        throw: &Throw,
        ground: [f64; 2],
        parameters: &[f64],
        state: &mut [f64],
    ) -> Result<(), ThrowError> {
        throw.check()?;
        if self.parameters != parameters {
            self.parameters.clear();
            self.parameters.extend_from_slice(parameters);
            let functions = &self.thrown.motion.compiled.functions;
            functions.prepare(parameters, &mut self.prepared);
        }
        if self.find(throw, ground, state).is_none() {
            state.copy_from_slice(&self.thrown.state(throw, ground, parameters)?);
        }
        Ok(())
    }

    /// Finds by Newton's method the state in which the body has the motion of `throw` and its mass centre is above the
    /// point `ground` (x, y), m, and writes it to `state`; `None` if the method does not apply to the model or does not
    /// converge.
    fn find(&mut self, throw: &Throw, ground: [f64; 2], state: &mut [f64]) -> Option<()> {
        let motion = &self.thrown.motion;
        let turns = motion.has_attitude();
        let states_turning = ["nose", "hyzer", "spin", "wobble"];
        if !turns
            && states_turning
                .iter()
                .any(|name| throw.field(name).is_some())
        {
            return None;
        }
        let equations = if turns { 9 } else { 6 };
        if motion.is_revolution || self.linear.len() != equations || self.attitude.len() > UNKNOWNS
        {
            return None;
        }
        state.copy_from_slice(&self.near);
        let axes = throw.attitude().into_inner();
        if turns {
            // A wide rotation is split, since Newton's method finds only nearby attitudes.
            let now = axes_of(&self.vectors(state));
            let turn = Rotation3::from_matrix_unchecked(axes * now.transpose()).scaled_axis();
            let parts = (turn.norm() / WIDEST_TURN).ceil().max(1.0);
            for part in 1..parts as usize {
                let turned = Rotation3::new(turn * (part as f64 / parts));
                self.turn(&(turned * now), state)?;
            }
            self.turn(&axes, state)?;
        }
        let mut at = self.vectors(state);
        let position = Vector3::new(ground[0], ground[1], throw.height);
        let velocity = throw.course() * Vector3::x() * throw.speed;
        let rates = match turns {
            true => rates(throw, &axes, &at)?,
            false => Vector3::zeros(),
        };
        let wanted = [position, velocity, rates];
        let difference = |at: &Vectors| {
            let found = [at.0[0], at.0[1], at.0[5]];
            let mut all = [0.0; UNKNOWNS];
            for k in 0..equations {
                all[k] = wanted[k / 3][k % 3] - found[k / 3][k % 3];
            }
            all
        };
        let mut system = [[0.0; UNKNOWNS + 1]; UNKNOWNS];
        let before = difference(&at);
        for column in 0..equations {
            let own = state[self.linear[column]];
            state[self.linear[column]] = own + 1.0;
            let after = difference(&self.vectors(state));
            state[self.linear[column]] = own;
            for row in 0..equations {
                system[row][column] = before[row] - after[row];
            }
        }
        for row in 0..equations {
            system[row][UNKNOWNS] = before[row];
        }
        let change = solve(&mut system, equations)?;
        for (column, place) in self.linear.iter().enumerate() {
            state[*place] += change[column];
        }
        at = self.vectors(state);
        let scale = 1.0 + throw.speed + rates.norm() + position.norm();
        let is_there = difference(&at).iter().all(|d| d.abs() < SAME * scale);
        let is_turned = !turns || (axes_of(&at) - axes).amax() < SAME;
        (is_there && is_turned && self.is_within_limits(state)).then_some(())
    }

    /// Changes the attitude states in `state` so that the body axes are the columns of `axes`, in the inertial frame,
    /// by Newton's method with slight damping. Whether the method converged is not checked. `None` if the equations are
    /// singular.
    fn turn(&mut self, axes: &Matrix3<f64>, state: &mut [f64]) -> Option<()> {
        let n = self.attitude.len();
        for _ in 0..MAX_STEPS {
            let difference = axes - axes_of(&self.vectors(state));
            if difference.amax() < 1e-13 {
                break;
            }
            let mut slopes = [Matrix3::zeros(); UNKNOWNS];
            for (column, slope) in slopes.iter_mut().enumerate().take(n) {
                let place = self.attitude[column];
                let own = state[place];
                state[place] = own + DIFFERENCE_STEP;
                let ahead = axes_of(&self.vectors(state));
                state[place] = own - DIFFERENCE_STEP;
                let behind = axes_of(&self.vectors(state));
                state[place] = own;
                *slope = (ahead - behind) / (2.0 * DIFFERENCE_STEP);
            }
            let mut system = [[0.0; UNKNOWNS + 1]; UNKNOWNS];
            for row in 0..n {
                for column in 0..n {
                    system[row][column] = slopes[row].dot(&slopes[column]);
                }
                system[row][row] += 1e-6;
                system[row][UNKNOWNS] = slopes[row].dot(&difference);
            }
            let change = solve(&mut system, n)?;
            for (column, place) in self.attitude.iter().enumerate() {
                state[*place] += change[column];
            }
        }
        let motion = &self.thrown.motion;
        for angle in &motion.angles {
            let turn = std::f64::consts::TAU;
            state[*angle] -= turn * (state[*angle] / turn).round();
        }
        for quaternion in &motion.quaternions {
            let length = quaternion.iter().map(|i| state[*i].powi(2)).sum::<f64>();
            let sign = if state[quaternion[0]] < 0.0 {
                -1.0
            } else {
                1.0
            };
            for i in quaternion {
                state[*i] *= sign / length.sqrt();
            }
        }
        Some(())
    }

    fn vectors(&mut self, state: &[f64]) -> Vectors {
        let motion: &MotionModel = &self.thrown.motion;
        let at = EvaluationPoint {
            t: 0.0,
            x: state,
            p: &self.parameters,
            prepared: &self.prepared,
        };
        let functions = &motion.compiled.functions;
        functions.quantities(at, &mut self.workspace, &mut self.quantities);
        let count = if motion.has_attitude() {
            VECTORS
        } else {
            POINT_VECTORS
        };
        let first = self.quantities.len() - 3 * count;
        let mut vectors = [Vector3::zeros(); VECTORS];
        for (vector, own) in vectors.iter_mut().zip(self.quantities[first..].chunks(3)) {
            *vector = Vector3::from_column_slice(own);
        }
        Vectors(vectors)
    }

    fn is_within_limits(&mut self, state: &[f64]) -> bool {
        let compiled = &self.thrown.motion.compiled;
        let at = EvaluationPoint {
            t: 0.0,
            x: state,
            p: &self.parameters,
            prepared: &self.prepared,
        };
        let functions = &compiled.functions;
        functions.limits(at, &mut self.workspace, &mut self.margins);
        let limits = self.margins.iter().zip(&compiled.limits);
        limits.into_iter().all(|(value, (bound, _))| value > bound)
    }
}

fn axes_of(at: &Vectors) -> Matrix3<f64> {
    Matrix3::from_columns(&at.0[2..5])
}

/// Angular velocity of the body in the inertial frame, rad/s, for the spin and wobble of a throw. `axes` contains the
/// body axes as columns, in the inertial frame; `at` contains the inertia tensor. `None` if there is a wobble and the
/// inertia tensor is singular.
fn rates(throw: &Throw, axes: &Matrix3<f64>, at: &Vectors) -> Option<Vector3<f64>> {
    let spin = throw.rotation_rate();
    let wobble = throw.wobble.unwrap_or(0.0).to_radians();
    let axis = axes.column(2);
    if wobble == 0.0 {
        return Some(axis * spin);
    }
    let cone = axis * wobble.cos() + axes.column(0) * wobble.sin();
    let [.., r1, r2, r3, e1, e2, e3] = at.0;
    let inertia = e1 * r1.transpose() + e2 * r2.transpose() + e3 * r3.transpose();
    let along = inertia.try_inverse()? * cone;
    Some(along * (spin / along.dot(&axis)))
}

/// Solves `n` linear equations by Gaussian elimination with pivoting; `None` if they are singular. The first `n` rows
/// of `system` are the equations: coefficients in the first `n` columns, right-hand side in column `UNKNOWNS`. They are
/// overwritten. The solution is in the first `n` entries of the result.
fn solve(system: &mut [[f64; UNKNOWNS + 1]; UNKNOWNS], n: usize) -> Option<[f64; UNKNOWNS]> {
    for k in 0..n {
        let rows = k..n;
        let pivot = rows.max_by(|a, b| system[*a][k].abs().total_cmp(&system[*b][k].abs()))?;
        system.swap(k, pivot);
        let own = system[k];
        if own[k] == 0.0 || !own[k].is_finite() {
            return None;
        }
        for row in system.iter_mut().take(n).skip(k + 1) {
            let factor = row[k] / own[k];
            for (value, own) in row.iter_mut().zip(own).skip(k) {
                *value -= factor * own;
            }
        }
    }
    let mut solution = [0.0; UNKNOWNS];
    for k in (0..n).rev() {
        let row = &system[k];
        let known: f64 = (k + 1..n).map(|j| row[j] * solution[j]).sum();
        solution[k] = (row[UNKNOWNS] - known) / row[k];
    }
    Some(solution)
}
