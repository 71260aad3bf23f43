//! Text files of bounded size.

use std::path::Path;

use model_spec::location::line_and_column;

use super::{Fault, ReleaseError};

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
    let refuse = |location, message: String| ReleaseError {
        file: file.clone(),
        faults: vec![Fault { location, message }],
    };
    let unreadable = |e: std::io::Error| refuse(None, format!("cannot be read: {e}"));
    let size = std::fs::metadata(path).map_err(unreadable)?.len();
    if size > max_bytes {
        let message = format!("has {size} bytes; {what} has at most {max_bytes}");
        return Err(refuse(None, message));
    }
    let bytes = std::fs::read(path).map_err(unreadable)?;
    match std::str::from_utf8(&bytes) {
        Ok(text) => read(&file, text),
        Err(e) => {
            let good = String::from_utf8_lossy(&bytes[..e.valid_up_to()]);
            let message = format!(
                "found the byte {:#04x}; expected UTF-8 text",
                bytes[e.valid_up_to()]
            );
            Err(refuse(Some(line_and_column(&good, good.len())), message))
        }
    }
}
