//! `hyzer check`: what a model says, or every fault with its place.

use std::io::IsTerminal;

use model_spec::load::inspect;
use model_spec::render;
use model_spec::summary;

use crate::cli::Check;
use crate::{Answer, output};

/// Checks each model; the answer is no where any has a fault.
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
