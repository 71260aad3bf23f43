//! Errors of loading a model or an effect.

use std::io;
use std::sync::Arc;

use thiserror::Error;

use crate::diagnostic::{Diagnostic, Source};
use crate::render::render;
use crate::suggest;

/// Error of loading a model or an effect.
#[derive(Clone, Debug, Error)]
pub enum LoadError {
    /// A model or effect has errors in its text.
    #[error("{}", render(diagnostics, sources, false).trim_end())]
    Faults {
        /// Errors found in the source texts, at least one.
        diagnostics: Vec<Diagnostic>,
        /// Source texts that the diagnostics' spans refer to.
        sources: Vec<Source>,
    },
    /// A file cannot be read.
    #[error("`{path}` cannot be read: {error}")]
    Unreadable {
        /// Path of the file that cannot be read.
        path: String,
        /// Error that the operating system returned when the file was read.
        error: Arc<io::Error>,
    },
    /// The path is a folder, not a model file.
    #[error("`{path}` is a folder, not a model file")]
    Folder {
        /// Path of the folder, which was given in place of the path of a model file.
        path: String,
    },
    /// The given name is neither an existing file nor a built-in model.
    #[error(
        "there is no model `{wanted}`: no such file, and no such model is built in{}\nbuilt in are {}",
        suggestion(wanted, known), known.join(", ")
    )]
    UnknownModel {
        /// Name or path of the requested model.
        wanted: String,
        /// Names of the built-in models.
        known: Vec<String>,
    },
    /// No effect has the given name.
    #[error(
        "there is no effect `{wanted}`: not in the model, not among the built-in ones, and no such file{}\nknown are {}",
        suggestion(wanted, known), known.join(", ")
    )]
    UnknownEffect {
        /// Name or path of the requested effect.
        wanted: String,
        /// Names of the effects of the model's file and of the built-in effects.
        known: Vec<String>,
    },
}

impl LoadError {
    /// Errors in the source texts of [`LoadError::Faults`]; empty for all other variants.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        match self {
            LoadError::Faults { diagnostics, .. } => diagnostics,
            _ => &[],
        }
    }
}

/// Line of text that suggests the known name nearest in spelling to `wanted`; empty if no name is near.
fn suggestion(wanted: &str, known: &[String]) -> String {
    let name = wanted.replace('-', "_");
    suggest::nearest(&name, known.iter().map(String::as_str))
        .map(|near| format!("\ndid you mean `{near}`?"))
        .unwrap_or_default()
}
