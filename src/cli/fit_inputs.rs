//! Arguments shared by all commands that fit a dataset.

use std::path::PathBuf;

use clap::Args;

/// Dataset, model and options of a fit.
#[derive(Args)]
pub struct FitInputs {
    /// Folder with dataset.toml
    pub dataset: PathBuf,
    /// Model: a name or a path; by default that of the dataset
    #[arg(long, value_name = "MODEL")]
    pub model: Option<String>,
    /// Add an effect (optional model extension), by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Fix a coefficient at a value (SI), by default the model's; may be repeated
    #[arg(long, value_name = "NAME[=VALUE]")]
    pub hold: Vec<String>,
    /// Also estimate a parameter or a component of an input, one value for all flights; may be repeated
    #[arg(long, value_name = "NAME")]
    pub free: Vec<String>,
    /// Gaussian prior of a coefficient: mean and standard deviation, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE+-SIGMA")]
    pub prior: Vec<String>,
    /// Also use flights whose data seem faulty: exchanged labels, wrong units or axes, samples in the hand
    #[arg(long)]
    pub trust_data: bool,
    /// Number of threads; the result does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
}
