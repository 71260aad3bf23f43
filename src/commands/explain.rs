//! Command `hyzer explain`: traces one quantity or derivative from its source line to its generated code.

use crate::cli::Explain;
use crate::{Answer, output};

/// Runs `hyzer explain`: prints how a quantity of the model, or its derivative, follows from its line in the model
/// file, with its formula and generated code. Always returns `Answer::Yes`.
pub fn run(options: &Explain) -> anyhow::Result<Answer> {
    let model = model_spec::load::load(&options.model, &super::names(&options.with))?;
    let explanation = codegen::explain::explain(&model, &options.quantity, options.wrt.as_deref())?;
    output::print(explanation.to_string())?;
    Ok(Answer::Yes)
}
