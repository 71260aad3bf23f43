//! Command `hyzer export`: writes a model for other programs.

use crate::cli::Export;
use crate::{Answer, output};

/// Runs `hyzer export`: writes a model as JSON.
pub(super) fn run(options: &Export) -> anyhow::Result<Answer> {
    let model = model_spec::load::load(&options.model, &super::names(&options.with))?;
    let json = codegen::ir::json(&model)?;
    match &options.out {
        Some(file) => {
            output::write(file, &json)?;
            eprintln!("{} is {}", model.name, file.display());
        }
        None => output::print(json)?,
    }
    Ok(Answer::Yes)
}
