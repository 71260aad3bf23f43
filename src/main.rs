//! Command-line program `hyzer`.

mod cli;
mod commands;
mod output;
mod progress;

use std::process::ExitCode;

use ::diagnose::DiagnosisError;
use clap::Parser;
use identify::FitError;

/// Outcome of a command, which determines the exit status: `Yes` (0); `No` (1), for example if a check fails; or
/// `Undecided` (3). Invalid input is an error instead, with exit status 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Answer {
    Yes,
    No,
    Undecided,
}

fn main() -> ExitCode {
    let cli = cli::Cli::parse();
    let answer = progress::handle_signals().and_then(|()| commands::run(cli.command));
    match answer {
        Ok(Answer::Yes) => ExitCode::SUCCESS,
        Ok(Answer::No) => ExitCode::from(1),
        Ok(Answer::Undecided) => ExitCode::from(3),
        Err(error) => {
            // A closed pipe on standard output is not an error.
            let closed = error
                .downcast_ref::<std::io::Error>()
                .is_some_and(|e| e.kind() == std::io::ErrorKind::BrokenPipe);
            if !closed {
                eprintln!("{}", output::error_text(&error));
            }
            ExitCode::from(match fit_error(&error) {
                Some(FitError::FaultyData(_)) => 1,
                _ => 2,
            })
        }
    }
}

/// Error of a fit that ended the command; `None` if the command ended for another reason.
fn fit_error(error: &anyhow::Error) -> Option<&FitError> {
    match error.downcast_ref::<DiagnosisError>() {
        Some(DiagnosisError::Fit(error)) => Some(error),
        _ => error.downcast_ref(),
    }
}
