//! The source files of the workspace.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

/// Longest file that is read in one sitting, lines.
const MAX_LINES: usize = 500;

/// Folders of the workspace's crates: each has a `Cargo.toml` and a folder `src`.
pub fn crates(root: &Path) -> Result<Vec<PathBuf>> {
    let mut found = vec![
        root.to_owned(),
        root.join("model-spec"),
        root.join("codegen"),
    ];
    for entry in fs::read_dir(root.join("crates"))? {
        let folder = entry?.path();
        if folder.join("Cargo.toml").is_file() {
            found.push(folder);
        }
    }
    found.sort();
    Ok(found)
}

/// Rust files below a folder, sorted; none where there is no such folder.
pub fn rust_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut pending = vec![folder.to_owned()];
    while let Some(folder) = pending.pop() {
        let Ok(entries) = fs::read_dir(&folder) else {
            continue;
        };
        for entry in entries {
            let path = entry?.path();
            if path.is_dir() {
                pending.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// The text of a file.
pub fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| path.display().to_string())
}

/// A path relative to the repository, for messages.
pub fn relative<'p>(root: &Path, path: &'p Path) -> std::path::Display<'p> {
    path.strip_prefix(root).unwrap_or(path).display()
}

/// Whether the files of a crate are written by `hyzer generate`.
pub fn is_generated(folder: &Path) -> bool {
    folder.ends_with("crates/generated")
}

/// Fails where a file is longer than [`MAX_LINES`]; generated files may be.
pub fn check_lengths(root: &Path) -> Result<()> {
    let mut long = Vec::new();
    for folder in crates(root)?.iter().filter(|folder| !is_generated(folder)) {
        for part in ["src", "tests", "examples", "benches"] {
            for file in rust_files(&folder.join(part))? {
                let lines = read(&file)?.lines().count();
                if lines > MAX_LINES {
                    long.push(format!("{} has {lines} lines", relative(root, &file)));
                }
            }
        }
    }
    if !long.is_empty() {
        bail!("longer than {MAX_LINES} lines:\n{}", long.join("\n"));
    }
    println!("no file is longer than {MAX_LINES} lines");
    Ok(())
}

/// Prints the lines under `src` of each crate, without `#[cfg(test)]` modules and test files.
pub fn print_lines(root: &Path) -> Result<()> {
    let mut lines = BTreeMap::new();
    for folder in crates(root)? {
        let name = relative(root, &folder).to_string();
        let mut sum = 0;
        for file in rust_files(&folder.join("src"))? {
            if file.file_stem().is_some_and(|stem| stem == "tests") {
                continue;
            }
            sum += lines_without_tests(&read(&file)?);
        }
        lines.insert(
            if name.is_empty() {
                "src".to_owned()
            } else {
                name
            },
            sum,
        );
    }
    for (name, lines) in &lines {
        println!("{lines:>7}  {name}");
    }
    println!("{:>7}  in all", lines.values().sum::<usize>());
    check_lengths(root)
}

/// Lines before the first `#[cfg(test)]` at the margin that opens a module.
fn lines_without_tests(text: &str) -> usize {
    let lines: Vec<&str> = text.lines().collect();
    let opens_tests = |pair: &[&str]| pair[0] == "#[cfg(test)]" && pair[1].ends_with('{');
    let end = lines.windows(2).position(opens_tests);
    end.unwrap_or(lines.len())
}
