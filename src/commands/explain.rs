//! Command `hyzer explain`: traces one quantity or derivative from its source line to its generated code.

use crate::cli::Explain;
use crate::{Answer, output};

/// Runs `hyzer explain`: prints how a quantity, or its derivative, follows from its line in the model file.
pub(super) fn run(options: &Explain) -> anyhow::Result<Answer> {
    let model = model_spec::load::load(&options.model, &super::names(&options.with))?;
    let explanation = codegen::explain::explain(&model, &options.quantity, options.wrt.as_deref())?;
    output::print(explanation.to_string())?;
    Ok(Answer::Yes)
}
