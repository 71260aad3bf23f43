//! Output of the program: standard output, and atomically written files.

use std::io::Write;
use std::path::Path;

use anyhow::Context;

/// Writes `contents` to `path` atomically; creates missing parent folders.
pub fn write(path: &Path, contents: impl AsRef<[u8]>) -> anyhow::Result<()> {
    let whole = || {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        report::write_atomic(path, contents)
    };
    whole().with_context(|| format!("cannot write {}", path.display()))
}

/// Prints text to standard output and flushes it.
pub fn print(text: impl AsRef<str>) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_ref().as_bytes())?;
    out.flush()?;
    Ok(())
}

/// Formats an error with its chain of causes for the terminal, prefixed by `error: `.
pub fn told(error: &anyhow::Error) -> String {
    let text = format!("{error:#}");
    // Rendered diagnostics of a model file have headings of their own.
    if text.contains("] Error:") {
        text
    } else {
        format!("error: {text}")
    }
}
