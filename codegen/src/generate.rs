//! The whole of `crates/generated/src`: written, or compared with what is there.

use crate::compile::compile;
use crate::rust;
use model_spec::model::Model;
use similar::TextDiff;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Every file, by its path below `src`, in order of path.
pub fn generate(models: &[Model]) -> Vec<(String, String)> {
    let mut ordered: Vec<&Model> = models.iter().collect();
    ordered.sort_by(|a, b| a.name.cmp(&b.name));
    let names: Vec<String> = ordered.iter().map(|model| model.name.clone()).collect();
    let mut files = vec![
        ("lib.rs".to_string(), rust::library(&names)),
        (
            "plain.rs".to_string(),
            include_str!("rust/plain.txt").to_string(),
        ),
        (
            "table.rs".to_string(),
            include_str!("rust/table.txt").to_string(),
        ),
    ];
    for model in ordered {
        files.extend(rust::emit(&compile(model), model));
    }
    files.sort();
    files
}

/// A file that is not as it would be generated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Path below `src`.
    pub path: String,
    /// A unified difference from what is there to what belongs there.
    pub text: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Compares `directory` (the crate's `src`) with what the models give; empty if nothing differs.
///
/// # Errors
/// If the directory cannot be read.
pub fn check(directory: &Path, models: &[Model]) -> io::Result<Vec<Difference>> {
    let files = generate(models);
    let mut differences = Vec::new();
    for (path, text) in &files {
        let there = match fs::read_to_string(directory.join(path)) {
            Ok(there) => there,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(error),
        };
        differences.extend(difference(path, &there, text));
    }
    for path in stale(directory, &files)? {
        let there = fs::read_to_string(directory.join(&path))?;
        differences.extend(difference(&path, &there, ""));
    }
    differences.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(differences)
}

fn difference(path: &str, there: &str, wanted: &str) -> Option<Difference> {
    if there == wanted {
        return None;
    }
    let text = TextDiff::from_lines(there, wanted)
        .unified_diff()
        .context_radius(2)
        .header(&format!("committed/{path}"), &format!("generated/{path}"))
        .to_string();
    Some(Difference {
        path: path.to_string(),
        text,
    })
}

/// Writes what differs, each file whole or not at all, and removes what no model gives any more.
/// Gives the paths that changed.
///
/// # Errors
/// If a file cannot be written.
pub fn write(directory: &Path, models: &[Model]) -> io::Result<Vec<String>> {
    let files = generate(models);
    let mut changed = Vec::new();
    for (path, text) in &files {
        let target = directory.join(path);
        if fs::read_to_string(&target).is_ok_and(|there| there == *text) {
            continue;
        }
        if let Some(folder) = target.parent() {
            fs::create_dir_all(folder)?;
        }
        let temporary = target.with_extension("rs.new");
        fs::write(&temporary, text)?;
        fs::rename(&temporary, &target)?;
        changed.push(path.clone());
    }
    for path in stale(directory, &files)? {
        fs::remove_file(directory.join(&path))?;
        if let Some(folder) = directory.join(&path).parent() {
            // only goes if it is empty
            let _ = fs::remove_dir(folder);
        }
        changed.push(path);
    }
    Ok(changed)
}

/// Rust files that are there and belong to no model.
fn stale(directory: &Path, files: &[(String, String)]) -> io::Result<Vec<String>> {
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
                if !files.iter().any(|(known, _)| *known == name) {
                    found.push(name);
                }
            }
        }
    }
    found.sort();
    Ok(found)
}
