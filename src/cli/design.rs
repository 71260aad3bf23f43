//! Arguments of `hyzer design`.

use std::path::PathBuf;

use clap::Args;
use report::FigureKind;

/// Arguments of `hyzer design`.
#[derive(Args)]
pub struct Design {
    /// Goal: the purpose of the throw
    #[arg(long, value_name = "GOAL", value_parser = clap::builder::PossibleValuesParser::new(analysis::design::GOALS))]
    pub goal: String,
    /// Point to hit, to curve to, to flare over or to land at, m; on the ground if Z is 0
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub target: Option<String>,
    /// Bounds of the throw, obstacle, landing circle and scatter: a TOML file
    #[arg(long, value_name = "FILE")]
    pub bounds: Option<PathBuf>,
    /// Model: a name or a path
    #[arg(long, value_name = "MODEL", default_value = "disc")]
    pub model: String,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Set a parameter or coefficient, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Wind: its velocity in the inertial frame, m/s, or a TOML file with [wind]: profiles in height, gusts (docs/reference/wind.md)
    #[arg(long, value_name = "X,Y,Z|FILE", allow_hyphen_values = true)]
    pub wind: Option<String>,
    /// Standard errors of the coefficients, included in the spread: report.json of `hyzer fit`
    #[arg(long, value_name = "FILE")]
    pub fit: Option<PathBuf>,
    /// Number of flights that are sampled for the spread
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    pub samples: u32,
    /// Number of throws that are simulated to find starting points for local searches
    #[arg(long, value_name = "N", default_value_t = 384, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub starts: u32,
    /// Seed of all random numbers
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Number of threads; the result does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub threads: Option<u32>,
    /// Also write every figure as pdf or png; may be repeated
    #[arg(long, value_name = "KIND", value_parser = super::figure_kind, requires = "out")]
    pub figures: Vec<FigureKind>,
    /// Folder for release.toml, design.json, report.html, flight.html and figures: new, empty, or of earlier results, which are
    /// replaced; other files in it are kept
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
