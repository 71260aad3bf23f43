//! Writes pages as files, atomically, and prints to standard output.

use std::io::Write;
use std::path::Path;

use anyhow::Context;
use studies::Page;

/// Writes the text of a documentation page to `file`, and its figures to the same folder.
pub fn write_page(file: &Path, page: &Page) -> anyhow::Result<()> {
    for (name, svg) in &page.figures {
        write(&file.with_file_name(name), svg)?;
    }
    write(file, &page.text)?;
    eprintln!("the page is {}", file.display());
    Ok(())
}

/// Writes `contents` to a file atomically, and creates the file's parent folders if they are missing.
fn write(file: &Path, contents: &str) -> anyhow::Result<()> {
    let whole = || {
        if let Some(folder) = file.parent() {
            std::fs::create_dir_all(folder)?;
        }
        flight::files::write_atomic(file, contents)
    };
    whole().with_context(|| format!("cannot write {}", file.display()))
}

/// Prints a text to standard output and flushes it.
pub fn print(text: impl AsRef<str>) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_ref().as_bytes())?;
    out.flush()?;
    Ok(())
}

/// Whether an error means that the reader of standard output has closed the pipe.
pub fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let error = error.downcast_ref::<std::io::Error>();
    error.is_some_and(|error| error.kind() == std::io::ErrorKind::BrokenPipe)
}
