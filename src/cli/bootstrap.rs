//! Arguments of `hyzer bootstrap`.

use std::path::PathBuf;

use clap::Args;

use super::FitInputs;

/// Arguments of `hyzer bootstrap`.
#[derive(Args)]
pub struct Bootstrap {
    #[command(flatten)]
    pub inputs: FitInputs,
    /// Ignore the bounds of coefficients in the model
    #[arg(long)]
    pub unbounded: bool,
    /// Number of refits, 2 to 1,000,000
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(2..=1_000_000))]
    pub refits: u64,
    /// Seed of the random draws of flights
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    pub seed: u64,
    /// Folder for the results: a new or an empty one, or that of an interrupted run of the same refits, to continue
    /// it
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Do only the I-th of N equal shares, for several processes or machines with one folder
    #[arg(long, value_name = "I/N")]
    pub part: Option<String>,
}
