//! The program `hyzer` as a function, for its binary and for the Python package.

use std::ffi::OsString;

use ::diagnose::DiagnosisError;
use clap::Parser;
use identify::FitError;

use crate::{Answer, cli, commands, output, progress};

/// What the commands print and write of their results, for the Python package.
pub mod fit {
    pub use crate::commands::fit::{files, model_of, text};
}

/// Runs the program with its arguments, the first of which is the name of the program, and returns the exit status. It
/// installs handlers of signals, and ends the process where the arguments are wrong or ask for help.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let cli = cli::Cli::parse_from(arguments);
    let answer = progress::handle_signals().and_then(|()| commands::run(cli.command));
    match answer {
        Ok(Answer::Yes) => 0,
        Ok(Answer::No) => 1,
        Ok(Answer::Undecided) => 3,
        Err(error) => {
            // A closed pipe on standard output is not an error.
            let closed = error
                .downcast_ref::<std::io::Error>()
                .is_some_and(|e| e.kind() == std::io::ErrorKind::BrokenPipe);
            if !closed {
                eprintln!("{}", output::error_text(&error));
            }
            match fit_error(&error) {
                Some(FitError::FaultyData(_)) => 1,
                _ => 2,
            }
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
