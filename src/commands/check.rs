//! Command `hyzer check`: prints what a model declares, or every error with its location, and runs its check cases.

use std::fmt::Write;
use std::io::IsTerminal;

use codegen::{Comparison, check_cases};
use model_spec::load::inspect;
use model_spec::model::Model;
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
    (summary(model) + &cases, passes)
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
