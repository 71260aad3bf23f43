//! What `f64` cannot decide. Where the code and a reference in `f64` disagree, the law is evaluated in 256 bits before
//! anything is refuted: a reference may overflow, terms may cancel, and rounding may decide a branch.

use super::function_rows::{law, row_name, tree_column, variables};
use crate::options::{ALLOWED, TOLERANCE};
use crate::random::Random;
use crate::report::Row;
use crate::row::Worst;
use codegen::Compiled;
use model_spec::model::Model;
use oracle::scalar::{Big, Dual, ErrorBound, Real, with_numbers};
use oracle::{Point, Tree, derivatives_of};
use std::collections::BTreeMap;

const HUGE: f64 = 1e150;
/// Relative distance of the points next to a point: some roundings.
const BESIDE: f64 = 1e-14;
const NEIGHBOURS: u64 = 8;

/// A value of the law, computed in 256 bits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact {
    /// Nearest `f64`; infinite beyond the range of `f64`.
    value: f64,
    /// Whether the value in 256 bits is neither infinite nor NaN.
    is_number: bool,
}

impl Exact {
    fn of(value: Big) -> Self {
        Self {
            value: value.re(),
            is_number: value.is_finite(),
        }
    }
}

/// Result of the comparison of one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Finding {
    /// Error relative to the magnitude of the terms.
    Error(f64),
    /// The value, or what it is computed from, is beyond the range of `f64`.
    Overflow,
}

/// Compares a value found in `f64` with the exact one. `expected` is by a method in `f64`, with a magnitude of NaN if the
/// terms overflow; `of_code` is the magnitude of the terms that the code sums, 0 if unknown; `in_256_bits` is what the code
/// gives in 256 bits, if a number on the way to it is beyond the range of `f64`.
pub(crate) fn decide(
    found: f64,
    expected: ErrorBound,
    of_code: f64,
    exact: Exact,
    in_256_bits: impl FnOnce() -> Option<f64>,
) -> Finding {
    if !exact.is_number {
        return Finding::Error(f64::INFINITY);
    }
    if exact.value.is_infinite() {
        return Finding::Overflow;
    }
    // Of the terms of the code, no more than the rounding of the backends is allowed.
    let rounding = of_code * (ALLOWED * f64::EPSILON / TOLERANCE);
    let finite = [expected.magnitude, rounding, exact.value.abs()].into_iter();
    let magnitude = finite.filter(|m| m.is_finite()).fold(0.0, f64::max);
    let value = exact.value;
    let error = |found| ErrorBound { value, magnitude }.relative_error(found);
    let is_right = |found| error(found) <= TOLERANCE;
    if is_right(found) {
        return Finding::Error(error(found));
    }
    let overflows = if found.is_finite() {
        !(expected.magnitude + of_code).is_finite()
    } else {
        !expected.value.is_finite()
    };
    if overflows || in_256_bits().is_some_and(is_right) {
        Finding::Overflow
    } else {
        Finding::Error(error(found))
    }
}

/// A value with the magnitude of its terms; NaN if the value overflows, and the magnitude is not known.
pub(crate) fn bounded_by(value: f64, magnitude: f64) -> ErrorBound {
    let magnitude = if value.is_finite() {
        magnitude
    } else {
        f64::NAN
    };
    ErrorBound { value, magnitude }
}

/// State derivatives and observation of the law in 256 bits; `None` if the vector expressions cannot be evaluated.
pub(crate) fn exact_values(model: &Model, point: &Point<f64>) -> Option<Vec<Exact>> {
    // Dual numbers, because another scalar type would be compiled for this alone.
    let constants = || point.map(|value| Dual::constant(Big::lit(value)));
    with_numbers(|| {
        let column = tree_column(model, &constants()).ok()?.into_iter();
        Some(column.map(|value| Exact::of(value.value)).collect())
    })
}

/// State derivatives and observation of the law in 256 bits, each with its derivative by one variable.
pub(crate) fn exact_column(
    model: &Model,
    compiled: &Compiled,
    point: &Point<f64>,
    index: usize,
) -> Option<Vec<[Exact; 2]>> {
    with_numbers(|| {
        let point = point.lift::<Big>();
        let variable = variables(model, compiled, &point.states).swap_remove(index);
        let column = law(model, &point, &variable)?.into_iter();
        Some(
            column
                .map(|v| [v.value, v.derivative].map(Exact::of))
                .collect(),
        )
    })
}

/// Name of a state derivative of the law that overflows `f64` at a point, or with which products overflow.
pub(crate) fn overflow(model: &Model, point: &Point<f64>) -> Option<String> {
    let lifted = point.lift::<ErrorBound>();
    let rates = derivatives_of(&Tree::new(model, &lifted)).ok()?;
    let is_small = |rate: &ErrorBound| rate.value.abs() < HUGE;
    let row = rates.iter().position(|rate| !is_small(rate))?;
    let exact = exact_values(model, point)?;
    exact[row].is_number.then(|| row_name(model, row))
}

/// Points next to a point, on all sides of a branch point that is as close as rounding.
pub(crate) fn neighbours(point: &Point<f64>) -> impl Iterator<Item = Point<f64>> + '_ {
    (0..NEIGHBOURS).map(|seed| {
        let mut random = Random::new(seed, "neighbours");
        point.map(|value| {
            let size = if value == 0.0 { 1.0 } else { value };
            value + random.within(BESIDE * size)
        })
    })
}

/// Errors of a check at many points, and what could not be compared there.
#[derive(Default)]
pub(crate) struct Tally {
    /// Maximum error of what was compared.
    pub worst: Worst,
    /// Number of points at which each value overflows, by its name.
    overflows: BTreeMap<String, usize>,
    /// Number of values that agree with the law only next to the point.
    kinks: usize,
}

impl Tally {
    /// Adds the result of a comparison.
    pub fn add(&mut self, finding: Finding, name: impl FnOnce() -> String) {
        match finding {
            Finding::Error(error) => self.worst.update(error, name),
            Finding::Overflow => *self.overflows.entry(name()).or_default() += 1,
        }
    }

    /// Counts a value at a branch point.
    pub fn add_kink(&mut self) {
        self.kinks += 1;
    }

    /// Adds the errors at one point of a check of the law's own derivatives, unless these overflow there.
    pub fn add_point(&mut self, model: &Model, point: &Point<f64>, errors: Worst) {
        let is_infinite = errors.error.is_infinite();
        let overflow = if is_infinite {
            overflow(model, point)
        } else {
            None
        };
        match overflow {
            Some(name) => self.add(Finding::Overflow, || name),
            None => self.worst.update(errors.error, || errors.place),
        }
    }

    /// Whether an error refutes already, so that nothing further needs to be decided.
    pub fn is_refuted(&self) -> bool {
        self.worst.error > TOLERANCE
    }

    /// Row of a report; `points` is the number of points at which each value was to be compared.
    pub fn row(&self, check: &'static str, cases: usize, points: usize) -> Row {
        let row = Row::judged(check, cases, &self.worst, TOLERANCE);
        let most = self.overflows.values().copied().max().unwrap_or(0);
        if most >= points.max(1) && !self.is_refuted() {
            return Row::unverified(check, self.remark(check, points));
        }
        if most == 0 && self.kinks == 0 {
            return row;
        }
        row.with_remark(self.remark(check, points))
    }

    fn remark(&self, check: &str, points: usize) -> String {
        let mut out = Vec::new();
        let mut values: Vec<(&String, usize)> = self
            .overflows
            .iter()
            .map(|(name, &count)| (name, count))
            .collect();
        values.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
        if let Some(&(name, count)) = values.first() {
            let others = match values.len() - 1 {
                0 => String::new(),
                others => format!(" and {others} more"),
            };
            out.push(format!(
                "OVERFLOW ({check}): {name}{others}: beyond the range of double precision at {count} of {points} points, \
                 and not compared there"
            ));
        }
        if self.kinks > 0 {
            let kinks = self.kinks;
            out.push(format!(
                "BRANCH POINT ({check}): {kinks} values compared with the law beside it, because rounding decides a branch"
            ));
        }
        out.join("\n")
    }
}
