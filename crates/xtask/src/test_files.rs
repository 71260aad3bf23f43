//! Check that every file of integration tests is part of its test program.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use crate::source;

/// Returns an error if a file in a folder `tests/integration` is not a module of its `main.rs`, so that none of its
/// tests would run.
pub fn check(root: &Path) -> Result<()> {
    let (mut files, mut missing) = (0, Vec::new());
    let name = |file: &PathBuf| source::relative(root, file).to_string();
    for folder in source::crates(root)? {
        let folder = folder.join("tests/integration");
        let beside = source::rust_files(&folder)?;
        let beside = beside.iter().filter(|file| file.parent() == Some(&folder));
        let (main, beside): (Vec<&PathBuf>, Vec<&PathBuf>) =
            beside.partition(|file| file.ends_with("main.rs"));
        let text = main.first().map(|main| source::read(main)).transpose()?;
        let text = text.unwrap_or_default();
        files += beside.len();
        let lost = beside.into_iter().filter(|file| !is_module(&text, file));
        missing.extend(lost.map(name));
    }
    if !missing.is_empty() {
        bail!(
            "no `mod` line in the main.rs beside them, so their tests do not run: {}",
            missing.join(", ")
        );
    }
    println!("{files} files of integration tests are in their programs");
    Ok(())
}

/// Whether the text of a `main.rs` declares the module of a file beside it.
fn is_module(main: &str, file: &Path) -> bool {
    let name = file.file_stem().map(|name| name.to_string_lossy());
    name.is_some_and(|name| {
        let line = format!("mod {name};");
        main.lines()
            .any(|found| found.trim_start_matches("pub ") == line)
    })
}
