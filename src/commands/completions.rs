//! Command `hyzer completions`: the completion script of a shell.

use clap::CommandFactory;

use crate::cli::{Cli, Completions};
use crate::{Answer, output};

/// Runs `hyzer completions`: prints the script to standard output. Always returns `Answer::Yes`.
pub fn run(options: &Completions) -> anyhow::Result<Answer> {
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut Cli::command(), "hyzer", &mut script);
    output::print(String::from_utf8_lossy(&script))?;
    Ok(Answer::Yes)
}
