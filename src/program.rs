//! The program `hyzer` as a function, for its binary and for the Python package.

use std::ffi::OsString;

use ::diagnose::DiagnosisError;
use clap::Parser;
use identify::FitError;

use crate::{Answer, cli, commands, output, progress};

/// What `hyzer check` prints of a model.
pub mod check {
    pub use crate::commands::check::report;
}

/// What `hyzer bootstrap` refits, prints and writes.
pub mod bootstrap {
    pub use crate::commands::bootstrap::{enough, refits, summary_json, table, text};
}

/// What `hyzer design` prints and writes of a throw.
pub mod design {
    pub use crate::commands::design::{Designed, aims};
}

/// What `hyzer stability` finds and writes.
pub mod stability {
    pub use crate::commands::stability::{files, found, json};
}

/// What `hyzer import` makes of recordings.
pub mod import {
    pub use crate::commands::import::Imported;
}

/// What `hyzer fit` prints and writes of a fit.
pub mod fit {
    pub use crate::commands::fit::{files, model_of, text};
}

/// What `hyzer diagnose` finds and writes.
pub mod diagnose {
    pub use crate::commands::diagnose::{diagnosis, files};
}

/// The plan that `hyzer sweep --example` prints.
pub mod sweep {
    pub use crate::commands::sweep::EXAMPLE;
}

/// What `hyzer simulate` writes of a flight.
pub mod simulate {
    pub use crate::commands::simulate::{Simulated, files, summary_json};
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

/// Error of a fit that ended the command; `None` if the command ended for another reason.
fn fit_error(error: &anyhow::Error) -> Option<&FitError> {
    match error.downcast_ref::<DiagnosisError>() {
        Some(DiagnosisError::Fit(error)) => Some(error),
        _ => error.downcast_ref(),
    }
}
