//! Values and derivatives at one point about which the code and a reference in `f64` disagree, decided in 256 bits.

use super::function_rows::{Value, Variable, compared, functions, law};
use super::precision::{Exact, Finding, decide, exact_column, neighbours};
use crate::evaluation::{overflowing, results};
use crate::options::TOLERANCE;
use codegen::Compiled;
use codegen::program::Function;
use model_spec::model::Model;
use oracle::Point;
use oracle::scalar::ErrorBound;
use std::cell::OnceCell;

/// What is compared: a result of a function, or its derivative.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Value,
    Derivative,
}

impl Part {
    /// Name of the compared number, such as `der(v) in f_jac`.
    pub fn name(self, value: &Value<'_, ErrorBound>) -> String {
        match self {
            Self::Value => value.name(),
            Self::Derivative => value.entry(),
        }
    }

    fn of<T: Copy>(self, value: T, derivative: T) -> T {
        match self {
            Self::Value => value,
            Self::Derivative => derivative,
        }
    }
}

/// The law and the magnitudes of the code's terms at a point, differentiated by one variable, computed when needed.
pub(super) struct Disputed<'a> {
    pub model: &'a Model,
    pub compiled: &'a Compiled,
    pub point: &'a Point<f64>,
    pub variable: &'a Variable<'a, ErrorBound>,
    /// Results of the compiled functions at the point, with the magnitudes of their terms.
    pub code: &'a OnceCell<Vec<(&'a Function, Vec<ErrorBound>)>>,
    /// Results of the law and their derivatives.
    pub exact: OnceCell<Option<Vec<[Exact; 2]>>>,
}

impl Disputed<'_> {
    /// Compares the number `found` at the position `place` of the results that are compared, which is `expected` by a
    /// method in `f64`. `None` if it agrees with the law only next to the point.
    pub fn decide(
        &self,
        found: f64,
        expected: ErrorBound,
        row: usize,
        place: usize,
        part: Part,
    ) -> Option<Finding> {
        let index = self.variable.index;
        let exact = || exact_column(self.model, self.compiled, self.point, index);
        let Some(exact) = self.exact.get_or_init(exact) else {
            return Some(Finding::Error(f64::INFINITY));
        };
        let rows = exact.len();
        let [value, derivative] = exact[row];
        let of_code = self.magnitude_of_code(rows, place, part);
        let exact = part.of(value, derivative);
        let in_256_bits = || self.in_256_bits(rows, place, part);
        let finding = decide(found, expected, of_code, exact, in_256_bits);
        let is_refuted = matches!(finding, Finding::Error(error) if error > TOLERANCE);
        (!(is_refuted && self.agrees_beside(found, row, part))).then_some(finding)
    }

    fn magnitude_of_code(&self, rows: usize, place: usize, part: Part) -> f64 {
        let code = self
            .code
            .get_or_init(|| results(self.compiled, functions(self.compiled), &self.point.lift()));
        let value = compared(self.model, code, self.variable, rows).swap_remove(place);
        let of_derivative = value
            .derivative
            .map_or(0.0, |derivative| derivative.magnitude);
        part.of(value.found.magnitude, of_derivative)
    }

    /// What the code gives in 256 bits, if a number on the way to it is beyond the range of `f64`.
    fn in_256_bits(&self, rows: usize, place: usize, part: Part) -> Option<f64> {
        let functions = functions(self.compiled);
        let programs = functions.iter().map(|function| &function.program);
        let all = overflowing(&self.compiled.prepare.program, programs, self.point, |_| {
            true
        })?;
        let results: Vec<(&Function, Vec<f64>)> = functions.into_iter().zip(all).collect();
        let direction = self.variable.direction.iter().map(|d| d.value).collect();
        let variable = self.variable.along(direction);
        let value = compared(self.model, &results, &variable, rows).swap_remove(place);
        Some(part.of(value.found, value.derivative.unwrap_or(0.0)))
    }

    /// Whether a number is that of the law next to the point, on one side of a branch point.
    fn agrees_beside(&self, found: f64, row: usize, part: Part) -> bool {
        found.is_finite()
            && neighbours(self.point).any(|beside| {
                let column = law(self.model, &beside.lift(), self.variable).unwrap_or_default();
                let law = column.get(row).map(|v| part.of(v.value, v.derivative));
                law.is_some_and(|law| law.relative_error(found) <= TOLERANCE)
            })
    }
}
