//! Command `hyzer check`: prints what a model declares, or every error with its location.

use std::io::IsTerminal;

use model_spec::load::inspect;
use model_spec::render;
use model_spec::summary;

use crate::cli::Check;
use crate::{Answer, output};

/// Checks each model; answers no if any model has an error.
pub fn run(options: &Check) -> anyhow::Result<Answer> {
    let mut answer = Answer::Yes;
    for name in &options.models {
        let loaded = inspect(name, &super::names(&options.with))?;
        match loaded.model {
            Some(model) if loaded.diagnostics.is_empty() => output::print(summary(&model))?,
            _ => {
                eprint!(
                    "{}",
                    render(
                        &loaded.diagnostics,
                        &loaded.sources,
                        std::io::stderr().is_terminal()
                    )
                );
                answer = Answer::No;
            }
        }
    }
    Ok(answer)
}
