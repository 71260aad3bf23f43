//! Arguments of `hyzer bootstrap`.

use std::path::PathBuf;

use clap::Args;

/// `hyzer bootstrap`.
#[derive(Args)]
pub struct Bootstrap {
    /// Folder with dataset.toml
    pub dataset: PathBuf,
    /// Number of refits, 2 to 1,000,000
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(2..=1_000_000))]
    pub refits: u64,
    /// Seed of the draws
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    pub seed: u64,
    /// Folder for the results: a new or an empty one, or that of the same refits, to go on
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Do the I-th of N equal shares alone, for several processes or machines with one folder
    #[arg(long, value_name = "I/N")]
    pub part: Option<String>,
    /// Model: a name or a path; by default the dataset's own
    #[arg(long, value_name = "MODEL")]
    pub model: Option<String>,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Fix a coefficient at a value (SI), by default the model's; may be repeated
    #[arg(long, value_name = "NAME[=VALUE]")]
    pub hold: Vec<String>,
    /// Estimate a parameter or a component of an input too, one value for all flights; may be repeated
    #[arg(long, value_name = "NAME")]
    pub free: Vec<String>,
    /// Gaussian prior of a coefficient: mean and standard deviation, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE+-SIGMA")]
    pub prior: Vec<String>,
    /// Ignore the bounds of coefficients in the model
    #[arg(long)]
    pub unbounded: bool,
    /// Also use flights whose data seem faulty: exchanged labels, wrong units or axes, samples in the hand
    #[arg(long)]
    pub trust_data: bool,
    /// Number of threads; the result does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
}
