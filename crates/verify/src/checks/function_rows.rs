//! Rows and directions for the comparison of compiled functions with the model's vector expressions.

use codegen::program::Function;
use model_spec::model::{FrameKind, Model};
use oracle::scalar::Field;
use std::ops::Range;

/// Describes the results of a compiled function: the range of its rows, the name of the section with its values, and
/// the names of the sections with its Jacobians with respect to states and to parameters. The rows of a model are its
/// scalar results: `all` rows, of which the first `states` are state derivatives, the others components of the
/// observation.
pub(crate) fn sections(
    function: &Function,
    states: usize,
    all: usize,
) -> (Range<usize>, &'static str, [&'static str; 2]) {
    match function.name.starts_with('f') {
        true => (0..states, "dx", ["j", "jp"]),
        false => (states..all, "y", ["dy_dx", "dy_dp"]),
    }
}

/// Derivative of one scalar result of a compiled function (row `row` of its Jacobians) with respect to the variable
/// with the given index (states first, then parameters); for a state, along `direction` in state space. It is computed
/// from the Jacobian entries in `values`, which contains all outputs of the function. The array contains the names of
/// the Jacobians by state and by parameter. `None` if the function does not compute the required Jacobian.
pub(crate) fn along<T: Field>(
    function: &Function,
    values: &[T],
    [by_state, by_parameter]: [&str; 2],
    row: usize,
    variable: usize,
    direction: &[T],
) -> Option<T> {
    let states = direction.len();
    let section = if variable < states {
        by_state
    } else {
        by_parameter
    };
    if !function.sections.iter().any(|s| s.name == section) {
        return None;
    }
    let entries = function
        .pattern(section)
        .iter()
        .zip(&values[function.range(section)]);
    let of_row = entries.filter(|((r, _), _)| *r as usize == row);
    let weight = |column: usize| match variable.checked_sub(states) {
        None => direction[column],
        Some(parameter) if parameter == column => T::one(),
        Some(_) => T::zero(),
    };
    Some(of_row.fold(T::zero(), |sum, ((_, column), &value)| {
        sum + value * weight(*column as usize)
    }))
}

/// Direction of differentiation in state space: a unit vector, projected onto the tangent space of the unit sphere for
/// a component of a quaternion; zero for a parameter.
pub(crate) fn direction<T: Field>(model: &Model, states: &[T], variable: usize) -> Vec<T> {
    let mut out = vec![T::zero(); states.len()];
    if let Some(component) = out.get_mut(variable) {
        *component = T::one();
    }
    for frame in &model.frames {
        if let FrameKind::Quaternion { states: q, .. } = frame.kind
            && q.contains(&variable)
        {
            for k in q {
                out[k] -= states[variable] * states[k];
            }
        }
    }
    out
}

pub(crate) fn row_name(model: &Model, row: usize) -> String {
    match model.states.get(row) {
        Some(state) => format!("der({})", state.name),
        None => format!("observation {}", row - model.states.len() + 1),
    }
}
