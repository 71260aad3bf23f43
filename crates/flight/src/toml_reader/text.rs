//! Text files of bounded size.

use std::path::Path;

use super::{Fault, ReleaseError};
use crate::files::{Unreadable, bounded_text};

/// Reads a text file and passes its name and text to `read`; `what` describes the expected file, as in `a release`.
///
/// # Errors
/// [`ReleaseError`] if the file cannot be read, is larger than `max_bytes` or is not UTF-8, and the error of `read`.
pub fn read_text<V>(
    path: &Path,
    what: &str,
    max_bytes: u64,
    read: impl FnOnce(&str, &str) -> Result<V, ReleaseError>,
) -> Result<V, ReleaseError> {
    let file = path.display().to_string();
    match bounded_text(path, max_bytes, what) {
        Ok(text) => read(&file, &text),
        Err(Unreadable { location, message }) => Err(ReleaseError {
            file,
            faults: vec![Fault { location, message }],
        }),
    }
}
