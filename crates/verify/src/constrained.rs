//! Points at which the constraints of a model's blocks `solve { … }` hold.

use flight::{moore_penrose, take_lengths};
use model_spec::model::{Expr, Model};
use nalgebra::{DMatrix, DVector};
use oracle::scalar::{Dual, ErrorBound};
use oracle::{Point, Tree};

/// Maximum number of steps; of those with derivatives of their own, as many are allowed by default.
const MAX_STEPS: usize = 40;

/// Size of a step, relative to the states, below which the constraints hold but for rounding.
const SMALL: f64 = 1e-15;

/// Size of a step, relative to the states and to the step before, at which the derivatives of that step do for the next:
/// they cost as much as the constraints themselves do for each state.
const CLOSING_IN: f64 = 0.1;

/// Singular value, relative to the greatest, up to which constraints count as saying the same.
const RANK_TOLERANCE: f64 = 1e-12;

/// Deviation of a constraint, relative to the magnitude of its terms, that is one of rounding: two units of the last place.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Moves the states to where the constraints and their derivatives hold, by the shortest steps of Newton's method; whether
/// such a place is found.
pub(crate) fn project(model: &Model, point: &mut Point<f64>) -> bool {
    project_within(model, point, MAX_STEPS)
}

/// As [`project`], with at most `most` evaluations of the derivatives.
pub(crate) fn project_within(model: &Model, point: &mut Point<f64>, most: usize) -> bool {
    let constraints = model.systems.iter().flat_map(|own| &own.constraints);
    let constraints: Vec<&Expr> = constraints.collect();
    if constraints.is_empty() {
        return true;
    }
    let quaternions: Vec<[usize; 4]> = model.quaternions().collect();
    let (mut linear, mut last) = (None, f64::INFINITY);
    let mut left = most;
    for _ in 0..MAX_STEPS {
        let deviations = deviations(model, &constraints, point);
        if deviations.iter().all(is_rounding) {
            return true;
        }
        if linear.is_none() && left == 0 {
            return false;
        }
        let of_states = linear.take().unwrap_or_else(|| {
            left -= 1;
            let mut by_states = by_states(model, &constraints, point);
            // Along the sphere of each quaternion, whose length the constraints may depend on.
            take_lengths(&mut by_states, &point.states, &quaternions);
            moore_penrose(&by_states, RANK_TOLERANCE)
        });
        let deviations = deviations.iter().map(|own| own.value);
        let deviations = DVector::from_iterator(constraints.len(), deviations);
        let step = &of_states * deviations;
        let size = DVector::from_column_slice(&point.states).norm();
        for (state, change) in point.states.iter_mut().zip(&step) {
            *state -= change;
        }
        normalize(model, point);
        let length = step.norm();
        if length <= SMALL * size {
            return true;
        }
        let closes_in = length <= CLOSING_IN * size && length <= CLOSING_IN * last;
        linear = closes_in.then_some(of_states);
        last = length;
    }
    false
}

/// Scales the attitude quaternions of a point to norm 1.
pub(crate) fn normalize(model: &Model, point: &mut Point<f64>) {
    for quaternion in model.quaternions() {
        let squares = quaternion.iter().map(|&i| point.states[i].powi(2));
        let length = squares.sum::<f64>().sqrt();
        for i in quaternion {
            point.states[i] /= length;
        }
    }
}

/// Whether a deviation is one of rounding.
fn is_rounding(deviation: &ErrorBound) -> bool {
    deviation.value.abs() <= ROUNDING * deviation.magnitude
}

/// Values of the constraints, with the magnitudes of their terms.
fn deviations(model: &Model, constraints: &[&Expr], point: &Point<f64>) -> Vec<ErrorBound> {
    let point = point.lift::<ErrorBound>();
    let tree = Tree::without_unknowns(model, &point, constraints);
    constraints.iter().map(|own| tree.scalar(own)).collect()
}

/// Derivatives of the constraints by the states, one row for each constraint.
fn by_states(model: &Model, constraints: &[&Expr], point: &Point<f64>) -> DMatrix<f64> {
    let mut by_states = DMatrix::zeros(constraints.len(), point.states.len());
    for state in 0..point.states.len() {
        let mut moving = point.map(Dual::constant);
        moving.states[state].derivative = 1.0;
        let tree = Tree::without_unknowns(model, &moving, constraints);
        for (row, constraint) in constraints.iter().enumerate() {
            by_states[(row, state)] = tree.scalar(constraint).derivative;
        }
    }
    by_states
}
