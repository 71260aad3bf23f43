//! Recordings of folders.

use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};

/// Extensions of recordings; other files of a folder are not read.
const EXTENSIONS: [&str; 5] = ["c3d", "csv", "trc", "tsv", "txt"];

/// The recordings as named, with those of each folder in its place, in the order of their names.
///
/// # Errors
/// If a folder cannot be read, is a dataset or has no recording.
pub fn recordings(named: &[PathBuf]) -> anyhow::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for path in named {
        match path.is_dir() {
            true => found.extend(in_folder(path)?),
            false => found.push(path.clone()),
        }
    }
    Ok(found)
}

fn in_folder(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let shown = folder.display();
    ensure!(
        !folder.join("dataset.toml").is_file(),
        "{shown}: found a dataset, expected recordings; `hyzer fit {shown}` reads it"
    );
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).with_context(|| shown.to_string())? {
        paths.push(entry.with_context(|| shown.to_string())?.path());
    }
    paths.retain(|path| path.is_file() && is_recording(path));
    paths.sort();
    ensure!(
        !paths.is_empty(),
        "{shown}: found no recording in this folder, expected files that end in .{}",
        EXTENSIONS.join(", .")
    );
    Ok(paths)
}

/// Whether a file has the extension of a recording, and is not hidden.
fn is_recording(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    let mut known = EXTENSIONS.iter();
    !name.starts_with('.') && known.any(|known| extension.eq_ignore_ascii_case(known))
}
