//! Implementations of the commands, one module each.

pub mod bootstrap;
pub mod check;
mod completions;
pub mod design;
pub mod diagnose;
mod diff;
mod effects;
mod explain;
mod export;
pub mod fit;
mod generate;
pub mod import;
mod man;
mod models;
pub mod simulate;
pub mod stability;
pub mod sweep;
mod synthesize;
mod verify;
mod wind;

use crate::Answer;
use crate::cli::Command;

/// Runs a command of `hyzer` and returns its outcome, which determines the exit status.
pub fn run(command: Command) -> anyhow::Result<Answer> {
    match command {
        Command::Check(options) => check::run(&options),
        Command::Generate(options) => generate::run(&options),
        Command::Export(options) => export::run(&options),
        Command::Verify(options) => verify::run(&options),
        Command::Diff(options) => diff::run(&options),
        Command::Explain(options) => explain::run(&options),
        Command::Import(options) => import::run(&options),
        Command::Simulate(options) => simulate::run(&options),
        Command::Sweep(options) => sweep::run(&options),
        Command::Design(options) => design::run(&options),
        Command::Stability(options) => stability::run(&options),
        Command::Synthesize(options) => synthesize::run(&options),
        Command::Fit(options) => fit::run(&options),
        Command::Bootstrap(options) => bootstrap::run(&options),
        Command::Diagnose(options) => diagnose::run(&options),
        Command::Effects(options) => effects::run(&options),
        Command::Models => models::run(),
        Command::Completions(options) => completions::run(&options),
        Command::Man(options) => man::run(&options),
    }
}

/// Names of the effects given by the option `--with`, as string slices for the model loader.
fn names(with: &[String]) -> Vec<&str> {
    with.iter().map(String::as_str).collect()
}

/// Parses the value of a command-line option as a finite number (SI units); `option` names it in messages.
fn number(option: &str, text: &str) -> anyhow::Result<f64> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => anyhow::bail!("{option}: found {text:?}, expected a finite number in SI units"),
    }
}

/// Parses the value `I/N` of the option `--part`, which selects share number I, counted from 1, of N equal shares of
/// the work.
fn share(text: &str) -> anyhow::Result<(u64, u64)> {
    let numbers = text.split_once('/');
    let numbers = numbers.and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
    match numbers {
        Some((part, of)) if part >= 1 && part <= of => Ok((part, of)),
        _ => anyhow::bail!("--part: found {text:?}, expected I/N with I from 1 to N, as in 2/8"),
    }
}

/// Parses the value `X,Y,Z` of a command-line option as three finite numbers; `option` and `unit` appear in messages
/// only.
fn vector(option: &str, text: &str, unit: &str) -> anyhow::Result<[f64; 3]> {
    let parts: Vec<&str> = text.split(',').collect();
    let [x, y, z] = parts[..] else {
        anyhow::bail!("{option}: found {text:?}, expected three numbers X,Y,Z in {unit}");
    };
    Ok([number(option, x)?, number(option, y)?, number(option, z)?])
}
