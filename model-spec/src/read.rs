//! Reading of model files, and the files that are built in.

use crate::diagnostic::{Diagnostic, Kind, Source, Span};
use crate::location::line_and_column;
use crate::render::render;
use crate::suggest;
use crate::syntax::{MAX_SOURCE_BYTES, Parsed, too_long};
use std::io;
use std::sync::Arc;
use thiserror::Error;

/// Reads the file of a model or of an effect as text.
pub fn read(path: &str) -> Result<String, LoadError> {
    let unreadable = |error| LoadError::Unreadable {
        path: path.to_owned(),
        error: Arc::new(error),
    };
    let length = std::fs::metadata(path).map_err(unreadable)?.len();
    if length > MAX_SOURCE_BYTES as u64 {
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let Parsed {
            diagnostics,
            source,
            ..
        } = too_long(path, length, 0);
        return Err(LoadError::Faults {
            diagnostics,
            sources: vec![source],
        });
    }
    decode(path, std::fs::read(path).map_err(unreadable)?)
}

/// Decodes the bytes of a model file as UTF-8; messages refer to the file as `name`.
///
/// # Errors
/// [`LoadError::Faults`] if the bytes are not UTF-8, with line and column of the first invalid byte.
pub fn decode(name: &str, bytes: Vec<u8>) -> Result<String, LoadError> {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return Ok(text),
        Err(error) => error,
    };
    let at = error.utf8_error().valid_up_to();
    let bytes = error.as_bytes();
    let (line, column) = line_and_column(&String::from_utf8_lossy(&bytes[..at]), at);
    let message = format!(
        "the file is not UTF-8: byte {at} (0x{:02X}), line {line} column {column}, begins no character",
        bytes[at]
    );
    let mut fault =
        Diagnostic::new(Kind::Lexical, Span::default(), message).help("save the file as UTF-8");
    if at == 0 && (bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF])) {
        fault = fault.note("it begins like a file in UTF-16");
    }
    Err(LoadError::Faults {
        diagnostics: vec![fault],
        sources: vec![Source::new(name, "")],
    })
}

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
    #[error("`{path}` is a folder or a device, not a model file")]
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

include!(concat!(env!("OUT_DIR"), "/library.rs"));

/// Text stored under `name` in a table of built-in files; `None` if the table has no such entry.
pub(crate) fn find(table: &[(&'static str, &'static str)], name: &str) -> Option<&'static str> {
    let entry = table.iter().find(|(own, _)| *own == name);
    entry.map(|(_, text)| *text)
}
