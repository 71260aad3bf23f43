//! The program `hyzer` as a function, for its binary and for the Python package.

use std::ffi::OsString;

use ::diagnose::DiagnosisError;
use clap::Parser;
use identify::FitError;

use crate::{Answer, cli, commands, output, progress};

/// What the commands print and write, for the Python package.
pub use crate::commands::{
    bootstrap, check, design, diagnose, fit, import, simulate, stability, sweep,
};
pub use crate::output::chain;

/// Runs the program with its arguments, the first of which is the name of the program, and returns the exit status. It
/// installs handlers of signals, and ends the process where the arguments are wrong or ask for help.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let cli = cli::Cli::parse_from(arguments);
    output::fit_terminal();
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

/// Imports recordings by the arguments of `hyzer import`, without `--out`.
///
/// # Errors
/// If an argument or a recording is faulty, or no throw is found.
pub fn import_takes(arguments: &[OsString]) -> anyhow::Result<import::Imported> {
    let begin = ["hyzer", "import", "--out=imported"].map(OsString::from);
    let cli = cli::Cli::try_parse_from(begin.iter().chain(arguments))?;
    match cli.command {
        cli::Command::Import(options) => commands::import::imported(&options),
        _ => anyhow::bail!("expected the arguments of hyzer import"),
    }
}

/// Error of a fit that ended the command.
fn fit_error(error: &anyhow::Error) -> Option<&FitError> {
    match error.downcast_ref::<DiagnosisError>() {
        Some(DiagnosisError::Fit(error)) => Some(error),
        _ => error.downcast_ref(),
    }
}
