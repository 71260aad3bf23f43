//! Trials of a release: each part is installed into an environment of its own and does what the first page says.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use super::{python, run_tool};

/// What the first page of the Python package promises.
const FIRST_PAGE: &str = "import hyzer; print(*hyzer.diagnose('examples/mystery').causes)";

/// Unpacks the program and runs the first page, with no variable of the caller's environment.
pub fn program(root: &Path, archive: &Path) -> Result<()> {
    let folder = tempfile::tempdir()?;
    let mut tar = Command::new("tar");
    tar.args(["--extract", "--strip-components=1", "--file"])
        .arg(archive);
    run_tool(tar.arg("--directory").arg(folder.path()))?;
    let program = folder.path().join("hyzer");
    let mut loader = Command::new("ldd");
    let linked = loader.arg(&program).output().context("ldd")?;
    let linked = [linked.stdout, linked.stderr].concat();
    let linked = String::from_utf8_lossy(&linked).into_owned();
    if !linked.contains("statically linked") && !linked.contains("not a dynamic executable") {
        bail!("the program is not linked statically: {linked}");
    }
    let mut first = Command::new(&program);
    first.env_clear().current_dir(root);
    first
        .args(["diagnose", "examples/mystery", "--out"])
        .arg(folder.path().join("found"));
    expect(&mut first, "stall")
}

/// Installs the wheel and, unless `quick`, the source archive, and runs the first page of each.
pub fn python(root: &Path, parts: &Path, tools: &Path, quick: bool) -> Result<()> {
    let mut archives = vec![find(parts, ".whl")?];
    if !quick {
        archives.push(find(parts, &format!("hyzer-{}.tar.gz", super::VERSION))?);
    }
    for archive in archives {
        let folder = tempfile::tempdir()?;
        let environment = folder.path().join("environment");
        python::environment(&environment)?;
        let path = std::env::var("PATH").unwrap_or_default();
        let mut install = python::pip(&environment);
        install.env("PATH", format!("{}:{path}", tools.join("bin").display()));
        run_tool(install.arg("install").arg(&archive))?;
        let mut first = Command::new(environment.join("bin/python"));
        expect(first.args(["-c", FIRST_PAGE]).current_dir(root), "stall")?;
        let mut program = Command::new(environment.join("bin/hyzer"));
        expect(program.arg("--version"), super::VERSION)?;
    }
    Ok(())
}

/// Runs a program, which must succeed and print `text`.
fn expect(command: &mut Command, text: &str) -> Result<()> {
    let found = command.output().with_context(|| format!("{command:?}"))?;
    let printed = String::from_utf8_lossy(&found.stdout);
    if !found.status.success() || !printed.contains(text) {
        let errors = String::from_utf8_lossy(&found.stderr);
        bail!("{command:?} did not print {text:?}:\n{printed}{errors}");
    }
    println!("{}: {text}", command.get_program().to_string_lossy());
    Ok(())
}

/// The one file of a folder whose name ends with `ending`.
fn find(folder: &Path, ending: &str) -> Result<PathBuf> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.to_string_lossy().ends_with(ending) {
            return Ok(path);
        }
    }
    bail!("{} has no file *{ending}", folder.display())
}
