//! Options of the commands for editors.

use std::path::PathBuf;

use clap::Args;

#[derive(Args)]
pub struct Lsp {
    /// Serve on standard input and output, as without the option; editors add it
    #[arg(long)]
    pub stdio: bool,
}

#[derive(Args)]
pub struct Format {
    /// Files of models and effects; `-` is standard input, whose formatted text is printed
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Write nothing; print the differences and exit with status 1 if a file is not formatted
    #[arg(long)]
    pub check: bool,
}
