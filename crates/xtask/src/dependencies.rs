//! Checks of the dependencies: each is used, has an allowed licence, and supports the Rust version of the workspace.

use std::path::Path;

use anyhow::{Result, bail};
use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, Package};
use spdx::{Expression, LicenseReq, Licensee};

use crate::source;

/// Licences that dependencies may have, as listed in `deny.toml`.
const ALLOWED: [&str; 11] = [
    "MIT",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "CC0-1.0",
    "ISC",
    "MPL-2.0",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

/// Returns an error if a dependency is unused, has a licence that is not allowed, or needs a newer Rust version than the
/// workspace.
pub fn check(root: &Path) -> Result<()> {
    let metadata = MetadataCommand::new()
        .manifest_path(root.join("Cargo.toml"))
        .other_options(["--locked".to_owned()])
        .exec()?;
    let mut faults = unused(&metadata)?;
    for package in &metadata.packages {
        faults.extend(licence_fault(package));
        faults.extend(compiler_fault(package, &metadata));
    }
    if !faults.is_empty() {
        bail!("{}", faults.join("\n"));
    }
    println!(
        "{} packages: used, allowed, and not too new",
        metadata.packages.len()
    );
    Ok(())
}

/// One message for each dependency that a package of the workspace declares, but that no Rust file of the package uses.
/// Build dependencies are not checked.
fn unused(metadata: &Metadata) -> Result<Vec<String>> {
    let mut faults = Vec::new();
    for package in metadata.workspace_packages() {
        let Some(folder) = package.manifest_path.parent() else {
            continue;
        };
        let mut text = String::new();
        for part in ["src", "tests", "examples", "benches", "build.rs"] {
            let path = folder.join(part);
            let files = match part {
                "build.rs" if path.is_file() => vec![path.into_std_path_buf()],
                _ => source::rust_files(path.as_std_path())?,
            };
            for file in files {
                text += &source::read(&file)?;
            }
        }
        for dependency in &package.dependencies {
            let name = dependency.rename.as_ref().unwrap_or(&dependency.name);
            let name = name.replace('-', "_");
            if dependency.kind != DependencyKind::Build && !names(&text, &name) {
                let message = format!("{} does not use its dependency {name}", package.name);
                faults.push(message);
            }
        }
    }
    Ok(faults)
}

/// Whether the Rust source `text` uses the crate `name`, as the first segment of a path or in an import.
fn names(text: &str, name: &str) -> bool {
    text.match_indices(name).any(|(at, _)| {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let before = text[..at].chars().next_back();
        let after = &text[at + name.len()..];
        let starts = !before.is_some_and(is_word);
        starts && (after.starts_with("::") || after.starts_with(';') || after.starts_with(" as "))
    })
}

fn licence_fault(package: &Package) -> Option<String> {
    let allowed = |requirement: &LicenseReq| {
        ALLOWED
            .iter()
            .any(|name| Licensee::parse(name).is_ok_and(|licensee| licensee.satisfies(requirement)))
    };
    let Some(stated) = &package.license else {
        return Some(format!("{} states no licence", package.name));
    };
    // Older manifests write "A/B" for "A OR B".
    match Expression::parse(&stated.replace('/', " OR ")) {
        Ok(licence) if licence.evaluate(allowed) => None,
        _ => Some(format!(
            "{} has the licence {stated}, which is not allowed",
            package.name
        )),
    }
}

fn compiler_fault(package: &Package, metadata: &Metadata) -> Option<String> {
    let ours = metadata.workspace_packages();
    let ours = ours
        .iter()
        .find_map(|package| package.rust_version.as_ref())?;
    let theirs = package
        .rust_version
        .as_ref()
        .filter(|theirs| *theirs > ours)?;
    Some(format!(
        "{} needs Rust {theirs}, the workspace states {ours}",
        package.name
    ))
}
