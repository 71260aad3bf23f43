//! `hyzer explain`: one quantity or derivative from its line to its code.

use crate::cli::Explain;
use crate::{Answer, output};

/// Explains a quantity.
pub fn run(options: &Explain) -> anyhow::Result<Answer> {
    let model = model_spec::load::load(&options.model, &super::names(&options.with))?;
    let explanation = codegen::explain::explain(&model, &options.quantity, options.wrt.as_deref())?;
    output::print(explanation.to_string())?;
    Ok(Answer::Yes)
}
