//! Evaluation of the check cases of a model file on a tape.

use std::fmt;

use crate::compile::scheduled_values;
use crate::graph::NodeId;
use crate::lower::lower;
use crate::tape::{Inputs, Tape};
use model_spec::model::{CheckCase, Expectation, Model, Observable, Target};
use model_spec::with_unit;

/// Expected and computed value of one quantity of a check case.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Name of the checked quantity in the notation of the check case: `alpha`, `der(u)`.
    pub name: String,
    /// SI unit of the values, in the notation of model files.
    pub unit: String,
    /// Value computed from the model, in the SI unit `unit`.
    pub found: f64,
    /// Expected value and tolerance, as stated in the check case.
    pub expected: Expectation,
}

impl Comparison {
    /// Whether the computed value is within the tolerance of the expected value; false for NaN.
    pub fn is_met(&self) -> bool {
        (self.found - self.expected.value).abs() <= self.expected.within
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = |of: f64| with_unit(of, &self.unit);
        let Expectation {
            value: of, within, ..
        } = self.expected;
        let (found, expected, within) = (value(self.found), value(of), value(within));
        write!(
            f,
            "{} = {found}, expected {expected} within {within}",
            self.name
        )
    }
}

/// Evaluates the check cases of a model; returns title and comparisons of each.
pub fn check_cases(model: &Model) -> Vec<(String, Vec<Comparison>)> {
    let observables: Vec<Observable> = model
        .checks
        .iter()
        .flat_map(|case| case.expectations.iter().map(|e| e.what))
        .collect();
    let mut lowered = lower(model);
    let wanted: Vec<NodeId> = observables
        .iter()
        .map(|what| match *what {
            Observable::Derivative(state) => lowered.dx[state],
            Observable::AuxVariable(variable) => lowered.lets[variable][0],
        })
        .collect();
    let program = scheduled_values(&mut lowered.graph, &lowered.layout, &wanted);
    let tape = Tape::new(&program);
    let mut registers = Vec::new();
    let mut first = 0;
    let cases = model.checks.iter().map(|case| {
        let (states, parameters, marker) = arguments(model, case);
        let inputs = Inputs {
            t: 0.0,
            x: &states,
            p: &parameters,
            prepared: &[],
            marker: &marker,
        };
        let mut out = vec![0.0; tape.outputs()];
        tape.eval(inputs, &mut registers, &mut out);
        let found = &out[first..first + case.expectations.len()];
        first += case.expectations.len();
        let comparisons = case.expectations.iter().zip(found);
        let comparisons = comparisons.map(|(expected, &found)| compared(model, expected, found));
        (case.title.clone(), comparisons.collect())
    });
    cases.collect()
}

fn compared(model: &Model, expected: &Expectation, found: f64) -> Comparison {
    let (name, unit) = match expected.what {
        Observable::Derivative(state) => {
            let state = &model.states[state];
            let unit = state.unit.checked_div(model_spec::unit::Unit::SECOND);
            (format!("der({})", state.name), unit.unwrap_or_default())
        }
        Observable::AuxVariable(variable) => {
            let variable = &model.aux_variables[variable];
            (variable.name.clone(), variable.value.unit)
        }
    };
    Comparison {
        name,
        unit: unit.tidy().to_string(),
        found,
        expected: *expected,
    }
}

/// States, parameters and marker of a check case, defaults where it sets none.
fn arguments(model: &Model, case: &CheckCase) -> (Vec<f64>, Vec<f64>, [f64; 3]) {
    let layout = crate::layout::Layout::new(model);
    let (mut states, mut parameters) = (layout.default_states(), layout.default_parameters());
    let mut marker = [0.0; 3];
    for &(target, value) in &case.settings {
        match target {
            Target::Param(k) => parameters[layout.param(k).index()] = value,
            Target::Coefficient(k) => parameters[layout.coefficient(k).index()] = value,
            Target::Input(k, axis) => parameters[layout.input(k)[axis].index()] = value,
            Target::State(k) => states[k] = value,
            Target::Marker(axis) => marker[axis] = value,
        }
    }
    (states, parameters, marker)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPRING: &str = "\
model spring;
frame N;
param k = 4 1/s^2;
state a = 1 m;
state b = 0 m/s;
let pull = k*a;
der(a) = b;
der(b) = -pull;
check \"pulls back\" {
  set a = 50 cm;
  set b = 2 m/s;
  expect pull = 2 m/s^2 within 1e-12;
  expect der(a) = 2 m/s within 0;
}
check \"is wrong\" {
  expect pull = 4 m/s^2 within 1e-12;
  expect der(b) = 4 m/s^2 within 1e-12;
}
";

    #[test]
    fn each_expectation_is_compared_with_the_model() {
        let model = model_spec::load::from_text("spring.hyz", SPRING, &[]).expect("a model");
        let cases = check_cases(&model);
        let met: Vec<Vec<bool>> = cases
            .iter()
            .map(|(_, results)| results.iter().map(Comparison::is_met).collect())
            .collect();
        assert_eq!(met, [vec![true, true], vec![true, false]]);
        let wrong = &cases[1].1[1];
        assert_eq!((wrong.name.as_str(), wrong.found), ("der(b)", -4.0));
        assert_eq!(wrong.unit, "m/s^2");
        assert_eq!(cases[0].0, "pulls back");
    }

    #[test]
    fn a_case_sets_the_marker() {
        let text = "model seen; frame N; state a = 1 m; der(a) = 2 [m/s]; marker mark in N;
            let place = (a, 0 [m], 0 [m]) in N; let seen = place + mark; let seen_y = seen.2;
            observe mark = seen;
            check \"of a marker aside\" { set mark = (0, 20, 0) cm; expect seen_y = 0.2 m within 1e-12; }
            check \"of the origin\" { expect seen_y = 0 m within 0; }";
        let model = model_spec::load::from_text("seen.hyz", text, &[]).expect("a model");
        let found: Vec<f64> = check_cases(&model)
            .iter()
            .map(|case| case.1[0].found)
            .collect();
        assert_eq!(found, [0.2, 0.0]);
    }

    #[test]
    fn the_built_in_models_meet_their_cases() {
        for (name, _) in model_spec::load::MODELS {
            let model = model_spec::load::load(name, &[]).expect("a built-in model");
            let cases = check_cases(&model);
            assert_eq!(cases.len(), model.checks.len());
            let failed = cases.iter().flat_map(|c| &c.1).find(|c| !c.is_met());
            assert_eq!(failed, None, "{name}");
        }
    }
}
