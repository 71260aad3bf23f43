//! Makes everything that is handed on into one folder, and tries each part in a clean environment.
//!
//! A program linked statically, with manual pages and completions; the packages of the workspace; the wheel and the
//! source archive of the Python package; a bill of materials; checksums of all of them.

mod bill;
mod python;
mod trial;

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::section;

/// Target of the program. The C library is linked statically, so that it runs on any Linux of this processor.
const TARGET: &str = "x86_64-unknown-linux-gnu";

/// Shells whose completions go with the program.
const SHELLS: [&str; 4] = ["bash", "zsh", "fish", "powershell"];

/// Files beside the program in its archive.
const BESIDE: [&str; 4] = ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// Version of the workspace, of which every part of a release has it.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Makes a release in `out`, which must not exist, and tries it. `quick` leaves out what builds the same code once more: the
/// packages and the source archive of Python from their own files.
pub fn run(root: &Path, out: &Path, quick: bool) -> Result<()> {
    if out.exists() {
        bail!("{} exists; name a new folder", out.display());
    }
    let parts = out.with_extension("part");
    if parts.exists() {
        std::fs::remove_dir_all(&parts)?;
    }
    std::fs::create_dir_all(&parts)?;
    let parts = parts.canonicalize()?;
    let program = program(root, &parts)?;
    section("packages");
    crate::packages::check(root, !quick)?;
    packages(root, &parts)?;
    let tools = python::build(root, &parts)?;
    section("bill of materials");
    bill::write(root, &parts)?;
    section("trials");
    trial::program(root, &program)?;
    trial::python(root, &parts, &tools, quick)?;
    checksums(&parts)?;
    std::fs::rename(&parts, out)?;
    println!("release {VERSION}: {}", out.display());
    Ok(())
}

/// Builds the program and its archive, and returns the path of the archive.
fn program(root: &Path, parts: &Path) -> Result<PathBuf> {
    section("program");
    let build = [
        "build",
        "--profile",
        "dist",
        "--locked",
        "--quiet",
        "--bin",
        "hyzer",
        "--target",
        TARGET,
    ];
    crate::cargo(
        root,
        &build,
        &[("RUSTFLAGS", "-C target-feature=+crt-static")],
    )?;
    let built = target(root)?.join(TARGET).join("dist/hyzer");
    let name = format!("hyzer-{VERSION}-{TARGET}");
    let folder = parts.join(&name);
    let completions = folder.join("completions");
    std::fs::create_dir_all(&completions)?;
    std::fs::copy(&built, folder.join("hyzer"))?;
    for file in BESIDE {
        std::fs::copy(root.join(file), folder.join(file))?;
    }
    run_tool(
        Command::new(&built)
            .arg("man")
            .arg("--out")
            .arg(folder.join("man")),
    )?;
    for shell in SHELLS {
        let script = Command::new(&built).args(["completions", shell]).output()?;
        if !script.status.success() || script.stdout.is_empty() {
            bail!("hyzer completions {shell} failed");
        }
        std::fs::write(completions.join(format!("hyzer.{shell}")), script.stdout)?;
    }
    let archive = parts.join(format!("{name}.tar.gz"));
    let mut tar = Command::new("tar");
    tar.arg("--create")
        .arg("--gzip")
        .arg("--file")
        .arg(&archive);
    run_tool(tar.arg("--directory").arg(parts).arg(&name))?;
    std::fs::remove_dir_all(folder)?;
    Ok(archive)
}

/// Copies the archives of the packages that `cargo package` made.
fn packages(root: &Path, parts: &Path) -> Result<()> {
    let made = target(root)?.join("package");
    let ending = format!("-{VERSION}.crate");
    for entry in std::fs::read_dir(&made).with_context(|| made.display().to_string())? {
        let file = entry?;
        let name = file.file_name().to_string_lossy().into_owned();
        if name.starts_with("hyzer") && name.ends_with(&ending) {
            std::fs::copy(file.path(), parts.join(name))?;
        }
    }
    Ok(())
}

/// Writes `SHA256SUMS`, in the order of the names, as `sha256sum --check` reads it.
fn checksums(parts: &Path) -> Result<()> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(parts)? {
        names.push(entry?.file_name());
    }
    names.sort();
    let sums = Command::new("sha256sum")
        .args(&names)
        .current_dir(parts)
        .output()?;
    if !sums.status.success() {
        bail!(
            "sha256sum failed: {}",
            String::from_utf8_lossy(&sums.stderr)
        );
    }
    std::fs::write(parts.join("SHA256SUMS"), sums.stdout)?;
    Ok(())
}

/// Folder that cargo builds into.
fn target(root: &Path) -> Result<PathBuf> {
    let metadata = cargo_metadata::MetadataCommand::new()
        .manifest_path(root.join("Cargo.toml"))
        .no_deps()
        .exec()?;
    Ok(metadata.target_directory.into_std_path_buf())
}

/// Runs a program to its end. Returns an error if it cannot be started or fails.
fn run_tool(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{command:?}"))?;
    if !status.success() {
        bail!("failed: {command:?}");
    }
    Ok(())
}
