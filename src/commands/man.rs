//! Command `hyzer man`: manual pages.

use clap::CommandFactory;

use crate::cli::{Cli, Man};
use crate::{Answer, output};

/// Runs `hyzer man`: writes `hyzer.1` and a page `hyzer-COMMAND.1` for each command. Always returns `Answer::Yes`.
pub fn run(options: &Man) -> anyhow::Result<Answer> {
    let mut program = Cli::command();
    program.build();
    let commands: Vec<clap::Command> = program.get_subcommands().cloned().collect();
    for command in std::iter::once(program).chain(commands) {
        let name = command.get_display_name().unwrap_or("hyzer").to_owned();
        let mut page = Vec::new();
        clap_mangen::Man::new(command).render(&mut page)?;
        output::write(&options.out.join(format!("{name}.1")), page)?;
    }
    eprintln!("manual pages: {}", options.out.display());
    Ok(Answer::Yes)
}
