//! The command line: names, options and help.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Studies of what hyzer's fits and diagnoses are worth; each writes a page of docs/.
#[derive(Parser)]
#[command(
    name = "hyzer-studies",
    version,
    arg_required_else_help = true,
    max_term_width = 100
)]
pub struct Cli {
    /// Which study
    #[command(subcommand)]
    pub study: Study,
}

/// The studies.
#[derive(Subcommand)]
pub enum Study {
    /// Compare the paper's statements on its two flights with every reading of its tables
    #[command(after_help = "Example:\n  hyzer-studies paper --out docs/paper.md")]
    Paper(Paper),
    /// Which laws of motion the equations of other simulators break, and what mends them
    #[command(after_help = "Example:\n  hyzer-studies others --out docs/others.md")]
    Others(Paper),
    /// Coverage of a fit's intervals on flights made by the oracle, and fits of the paper's two flights one by one
    #[command(after_help = "Example:\n  hyzer-studies identification --seeds 20")]
    Identification(Identification),
    /// Fits of measured flights, and comparison with a wind tunnel's table
    #[command(
        after_help = "Example:\n  hyzer-studies real-data --data ../shared/data --out docs/real-data.md"
    )]
    RealData(RealData),
    /// How often the diagnosis finds effects that were seeded into flights made by the oracle
    #[command(
        after_help = "Example:\n  hyzer-studies discovery --seeds 40 --only 'stall strong' --details"
    )]
    Discovery(Discovery),
    /// How often fits with one to three effects reach the noise from the model's own start
    #[command(after_help = "Example:\n  hyzer-studies fits --seeds 100 --only stall")]
    Fits(Runs),
    /// Whether effects hidden in flights of a user's own models are detected, and found at the right site
    #[command(after_help = "Example:\n  hyzer-studies own-models --only 'glider strong'")]
    OwnModels(Runs),
    /// Whether mistakes of a laboratory are named, harmless, or reported as unreliable; with the section of `cuts`
    #[command(after_help = "Example:\n  hyzer-studies spoiled --seeds 2 --only 'labels one'")]
    Spoiled(Runs),
    /// Fits and diagnoses by poses, gyroscopes, accelerometers and speeds, alone and with markers
    #[command(after_help = "Example:\n  hyzer-studies sensors --seeds 20")]
    Sensors(Runs),
    /// Truncation at the ground: flights that touch nothing, and flights that bounce
    #[command(after_help = "Example:\n  hyzer-studies cuts --seeds 10")]
    Cuts(Runs),
    /// Throws found by `design` against what Crowther and Potts report of a disc, and Frohlich of the discus
    #[command(after_help = "Example:\n  hyzer-studies throws --out docs/throws.md")]
    Throws(Paper),
    /// Coefficients and flights of the program's bodies, and a driver's filmed throws
    #[command(
        after_help = "Example:\n  hyzer-studies bodies --data ../shared/data --out docs/bodies.md"
    )]
    Bodies(Bodies),
    /// From takes of throws, as laboratories write them, to a template and coefficients
    #[command(after_help = "Example:\n  hyzer-studies takes --seeds 20 --python python3")]
    Takes(Takes),
}

/// `hyzer-studies bodies`.
#[derive(Args)]
pub struct Bodies {
    /// Folder of the measured data, with the folder discgolf; without it the page has no filmed throws
    #[arg(long, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// File for the page, with its figure beside it; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// `hyzer-studies takes`.
#[derive(Args)]
pub struct Takes {
    /// Options of its runs; `--only '#7'` runs the session of seed 7
    #[command(flatten)]
    pub runs: Runs,
    /// Python with ezc3d, which writes every fourth session as C3D; without it there is no C3D
    #[arg(long, value_name = "PATH")]
    pub python: Option<PathBuf>,
}

/// Options of a study of random runs.
#[derive(Args)]
pub struct Runs {
    /// Number of runs, or of runs of each row
    #[arg(long)]
    pub seeds: Option<u64>,
    /// Only runs that have all of these words
    #[arg(long, value_name = "WORDS")]
    pub only: Option<String>,
    /// Number of runs at a time; without it one for each processor
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..=1024))]
    pub threads: Option<u64>,
    /// File for the page; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

impl Runs {
    /// Number of threads.
    pub fn threads(&self) -> usize {
        let stated = self.threads.map(|threads| threads as usize);
        stated.unwrap_or_else(flight::batch::threads)
    }
}

/// `hyzer-studies paper` and `hyzer-studies others`.
#[derive(Args)]
pub struct Paper {
    /// File for the page; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// `hyzer-studies identification`.
#[derive(Args)]
pub struct Identification {
    /// Datasets made under each noise
    #[arg(long, default_value_t = 200)]
    pub seeds: u64,
    /// File for the page, with its figures beside it; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// `hyzer-studies real-data`.
#[derive(Args)]
pub struct RealData {
    /// Folder of the measured data, with the folders spindoe, spindown, windtunnel and discgolf
    #[arg(long, value_name = "DIR")]
    pub data: PathBuf,
    /// File for the page, with its figures beside it; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// `hyzer-studies discovery`.
#[derive(Args)]
pub struct Discovery {
    /// Options of its runs; without `--seeds` 100 of each row without a seeded effect, other rows have a few for every hundred
    #[command(flatten)]
    pub runs: Runs,
    /// Print a line for each run, and what rejects a seeded effect that was missed
    #[arg(long)]
    pub details: bool,
}
