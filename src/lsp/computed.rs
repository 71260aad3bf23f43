//! What an editor shows of the compiled code: operations for each quantity, and checks that fail.

use codegen::check_cases;
use codegen::compile::compile_every_value;
use codegen::count::count_for;
use model_spec::diagnostic::{Diagnostic, Kind};
use model_spec::model::{Expr, Model};

/// Greatest number of nodes of the expressions of a model that is compiled while somebody types.
const MAX_NODES: usize = 5000;

/// Number of operations for each auxiliary variable of a model, by its index, those of the quantities that it uses
/// included; none for a large model.
pub fn of_quantities(model: &Model) -> Vec<usize> {
    if is_large(model) {
        return Vec::new();
    }
    let compiled = compile_every_value(model);
    let lengths: usize = compiled.lets.iter().sum();
    let mut next = compiled.program.outputs.len().saturating_sub(lengths);
    let counts = compiled.lets.iter().map(|length| {
        let outputs: Vec<usize> = (next..next + length).collect();
        next += length;
        count_for(&compiled.program, &outputs).total()
    });
    counts.collect()
}

/// The expectations of check cases that a model does not meet; none of a large model.
pub fn failing_checks(model: &Model) -> Vec<Diagnostic> {
    if model.checks.is_empty() || is_large(model) {
        return Vec::new();
    }
    let cases = check_cases(model).into_iter();
    let compared = cases.flat_map(|(_, compared)| compared);
    let failing = compared.filter(|own| !own.is_met());
    failing
        .map(|own| Diagnostic::new(Kind::Value, own.expected.span, own.to_string()))
        .collect()
}

fn is_large(model: &Model) -> bool {
    let loads = model.forces.iter().chain(&model.moments);
    let values = { model.aux_variables.iter() }.map(|own| &own.value);
    let values = values.chain(loads.map(|own| &own.value));
    let values = values.chain(model.equations.iter().map(|own| &own.value));
    let values = values.chain(model.systems.iter().flat_map(|own| &own.equations));
    let values = values.chain(model.limits.iter().map(|own| &own.value));
    values.flat_map(Expr::nodes).count() > MAX_NODES
}
