//! The `hyzer` program: a thin door to the rooms behind it.

mod cli;
mod commands;
mod output;
mod progress;

use std::process::ExitCode;

use clap::Parser;

/// What a command answers: yes, or no (a check that failed). Bad input is an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Answer {
    Yes,
    No,
}

fn main() -> ExitCode {
    let cli = cli::Cli::parse();
    match commands::run(cli.command) {
        Ok(Answer::Yes) => ExitCode::SUCCESS,
        Ok(Answer::No) => ExitCode::from(1),
        Err(error) => {
            // Whoever closed the pipe has read enough.
            let closed = error
                .downcast_ref::<std::io::Error>()
                .is_some_and(|e| e.kind() == std::io::ErrorKind::BrokenPipe);
            if !closed {
                eprintln!("{}", output::told(&error));
            }
            let interrupted = error
                .downcast_ref::<identify::FitError>()
                .is_some_and(|e| *e == identify::FitError::Interrupted);
            ExitCode::from(if interrupted {
                progress::INTERRUPTED
            } else {
                2
            })
        }
    }
}
