//! Command line of `hyzer-studies`: subcommands, options and help texts.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Studies of the accuracy and reliability of hyzer's fits and diagnoses; each study writes a page of docs/studies/.
#[derive(Parser)]
#[command(
    name = "hyzer-studies",
    version,
    arg_required_else_help = true,
    max_term_width = 100
)]
pub struct Cli {
    /// Which study to run
    #[command(subcommand)]
    pub study: Study,
}

/// Subcommands of `hyzer-studies`, one per study.
#[derive(Subcommand)]
pub enum Study {
    /// Compare what Hubbard & Hummel (2000) state about their two flights with simulations, under every interpretation
    /// of their tables of coefficients
    #[command(after_help = "Example:\n  hyzer-studies paper --out docs/studies/paper.md")]
    Paper(Paper),
    /// Find the laws of motion that the equations of other simulators violate, and the changes that correct them
    #[command(after_help = "Example:\n  hyzer-studies others --out docs/studies/others.md")]
    Others(Paper),
    /// Coverage of a fit's confidence intervals on flights of the reference simulator (`oracle`), and separate fits of
    /// the two flights of Hubbard & Hummel (2000)
    #[command(after_help = "Example:\n  hyzer-studies identification --seeds 20")]
    Identification(Identification),
    /// Fits of measured flights, and comparison with a wind tunnel's table of coefficients
    #[command(
        after_help = "Example:\n  hyzer-studies real-data --data ../shared/data --out docs/studies/real-data.md"
    )]
    RealData(RealData),
    /// How often the diagnosis finds effects that were added to flights of the reference simulator (`oracle`)
    #[command(
        after_help = "Example:\n  hyzer-studies discovery --seeds 40 --only 'stall strong' --details"
    )]
    Discovery(Discovery),
    /// How often fits of one to three effects reach the noise level from the model's default initial values
    #[command(after_help = "Example:\n  hyzer-studies fits --seeds 100 --only stall")]
    Fits(Runs),
    /// Whether effects hidden in simulated flights of models that a user could write are detected, and attributed to
    /// the right term of the model
    #[command(after_help = "Example:\n  hyzer-studies own-models --only 'glider strong'")]
    OwnModels(Runs),
    /// Whether typical laboratory mistakes are reported, harmless, or make results that are marked as unreliable;
    /// without `--only`, also runs the study `cuts`
    #[command(after_help = "Example:\n  hyzer-studies spoiled --seeds 2 --only 'labels one'")]
    Spoiled(Runs),
    /// Fits and diagnoses with poses, gyroscopes, accelerometers and speeds, alone and together with markers
    #[command(after_help = "Example:\n  hyzer-studies sensors --seeds 20")]
    Sensors(Runs),
    /// Whether fits truncate flights at ground contact: simulated flights that do not touch the ground, and simulated
    /// flights that bounce
    #[command(after_help = "Example:\n  hyzer-studies cuts --seeds 10")]
    Cuts(Runs),
    /// Compare throws found by `design` with what Crowther and Potts report of a disc, and Frohlich of the discus
    #[command(after_help = "Example:\n  hyzer-studies throws --out docs/studies/throws.md")]
    Throws(Paper),
    /// Coefficients and flights of the built-in bodies, and filmed throws of a driver
    #[command(
        after_help = "Example:\n  hyzer-studies bodies --data ../shared/data --out docs/studies/bodies.md"
    )]
    Bodies(Bodies),
    /// Import of simulated recordings of throws in the file formats of laboratories, and estimation of the marker
    /// template and the coefficients from them
    #[command(after_help = "Example:\n  hyzer-studies takes --seeds 20 --python python3")]
    Takes(Takes),
    /// Fits and diagnoses of recordings as they occur: nothing wrong, mistakes of a laboratory, and hidden physics
    #[command(
        after_help = "Example:\n  hyzer-studies wild --seeds 2 --diagnose-every 0 --only 'rolling shutter'"
    )]
    Wild(Wild),
}

/// Options of `hyzer-studies wild`.
#[derive(Args)]
pub struct Wild {
    /// Options of the runs; `--seeds` is the number of datasets of each class of mistakes (default 16)
    #[command(flatten)]
    pub runs: Runs,
    /// Diagnose every n-th of the selected datasets, the first one included; 0: none
    #[arg(long, value_name = "N", default_value_t = 5)]
    pub diagnose_every: u64,
    /// Write the selected datasets as folders that `hyzer` reads, and run nothing
    #[arg(long, value_name = "DIR")]
    pub write: Option<PathBuf>,
}

/// Options of `hyzer-studies bodies`.
#[derive(Args)]
pub struct Bodies {
    /// Folder of the measured data, which contains the folder discgolf; without it the page has no filmed throws
    #[arg(long, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// File for the page, with its figure beside it; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Options of `hyzer-studies takes`.
#[derive(Args)]
pub struct Takes {
    /// Options of the runs; `--only '#7'` runs the session of seed 7 alone
    #[command(flatten)]
    pub runs: Runs,
    /// Python interpreter with ezc3d, which writes every fourth session as C3D; without it no session is written as C3D
    #[arg(long, value_name = "PATH")]
    pub python: Option<PathBuf>,
}

/// Options shared by the studies that repeat runs with random seeds.
#[derive(Args)]
pub struct Runs {
    /// Number of runs, or of runs per row of the study's table
    #[arg(long)]
    pub seeds: Option<u64>,
    /// Run only the cases whose names contain all of these words
    #[arg(long, value_name = "WORDS")]
    pub only: Option<String>,
    /// Number of runs in parallel; default: one per processor
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..=1024))]
    pub threads: Option<u64>,
    /// File for the page; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

impl Runs {
    /// Number of runs in parallel: `--threads` if given, otherwise one per processor.
    pub fn threads(&self) -> usize {
        let stated = self.threads.map(|threads| threads as usize);
        stated.unwrap_or_else(flight::parallel::threads)
    }
}

/// Options of the studies that accept no option but the output file.
#[derive(Args)]
pub struct Paper {
    /// File for the page; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Options of `hyzer-studies identification`.
#[derive(Args)]
pub struct Identification {
    /// Number of simulated datasets per noise condition
    #[arg(long, default_value_t = 200)]
    pub seeds: u64,
    /// File for the page, with its figures beside it; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Options of `hyzer-studies real-data`.
#[derive(Args)]
pub struct RealData {
    /// Folder of the measured data, which contains the folders spindoe, spindown, windtunnel and discgolf
    #[arg(long, value_name = "DIR")]
    pub data: PathBuf,
    /// File for the page, with its figures beside it; without it the page is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Options of `hyzer-studies discovery`.
#[derive(Args)]
pub struct Discovery {
    /// Options of the runs; `--seeds` is the number of runs per row whose flights have no added effect (default 100),
    /// and other rows have a small fraction of it
    #[command(flatten)]
    pub runs: Runs,
    /// Print a line for each run, and why the diagnosis rejects an effect of the simulated flights that it missed
    #[arg(long)]
    pub details: bool,
    /// Write the datasets of the selected runs as folders that `hyzer` reads, and run nothing
    #[arg(long, value_name = "DIR")]
    pub write: Option<PathBuf>,
}
