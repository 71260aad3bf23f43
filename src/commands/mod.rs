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
mod format;
mod generate;
pub mod import;
mod lsp;
mod man;
mod models;
pub mod simulate;
pub mod stability;
pub mod sweep;
mod synthesize;
mod verify;
mod wind;

use crate::cli::Command;

/// Outcome of a command, which determines the exit status; invalid input is an error instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Answer {
    Yes,
    /// Such as a failed check.
    No,
    Undecided,
}

impl Answer {
    /// `Yes` or `No`.
    fn of(answer: bool) -> Answer {
        if answer { Answer::Yes } else { Answer::No }
    }
}

/// Runs a command of `hyzer`.
pub(super) fn run(command: Command) -> anyhow::Result<Answer> {
    match command {
        Command::Check(options) => check::run(&options),
        Command::Format(options) => format::run(&options),
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
        Command::Lsp(options) => lsp::run(&options),
        Command::Models => models::run(),
        Command::Completions(options) => completions::run(&options),
        Command::Man(options) => man::run(&options),
    }
}

fn names(with: &[String]) -> Vec<&str> {
    with.iter().map(String::as_str).collect()
}

/// Parses a finite number, the value of an option, SI.
fn number(option: &str, text: &str) -> anyhow::Result<f64> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => anyhow::bail!("{option}: found {text:?}, expected a finite number in SI units"),
    }
}

/// Parses the value `I/N` of the option `--part`: share number I, from 1, of N shares of the work.
fn share(text: &str) -> anyhow::Result<(u64, u64)> {
    let numbers = text.split_once('/');
    let numbers = numbers.and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
    match numbers {
        Some((part, of)) if part >= 1 && part <= of => Ok((part, of)),
        _ => anyhow::bail!("--part: found {text:?}, expected I/N with I from 1 to N, as in 2/8"),
    }
}

/// Parses three finite numbers `X,Y,Z`, the value of an option.
fn vector(option: &str, text: &str, unit: &str) -> anyhow::Result<[f64; 3]> {
    let parts: Vec<&str> = text.split(',').collect();
    let [x, y, z] = parts[..] else {
        anyhow::bail!("{option}: found {text:?}, expected three numbers X,Y,Z in {unit}");
    };
    Ok([number(option, x)?, number(option, y)?, number(option, z)?])
}
