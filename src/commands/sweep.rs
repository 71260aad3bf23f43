//! Command `hyzer sweep`: flies a plan; writes a table of the flights and a summary.

use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

use analysis::sweep::{Plan, SweepOptions, plan, run as fly};
use anyhow::{Context, bail};
use report::Table;
use serde_json::Value;

use crate::cli::Sweep;
use crate::progress::{self, Progress};
use crate::{Answer, output};

/// TOML text of the built-in sweep plan.
pub const EXAMPLE: &str = include_str!("sweep/backhands.toml");

/// Name of the built-in sweep plan, and its text.
const BUILT_IN: (&str, &str) = ("backhands", EXAMPLE);

/// Runs `hyzer sweep`: flies a plan and prints the summary, or for a share where its results are.
pub(super) fn run(options: &Sweep) -> anyhow::Result<Answer> {
    if options.example {
        output::print(BUILT_IN.1)?;
        return Ok(Answer::Yes);
    }
    let (Some(path), Some(out)) = (&options.plan, &options.out) else {
        bail!("expected PLAN and --out");
    };
    let share = options.part.as_deref().map(super::share).transpose()?;
    let threads = match options.threads {
        Some(0) => bail!("--threads: found 0, expected a number above 0"),
        Some(threads) => threads,
        None => flight::parallel::threads(),
    };
    // A file takes precedence over the built-in name.
    let plan = if path.as_os_str() == BUILT_IN.0 && !path.is_file() {
        plan::read(BUILT_IN.0, BUILT_IN.1, Path::new("."))?
    } else {
        plan::read_file(path)?
    };
    let bar = Progress::new()?;
    let flights = share.map_or(plan.flights, |(_, of)| plan.flights / of);
    bar.start(&plan.model.name, flights);
    progress::resumes();
    // The rate of a run that goes on with an earlier one would count that one's flights.
    let is_fresh = !out.exists();
    let start = Instant::now();
    let settings = SweepOptions {
        threads,
        share,
        csv: options.csv,
        progress: &|flights| bar.advance(flights),
        is_cancelled: &|| false,
    };
    let summary = fly(&plan, out, &settings).context("--out")?;
    drop(bar);
    match summary {
        Some(summary) => {
            output::print(table(&plan, &summary))?;
            let csv = if options.csv { ", flights.csv" } else { "" };
            let rate = plan.flights as f64 / start.elapsed().as_secs_f64();
            let rate = if is_fresh {
                format!("; {rate:.0} flights a second")
            } else {
                String::new()
            };
            eprintln!(
                "flights.parquet{csv} and summary.json are in {}{rate}",
                out.display()
            );
        }
        None => eprintln!(
            "the parts of this share are in {}; `hyzer sweep` without --part joins them when all are there",
            out.display()
        ),
    }
    Ok(Answer::Yes)
}

fn table(plan: &Plan, summary: &Value) -> String {
    let mut text = format!("{}: {} flights", plan.model.name, plan.flights);
    for (status, count) in summary["statuses"].as_object().into_iter().flatten() {
        let _ = write!(text, ", {count} {status}");
    }
    let number = |value: &Value| {
        let value = value.as_f64();
        value.map_or("–".to_owned(), |value| format!("{value:.5}"))
    };
    let mut rows = Table::of(summary["columns"].as_object().into_iter().flatten())
        .name("", |(name, _)| *name)
        .number("mean", |(_, column)| number(&column["mean"]))
        .number("sd", |(_, column)| number(&column["sd"]));
    for (head, key) in [("5 %", "0.05"), ("median", "0.5"), ("95 %", "0.95")] {
        rows = rows.number(head, |(_, column)| number(&column["quantiles"][key]));
    }
    format!("{text}\n{}", rows.table().text(usize::MAX))
}
