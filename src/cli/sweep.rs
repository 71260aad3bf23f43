//! Arguments of `hyzer sweep`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `hyzer sweep`.
#[derive(Args)]
pub struct Sweep {
    /// Plan: a TOML file, or `backhands`, the built-in one
    #[arg(value_name = "PLAN", required_unless_present = "example")]
    pub plan: Option<PathBuf>,
    /// Print an example of a plan
    #[arg(long, exclusive = true)]
    pub example: bool,
    /// Folder for the results: a new or an empty one, or that of an interrupted run of the same plan, to continue it
    #[arg(long, value_name = "DIR", required_unless_present = "example")]
    pub out: Option<PathBuf>,
    /// Fly only the I-th of N equal shares, for several processes or machines with one folder
    #[arg(long, value_name = "I/N")]
    pub part: Option<String>,
    /// Number of threads; by default the number of processors
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// Also write flights.csv
    #[arg(long)]
    pub csv: bool,
}
