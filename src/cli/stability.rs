//! Arguments of `hyzer stability`.

use std::path::PathBuf;

use clap::Args;
use report::FigureKind;

use super::ThrowOptions;

/// Arguments of `hyzer stability`.
#[derive(Args)]
pub struct Stability {
    /// Model: a name or a path
    pub model: String,
    /// A release: a name, or a TOML file; without it a throw of 16 m/s and 700 rpm, which the options of a throw
    /// modify
    #[arg(long, value_name = "RELEASE")]
    pub release: Option<String>,
    /// Throw given by its quantities
    #[command(flatten)]
    pub throw: ThrowOptions,
    /// Set a parameter or coefficient, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Constant wind: its velocity in the inertial frame, m/s
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub wind: Option<String>,
    /// Number of instants of the flight at which modes are computed
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(2..=10_000))]
    pub times: u32,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
    /// Also write every figure as pdf or png; may be repeated
    #[arg(long, value_name = "KIND", value_parser = super::figure_kind, requires = "out")]
    pub figures: Vec<FigureKind>,
    /// Folder for stability.json, report.html, modes.csv, map.csv and figures: new, empty, or of earlier results, which are replaced;
    /// other files in it are kept
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
