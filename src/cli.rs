//! The command line: commands, options and their help.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use report::{FigureKind, Units};

mod editor;
mod fits;
mod throws;

pub use editor::{Format, Lsp};
pub use fits::{Bootstrap, Diagnose, Fit, FitInputs, TableFormat};
pub use throws::{Design, Stability, Sweep, ThrowOptions};

/// Declare how a body flies, once; get checked, fast, verified code, and fit it to measured flights.
#[derive(Parser)]
#[command(version, arg_required_else_help = true, max_term_width = 100)]
pub struct Cli {
    /// Command to run.
    #[command(subcommand)]
    pub command: Command,
}

/// Commands of the program.
#[derive(Subcommand)]
pub enum Command {
    /// Check models: grammar, units, frames, singular points; print what they declare, and every error with its
    /// location
    #[command(
        after_help = "Example:\n  hyzer check disc ball\n  hyzer check disc_appendix_printed     # refused, with the reasons"
    )]
    Check(Check),
    /// Format the files of models and effects: white space alone, with every token and comment as it is
    #[command(
        after_help = "Examples:\n  hyzer format kite.hyz wing.hyz\n  hyzer format --check kite.hyz         # shows the difference, exit status 1\n  hyzer format - < kite.hyz\n\nA file with errors of grammar is refused, and then none of the files is written. Rules: docs/how-to/editor.md."
    )]
    Format(Format),
    /// Compile models to source code: into a folder of your own, or, inside the repository, into crates/generated
    #[command(
        after_help = "Examples:\n  hyzer generate models/kite.hyz disc --out src/models\n  hyzer generate disc --with wind_by_height --out src/models --check\n  hyzer generate --check                # crates/generated\n\nEach model becomes one Rust module over f64 that needs no other crate: `mod kite;`. With --lanes it is generic over\nlanes::Real, for SIMD. Build scripts can use hyzer_codegen::build instead."
    )]
    Generate(Generate),
    /// Export a model for other programs: its equations, derivatives and observation as JSON
    #[command(
        after_help = "Examples:\n  hyzer export disc --ir --out disc.json\n  hyzer export ball --with magnus --ir\n\nThe format, and what reads it: docs/reference/ir.md. hyzer.ir in Python makes NumPy, JAX, CasADi and SymPy functions of it."
    )]
    Export(Export),
    /// Verify models by every independent check against a reference implementation
    #[command(
        after_help = "Example:\n  hyzer verify disc --json\n  hyzer verify                          # all models\n  hyzer verify disc --rounding\n  hyzer verify disc --json > disc.json  # verdicts, and hashes (SHA-256) of the texts and of the generated code\n  hyzer verify --check disc.json        # the same verification again\n\nWith --check the exit status is 0 where hashes and verdicts agree, 1 where they differ, 2 for a bad file.\n\nExit status: 0 verified, every check that applies was made and holds; 1 refuted, at least one check fails; 3 not verified,\nno check fails and at least one that applies could not be made: the table says which and why. A check that is `skipped` does\nnot apply to the model."
    )]
    Verify(Verify),
    /// Compare two versions of a model: which derivatives are exactly the same function, and in which terms the
    /// others differ
    #[command(
        after_help = "Examples:\n  hyzer diff disc_appendix_printed disc_appendix\n  hyzer diff disc disc_appendix --release backhand --json\n\nFor a file at a revision of git: git show REVISION:PATH > old.hyz\n\nStates, parameters and inputs correspond by name; statements may be reordered, factored or written in another frame.\nWhether a derivative is the same function of states, parameters and time is decided by evaluation at random points of a\nprime field; where functions differ as symbols and agree in numbers to rounding, the output says so. Exit status: 0 the\nsame function (default values may differ, they are among the statements), 1 another function."
    )]
    Diff(Diff),
    /// Trace one quantity, or its derivative, from its line in the model to formula and code
    #[command(
        after_help = "Example:\n  hyzer explain disc alpha --wrt w\n  hyzer explain disc 'der(u)'\n  hyzer explain disc C_L --format latex"
    )]
    Explain(Explain),
    /// Simulate a release; write the trajectory and a figure
    #[command(
        after_help = "Examples:\n  hyzer simulate disc --release backhand --out flight\n  hyzer simulate disc --release bffl8 --set C_Mq=-0.025 --until ground --out flight\n  hyzer simulate discus --release discus --wind=-5,0,0 --out flight\n  hyzer simulate disc --speed 20 --launch 8 --nose 2 --hyzer 10 --spin 700 --height 1.5 --out flight\n  hyzer simulate disc --speed 45 --launch 8 --spin 700 --units imperial     # 45 mph; distances in ft\n  hyzer simulate disc --techdisc examples/throws/techdisc.csv --out flight\n  hyzer simulate disc --speed 20 --nose 2 --spin 700 --wind examples/throws/gusty.toml --out flight\n\nReleases by name: run `hyzer simulate --list`. A throw by options needs --speed or a release whose throw the options change;\nsigns of the angles: docs/reference/releases.md. With --techdisc every row is flown and listed, or the one of --row; exit status 1: some\ncould not be flown."
    )]
    Simulate(Simulate),
    /// Simulate many flights of a model: releases, coefficients and wind from grids or distributions; write a table
    /// and a summary
    #[command(
        after_help = "Examples:\n  hyzer sweep backhands --out swept --csv\n  hyzer sweep backhands --out swept --kml 47.3769,8.5417 --units imperial\n  hyzer sweep backhands --part 2/4 --out swept   # one quarter; without --part the rest is flown and all joined\n\nA plan is a release file with what varies: `hyzer sweep --example` prints the built-in one, docs/reference/sweep.md has all of the\nformat. The folder then holds flights.parquet, a row per flight, summary.json and report.html with a map of the landings. A flight depends on the plan and its\nnumber alone: results are the same bits for any number of threads and however the work is divided. A run that was ended goes\non with the same command."
    )]
    Sweep(Sweep),
    /// Find a throw for a purpose: hit a point, fly farthest or longest, avoid an obstacle, flare, land with the
    /// least spread
    #[command(
        after_help = "Examples:\n  hyzer design --goal hit --target 30,5,0 --out designed\n  hyzer design --goal range --model discus --wind=-5,0,0 --out designed\n  hyzer design --goal curve --target 30,0,0 --bounds examples/design/round-a-tree.toml --out designed\n  hyzer design --goal flare --target 25,0,1.5\n  hyzer simulate --release designed/release.toml       # flies it\n\nGoals, bounds and what is written: docs/how-to/design-a-throw.md. Exit status: 0 the throw serves its purpose, 1 none within the bounds was\nfound to, and the nearest is written, 2 bad input."
    )]
    Design(Design),
    /// Compute the modes of the linearised motion with frequency and damping, criteria of stability, maps over speed
    /// and spin
    #[command(
        after_help = "Examples:\n  hyzer stability disc --out modes\n  hyzer stability disc --speed 14 --spin 300 --nose 4\n  hyzer stability discus --release discus --json\n\nDerivations, and what the names of the modes mean: docs/explanation/stability.md."
    )]
    Stability(Stability),
    /// Make a synthetic dataset: simulate releases of a model, observe its markers, add noise
    #[command(
        after_help = "Examples:\n  hyzer synthesize disc --release backhand --duration 1 --out made\n  hyzer synthesize ball --release serve --flights 4 --held-out 1 --set C_D=0.5 --seed 7 --out balls\n  hyzer synthesize disc --release backhand --with zero_lift_drag_angle --set alpha_0=-0.07 --duration 1 --out odd\n\nReleases by name: run `hyzer simulate --list`. The true values are written to the dataset's folder as\ntruth.toml, which `hyzer fit` does not read."
    )]
    Synthesize(Synthesize),
    /// Convert recordings of a laboratory (C3D, Vicon, Qualisys, OptiTrack, DLTdv8, poses, CSV) to a dataset of the
    /// free flights
    #[command(
        after_help = "Examples:\n  hyzer import examples/disc/flight01.csv --length m --time s --up +z --markers examples/disc/dataset.toml --out imported\n  hyzer import examples/ball/flight01.csv examples/ball/flight02.csv --length m --time s --up +z --markers examples/ball/dataset.toml --model ball --out imported\n\nThe format is recognised by the content. Units and axes are as a file states them; what it does not state is asked for by an\noption. The template of --markers is a dataset.toml, of which [[markers]], [parameters] and model are taken. Without it the positions\nof the markers are estimated from the throws of all takes, with their standard errors. What was decided is printed, and written to\nimport.txt in the dataset's folder; import.html shows each flight as it was cut."
    )]
    Import(Import),
    /// Estimate a model's coefficients from measured flights, with their uncertainty
    #[command(
        after_help = "Examples:\n  hyzer fit examples/ball --out fitted\n  hyzer fit examples/disc --with zero_lift_drag_angle --hold C_Nr --profile C_D0 --out fitted\n  hyzer fit examples/disc --model disc_quaternion --prior C_D0=0.1+-0.02 --free wind_x\n  hyzer fit examples/ball --tables parquet --out fitted\n\nThe folder then holds report.html, report.json, fitted.hyz (the model with the estimates as its default values), figures and\ntables. Exit status 1: the answer cannot be relied on; the output says why."
    )]
    Fit(Fit),
    /// Refit to flights drawn with replacement: standard errors and intervals without assuming a distribution
    #[command(
        after_help = "Examples:\n  hyzer bootstrap examples/disc --refits 200 --out scattered\n  hyzer bootstrap examples/disc --refits 200 --part 2/4 --out scattered   # one quarter; without --part the rest is done and all joined\n\nThe folder then holds refits.csv, a row of estimates per refit, and summary.json. A refit depends on the dataset, the options and\nits number alone: results are the same bits for any number of threads and however the work is divided. A run that was ended goes on\nwith the same command. Exit status 1: the fit itself cannot be relied on; the output says why."
    )]
    Bootstrap(Bootstrap),
    /// Test a model for missing effects with measured flights, extend it, and measure the gain in prediction
    #[command(
        after_help = "Examples:\n  hyzer diagnose examples/mystery --out found\n  hyzer diagnose examples/ball --without wind_of_each_flight --threads 2\n\nThe folder then holds report.html, report.json, figures, tables and, if an effect is found, extended.hyz (the model with that\neffect and the estimates as its default values) and its Rust code, extended/. Exit status 1: the answer cannot be relied on;\nthe output says why."
    )]
    Diagnose(Diagnose),
    /// List the effects that can be added to a model: where each acts, its null value, its smallest effect of interest
    #[command(
        after_help = "Examples:\n  hyzer effects ball\n  hyzer effects ball --format text      # as on a terminal\n  hyzer effects --out docs/reference/effects.md     # all of them"
    )]
    Effects(Effects),
    /// Serve an editor with errors, hover, completion and more, by the language server protocol
    #[command(
        after_help = "Example:\n  hyzer lsp                             # started by an editor: docs/how-to/editor.md\n\nMessages are read from standard input and answered on standard output. Exit status: 0 after `shutdown` and `exit`, 1 if\nthe client ended without."
    )]
    Lsp(Lsp),
    /// List the built-in models
    #[command(after_help = "Example:\n  hyzer models")]
    Models,
    /// Print the completion script of a shell
    #[command(
        after_help = "Examples:\n  hyzer completions bash > ~/.local/share/bash-completion/completions/hyzer\n  hyzer completions zsh > ~/.zfunc/_hyzer        # a folder of fpath\n  hyzer completions fish > ~/.config/fish/completions/hyzer.fish\n  hyzer completions powershell >> $PROFILE"
    )]
    Completions(Completions),
    /// Write the manual pages, one for the program and one for each command
    #[command(after_help = "Example:\n  hyzer man --out ~/.local/share/man/man1; man hyzer-fit")]
    Man(Man),
}

#[derive(Args)]
pub struct Completions {
    /// Shell that reads the script
    pub shell: clap_complete::Shell,
}

#[derive(Args)]
pub struct Man {
    /// Folder to write the pages to, created if missing; other files in it stay
    #[arg(long)]
    pub out: PathBuf,
}

#[derive(Args)]
pub struct Check {
    /// Models: names or paths
    #[arg(required = true, value_name = "MODEL")]
    pub models: Vec<String>,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
}

#[derive(Args)]
pub struct Generate {
    /// Models: names or paths; without any, generate the models of the repository into its crates/generated
    #[arg(value_name = "MODEL", requires = "out")]
    pub models: Vec<String>,
    /// Folder for the code, one module per model
    #[arg(long, value_name = "DIR", requires = "models")]
    pub out: Option<PathBuf>,
    /// Add an effect to all the models, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT", requires = "out")]
    pub with: Vec<String>,
    /// Generate code generic over lanes::Real instead of f64: short for --backend rust-lanes
    #[arg(long, requires = "out", conflicts_with = "backend")]
    pub lanes: bool,
    /// Backend: the kind of code to generate
    #[arg(long, value_name = "NAME", default_value = "rust", requires = "out", value_parser = backends())]
    pub backend: String,
    /// Write nothing; print the differences and exit with status 1 if the code is stale
    #[arg(long)]
    pub check: bool,
    /// Root folder of the repository, by default the one around the current folder
    #[arg(long, value_name = "DIR", conflicts_with = "out")]
    pub root: Option<PathBuf>,
}

#[derive(Args)]
pub struct Export {
    /// Model: a name or a path
    pub model: String,
    /// Write the model as JSON, in the format of docs/reference/ir.md
    #[arg(long, required = true)]
    pub ir: bool,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, alias = "effect", value_name = "EFFECT")]
    pub with: Vec<String>,
    /// File to write; without it the model is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Parser of the names of the registered backends, with their descriptions as help.
fn backends() -> clap::builder::PossibleValuesParser {
    let backends = codegen::BACKENDS.iter();
    let values = backends.map(|backend| {
        clap::builder::PossibleValue::new(backend.name()).help(backend.description())
    });
    clap::builder::PossibleValuesParser::new(values)
}

/// Parses the value of the option `--units`.
fn units(name: &str) -> Result<Units, String> {
    Units::parse(name).ok_or_else(|| "expected si or imperial".to_owned())
}

/// Parses the name of a kind of figure file, pdf or png. An error if the program cannot write it.
fn figure_kind(name: &str) -> Result<FigureKind, String> {
    let mut kinds = FigureKind::ALL.into_iter();
    let kind = kinds.find(|kind| kind.name() == name);
    let kind = kind.ok_or_else(|| "expected pdf or png".to_owned())?;
    kind.available().map_err(|error| error.to_string())
}

#[derive(Args)]
pub struct Verify {
    /// Models: names or paths; by default all built-in ones
    #[arg(value_name = "MODEL")]
    pub models: Vec<String>,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
    /// Mutation test: list every mutant of the model, and the check that detects it
    #[arg(long)]
    pub mutants: bool,
    /// Measure rounding errors of each backend and function at many states; list the statements of the model that
    /// lose digits
    #[arg(long)]
    pub rounding: bool,
    /// Seed of the random states
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Number of random states for each check
    #[arg(long, default_value_t = 200)]
    pub cases: usize,
    /// Repeat a verification whose JSON is in a file, and list each hash or verdict that differs
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with_all = ["models", "with", "mutants", "rounding", "seed", "cases"]
    )]
    pub check: Option<PathBuf>,
}

#[derive(Args)]
pub struct Diff {
    /// Model before the change: a name or a path
    pub old: String,
    /// Model after the change: a name or a path
    pub new: String,
    /// Add an effect to both models, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Fly a release with both models, and print where and when each flight ends; may be repeated
    #[arg(long, value_name = "RELEASE")]
    pub release: Vec<String>,
    /// Print the result as JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Args)]
pub struct Explain {
    /// Model: a name or a path
    pub model: String,
    /// Quantity to trace: a named quantity, a component of one, a force or moment, or `der(u)`
    pub quantity: String,
    /// State, parameter, coefficient or component of an input to differentiate with respect to
    #[arg(long, value_name = "X")]
    pub wrt: Option<String>,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Notation of the formulas; by default text on a terminal and latex elsewhere
    #[arg(long, value_enum, value_name = "NOTATION")]
    pub format: Option<Notation>,
}

/// Notation of formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Notation {
    /// Plain text, to read
    Text,
    /// LaTeX, for a paper or a page
    Latex,
}

#[derive(Args)]
pub struct Simulate {
    /// Model: a name or a path; by default that of the release
    #[arg(value_name = "MODEL")]
    pub model: Option<String>,
    /// A release: a name, or a TOML file
    #[arg(long, value_name = "RELEASE")]
    pub release: Option<String>,
    /// Throw given by its quantities, or by a launch monitor
    #[command(flatten)]
    pub throw: ThrowOptions,
    /// Set a parameter, coefficient, component of an input such as wind_x, or initial state, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Wind: its velocity in the inertial frame, m/s, or a TOML file with [wind]: profiles in height, gusts (docs/reference/wind.md)
    #[arg(long, value_name = "X,Y,Z|FILE", allow_hyphen_values = true)]
    pub wind: Option<String>,
    /// Duration of the flight, s, or `ground` to stop there
    #[arg(long, value_name = "SECONDS|ground")]
    pub until: Option<String>,
    /// Units of the options of the throw and of the wind, and of what is printed: si, or imperial for mph and ft; files are in SI
    #[arg(long, value_name = "UNITS", default_value = "si", value_parser = units)]
    pub units: Units,
    /// Rows of trajectory.csv per second
    #[arg(long, default_value_t = 120.0)]
    pub rate: f64,
    /// Relative tolerance of the integration
    #[arg(long, default_value_t = 1e-9)]
    pub tolerance: f64,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Also write every figure as pdf or png; may be repeated
    #[arg(long, value_name = "KIND", value_parser = figure_kind, requires = "out")]
    pub figures: Vec<FigureKind>,
    /// Folder for trajectory.csv, summary.json, flight.svg and flight.html: new, empty, or of earlier results, which are replaced
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// List the named releases
    #[arg(long)]
    pub list: bool,
}

#[derive(Args)]
pub struct Synthesize {
    /// Model: a name or a path; by default that of the release
    #[arg(value_name = "MODEL")]
    pub model: Option<String>,
    /// A release: a name, or a TOML file; may be repeated, and the flights then use the releases in turn
    #[arg(long, value_name = "RELEASE", required = true)]
    pub release: Vec<String>,
    /// Number of flights
    #[arg(long, value_name = "N", default_value_t = 8)]
    pub flights: usize,
    /// Number of held-out flights: the last ones of the dataset
    #[arg(long, value_name = "K", default_value_t = 0)]
    pub held_out: usize,
    /// Standard deviation of the initial states except the position, as a fraction of each state's magnitude or of 5
    /// m/s, 1 rad or 10 rad/s, whichever is larger
    #[arg(long, value_name = "FRACTION", default_value_t = 0.1)]
    pub spread: f64,
    /// Duration of each flight, s; by default that of its release
    #[arg(long, value_name = "S")]
    pub duration: Option<f64>,
    /// Samples per second
    #[arg(long, value_name = "HZ", default_value_t = 120.0)]
    pub rate: f64,
    /// Add a marker at a position in the body frame, m; may be repeated; by default three markers on a rigid body, one at the
    /// centre of a point mass
    #[arg(long, value_name = "NAME=X,Y,Z")]
    pub marker: Vec<String>,
    /// Standard deviation of the noise along each axis, m
    #[arg(long, value_name = "M", default_value_t = 0.0015)]
    pub noise_sigma: f64,
    /// Lag-1 autocorrelation of the noise
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
    /// Standard deviation of an outlier along each axis, m
    #[arg(long, value_name = "M", default_value_t = 0.05)]
    pub outlier_size: f64,
    /// Fraction of missing marker points: half isolated, half in runs of 3 to 12 samples
    #[arg(long, value_name = "FRACTION", default_value_t = 0.0)]
    pub dropouts: f64,
    /// Add an effect, by name or path; may be repeated
    #[arg(long, value_name = "EFFECT")]
    pub with: Vec<String>,
    /// Set a parameter, coefficient, component of an input such as wind_x, or initial state, SI; may be repeated
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Seed of all random numbers
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Folder for the dataset: a new or an empty one
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

#[derive(Clone, Args)]
pub struct Import {
    /// Recordings: motion-capture files of a laboratory or folders of them, or with --launch-monitor the table of the shots
    #[arg(required = true, value_name = "TAKE")]
    pub takes: Vec<PathBuf>,
    /// Format: c3d, vicon, qualisys, qualisys-6dof, optitrack, dltdv, poses or csv; by default recognised by the content
    #[arg(long, value_name = "FORMAT")]
    pub format: Option<String>,
    /// Unit of the coordinates, if a file states none or a wrong one: m, cm, mm, in or ft
    #[arg(long, value_name = "UNIT")]
    pub length: Option<String>,
    /// Unit of the times, if a file states none or a wrong one: s or ms
    #[arg(long, value_name = "UNIT")]
    pub time: Option<String>,
    /// Frames per second, if a file states none or a wrong value
    #[arg(long, value_name = "HZ")]
    pub rate: Option<f64>,
    /// Axis of the file that points up, if the file states none or a wrong one: +z, -z, +y, -y, +x or -x
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<String>,
    /// The axes of the file are left-handed
    #[arg(long)]
    pub left_handed: bool,
    /// Rename a label of the files to the name of a marker in the template; may be repeated
    #[arg(long, value_name = "FILE_LABEL=NAME")]
    pub label: Vec<String>,
    /// Template: a TOML file with [[markers]], their names and positions on the body, such as a dataset.toml; without it the
    /// positions are estimated from the throws
    #[arg(long, value_name = "TEMPLATE")]
    pub markers: Option<PathBuf>,
    /// Height of the centre of mass above the mean of the markers along the axis of the spin, m, if it is known and
    /// no template is given; negative if it is below the markers
    #[arg(
        long,
        value_name = "METRES",
        allow_hyphen_values = true,
        conflicts_with = "markers"
    )]
    pub centre_height: Option<f64>,
    /// Model: a name or a path; by default that of the template
    #[arg(long, value_name = "MODEL")]
    pub model: Option<String>,
    /// The file is the export of a launch monitor: a row for each shot
    #[arg(long, conflicts_with_all = ["format", "length", "time", "rate", "up", "left_handed", "label", "markers", "centre_height"])]
    pub launch_monitor: bool,
    /// With --launch-monitor: what a column is, where its header does not tell, and its unit; may be repeated
    #[arg(long, value_name = "HEADER=IS[,UNIT]", requires = "launch_monitor")]
    pub column: Vec<String>,
    /// Folder for the dataset: a new or an empty one
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

#[derive(Args)]
pub struct Effects {
    /// List only the effects that apply to this model: a name or a path
    pub model: Option<String>,
    /// File for the list, as Markdown; without it the list is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Form of the printed list; by default text on a terminal and markdown elsewhere
    #[arg(long, value_enum, value_name = "FORM", conflicts_with = "out")]
    pub format: Option<ListForm>,
}

/// Form of a printed list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ListForm {
    /// Aligned columns, to read
    Text,
    /// Markdown, with sources and the models of each effect
    Markdown,
}
