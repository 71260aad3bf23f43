//! Task runner of the repository. `cargo xtask check` runs every task that must pass before a change is committed; the
//! tests run separately.

mod api;
mod circles;
mod dependencies;
mod docs;
mod glossary;
mod packages;
mod release;
mod source;
mod test_files;
mod untested;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail};
use clap::{Parser, Subcommand};
use shared_features as _;

#[derive(Parser)]
#[command(
    about = "Tasks of the repository",
    arg_required_else_help = true,
    after_help = "Examples:\n  cargo xtask check\n  cargo xtask circles\n  cargo xtask doc-sample --seed 7 --count 20"
)]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Run every check that a change must pass, except the tests
    Check,
    /// Run rustfmt, clippy and rustdoc, with warnings as errors
    Lint,
    /// Find import cycles between the modules of a crate
    Circles,
    /// Write the snapshot of the library's public API, docs/reference/api.txt
    Api {
        /// Compare the API with the snapshot, and write nothing
        #[arg(long)]
        check: bool,
    },
    /// Find unused dependencies, licences that are not allowed, and packages that need a newer compiler
    Dependencies,
    /// Build every publishable package from its own archive, as a registry would receive it
    Package,
    /// Make a release in one folder and try each part of it in a clean environment: program, packages, Python wheel and
    /// source archive, bill of materials, checksums
    Release {
        /// New folder for the parts
        #[arg(long, default_value = "target/release-parts")]
        out: PathBuf,
        /// Leave out the builds of packages and of the Python source archive from their own files
        #[arg(long)]
        quick: bool,
    },
    /// Find names in docs/reference/glossary.md that occur in no source file
    Glossary,
    /// Find files longer than 500 lines, and print the line count of each crate without its tests
    Lines,
    /// Print a random sample of doc comments, each with the signature of its item
    DocSample {
        /// Seed of the random sample
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Number of comments in the sample
        #[arg(long, default_value_t = 100)]
        count: usize,
    },
}

fn main() -> ExitCode {
    match run(&Cli::parse().task) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(task: &Task) -> Result<()> {
    let root = root()?;
    match task {
        Task::Check => check(&root),
        Task::Lint => lint(&root),
        Task::Circles => circles::check(&root),
        Task::Api { check } => api::run(&root, *check),
        Task::Dependencies => dependencies::check(&root),
        Task::Package => packages::check(&root, true),
        Task::Release { out, quick } => release::run(&root, out, *quick),
        Task::Glossary => glossary::check(&root),
        Task::Lines => source::print_lines(&root),
        Task::DocSample { seed, count } => docs::print_sample(&root, *seed, *count),
    }
}

fn check(root: &Path) -> Result<()> {
    lint(root)?;
    section("dependencies");
    dependencies::check(root)?;
    section("packages");
    packages::check(root, false)?;
    section("import circles and long files");
    circles::check(root)?;
    source::check_lengths(root)?;
    section("public API");
    api::run(root, true)?;
    section("test files");
    test_files::check(root)?;
    untested::check(root)?;
    section("glossary");
    glossary::check(root)
}

fn lint(root: &Path) -> Result<()> {
    section("format");
    cargo(root, &["fmt", "--all", "--check"], &[])?;
    section("clippy");
    let clippy = [
        "clippy",
        "--workspace",
        "--all-targets",
        "--locked",
        "--quiet",
    ];
    cargo(
        root,
        &[&clippy[..], &["--", "-D", "warnings"]].concat(),
        &[],
    )?;
    section("rustdoc");
    let doc = ["doc", "--workspace", "--no-deps", "--locked", "--quiet"];
    cargo(root, &doc, &[("RUSTDOCFLAGS", "-D warnings")])
}

fn section(name: &str) {
    println!("== {name}");
}

/// Runs cargo in the root of the repository. Returns an error if cargo cannot be started or exits with a failure.
fn cargo(root: &Path, arguments: &[&str], environment: &[(&str, &str)]) -> Result<()> {
    let program = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let status = Command::new(program)
        .args(arguments)
        .envs(environment.iter().copied())
        .current_dir(root)
        .status()
        .context("cargo could not be started")?;
    if !status.success() {
        bail!("`cargo {}` failed", arguments.join(" "));
    }
    Ok(())
}

/// Root folder of the repository: two levels above the folder of this crate's manifest.
fn root() -> Result<PathBuf> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = manifest.ancestors().nth(2);
    Ok(root
        .context("xtask lies outside the repository")?
        .to_owned())
}
