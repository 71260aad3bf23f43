//! Reasons why a model cannot be loaded.

use std::io;
use std::sync::Arc;

use thiserror::Error;

use crate::diagnostic::{Diagnostic, Source};
use crate::render::render;
use crate::suggest;

/// Why a model or an effect cannot be loaded.
#[derive(Clone, Debug, Error)]
pub enum LoadError {
    /// The texts have faults.
    #[error("{}", render(diagnostics, sources, false).trim_end())]
    Faults {
        /// The faults, at least one.
        diagnostics: Vec<Diagnostic>,
        /// The texts, indexed by the `source` of a span.
        sources: Vec<Source>,
    },
    /// A file cannot be read.
    #[error("`{path}` cannot be read: {error}")]
    Unreadable {
        /// Its path.
        path: String,
        /// The error of the operating system.
        error: Arc<io::Error>,
    },
    /// A path of a folder was given in place of a model file.
    #[error("`{path}` is a folder, not a model file")]
    Folder {
        /// The path.
        path: String,
    },
    /// Neither a file nor a built-in model.
    #[error(
        "there is no model `{wanted}`: no such file, and no such model is built in{}\nbuilt in are {}",
        suggestion(wanted, known), known.join(", ")
    )]
    UnknownModel {
        /// The name as given.
        wanted: String,
        /// Names of the built-in models.
        known: Vec<String>,
    },
    /// Neither a file, nor an effect of the model's file, nor a built-in effect.
    #[error(
        "there is no effect `{wanted}`: not in the model, not among the built-in ones, and no such file{}\nknown are {}",
        suggestion(wanted, known), known.join(", ")
    )]
    UnknownEffect {
        /// The name as given.
        wanted: String,
        /// Names of the effects of the model's file and of the built-in ones.
        known: Vec<String>,
    },
}

impl LoadError {
    /// The faults in the texts; none if a text is missing.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        match self {
            LoadError::Faults { diagnostics, .. } => diagnostics,
            _ => &[],
        }
    }
}

/// A second line with the nearest of the known names, if one is near.
fn suggestion(wanted: &str, known: &[String]) -> String {
    let name = wanted.replace('-', "_");
    suggest::nearest(&name, known.iter().map(String::as_str))
        .map(|near| format!("\ndid you mean `{near}`?"))
        .unwrap_or_default()
}
