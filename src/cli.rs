//! The command line: names, options and help, as the contract of the program has them.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Declare how a body flies, once; get checked, fast, verified code, and fit it to measured flights.
#[derive(Parser)]
#[command(version, arg_required_else_help = true, max_term_width = 100)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What the program does.
#[derive(Subcommand)]
pub enum Command {
    /// Check models: grammar, units, frames, singular points; say what they mean, and every fault with its place
    #[command(
        after_help = "Example:\n  hyzer check disc ball\n  hyzer check disc_appendix_printed     # refused, and told why"
    )]
    Check(Check),
    /// Compile models to source code: into a folder of your own, or, inside the repository, into crates/generated
    #[command(
        after_help = "Examples:\n  hyzer generate models/kite.hyz disc --out src/models\n  hyzer generate disc --with wind_by_height --out src/models --check\n  hyzer generate --check                # crates/generated\n\nEach model becomes one Rust module over f64 that needs no other crate: `mod kite;`. With --lanes it is generic over\nlanes::Real, for SIMD. Build scripts can call the crate hyzer-build instead."
    )]
    Generate(Generate),
    /// Verify models by every independent check, against their oracle
    #[command(
        after_help = "Example:\n  hyzer verify disc --json\n  hyzer verify                          # all models"
    )]
    Verify(Verify),
    /// Follow one quantity, or its derivative, from its line in the model to formula and code
    #[command(
        after_help = "Example:\n  hyzer explain disc alpha --wrt w\n  hyzer explain disc 'der(u)'"
    )]
    Explain(Explain),
    /// Fly a release to a CSV and a picture
    #[command(
        after_help = "Examples:\n  hyzer simulate disc --release backhand --out flight\n  hyzer simulate disc --release bffl8 --set C_Mq=-0.025 --until ground --out flight\n  hyzer simulate discus --release discus --wind=-5,0,0 --out against\n\nReleases by name: run `hyzer simulate --list`."
    )]
    Simulate(Simulate),
    /// Make a dataset: fly releases of a model, observe its markers, add noise
    #[command(
        after_help = "Examples:\n  hyzer synthesize disc --release backhand --duration 1 --out made\n  hyzer synthesize ball --release serve --flights 4 --held-out 1 --set C_D=0.5 --seed 7 --out balls\n  hyzer synthesize disc --release backhand --with zero_lift_drag_angle --set alpha_0=-0.07 --duration 1 --out odd\n\nReleases by name: run `hyzer simulate --list`. What was put in stands beside the dataset in truth.toml, which\n`hyzer fit` does not read."
    )]
    Synthesize(Synthesize),
    /// Fit a model's coefficients to measured flights
    #[command(
        after_help = "Examples:\n  hyzer fit examples/ball --out fitted\n  hyzer fit examples/disc --with zero_lift_drag_angle --hold C_Nr --profile C_D0 --out fitted\n  hyzer fit examples/disc --model disc_quaternion --prior C_D0=0.1+-0.02 --free wind_x"
    )]
    Fit(Fit),
    /// Find what a model gets wrong of measured flights, name the cause, extend the model, measure the gain
    #[command(
        after_help = "Examples:\n  hyzer diagnose examples/mystery --out found\n  hyzer diagnose examples/ball --without wind_of_each_flight --threads 2\n\nThe folder then holds report.html, report.json, figures, tables and, where something is found, extended.hyz: the model with it\nwritten in, and extended/, its code."
    )]
    Diagnose(Diagnose),
    /// List the effects that a model can be given: what each says, where it acts, when it vanishes and when it does not matter
    #[command(
        after_help = "Examples:\n  hyzer effects ball\n  hyzer effects --out docs/effects.md     # all of them"
    )]
    Effects(Effects),
}

/// `hyzer check`.
#[derive(Args)]
pub struct Check {
    /// Models: names or paths
    #[arg(required = true, value_name = "MODEL")]
    pub models: Vec<String>,
    /// Switch an effect on, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
}

/// `hyzer generate`.
#[derive(Args)]
pub struct Generate {
    /// Models: names or paths; without any, the models of the repository go into its crates/generated
    #[arg(value_name = "MODEL", requires = "out")]
    pub models: Vec<String>,
    /// Folder for the code, one module per model
    #[arg(long, value_name = "DIR", requires = "models")]
    pub out: Option<PathBuf>,
    /// Switch an effect on in all the models, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT", requires = "out")]
    pub with: Vec<String>,
    /// Generic over lanes::Real instead of f64: short for --backend rust-lanes
    #[arg(long, requires = "out", conflicts_with = "backend")]
    pub lanes: bool,
    /// Kind of code
    #[arg(long, value_name = "NAME", default_value = "rust", requires = "out", value_parser = backends())]
    pub backend: String,
    /// Change nothing; print the differences and fail where the code is stale
    #[arg(long)]
    pub check: bool,
    /// The repository, by default the one around the current folder
    #[arg(long, value_name = "DIR", conflicts_with = "out")]
    pub root: Option<PathBuf>,
}

/// The registered backends, each with its description.
fn backends() -> clap::builder::PossibleValuesParser {
    let backends = codegen::backend::BACKENDS.iter();
    let values = backends.map(|backend| {
        clap::builder::PossibleValue::new(backend.name()).help(backend.description())
    });
    clap::builder::PossibleValuesParser::new(values)
}

/// `hyzer verify`.
#[derive(Args)]
pub struct Verify {
    /// Models: names or paths; all built-in ones where none is given
    #[arg(value_name = "MODEL")]
    pub models: Vec<String>,
    /// Switch an effect on, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
    /// Show the kill table: every mutant of the model and the check that finds it
    #[arg(long)]
    pub mutants: bool,
    /// Seed of the random states
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Random states for each check
    #[arg(long, default_value_t = 200)]
    pub cases: usize,
}

/// `hyzer explain`.
#[derive(Args)]
pub struct Explain {
    /// Model: a name or a path
    pub model: String,
    /// A named quantity, a component of one, a force or moment, or `der(u)`
    pub quantity: String,
    /// The state, parameter, coefficient or component of an input to differentiate by
    #[arg(long, value_name = "X")]
    pub wrt: Option<String>,
    /// Switch an effect on, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
}

/// `hyzer simulate`.
#[derive(Args)]
pub struct Simulate {
    /// Model: a name or a path; by default the release's own
    #[arg(value_name = "MODEL")]
    pub model: Option<String>,
    /// A release: a name, or a TOML file
    #[arg(long, value_name = "RELEASE")]
    pub release: Option<String>,
    /// Set a parameter, coefficient or initial state, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Velocity of the air in the inertial frame, m/s
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub wind: Option<String>,
    /// Fly for so many seconds, or until `ground`
    #[arg(long, value_name = "SECONDS|ground")]
    pub until: Option<String>,
    /// Rows of the table per second
    #[arg(long, default_value_t = 120.0)]
    pub rate: f64,
    /// Relative tolerance of the integration
    #[arg(long, default_value_t = 1e-9)]
    pub tolerance: f64,
    /// Switch an effect on, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Folder for trajectory.csv and flight.svg; without it a summary is printed
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// List the named releases
    #[arg(long)]
    pub list: bool,
}

/// `hyzer synthesize`.
#[derive(Args)]
pub struct Synthesize {
    /// Model: a name or a path; by default the release's own
    #[arg(value_name = "MODEL")]
    pub model: Option<String>,
    /// A release: a name, or a TOML file; may be repeated, and the flights take them in turn
    #[arg(long, value_name = "RELEASE", required = true)]
    pub release: Vec<String>,
    /// How many flights
    #[arg(long, value_name = "N", default_value_t = 8)]
    pub flights: usize,
    /// How many of them, the last, are held out
    #[arg(long, value_name = "K", default_value_t = 0)]
    pub held_out: usize,
    /// How far initial states vary: each but the position gets a normal deviation of FRACTION times its size, or
    /// times 5 m/s, 1 rad or 10 rad/s where it is smaller
    #[arg(long, value_name = "FRACTION", default_value_t = 0.1)]
    pub spread: f64,
    /// Watch each flight for so many seconds; by default as its release says
    #[arg(long, value_name = "S")]
    pub duration: Option<f64>,
    /// Samples per second
    #[arg(long, value_name = "HZ", default_value_t = 120.0)]
    pub rate: f64,
    /// Track a point of the body, m; may be repeated; by default three points of a rigid body, the centre of a point mass
    #[arg(long, value_name = "NAME=X,Y,Z")]
    pub marker: Vec<String>,
    /// Standard deviation of the noise along each axis, m
    #[arg(long, value_name = "M", default_value_t = 0.0015)]
    pub noise_sigma: f64,
    /// Correlation of the noise from sample to sample
    #[arg(
        long,
        value_name = "R",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    pub noise_ar1: f64,
    /// Fraction of marker points that are outliers
    #[arg(long, value_name = "FRACTION", default_value_t = 0.0)]
    pub outliers: f64,
    /// Standard deviation of each axis of an outlier, m
    #[arg(long, value_name = "M", default_value_t = 0.05)]
    pub outlier_size: f64,
    /// Fraction of marker points that are not seen: half singly, half in runs of 3 to 12 samples
    #[arg(long, value_name = "FRACTION", default_value_t = 0.0)]
    pub dropouts: f64,
    /// Switch an effect on, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Set a parameter, coefficient or initial state, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Seed of everything random
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Folder for the dataset: a new or an empty one
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// `hyzer fit`.
#[derive(Args)]
pub struct Fit {
    /// Folder with dataset.toml
    pub dataset: PathBuf,
    /// Model: a name or a path; by default the dataset's own
    #[arg(long, value_name = "MODEL")]
    pub model: Option<String>,
    /// Switch an effect on, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Hold a coefficient at a value (SI), by default the model's own; may be repeated
    #[arg(long, value_name = "NAME[=VALUE]")]
    pub hold: Vec<String>,
    /// Estimate a parameter or a component of an input too, one value for all flights; may be repeated
    #[arg(long, value_name = "NAME")]
    pub free: Vec<String>,
    /// What is known of a coefficient beforehand: value and standard deviation, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE+-SIGMA")]
    pub prior: Vec<String>,
    /// Let coefficients leave the bounds of the model's file
    #[arg(long)]
    pub unbounded: bool,
    /// Profile the likelihood of a coefficient: an interval that needs no straight lines; may be repeated
    #[arg(long, value_name = "NAME")]
    pub profile: Vec<String>,
    /// Use flights whose data seem faulty too: exchanged labels, wrong units or axes, samples in the hand
    #[arg(long)]
    pub trust_data: bool,
    /// Flights worked on at once; the result does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// Stop after this many seconds with the best answer so far, which is said in the result
    #[arg(long, value_name = "S")]
    pub max_seconds: Option<f64>,
    /// Folder for report.html, report.json, figures and tables; without it a summary is printed
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// `hyzer diagnose`.
#[derive(Args)]
pub struct Diagnose {
    /// Folder with dataset.toml
    pub dataset: PathBuf,
    /// Model: a name or a path; by default the dataset's own
    #[arg(long, value_name = "MODEL")]
    pub model: Option<String>,
    /// Switch an effect on from the beginning, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Do not look for an effect; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub without: Vec<String>,
    /// Hold a coefficient at a value (SI), by default the model's own; may be repeated
    #[arg(long, value_name = "NAME[=VALUE]")]
    pub hold: Vec<String>,
    /// Estimate a parameter or a component of an input too, one value for all flights; may be repeated
    #[arg(long, value_name = "NAME")]
    pub free: Vec<String>,
    /// What is known of a coefficient beforehand: value and standard deviation, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE+-SIGMA")]
    pub prior: Vec<String>,
    /// Use flights whose data seem faulty too: exchanged labels, wrong units or axes, samples in the hand
    #[arg(long)]
    pub trust_data: bool,
    /// Flights worked on at once; the result does not depend on it
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// Folder for report.html, report.json, the extended model, figures and tables; without it a summary is printed
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// `hyzer effects`.
#[derive(Args)]
pub struct Effects {
    /// Only those that go with this model: a name or a path
    pub model: Option<String>,
    /// File for the page; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}
