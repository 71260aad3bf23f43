//! Command `hyzer explain`: traces one quantity or derivative from its source line to its generated code.

use crate::cli::{Explain, Notation};
use crate::{Answer, output};

/// Runs `hyzer explain`: prints how a quantity, or its derivative, follows from its line in the model file.
pub(super) fn run(options: &Explain) -> anyhow::Result<Answer> {
    let model = model_spec::load::load(&options.model, &super::names(&options.with))?;
    let mut explanation =
        codegen::explain::explain(&model, &options.quantity, options.wrt.as_deref())?;
    let by_default = match output::is_terminal() {
        true => Notation::Text,
        false => Notation::Latex,
    };
    if options.format.unwrap_or(by_default) == Notation::Text {
        let formulas = explanation.latex.iter_mut();
        for formula in formulas.chain(&mut explanation.derivative) {
            *formula = broken(&report::plain_formula(formula));
        }
    }
    output::print(explanation.to_string())?;
    Ok(Answer::Yes)
}

/// A formula in lines that fit the terminal, indented but for the first.
fn broken(formula: &str) -> String {
    let lines = report::wrapped(formula);
    lines.trim_end().replace('\n', "\n        ")
}
