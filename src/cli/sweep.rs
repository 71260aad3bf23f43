//! Arguments of `hyzer sweep`.

use std::path::PathBuf;

use clap::Args;

/// `hyzer sweep`.
#[derive(Args)]
pub struct Sweep {
    /// Plan: a TOML file, or `backhands`
    #[arg(value_name = "PLAN", required_unless_present = "example")]
    pub plan: Option<PathBuf>,
    /// Print a plan to start from
    #[arg(long, exclusive = true)]
    pub example: bool,
    /// Folder for the results: a new or an empty one, or that of the same plan, to go on
    #[arg(long, value_name = "DIR", required_unless_present = "example")]
    pub out: Option<PathBuf>,
    /// Fly the I-th of N equal shares alone, for several processes or machines with one folder
    #[arg(long, value_name = "I/N")]
    pub part: Option<String>,
    /// Number of threads; by default that of the processors
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// Write flights.csv too
    #[arg(long)]
    pub csv: bool,
}
