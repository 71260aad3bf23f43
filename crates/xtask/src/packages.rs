//! Check of the publishable packages: archives and licence files.

use std::path::Path;

use anyhow::{Result, bail};
use cargo_metadata::MetadataCommand;

/// Licence files that every published package must contain.
const LICENSE_FILES: [&str; 2] = ["LICENSE-MIT", "LICENSE-APACHE"];

/// Creates the archive of every publishable package, after a check that it contains the licence files. With `verify`,
/// each package is also built from its own archive, against the archives of the other packages.
pub fn check(root: &Path, verify: bool) -> Result<()> {
    let metadata = MetadataCommand::new()
        .manifest_path(root.join("Cargo.toml"))
        .no_deps()
        .exec()?;
    let mut arguments = vec!["package", "--workspace", "--locked", "--quiet"];
    // Uncommitted changes are included in the check.
    arguments.push("--allow-dirty");
    if !verify {
        arguments.push("--no-verify");
    }
    let mut published = 0;
    let mut faults = Vec::new();
    for package in metadata.workspace_packages() {
        if package.publish.as_ref().is_some_and(Vec::is_empty) {
            arguments.extend(["--exclude", package.name.as_str()]);
            continue;
        }
        published += 1;
        let folder = package.manifest_path.parent();
        for file in LICENSE_FILES {
            if !folder.is_some_and(|folder| folder.join(file).is_file()) {
                faults.push(format!("{} has no {file}", package.name));
            }
        }
    }
    if !faults.is_empty() {
        bail!("{}", faults.join("\n"));
    }
    crate::cargo(root, &arguments, &[])?;
    println!("{published} packages");
    Ok(())
}
