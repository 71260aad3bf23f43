//! Arguments of the commands that fit a dataset.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use report::FigureKind;

/// Dataset, model and options of a fit.
#[derive(Args)]
pub struct FitInputs {
    /// Folder with dataset.toml
    pub dataset: PathBuf,
    /// Model: a name or a path; by default that of the dataset
    #[arg(long, value_name = "MODEL")]
    pub model: Option<String>,
    /// Add an effect, by name or path; may be repeated
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
    /// Seed of drawing the flights
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

/// Format of tables besides CSV.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableFormat {
    /// Apache Parquet
    Parquet,
}

#[derive(Args)]
pub struct Fit {
    #[command(flatten)]
    pub inputs: FitInputs,
    /// Ignore the bounds of coefficients in the model
    #[arg(long)]
    pub unbounded: bool,
    /// Compute the profile-likelihood interval of a coefficient; may be repeated
    #[arg(long, value_name = "NAME")]
    pub profile: Vec<String>,
    /// Stop after this many seconds with the best answer so far; the result then says so
    #[arg(long, value_name = "S")]
    pub max_seconds: Option<f64>,
    /// Also write every figure as pdf or png; may be repeated
    #[arg(long, value_name = "KIND", value_parser = super::figure_kind, requires = "out")]
    pub figures: Vec<FigureKind>,
    /// Also write every CSV table in another format; may be repeated
    #[arg(long, value_enum, value_name = "FORMAT", requires = "out")]
    pub tables: Vec<TableFormat>,
    /// Folder for report.html, report.json, fitted.hyz, figures and tables: new, empty, or of earlier results, which are
    /// replaced; other files in it are kept
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

#[derive(Args)]
pub struct Diagnose {
    #[command(flatten)]
    pub inputs: FitInputs,
    /// Exclude an effect from the tests; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub without: Vec<String>,
    /// Stop after this many seconds with the best answer so far; the result then says so
    #[arg(long, value_name = "S")]
    pub max_seconds: Option<f64>,
    /// Also write every figure as pdf or png; may be repeated
    #[arg(long, value_name = "KIND", value_parser = super::figure_kind, requires = "out")]
    pub figures: Vec<FigureKind>,
    /// Also write every CSV table in another format; may be repeated
    #[arg(long, value_enum, value_name = "FORMAT", requires = "out")]
    pub tables: Vec<TableFormat>,
    /// Folder for report.html, report.json, the extended model, figures and tables: new, empty, or of earlier results, which
    /// are replaced; other files in it are kept
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
