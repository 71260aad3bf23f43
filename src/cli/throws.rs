//! Arguments of the commands on throws and flights.

use std::path::PathBuf;

use clap::Args;
use report::{FigureKind, Units};

/// A throw given by its quantities, or by a launch monitor. Options take precedence over the release and the launch
/// monitor.
#[derive(Args)]
#[command(next_help_heading = "Throw")]
pub struct ThrowOptions {
    /// Speed over the ground, m/s
    #[arg(long, value_name = "M/S", allow_hyphen_values = true)]
    pub speed: Option<String>,
    /// Direction of the velocity over the ground, measured from +x, positive to the left, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub heading: Option<String>,
    /// Angle of the velocity above the horizontal, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub launch: Option<String>,
    /// Angle of attack, positive nose-up, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub nose: Option<String>,
    /// Tilt about the velocity, positive when the left edge is the lower one, seen from behind, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub hyzer: Option<String>,
    /// Spin, positive clockwise seen from above, rpm
    #[arg(long, value_name = "RPM", allow_hyphen_values = true)]
    pub spin: Option<String>,
    /// Height at release, m; by default 1
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub height: Option<String>,
    /// Wobble: half the opening angle of the cone that the axis describes, deg
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub wobble: Option<String>,
    /// Throws of a launch monitor: a CSV file of TechDisc
    #[arg(long, value_name = "FILE", conflicts_with = "release")]
    pub techdisc: Option<PathBuf>,
    /// Fly only this throw of the launch monitor: its id, or its number from 1
    #[arg(long, value_name = "ID|N", requires = "techdisc")]
    pub row: Option<String>,
}

impl ThrowOptions {
    /// Names and texts of the throw options that were given on the command line.
    pub fn given(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let all = [
            ("speed", &self.speed),
            ("heading", &self.heading),
            ("launch", &self.launch),
            ("nose", &self.nose),
            ("hyzer", &self.hyzer),
            ("spin", &self.spin),
            ("height", &self.height),
            ("wobble", &self.wobble),
        ];
        all.into_iter()
            .filter_map(|(name, text)| Some((name, text.as_deref()?)))
    }
}

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
    /// Coefficients of a fit, with their standard errors in the spread: report.json of `hyzer fit`; --set goes before it
    #[arg(long, value_name = "FILE")]
    pub fit: Option<PathBuf>,
    /// Number of flights that are sampled for the spread
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    pub samples: u32,
    /// Number of throws that are simulated to find starting points for local searches
    #[arg(long, value_name = "N", default_value_t = 384, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub starts: u32,
    /// Units of --target and --wind, and of what is printed: si, or imperial for mph and ft; files, --bounds too, are in SI
    #[arg(long, value_name = "UNITS", default_value = "si", value_parser = super::units)]
    pub units: Units,
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
    /// Set a parameter, coefficient or component of an input such as wind_x, SI; may be repeated
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
    /// Also write landings.kml, for maps: the release is at this latitude and longitude, deg, and +x points to this bearing,
    /// deg clockwise from north, by default 90, the east
    #[arg(long, value_name = "LAT,LON[,BEARING]", allow_hyphen_values = true)]
    pub kml: Option<String>,
    /// Units of what is printed: si, or imperial for mph and ft; files are in SI
    #[arg(long, value_name = "UNITS", default_value = "si", value_parser = super::units)]
    pub units: Units,
}
