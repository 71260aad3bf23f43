//! Where results go: standard output, or files that appear whole or not at all.

use std::io::Write;
use std::path::Path;

use anyhow::Context;

/// Writes a file, and the folders that it lies in; no reader ever sees half of it.
pub fn write(path: &Path, contents: impl AsRef<[u8]>) -> anyhow::Result<()> {
    let whole = || {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        report::write_atomic(path, contents)
    };
    whole().with_context(|| format!("cannot write {}", path.display()))
}

/// Prints to standard output.
pub fn print(text: impl AsRef<str>) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_ref().as_bytes())?;
    out.flush()?;
    Ok(())
}

/// An error with its causes, as one paragraph.
pub fn told(error: &anyhow::Error) -> String {
    let text = format!("{error:#}");
    // Faults of a model file bring their own heading.
    if text.contains("] Error:") {
        text
    } else {
        format!("error: {text}")
    }
}
