//! Output of the program: standard output, and result files that are written atomically.

use std::io::Write;
use std::path::Path;

use anyhow::Context;
use flight::files::{ResultFile, ResultFolder, write_atomic};
use report::FigureKind;

use crate::progress;

/// Writes `contents` to `path` atomically; creates missing parent folders.
pub fn write(path: &Path, contents: impl AsRef<[u8]>) -> anyhow::Result<()> {
    let whole = || {
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        write_atomic(path, contents)
    };
    progress::writing(whole).with_context(|| format!("cannot write {}", path.display()))
}

/// Opens the folder that the option `--out` names, if given, so that an unusable folder is an error before any work is
/// done.
pub fn folder(out: Option<&Path>) -> anyhow::Result<Option<ResultFolder>> {
    let open = |path| ResultFolder::open(path).context("--out");
    out.map(open).transpose()
}

/// Checks that an output folder can be created, before any work is done. A folder that already contains files is
/// accepted here; its contents are checked when the results are written.
pub fn new_folder(path: &Path) -> anyhow::Result<()> {
    let holds_files = std::fs::read_dir(path).is_ok_and(|mut entries| entries.next().is_some());
    if !holds_files {
        folder(Some(path))?;
    }
    Ok(())
}

/// Replaces the results of an earlier run in a folder by `files`, all at once.
pub fn replace(folder: &ResultFolder, files: &[ResultFile]) -> anyhow::Result<()> {
    progress::writing(|| folder.replace(files)).context("--out")
}

/// Appends to `files` a conversion of each SVG figure among them to each of the requested `kinds`.
pub fn add_figures(files: &mut Vec<ResultFile>, kinds: &[FigureKind]) -> anyhow::Result<()> {
    for kind in FigureKind::ALL.iter().filter(|kind| kinds.contains(kind)) {
        let mut drawn = Vec::new();
        for file in files.iter() {
            let path = &file.path;
            let Some(stem) = path.strip_suffix(".svg") else {
                continue;
            };
            let svg = std::str::from_utf8(&file.contents).context("--figures")?;
            let picture = kind
                .draw(svg)
                .with_context(|| format!("--figures: {path}"))?;
            drawn.push(ResultFile::new(format!("{stem}.{}", kind.name()), picture));
        }
        files.extend(drawn);
    }
    Ok(())
}

/// Prints text to standard output and flushes it.
pub fn print(text: impl AsRef<str>) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_ref().as_bytes())?;
    out.flush()?;
    Ok(())
}

/// Formats an error with its chain of causes for the terminal, prefixed by `error: `.
pub fn error_text(error: &anyhow::Error) -> String {
    let text = format!("{error:#}");
    // Rendered diagnostics of a model file already have headings.
    if text.contains("] Error:") {
        text
    } else {
        format!("error: {text}")
    }
}
