//! Compares all of f, J, Jp and the observation in 256-bit arithmetic: the compiled functions with the vector tree of
//! the declared law and its dual numbers, at states of the model. Only constants that the code rounds to f64 may cause
//! differences.

use super::derivatives::tree_column;
use super::function_rows::{along, direction, row_name, sections};
use crate::random::Random;
use crate::rounding::big::{Big, with_numbers};
use crate::rounding::program::{Inputs, magnitudes, outputs};
use crate::sample;
use codegen::Compiled;
use codegen::program::Function;
use model_spec::model::Model;
use oracle::Point;
use oracle::scalar::{Dual, ErrorBound, Real};

/// Number of points at which the functions are compared. It is more than one so that functions with branches are likely
/// to be compared on every branch.
const POINTS: usize = 8;
/// Maximum number of random draws to find a point at which rounding cannot change the result of a branch, such as that
/// of abs.
const DRAWS: usize = 30;
/// Maximum difference between compiled code and model, relative to the magnitude of the terms. It is about a thousand
/// times the error of a constant that the code rounds to f64.
const TOLERANCE: f64 = 1e-13;

/// Values of a compiled function in 256-bit arithmetic. For each value, `bounds` contains the sum of the magnitudes of
/// the terms that are added to give it.
struct Evaluated<'a> {
    function: &'a Function,
    values: Vec<Big>,
    bounds: Vec<ErrorBound>,
}

/// Names of the values and derivatives in which the compiled functions differ from the model's vector expressions;
/// empty if all agree. `None` if nothing was compared, because rounding may change the result of a branch at every
/// drawn point.
pub fn differences(model: &Model, compiled: &Compiled, random: &mut Random) -> Option<Vec<String>> {
    let (mut faults, mut made) = (Vec::new(), 0);
    for _ in 0..DRAWS {
        if made == POINTS || !faults.is_empty() {
            break;
        }
        let point = sample::point(model, random);
        if let Some(found) = with_numbers(|| at(model, compiled, &point)) {
            made += 1;
            faults.extend(found);
        }
    }
    faults.sort();
    faults.dedup();
    (made > 0).then_some(faults)
}

/// Names of the values and derivatives in which the compiled functions differ from the model's vector expressions at a
/// point; `None` if rounding may change the result of a branch, such as that of abs, at this point.
fn at(model: &Model, compiled: &Compiled, point: &Point<f64>) -> Option<Vec<String>> {
    let all = evaluated(compiled, point)?;
    let states: Vec<Big> = point.states.iter().map(|&s| Big::lit(s)).collect();
    let bounded: Vec<ErrorBound> = point.states.iter().map(|&s| ErrorBound::lit(s)).collect();
    let layout = &compiled.layout;
    let mut faults = Vec::new();
    for (j, name) in layout.states.iter().chain(&layout.parameters).enumerate() {
        let along_state = direction(model, &states, j);
        let bound_along = direction(model, &bounded, j);
        let expected = law(model, point, j, &along_state)?;
        let size = law(model, point, j, &bound_along)?;
        for one in &all {
            let function = one.function;
            let (rows, section, jacobians) = sections(function, states.len(), expected.len());
            let first = function.range(section).start;
            for (k, row) in rows.enumerate() {
                let Dual { value, derivative } = expected[row];
                let named = row_name(model, row);
                if differs(
                    one.values[first + k],
                    value,
                    [one.bounds[first + k], size[row].value],
                ) {
                    faults.push(format!("{named} in {}", function.name));
                }
                let found = along(function, &one.values, jacobians, k, j, &along_state);
                let bound = along(function, &one.bounds, jacobians, k, j, &bound_along);
                if let (Some(found), Some(bound)) = (found, bound)
                    && differs(found, derivative, [bound, size[row].derivative])
                {
                    faults.push(format!("∂{named}/∂{name} in {}", function.name));
                }
            }
        }
    }
    Some(faults)
}

fn evaluated<'a>(compiled: &'a Compiled, point: &Point<f64>) -> Option<Vec<Evaluated<'a>>> {
    let mut bounds: Inputs<ErrorBound> = Inputs::of(point);
    let mut inputs: Inputs<Big> = Inputs::of(point);
    let prepare = &compiled.prepare.program;
    let (prepared, undecided) = magnitudes(prepare, &bounds, Some(&inputs));
    if undecided {
        return None;
    }
    bounds.prepared = prepared;
    inputs.prepared = outputs(prepare, &inputs);
    let functions = [
        &compiled.f,
        &compiled.f_jac,
        &compiled.f_jac_par,
        &compiled.observe,
        &compiled.observe_jac,
    ];
    let each = functions.into_iter().map(|function| {
        let (bounds, undecided) = magnitudes(&function.program, &bounds, Some(&inputs));
        (!undecided).then(|| Evaluated {
            function,
            values: outputs(&function.program, &inputs),
            bounds,
        })
    });
    each.collect()
}

/// Whether a value `found` by the compiled code differs from the value `expected` from the model's vector expressions
/// by more than [`TOLERANCE`], which allows for constants rounded to f64. The difference is relative to the largest
/// magnitude in `terms` (terms of the code, terms of the expressions) and of `expected`.
fn differs(found: Big, expected: Big, terms: [ErrorBound; 2]) -> bool {
    let difference = (found - expected).re().abs();
    let size = terms
        .iter()
        .fold(expected.re().abs(), |size, t| size.max(t.magnitude));
    difference.is_nan() || difference > TOLERANCE * size.max(f64::MIN_POSITIVE)
}

/// Every state derivative and the components of the observation, from the model's vector expressions, each with its
/// derivative with respect to the variable with the given index (states first, then parameters); for a state, along
/// `direction` in state space. `None` if the model has no equations of motion.
fn law<T: Real>(
    model: &Model,
    at: &Point<f64>,
    variable: usize,
    direction: &[T],
) -> Option<Vec<Dual<T>>> {
    let mut point: Point<Dual<T>> = at.lift();
    for (state, &d) in point.states.iter_mut().zip(direction) {
        state.derivative = d;
    }
    if let Some(k) = variable.checked_sub(model.states.len())
        && let Some(value) = point.parameters_mut().nth(k)
    {
        value.derivative = T::one();
    }
    tree_column(model, &point)
}
