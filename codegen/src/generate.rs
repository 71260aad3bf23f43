//! Writing of generated files, and comparison of generated files with the files on disk.

use crate::backend::{Backend, SourceFile};
use crate::compile::compile;
use crate::rust;
use model_spec::model::Model;
use similar::TextDiff;
use std::path::{Path, PathBuf};
use std::{fmt, fs, io};

/// Source files of the crate `generated`, sorted by path relative to its `src`.
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

/// Generates the source files of the models `models` with the backend `backend`, sorted by path.
pub fn generate_with(backend: &dyn Backend, models: &[Model]) -> Vec<SourceFile> {
    let each = models.iter();
    let mut files: Vec<SourceFile> = each
        .flat_map(|model| backend.emit(model, &compile(model)))
        .collect();
    files.sort();
    files
}

/// File on disk that differs from its generated text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Path relative to the compared directory.
    pub path: String,
    /// Unified diff from the file on disk to the generated text, or that the file is missing.
    pub text: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Compares `directory`, the `src` directory of the crate `generated` (Rust code of the models), with the files that
/// [`generate`] generates from `models`. Rust files in the directory that are not among the generated files also count
/// as differences. Returns an empty list if nothing differs.
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

/// Compares generated files with the files of equal path in a directory; other files in the directory are ignored.
pub fn check_files(directory: &Path, files: &[SourceFile]) -> io::Result<Vec<Difference>> {
    let mut differences = Vec::new();
    for SourceFile { path, text } in files {
        let found = match fs::read_to_string(directory.join(path)) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                differences.push(Difference {
                    path: path.clone(),
                    text: format!("{path} is missing\n"),
                });
                continue;
            }
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

/// Writes the changed files of the crate `generated` (Rust code of the models) to `directory`, and removes Rust files
/// that are not among the generated files. Returns the paths, relative to `directory`, of all changed and removed
/// files.
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

/// Writes the files whose text differs from the file on disk, each atomically by renaming a temporary file. Returns the
/// paths of the written files, relative to `directory`.
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

/// Paths, relative to `directory`, of the Rust files in it that are not among the generated `files`.
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
