//! Evaluates the check cases stated in the model file.

use crate::row::Row;
use crate::subject::Subject;
use model_spec::model::{Model, Observable, Target};
use oracle::{Point, Tree, Value};

/// Name of this check in reports: the check cases specified in the model file.
pub const CASES: &str = "check cases of the model";

/// Compares expected values with derivatives from the equations under test and variables from the vector tree.
pub fn check(subject: &Subject<'_>) -> Row {
    let model = subject.model;
    if model.checks.is_empty() {
        return Row::skipped(CASES, "the model states none");
    }
    let mut faults = Vec::new();
    for case in &model.checks {
        let point = set(model, &case.settings);
        let rates = subject.equations.rates(&point);
        let tree = Tree::new(model, &point);
        for expected in &case.expectations {
            let (name, got) = match expected.what {
                Observable::Derivative(i) => (
                    format!("der({})", model.states[i].name),
                    rates.get(i).copied().unwrap_or(f64::NAN),
                ),
                Observable::AuxVariable(i) => match tree.aux_variables[i] {
                    Value::Scalar(v) => (model.aux_variables[i].name.clone(), v),
                    Value::Vector(_) => (model.aux_variables[i].name.clone(), f64::NAN),
                },
            };
            let close = (got - expected.value).abs() <= expected.within;
            if !close {
                let (want, within) = (expected.value, expected.within);
                let title = &case.title;
                faults.push(format!(
                    "\"{title}\": {name} is {got}, expected {want} within {within}"
                ));
            }
        }
    }
    Row::counted(CASES, model.checks.len(), &faults, "")
}

/// Default values, overridden by the settings of a check case.
pub fn set(model: &Model, settings: &[(Target, f64)]) -> Point<f64> {
    let mut point = Point::defaults(model);
    for &(target, value) in settings {
        match target {
            Target::Param(i) => point.params[i] = value,
            Target::Coefficient(i) => point.coefficients[i] = value,
            Target::Input(i, axis) => point.inputs[i][axis] = value,
            Target::State(i) => point.states[i] = value,
            Target::Marker(axis) => point.marker[axis] = value,
        }
    }
    point
}
