//! Rows and directions for the comparison of compiled functions with the model's vector expressions.

use codegen::Compiled;
use codegen::program::Function;
use model_spec::model::{FrameKind, Model};
use oracle::scalar::{Dual, Field, Real};
use oracle::{Point, Reference, Tree, Unsupported, derivatives_of};
use std::ops::Range;

pub(crate) fn functions(compiled: &Compiled) -> [&Function; 5] {
    [
        &compiled.f,
        &compiled.f_jac,
        &compiled.f_jac_par,
        &compiled.observe,
        &compiled.observe_jac,
    ]
}

/// A state or parameter with respect to which the results of compiled functions are differentiated.
pub(crate) struct Variable<'a, T> {
    /// Name of the state or parameter.
    pub name: &'a str,
    /// Index of the variable in the list of all states, followed by all parameters.
    pub index: usize,
    /// Direction of differentiation in state space: a unit vector, projected onto the tangent space of the unit sphere
    /// for a component of a quaternion; zero for a parameter.
    pub direction: Vec<T>,
}

impl<'a, T> Variable<'a, T> {
    /// The variable with another direction.
    pub fn along<U>(&self, direction: Vec<U>) -> Variable<'a, U> {
        Variable {
            name: self.name,
            index: self.index,
            direction,
        }
    }
}

pub(crate) fn variables<'a, T: Field>(
    model: &Model,
    compiled: &'a Compiled,
    states: &[T],
) -> Vec<Variable<'a, T>> {
    let layout = &compiled.layout;
    let names = layout.states.iter().chain(&layout.parameters).enumerate();
    let variable = |(index, name): (usize, &'a String)| Variable {
        name,
        index,
        direction: direction(model, states, index),
    };
    names.map(variable).collect()
}

pub(crate) fn law<T: Real>(
    model: &Model,
    point: &Point<T>,
    variable: &Variable<'_, T>,
) -> Option<Vec<Dual<T>>> {
    tree_column(model, &moving_along(point, variable)).ok()
}

/// The point with derivatives with respect to a variable.
pub(crate) fn moving_along<T: Real>(
    point: &Point<T>,
    variable: &Variable<'_, T>,
) -> Point<Dual<T>> {
    let mut moving = point.map(Dual::constant);
    for (state, &d) in moving.states.iter_mut().zip(&variable.direction) {
        state.derivative = d;
    }
    let parameter = variable.index.checked_sub(point.states.len());
    if let Some(value) = parameter.and_then(|k| moving.parameters_mut().nth(k)) {
        value.derivative = T::one();
    }
    moving
}

/// A scalar result of a compiled function, and its derivative with respect to a variable.
pub(crate) struct Value<'a, T> {
    model: &'a Model,
    function: &'static str,
    variable: &'a str,
    /// Index of the result among the state derivatives, followed by the components of the observation.
    pub row: usize,
    /// The result itself.
    pub found: T,
    /// Derivative of the result; `None` if the function does not compute it.
    pub derivative: Option<T>,
}

impl<T> Value<'_, T> {
    /// Name of the result, such as `der(v) in f_jac`.
    pub fn name(&self) -> String {
        format!("{} in {}", row_name(self.model, self.row), self.function)
    }

    /// Name of the derivative, such as `∂der(v)/∂m in f_jac_par`.
    pub fn entry(&self) -> String {
        let (row, variable) = (row_name(self.model, self.row), self.variable);
        format!("∂{row}/∂{variable} in {}", self.function)
    }
}

/// Results of compiled functions, given with all their outputs, and their derivatives with respect to a variable;
/// `rows` is the number of results of the model.
pub(crate) fn compared<'a, T: Field>(
    model: &'a Model,
    results: &[(&Function, Vec<T>)],
    variable: &Variable<'a, T>,
    rows: usize,
) -> Vec<Value<'a, T>> {
    let mut out = Vec::new();
    for (function, values) in results {
        let (rows, section, jacobians) = sections(function, model.states.len(), rows);
        let found = rows.zip(&values[function.range(section)]).enumerate();
        out.extend(found.map(|(k, (row, &found))| Value {
            model,
            function: function.name,
            variable: variable.name,
            row,
            found,
            derivative: along(function, values, jacobians, k, variable),
        }));
    }
    out
}

/// Names of results and derivatives that differ from the `expected` values.
pub(crate) fn differences<T: Field>(
    model: &Model,
    results: &[(&Function, Vec<T>)],
    variable: &Variable<'_, T>,
    expected: &[Dual<T>],
    differ: &dyn Fn(T, T) -> bool,
) -> Vec<String> {
    let mut faults = Vec::new();
    for value in compared(model, results, variable, expected.len()) {
        let expected = expected[value.row];
        if differ(value.found, expected.value) {
            faults.push(value.name());
        }
        if { value.derivative }.is_some_and(|found| differ(found, expected.derivative)) {
            faults.push(value.entry());
        }
    }
    faults
}

/// Outputs of a compiled function: range of its results among the `all` results of the model, name of their group, and
/// names of the groups of Jacobians by states and by parameters.
fn sections(
    function: &Function,
    states: usize,
    all: usize,
) -> (Range<usize>, &'static str, [&'static str; 2]) {
    match function.name.starts_with('f') {
        true => (0..states, "dx", ["j", "jp"]),
        false => (states..all, "y", ["dy_dx", "dy_dp"]),
    }
}

/// Derivative of the result `row` of a function with the outputs `values`; the array contains the names of its
/// Jacobians. `None` if the function has no such Jacobian.
fn along<T: Field>(
    function: &Function,
    values: &[T],
    [by_state, by_parameter]: [&str; 2],
    row: usize,
    variable: &Variable<'_, T>,
) -> Option<T> {
    let states = variable.direction.len();
    let section = if variable.index < states {
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
    let weight = |column: usize| match variable.index.checked_sub(states) {
        None => variable.direction[column],
        Some(parameter) if parameter == column => T::one(),
        Some(_) => T::zero(),
    };
    // An entry that overflows must not spoil directions to which it does not contribute.
    let terms = of_row.map(|((_, column), &value)| (value, weight(*column as usize)));
    let terms = terms.filter(|(_, weight)| !weight.is_zero());
    Some(terms.fold(T::zero(), |sum, (value, weight)| sum + value * weight))
}

/// Direction of differentiation in state space: a unit vector, projected onto the tangent space of the unit sphere for
/// a component of a quaternion; zero for a parameter. `variable` is an index in the list of all states, followed by all
/// parameters.
pub(crate) fn direction<T: Field>(model: &Model, states: &[T], variable: usize) -> Vec<T> {
    let mut out = vec![T::zero(); states.len()];
    if let Some(component) = out.get_mut(variable) {
        *component = T::one();
    }
    for frame in &model.frames {
        if let FrameKind::Quaternion { states: q, .. } = frame.kind
            && q.contains(&variable)
        {
            // Not 1 − q², of which nothing is left near an attitude that is no turn.
            let others = q.into_iter().filter(|k| *k != variable);
            out[variable] = others
                .clone()
                .fold(T::zero(), |sum, k| sum + states[k] * states[k]);
            for k in others {
                out[k] = -(states[variable] * states[k]);
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

/// State derivatives and observation from the vector expressions.
pub(crate) fn tree_column<T: Real>(model: &Model, point: &Point<T>) -> Result<Vec<T>, Unsupported> {
    let tree = Tree::new(model, point);
    let mut out = derivatives_of(&tree)?;
    if let Some(observed) = &model.observation {
        out.extend(tree.vector(&observed.value).iter());
    }
    Ok(out)
}

pub(crate) fn reference_column<T: Real>(
    reference: &Reference,
    model: &Model,
    point: &Point<T>,
) -> Vec<T> {
    let mut out = reference.derivatives(point);
    if model.observation.is_some() {
        out.extend(reference.observation(point).iter());
    }
    out
}
