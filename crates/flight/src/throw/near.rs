//! States of many throws of one model, each found from the state of a nearby throw: Newton's method for the attitude,
//! then a linear system for the other states. Throws for which this fails are left to the general search.

use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3};

use super::motion::{BoundMotion, with_offset};
use super::{Throw, ThrowError, ThrownModel};

/// Maximum number of attitude states; the general search finds the states of models with more.
const MAX_ATTITUDE: usize = 6;
const MAX_STEPS: usize = 20;
/// Maximum angle of a rotation of the body that Newton's method is to find at once, rad; greater rotations are split.
const WIDEST_TURN: f64 = 0.5;
/// Offset of an attitude state in the central differences of the body axes, rad, or 1 for a quaternion.
const DIFFERENCE_STEP: f64 = 1e-5;
/// Tolerance for a state to have the wanted motion.
const SAME: f64 = 1e-9;

/// Finds the model states for throws that are near a throw whose state is known.
pub struct NearThrows<'m> {
    thrown: &'m ThrownModel,
    /// State of the known throw, from which the search starts.
    near: Vec<f64>,
    /// Indices of the attitude states.
    attitude: Vec<usize>,
    /// Indices of the states on which the motion depends linearly.
    linear: Vec<usize>,
    /// Parameters of the last throw, and the motion bound to them.
    bound: Option<(Vec<f64>, BoundMotion<'m>)>,
}

impl<'m> NearThrows<'m> {
    /// Prepares the search near a known throw, from whose state `near` Newton's method starts.
    pub fn new(thrown: &'m ThrownModel, near: &[f64]) -> NearThrows<'m> {
        let mut attitude = thrown.angles.clone();
        attitude.extend(thrown.quaternions.iter().flatten());
        let is_linear = |k: &usize| !attitude.contains(k) && !thrown.added.contains(k);
        NearThrows {
            thrown,
            near: near.to_vec(),
            linear: (0..near.len()).filter(is_linear).collect(),
            attitude,
            bound: None,
        }
    }

    /// Writes to `state` the one with the motion of `throw` and its mass centre above `ground` (x, y), m.
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
        self.thrown.check(throw)?;
        let last = self.bound.take().filter(|(last, _)| last == parameters);
        let bind = || (parameters.to_vec(), self.thrown.bind(parameters));
        let (parameters, bound) = last.unwrap_or_else(bind);
        if self.find(&bound, throw, ground, state).is_none() {
            state.copy_from_slice(&self.thrown.state(throw, ground, &parameters)?);
        }
        self.bound = Some((parameters, bound));
        Ok(())
    }

    fn find(
        &self,
        bound: &BoundMotion<'_>,
        throw: &Throw,
        ground: [f64; 2],
        state: &mut [f64],
    ) -> Option<()> {
        let thrown = self.thrown;
        let turns = thrown.has_attitude();
        let equations = if turns { 9 } else { 6 };
        let is_small = self.attitude.len() <= MAX_ATTITUDE;
        if thrown.fixed_axes.len() < 3 || self.linear.len() != equations || !is_small {
            return None;
        }
        state.copy_from_slice(&self.near);
        let axes = throw.attitude().into_inner();
        if turns {
            // A wide rotation is split, since Newton's method finds only nearby attitudes.
            let now = bound.vectors(state).axes();
            let turn = Rotation3::from_matrix_unchecked(axes * now.transpose()).scaled_axis();
            let parts = (turn.norm() / WIDEST_TURN).ceil().max(1.0);
            for part in 1..parts as usize {
                let turned = Rotation3::new(turn * (part as f64 / parts));
                self.turn(bound, &(turned * now), state)?;
            }
            self.turn(bound, &axes, state)?;
        }
        let mut rates = Vector3::zeros();
        if turns {
            let inertia = || Some(bound.vectors(state).inertia());
            rates = throw.rates(&axes, thrown.is_along, inertia)?;
        }
        let place = throw.motion(ground, false, thrown.is_along);
        let wanted = [(0, place.position), (1, place.velocity), (5, rates)];
        let difference = |state: &[f64]| {
            let mut all = SVector::<f64, 9>::zeros();
            let found = bound.vectors(state);
            for (row, (k, wanted)) in (0..).step_by(3).zip(wanted) {
                all.fixed_rows_mut::<3>(row)
                    .copy_from(&(wanted - found.0[k]));
            }
            all
        };
        let before = difference(state);
        // A point mass has no rates: the last three equations are those of the identity.
        let mut system = SMatrix::<f64, 9, 9>::identity();
        for (column, &place) in self.linear.iter().enumerate() {
            let after = with_offset(state, place, 1.0, difference);
            system.set_column(column, &(before - after));
        }
        let change = system.lu().solve(&before)?;
        for (place, change) in self.linear.iter().zip(&change) {
            state[*place] += change;
        }
        let scale = 1.0 + throw.speed + rates.norm() + place.position.norm();
        let is_there = difference(state).iter().all(|d| d.abs() < SAME * scale);
        let is_turned = !turns || (bound.vectors(state).axes() - axes).amax() < SAME;
        (is_there && is_turned && bound.is_within_limits(state)).then_some(())
    }

    /// Changes the attitude states so that the body axes are the columns of `axes`, by slightly damped Newton steps.
    fn turn(&self, bound: &BoundMotion<'_>, axes: &Matrix3<f64>, state: &mut [f64]) -> Option<()> {
        let seen = |state: &[f64]| bound.vectors(state).axes();
        for _ in 0..MAX_STEPS {
            let difference = axes - seen(state);
            if difference.amax() < 1e-13 {
                break;
            }
            let mut slopes = SMatrix::<f64, 9, MAX_ATTITUDE>::zeros();
            for (column, &place) in self.attitude.iter().enumerate() {
                let ahead = with_offset(state, place, DIFFERENCE_STEP, seen);
                let behind = with_offset(state, place, -DIFFERENCE_STEP, seen);
                let slope = (ahead - behind) / (2.0 * DIFFERENCE_STEP);
                slopes.column_mut(column).copy_from_slice(slope.as_slice());
            }
            let damping = SMatrix::from_diagonal_element(1e-6);
            let normal = slopes.tr_mul(&slopes) + damping;
            let right = slopes.tr_mul(&SVector::<f64, 9>::from_column_slice(difference.as_slice()));
            let change = normal.cholesky()?.solve(&right);
            for (place, change) in self.attitude.iter().zip(&change) {
                state[*place] += change;
            }
        }
        self.thrown.normalise(state);
        Some(())
    }
}
