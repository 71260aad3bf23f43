//! Generated files on disk: written, or compared with what is there.

use crate::backend::{Backend, SourceFile};
use crate::compile::compile;
use crate::rust;
use model_spec::model::Model;
use similar::TextDiff;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The files of the crate `generated`, below its `src`, sorted by path.
pub fn generate(models: &[Model]) -> Vec<SourceFile> {
    let mut ordered: Vec<&Model> = models.iter().collect();
    ordered.sort_by(|a, b| a.name.cmp(&b.name));
    let names: Vec<String> = ordered.iter().map(|model| model.name.clone()).collect();
    let mut files = rust::library(&names);
    for model in ordered {
        files.extend(rust::emit(&compile(model), model));
    }
    files.sort();
    files
}

/// The files of some models in the language of a backend, sorted by path.
pub fn generate_with(backend: &dyn Backend, models: &[Model]) -> Vec<SourceFile> {
    let each = models.iter();
    let mut files: Vec<SourceFile> = each
        .flat_map(|model| backend.emit(model, &compile(model)))
        .collect();
    files.sort();
    files
}

/// A file whose text differs from the generated text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Path below the compared directory.
    pub path: String,
    /// Unified difference from the file to the generated text.
    pub text: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Compares `directory`, the `src` of the crate `generated`, with the generated files; files of no model count as
/// differences. Empty if nothing differs.
///
/// # Errors
/// If the directory cannot be read.
pub fn check(directory: &Path, models: &[Model]) -> io::Result<Vec<Difference>> {
    let files = generate(models);
    let mut differences = check_files(directory, &files)?;
    for path in stale(directory, &files)? {
        let found = fs::read_to_string(directory.join(&path))?;
        differences.extend(difference(&path, &found, ""));
    }
    differences.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(differences)
}

/// Compares files with those of the same paths below a directory; other files there are ignored. A missing file counts
/// as empty.
///
/// # Errors
/// If a file cannot be read.
pub fn check_files(directory: &Path, files: &[SourceFile]) -> io::Result<Vec<Difference>> {
    let mut differences = Vec::new();
    for SourceFile { path, text } in files {
        let found = match fs::read_to_string(directory.join(path)) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(error),
        };
        differences.extend(difference(path, &found, text));
    }
    Ok(differences)
}

fn difference(path: &str, found: &str, expected: &str) -> Option<Difference> {
    if found == expected {
        return None;
    }
    let text = TextDiff::from_lines(found, expected)
        .unified_diff()
        .context_radius(2)
        .header(&format!("committed/{path}"), &format!("generated/{path}"))
        .to_string();
    Some(Difference {
        path: path.to_string(),
        text,
    })
}

/// Writes the files of the crate `generated` that differ, and removes the Rust files of no model. Returns the paths
/// that changed.
///
/// # Errors
/// If a file cannot be written.
pub fn write(directory: &Path, models: &[Model]) -> io::Result<Vec<String>> {
    let files = generate(models);
    let mut changed = write_files(directory, &files)?;
    for path in stale(directory, &files)? {
        fs::remove_file(directory.join(&path))?;
        if let Some(folder) = directory.join(&path).parent() {
            // Fails, as intended, unless the folder is empty.
            let _ = fs::remove_dir(folder);
        }
        changed.push(path);
    }
    Ok(changed)
}

/// Writes the files that differ below a directory, each atomically: a file is replaced as a whole or not at all.
/// Returns the paths that changed.
///
/// # Errors
/// If a file cannot be written.
pub fn write_files(directory: &Path, files: &[SourceFile]) -> io::Result<Vec<String>> {
    let mut changed = Vec::new();
    for SourceFile { path, text } in files {
        let target = directory.join(path);
        if fs::read_to_string(&target).is_ok_and(|found| found == *text) {
            continue;
        }
        if let Some(folder) = target.parent() {
            fs::create_dir_all(folder)?;
        }
        let temporary = target.with_extension(format!("{}.tmp", std::process::id()));
        fs::write(&temporary, text)?;
        fs::rename(&temporary, &target)?;
        changed.push(path.clone());
    }
    Ok(changed)
}

/// Rust files below a directory that are not among the generated ones.
fn stale(directory: &Path, files: &[SourceFile]) -> io::Result<Vec<String>> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        let entries = match fs::read_dir(directory.join(&folder)) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(error) => return Err(error),
        };
        for entry in entries {
            let entry = entry?;
            let path = folder.join(entry.file_name());
            if entry.file_type()?.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let name = path.to_string_lossy().replace('\\', "/");
                if !files.iter().any(|known| known.path == name) {
                    found.push(name);
                }
            }
        }
    }
    found.sort();
    Ok(found)
}
