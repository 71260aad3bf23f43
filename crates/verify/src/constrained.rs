//! Points at which the constraints of a model's blocks `solve { … }` hold.

use flight::take_lengths;
use model_spec::model::{Expr, Model};
use nalgebra::{DMatrix, DVector};
use oracle::scalar::{Dual, ErrorBound};
use oracle::{Point, Tree};

const MAX_STEPS: usize = 40;

/// Size of a step, relative to the states, below which the constraints hold but for rounding.
const SMALL: f64 = 1e-15;

/// Deviation of a constraint, relative to the magnitude of its terms, that is one of rounding: two units of the last place.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Moves the states to where the constraints and their derivatives hold, by the shortest steps of Newton's method; whether
/// such a place is found.
pub(crate) fn project(model: &Model, point: &mut Point<f64>) -> bool {
    let constraints = model.systems.iter().flat_map(|own| &own.constraints);
    let constraints: Vec<&Expr> = constraints.collect();
    if constraints.is_empty() {
        return true;
    }
    let quaternions: Vec<[usize; 4]> = model.quaternions().collect();
    for _ in 0..MAX_STEPS {
        // A state costs as much as all of this, and a point is often put here again.
        if hold(model, &constraints, point) {
            return true;
        }
        let (deviations, mut by_states) = linearized(model, &constraints, point);
        // Along the sphere of each quaternion, whose length the constraints may depend on.
        take_lengths(&mut by_states, &point.states, &quaternions);
        let step = by_states.svd(true, true).solve(&deviations, 1e-12);
        let Ok(step) = step else { return false };
        let size = DVector::from_column_slice(&point.states).norm();
        for (state, change) in point.states.iter_mut().zip(&step) {
            *state -= change;
        }
        normalize(model, point);
        if step.norm() <= SMALL * size {
            return true;
        }
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

/// Whether the constraints hold at a point but for rounding.
fn hold(model: &Model, constraints: &[&Expr], point: &Point<f64>) -> bool {
    let point = point.lift::<ErrorBound>();
    let tree = Tree::without_unknowns(model, &point, constraints);
    let mut deviations = constraints.iter().map(|constraint| tree.scalar(constraint));
    deviations.all(|own| own.value.abs() <= ROUNDING * own.magnitude)
}

/// Values of the constraints, and their derivatives by the states, one row for each.
fn linearized(
    model: &Model,
    constraints: &[&Expr],
    point: &Point<f64>,
) -> (DVector<f64>, DMatrix<f64>) {
    let mut deviations = DVector::zeros(constraints.len());
    let mut by_states = DMatrix::zeros(constraints.len(), point.states.len());
    for state in 0..point.states.len() {
        let mut moving = point.map(Dual::constant);
        moving.states[state].derivative = 1.0;
        let tree = Tree::without_unknowns(model, &moving, constraints);
        for (row, constraint) in constraints.iter().enumerate() {
            let value = tree.scalar(constraint);
            deviations[row] = value.value;
            by_states[(row, state)] = value.derivative;
        }
    }
    (deviations, by_states)
}
