//! Cases with known answers.

use crate::location::Span;

/// A test case of the model file: values to set, and expected results.
#[derive(Clone, Debug)]
pub struct CheckCase {
    /// Title of the check case, as in `check "title" { … }`.
    pub title: String,
    /// Quantities that the check case sets, with their values, SI; all other quantities have their default values.
    pub settings: Vec<(Target, f64)>,
    /// Results to compare, with expected values and tolerances.
    pub expectations: Vec<Expectation>,
}

/// A scalar that a check case sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A known constant, by index into [`Model::params`](super::Model::params).
    Param(usize),
    /// A coefficient, by index into [`Model::coefficients`](super::Model::coefficients).
    Coefficient(usize),
    /// A component of an input: index into [`Model::inputs`](super::Model::inputs), and component 0, 1 or 2.
    Input(usize, usize),
    /// A state, by index into [`Model::states`](super::Model::states).
    State(usize),
    /// Coordinate 0, 1 or 2 of the marker in the frame in which it is fixed, m.
    Marker(usize),
}

/// A scalar result of the model that a check case compares with an expected value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observable {
    /// The time derivative of a state, by index into [`Model::states`](super::Model::states).
    Derivative(usize),
    /// A scalar auxiliary variable, by index into [`Model::aux_variables`](super::Model::aux_variables).
    AuxVariable(usize),
}

/// A result that a check case expects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expectation {
    /// Result of the model that is compared with the expected value.
    pub what: Observable,
    /// Expected value of the result, SI.
    pub value: f64,
    /// Absolute tolerance of the comparison, SI.
    pub within: f64,
    /// Source span of the statement.
    pub span: Span,
}
