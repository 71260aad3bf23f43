//! Checks the Jacobians of the state derivatives and of the observation, with respect to states and parameters. They
//! are compared with three differentiations of the vector tree that share nothing with the compiler's rules (dual
//! numbers of `num-dual`, complex steps, dual numbers with error bounds), and with dual numbers through the reference
//! implementation.
//!
//! Quaternions are varied on the unit sphere only, because other quaternions represent no attitude.

use super::backends::{Functions, Tapes, results_of};
use super::disputed::{Disputed, Part};
use super::function_rows::{
    Variable, compared, functions, moving_along, reference_column, tree_column, variables,
};
use super::precision::{Finding, Tally, bounded_by};
use crate::evaluation::Inputs;
use crate::options::{Options, TOLERANCE};
use crate::random::Random;
use crate::row::Row;
use crate::sample;
use crate::subject::{Bounded, Subject};
use codegen::Compiled;
use codegen::program::Function;
use model_spec::model::Model;
use oracle::scalar::{ComplexStep, ErrorBound, Lockstep, NumDual, Real};
use oracle::{Point, Reference, Tree};
use std::cell::OnceCell;

/// Names of the checks: three differentiations of the vector tree, and the reference implementation.
pub const CHECKS: [&str; 4] = [
    "derivatives: num-dual",
    "derivatives: complex step",
    "derivatives: dual numbers",
    "derivatives: reference",
];

/// Scalar that differentiates by three methods at once.
type ThreeWays = Lockstep<Bounded, Lockstep<NumDual, ComplexStep>>;

fn three_ways(first: Bounded) -> ThreeWays {
    let (value, derivative) = (first.value.value, first.derivative.value);
    Lockstep {
        first,
        second: Lockstep {
            first: NumDual::new(value, derivative),
            second: ComplexStep::new(value, derivative),
        },
    }
}

/// Compares every Jacobian entry, structural zeros included, with three differentiations and the reference.
pub fn check(subject: &Subject<'_>, compiled: &Compiled, options: &Options) -> Vec<Row> {
    let cases = options.cases.div_ceil(4);
    let mut random = Random::new(options.seed, "derivatives");
    let mut comparison = Comparison {
        subject,
        compiled,
        tapes: Tapes::new(compiled.functions().map(|f| &f.program)),
        found: Default::default(),
    };
    for _ in 0..cases {
        let point = sample::point(subject.model, &mut random);
        if comparison.with_tree(&point).is_none() {
            return CHECKS
                .map(|name| Row::unverified(name, "the vector tree has no equations of motion"))
                .into();
        }
        comparison.with_reference(&subject.without_extras(point));
    }
    let rows = CHECKS.iter().zip(&comparison.found).enumerate();
    let rows = rows.map(|(k, (name, found))| {
        if k == 3 && subject.reference.is_none() {
            Row::skipped(name, "the model claims no reference")
        } else {
            found.row(name, cases, cases)
        }
    });
    rows.collect()
}

struct Comparison<'a> {
    subject: &'a Subject<'a>,
    compiled: &'a Compiled,
    tapes: Tapes,
    /// Errors found by each check in [`CHECKS`], in that order.
    found: [Tally; 4],
}

impl<'a> Comparison<'a> {
    /// Variables, and results of the functions at a point, whose magnitudes are absolute values.
    fn found(&self, point: &Point<f64>) -> Found<'a> {
        let all = self.tapes.results(Inputs::of(point));
        let results = functions(self.compiled).map(|function| {
            let results = results_of(self.compiled, &all, function.name).iter();
            (function, results.map(|&v| ErrorBound::lit(v)).collect())
        });
        let states = point.lift().states;
        let variables = variables(self.subject.model, self.compiled, &states);
        (variables, results.into())
    }

    /// Compares with derivatives of the vector expressions; `None` if these cannot be evaluated.
    fn with_tree(&mut self, point: &Point<f64>) -> Option<()> {
        let model = self.subject.model;
        let (variables, results) = self.found(point);
        let code = OnceCell::new();
        for variable in &variables {
            let moving = moving_along(&point.lift(), variable).map(three_ways);
            let expected = tree_column(model, &moving).ok()?;
            let size = size(point, variable.index);
            let disputed = Disputed {
                model,
                compiled: self.compiled,
                point,
                variable,
                code: &code,
                exact: OnceCell::new(),
            };
            let compared = compared(model, &results, variable, expected.len());
            for (place, value) in compared.iter().enumerate() {
                let ThreeWays { first, second } = expected[value.row];
                let add = |tally: &mut Tally, found: f64, expected: ErrorBound, part: Part| {
                    let error = expected.relative_error(found);
                    let is_known = error <= TOLERANCE && expected.magnitude.is_finite();
                    let finding = if is_known || tally.is_refuted() {
                        Some(Finding::Error(error))
                    } else {
                        disputed.decide(found, expected, value.row, place, part)
                    };
                    match finding {
                        Some(finding) => tally.add(finding, || part.name(value)),
                        None => tally.add_kink(),
                    }
                };
                // The results themselves are the same for every variable.
                if std::ptr::eq(variable, &variables[0]) {
                    let found = value.found.value;
                    let first = bounded_by(first.value.value, first.value.magnitude);
                    add(&mut self.found[2], found, first, Part::Value);
                }
                let Some(found) = value.derivative else {
                    continue;
                };
                let magnitude = match first.derivative.magnitude {
                    0.0 => cancelled(first.value, size),
                    magnitude => magnitude,
                };
                let magnitude = magnitude.max(found.magnitude);
                let magnitude = bounded_by(first.derivative.value, magnitude).magnitude;
                let (num_dual, complex_step) =
                    (second.first.derivative(), second.second.derivative());
                let each = [num_dual, complex_step, first.derivative.value];
                for (tally, expected) in self.found.iter_mut().zip(each) {
                    let expected = ErrorBound {
                        value: expected,
                        magnitude,
                    };
                    add(tally, found.value, expected, Part::Derivative);
                }
            }
        }
        Some(())
    }

    /// Compares with derivatives of the reference law, if any; coefficients that it lacks have their null values.
    fn with_reference(&mut self, point: &Point<f64>) {
        let Some(reference) = &self.subject.reference else {
            return;
        };
        let model = self.subject.model;
        let added = model.added_states();
        let (variables, results) = self.found(point);
        let known = { variables.iter() }.filter(|v| has_reference(model, reference, v.index));
        for variable in known {
            // The tree is already instantiated for `ThreeWays`, whose first component is the bounded dual number.
            let point = moving_along(&point.lift(), variable);
            let clock_rate = Tree::new(model, &point.map(three_ways)).clock().first;
            let mut expected = reference_column(reference, model, &point);
            let rates = expected.iter_mut().take(model.states.len());
            rates.for_each(|rate| *rate *= clock_rate);
            let compared = compared(model, &results, variable, expected.len()).into_iter();
            for value in compared.filter(|value| !added.contains(&value.row)) {
                let ErrorBound {
                    value: wanted,
                    magnitude,
                } = expected[value.row].derivative;
                let error = |found| error(wanted, magnitude, found);
                let error = Finding::Error(value.derivative.map_or(0.0, error));
                self.found[3].add(error, || value.entry());
            }
        }
    }
}

/// Variables of the Jacobians, and the outputs of each compiled function.
type Found<'a> = (
    Vec<Variable<'a, ErrorBound>>,
    Vec<(&'a Function, Vec<ErrorBound>)>,
);

/// Whether the reference law has a variable: not the states and coefficients of effects and of the author.
fn has_reference(model: &Model, reference: &Reference, variable: usize) -> bool {
    if model.added_states().contains(&variable) {
        return false;
    }
    let first = model.states.len() + model.params.len();
    variable
        .checked_sub(first)
        .is_none_or(|index| !reference.unknown.contains(&index))
}

/// Relative difference of a derivative; the larger sum of magnitudes counts.
fn error(expected: f64, magnitude: f64, got: ErrorBound) -> f64 {
    ErrorBound {
        value: expected,
        magnitude: magnitude.max(got.magnitude),
    }
    .relative_error(got.value)
}

/// Divisor for an entry whose expected derivative has no nonzero terms. The code computes in another frame, where such
/// an entry may be a sum of terms that cancel up to rounding; their magnitude is estimated from that of the
/// differentiated `value`.
fn cancelled(value: ErrorBound, variable: f64) -> f64 {
    value.magnitude / variable.max(1.0)
}

fn size(point: &Point<f64>, variable: usize) -> f64 {
    let parameters = point.parameters();
    let mut all = point.states.iter().chain(&parameters);
    all.nth(variable).map_or(0.0, |v| v.abs())
}
