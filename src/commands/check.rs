//! Command `hyzer check`: prints what a model declares, or every error with its location, and runs its check cases.

use std::fmt::Write;
use std::io::IsTerminal;

use codegen::{Comparison, check_cases};
use flight::throw::ThrownModel;
use identify::numbers::significant;
use model_spec::layout::Layout;
use model_spec::load::inspect;
use model_spec::model::{Expr, ExprKind, Model};
use model_spec::{render, summary};

use crate::cli::Check;
use crate::{Answer, output};

/// Runs `hyzer check`. `Answer::No` if a model has an error or fails one of its check cases.
pub(super) fn run(options: &Check) -> anyhow::Result<Answer> {
    let mut answer = Answer::Yes;
    for name in &options.models {
        let loaded = inspect(name, &super::names(&options.with))?;
        let passes = if let Some(model) = loaded.model.filter(|_| loaded.diagnostics.is_empty()) {
            let (report, passes) = report(&model);
            output::print(report)?;
            passes
        } else {
            let is_terminal = std::io::stderr().is_terminal();
            eprint!(
                "{}",
                render(&loaded.diagnostics, &loaded.sources, is_terminal)
            );
            false
        };
        if !passes {
            answer = Answer::No;
        }
    }
    Ok(answer)
}

/// What a model declares, the results of its check cases, and whether all of them pass.
pub fn report(model: &Model) -> (String, bool) {
    let (cases, passes) = cases(model);
    let fault = inertia_fault(model);
    let mut text = summary(model) + &cases;
    if let Some(fault) = &fault {
        let _ = writeln!(text, "  FAIL  {fault}");
    }
    (text, passes && fault.is_none())
}

/// What is wrong with the products of inertia at the default values.
pub(super) fn inertia_fault(model: &Model) -> Option<String> {
    let rotation = model.body.as_ref()?.rotation.as_ref()?;
    let is_zero =
        |entry: &Expr| matches!(entry.kind, ExprKind::Number { value, .. } if value == 0.0);
    let rows = rotation.inertia.iter().enumerate();
    let mut others = rows.flat_map(|(i, row)| row.iter().enumerate().filter(move |(j, _)| i != *j));
    if others.all(|(_, entry)| is_zero(entry)) {
        return None;
    }
    let body = ThrownModel::new(model).ok()?;
    let layout = Layout::new(model);
    let (parameters, state) = (layout.default_parameters(), layout.default_states());
    let moments = body.improper_moments(&parameters, &state)?;
    let [a, b, c] = moments.map(|moment| significant(moment, 5));
    Some(format!(
        "the inertia tensor is not positive definite: its principal moments are {a}, {b} and {c} kg m²; check \
         the signs and sizes of its products of inertia"
    ))
}

/// Results of the check cases of a model as text, and whether all of them pass.
fn cases(model: &Model) -> (String, bool) {
    let mut text = String::new();
    let mut all_pass = true;
    for (title, results) in check_cases(model) {
        let passes = results.iter().all(Comparison::is_met);
        all_pass &= passes;
        let verdict = if passes { "pass" } else { "FAIL" };
        let _ = writeln!(text, "  {verdict}  {title}");
        for result in &results {
            let failed = if result.is_met() { "" } else { "  ← fails" };
            let _ = writeln!(text, "        {result}{failed}");
        }
    }
    (text, all_pass)
}
