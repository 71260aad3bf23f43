//! Checks the Jacobians of the state derivatives and of the observation, with respect to states and parameters. They
//! are compared with three differentiations of the vector tree that share nothing with the compiler's rules (dual
//! numbers of `num-dual`, complex steps, dual numbers with error bounds), and with dual numbers through the reference
//! implementation.
//!
//! Quaternions are varied on the unit sphere only, because other quaternions represent no attitude.

use super::function_rows::{direction, row_name, tree_column};
use crate::options::{Options, TOLERANCE};
use crate::random::Random;
use crate::row::{Row, Worst};
use crate::sample;
use crate::subject::{Derivatives, Differentiable, Subject};
use model_spec::Layout;
use model_spec::model::Model;
use oracle::scalar::{ComplexStep, Dual, ErrorBound, Lockstep, NumDual, Real};
use oracle::{Point, Reference, Tree};

/// Names of the checks of a model's Jacobians against three methods of differentiation and against the reference
/// implementation.
pub const CHECKS: [&str; 4] = [
    "derivatives: num-dual",
    "derivatives: complex step",
    "derivatives: dual numbers",
    "derivatives: reference",
];

type Bounded = Dual<ErrorBound>;

/// Scalar that differentiates by three methods at once: dual numbers with error bounds, dual numbers of the crate
/// `num-dual`, and the complex step.
type ThreeWays = Lockstep<Bounded, Lockstep<NumDual, ComplexStep>>;

fn bounded(value: f64, derivative: f64) -> Bounded {
    Dual::new(ErrorBound::lit(value), ErrorBound::lit(derivative))
}

fn three_ways(value: f64, derivative: f64) -> ThreeWays {
    Lockstep {
        first: bounded(value, derivative),
        second: Lockstep {
            first: NumDual::new(value, derivative),
            second: ComplexStep::new(value, derivative),
        },
    }
}

/// Compares every entry of every Jacobian of the compiled model, structural zeros included, with three differentiation
/// methods applied to the model's vector expressions, and with the reference implementation.
pub fn check(subject: &Subject<'_>, equations: &dyn Differentiable, options: &Options) -> Vec<Row> {
    let cases = options.cases.div_ceil(4);
    let mut random = Random::new(options.seed, "derivatives");
    let layout = Layout::new(subject.model);
    let mut comparison = Comparison {
        subject,
        variables: [layout.states, layout.parameters].concat(),
        worst: Default::default(),
    };
    for _ in 0..cases {
        let point = sample::point(subject.model, &mut random);
        if comparison.with_tree(equations, &point).is_none() {
            return CHECKS
                .map(|name| Row::unverified(name, "the vector tree has no equations of motion"))
                .into();
        }
        comparison.with_reference(equations, &subject.without_extras(point));
    }
    let rows = CHECKS.iter().zip(&comparison.worst).enumerate();
    let rows = rows.map(|(k, (name, worst))| {
        if k == 3 && subject.reference.is_none() {
            Row::skipped(name, "the model claims no reference")
        } else {
            Row::judged(name, cases, worst, TOLERANCE)
        }
    });
    rows.collect()
}

struct Comparison<'a> {
    subject: &'a Subject<'a>,
    /// Names of the independent variables, in the order of the Jacobian's columns: states, parameters, coefficients,
    /// components of inputs.
    variables: Vec<String>,
    /// Maximum error found by each check in [`CHECKS`], in that order.
    worst: [Worst; 4],
}

impl Comparison<'_> {
    /// Compares the equations' Jacobians at a point with derivatives of the model's vector expressions, and updates the
    /// maximum errors. `None` if the vector expressions cannot be evaluated.
    fn with_tree(&mut self, equations: &dyn Differentiable, point: &Point<f64>) -> Option<()> {
        let model = self.subject.model;
        let got = equations.derivatives(point);
        let by_state = equations.by_state(point);
        for (j, name) in self.variables.iter().enumerate() {
            let column = along(&got, model, point, j);
            let short = (j < model.states.len()).then(|| along(&by_state, model, point, j));
            let expected = tree_column(model, &seed(model, point, j, three_ways))?;
            for (i, expected) in expected.into_iter().enumerate() {
                let ErrorBound { value, magnitude } = expected.first.derivative;
                let magnitude = match magnitude {
                    0.0 => cancelled(expected.first.value, size(point, j)),
                    _ => magnitude,
                };
                let [num_dual, complex_step, dual] = [
                    expected.second.first.derivative(),
                    expected.second.second.derivative(),
                    value,
                ];
                let entry = || format!("d {} / d {name}", row_name(model, i));
                for (k, expected) in [num_dual, complex_step, dual].into_iter().enumerate() {
                    self.worst[k].update(error(expected, magnitude, column[i]), entry);
                }
                if let Some(short) = short.as_ref().and_then(|short| short.get(i)) {
                    self.worst[2].update(error(dual, magnitude, *short), || entry() + " in f_jac");
                }
                for values in [&got.values, &by_state.values] {
                    let error = |&v: &f64| expected.first.value.relative_error(v);
                    self.worst[2].update(values.get(i).map_or(0.0, error), || {
                        row_name(model, i) + " beside its derivatives"
                    });
                }
            }
        }
        Some(())
    }

    /// Compares the equations' Jacobians with the derivatives of the reference implementation at a point. Coefficients
    /// that the reference law does not contain have their null values there, at which they change nothing. Does nothing
    /// if the model names no reference law.
    fn with_reference(&mut self, equations: &dyn Differentiable, point: &Point<f64>) {
        let Some(reference) = &self.subject.reference else {
            return;
        };
        let model = self.subject.model;
        let added = model.added_states();
        let got = equations.derivatives(point);
        for (j, name) in self.variables.iter().enumerate() {
            if !has_reference(model, reference, j) {
                continue;
            }
            let column = along(&got, model, point, j);
            // The tree is already instantiated for `ThreeWays`, whose first component is the bounded dual number.
            let clocked = seed(model, point, j, three_ways);
            let clock_rate = Tree::new(model, &clocked).clock().first;
            let point = seed(model, point, j, bounded);
            let expected = reference_column(reference, model, &point, clock_rate);
            for (i, expected) in expected.iter().enumerate() {
                if added.contains(&i) {
                    continue;
                }
                let ErrorBound { value, magnitude } = expected.derivative;
                self.worst[3].update(error(value, magnitude, column[i]), || {
                    format!("d {} / d {name}", row_name(model, i))
                });
            }
        }
    }
}

/// Whether the reference implementation has a variable of the model, so that derivatives with respect to it can be
/// compared. The reference implementation lacks the states and coefficients that the reference law does not contain,
/// such as those of effects. `variable` is the index of the variable in the order of the Jacobian's columns: states,
/// parameters, coefficients, components of inputs.
fn has_reference(model: &Model, reference: &Reference, variable: usize) -> bool {
    if model.added_states().contains(&variable) {
        return false;
    }
    let first = model.states.len() + model.params.len();
    variable
        .checked_sub(first)
        .is_none_or(|index| !reference.unknown.contains(&index))
}

/// Lifts the point to scalars that carry derivatives with respect to the variable with index `j`, in the order of the
/// Jacobian's columns: states, parameters, coefficients, components of inputs. `variable(value, derivative)` creates
/// such a scalar.
fn seed<T: Real>(
    model: &Model,
    point: &Point<f64>,
    j: usize,
    variable: fn(f64, f64) -> T,
) -> Point<T> {
    let mut out = point.lift::<T>();
    let derivatives = direction(model, &point.states, j);
    for (state, derivative) in out.states.iter_mut().zip(derivatives) {
        if derivative != 0.0 {
            *state = variable(state.re(), derivative);
        }
    }
    let Some(k) = j.checked_sub(out.states.len()) else {
        return out;
    };
    if let Some(value) = out.parameters_mut().nth(k) {
        *value = variable(value.re(), 1.0);
    }
    out
}

/// Derivative of each state derivative and observation component with respect to the variable of the Jacobian's column
/// `j`, computed from the Jacobian in `got`. For a component of a quaternion, it is taken along the component's axis
/// projected onto the tangent space of the unit sphere. The `magnitude` of each result, to which errors are relative,
/// is the sum of the absolute values of the Jacobian entries that are used.
fn along(got: &Derivatives, model: &Model, point: &Point<f64>, j: usize) -> Vec<ErrorBound> {
    let mut direction = direction(model, &point.states, j);
    direction.resize(got.entries.first().map_or(0, Vec::len), 0.0);
    if j >= point.states.len() {
        direction[j] = 1.0;
    }
    let sum = |row: &Vec<f64>| {
        let nonzero = direction.iter().zip(row).filter(|(d, _)| **d != 0.0);
        ErrorBound {
            value: nonzero.clone().map(|(d, entry)| d * entry).sum(),
            magnitude: nonzero.map(|(_, entry)| entry.abs()).sum(),
        }
    };
    got.entries.iter().map(sum).collect()
}

/// Difference between an expected derivative and one from the Jacobian, relative to the larger of the two sums of the
/// magnitudes of their terms.
fn error(expected: f64, magnitude: f64, got: ErrorBound) -> f64 {
    ErrorBound {
        value: expected,
        magnitude: magnitude.max(got.magnitude),
    }
    .relative_error(got.value)
}

/// Divisor that makes the error of a Jacobian entry relative if the expected derivative has no nonzero terms in the
/// model's vector expressions. The compiled code computes in another frame, where such an entry may be a sum of terms
/// that cancel up to rounding. The magnitude of these terms is estimated as the magnitude of the differentiated
/// `value`, divided by max(`variable`, 1), where `variable` is the absolute value of the independent variable.
fn cancelled(value: ErrorBound, variable: f64) -> f64 {
    value.magnitude / variable.max(1.0)
}

/// Absolute value of the variable with the given index. The variables are numbered like the Jacobian's columns: states,
/// parameters, coefficients, components of inputs.
fn size(point: &Point<f64>, variable: usize) -> f64 {
    let parameters = point.parameters();
    let mut all = point.states.iter().chain(&parameters);
    all.nth(variable).map_or(0.0, |v| v.abs())
}

/// Derivatives of the states with respect to recorded time, followed by the components of the observation, from the
/// reference implementation. `clock_rate`: seconds of flight per second of recorded time.
fn reference_column(
    reference: &Reference,
    model: &Model,
    point: &Point<Bounded>,
    clock_rate: Bounded,
) -> Vec<Bounded> {
    let rates = reference.derivatives(point).into_iter();
    let mut out: Vec<Bounded> = rates.map(|rate| rate * clock_rate).collect();
    if model.observation.is_some() {
        out.extend(reference.observation(point).iter());
    }
    out
}
