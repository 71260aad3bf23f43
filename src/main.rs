//! Command-line program `hyzer`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(hyzer::program::run(std::env::args_os()))
}
