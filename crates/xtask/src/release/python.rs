//! The wheel and the source archive of the Python package.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use super::{run_tool, target};
use crate::section;

/// Tools that build the wheel: `zig` links against the glibc 2.17 of manylinux2014.
const TOOLS: [&str; 2] = ["maturin>=1.16,<2", "ziglang"];

/// Builds wheel and source archive into `parts`, and returns the environment of the tools.
pub fn build(root: &Path, parts: &Path) -> Result<PathBuf> {
    section("wheel");
    let tools = target(root)?.join("release-tools");
    environment(&tools)?;
    run_tool(pip(&tools).arg("install").args(TOOLS))?;
    let common = ["--manifest-path", "python/Cargo.toml", "--out"];
    let mut wheel = maturin(root, &tools);
    wheel.args([
        "build",
        "--quiet",
        "--profile",
        "wheel-dist",
        "--locked",
        "--zig",
    ]);
    run_tool(
        wheel
            .args(["--compatibility", "manylinux2014"])
            .args(common)
            .arg(parts),
    )?;
    section("source archive");
    run_tool(maturin(root, &tools).arg("sdist").args(common).arg(parts))?;
    Ok(tools)
}

/// Makes a Python environment of its own, or keeps the one there.
pub fn environment(folder: &Path) -> Result<()> {
    let python = std::env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
    run_tool(Command::new(python).args(["-m", "venv"]).arg(folder))
}

/// `pip` of an environment.
pub fn pip(environment: &Path) -> Command {
    let mut pip = Command::new(environment.join("bin/python"));
    pip.args(["-m", "pip", "--quiet", "--disable-pip-version-check"]);
    pip
}

fn maturin(root: &Path, tools: &Path) -> Command {
    let mut maturin = Command::new(tools.join("bin/maturin"));
    let path = std::env::var("PATH").unwrap_or_default();
    maturin.env("PATH", format!("{}:{path}", tools.join("bin").display()));
    maturin.current_dir(root);
    maturin
}
