//! Text files of bounded size: what is said where one cannot be read is what was found and what was expected.

use std::fmt;
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use model_spec::location::line_and_column;

/// Why a file has no text: what was found, and what was expected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// Line and column, from 1, of what was found in the file.
    pub location: Option<(usize, usize)>,
    /// One sentence, without the name of the file.
    pub message: String,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((line, column)) = self.location {
            write!(f, "{line}:{column}: ")?;
        }
        f.write_str(&self.message)
    }
}

/// Text of a file of at most `most` bytes; `what` describes the expected file, as in `a release`.
///
/// # Errors
/// [`Unreadable`] if there is no such file, or it is a folder, larger or not UTF-8.
pub fn bounded_text(path: &Path, most: u64, what: &str) -> Result<String, Unreadable> {
    let refuse = |location, message: String| Unreadable { location, message };
    let unreadable = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => refuse(None, format!("found no such file; expected {what}")),
        _ => refuse(None, format!("cannot be read: {error}")),
    };
    let metadata = std::fs::metadata(path).map_err(unreadable)?;
    if metadata.is_dir() {
        return Err(refuse(None, format!("found a folder; expected {what}")));
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(unreadable)?;
    // A pipe does not tell its size before.
    file.take(most + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    let size = metadata.len().max(bytes.len() as u64);
    if size > most {
        let message = format!("has {size} bytes; {what} has at most {most}");
        return Err(refuse(None, message));
    }
    String::from_utf8(bytes).map_err(|error| {
        let (end, bytes) = (error.utf8_error().valid_up_to(), error.as_bytes());
        let good = String::from_utf8_lossy(&bytes[..end]);
        let message = format!("found the byte {:#04x}; expected UTF-8 text", bytes[end]);
        refuse(Some(line_and_column(&good, good.len())), message)
    })
}

/// Reads a JSON text; `what` describes what was expected.
///
/// # Errors
/// If the text is empty or no such JSON: where, what was found, and what was expected.
pub fn json<T: serde::de::DeserializeOwned>(text: &str, what: &str) -> Result<T, Unreadable> {
    if text.trim().is_empty() {
        let message = format!("found an empty file; expected {what}");
        return Err(Unreadable {
            location: None,
            message,
        });
    }
    serde_json::from_str(text).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        let found = error.to_string();
        let place = format!(" at line {line} column {column}");
        let found = found.strip_suffix(&place).unwrap_or(&found);
        let message = if error.is_data() {
            format!("{found}; expected {what}")
        } else if error.is_eof() {
            format!("the text ends too early: {found}; expected {what}")
        } else {
            format!("this is no JSON: {found}; expected {what}")
        };
        Unreadable {
            location: (line > 0).then_some((line, column)),
            message,
        }
    })
}
