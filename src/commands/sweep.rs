//! Command `hyzer sweep`: flies a plan; writes a table of the flights and a summary.

use std::path::Path;
use std::time::Instant;

use analysis::sweep::{Plan, SweepOptions, landings, plan, run as fly};
use anyhow::{Context, anyhow, bail};
use report::kml::Origin;
use report::sweep::{Landings, MAX_LANDINGS};
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
    let origin = options.kml.as_deref().map(|text| {
        let expected = |expected| anyhow!("--kml: found {text:?}, expected {expected}");
        Origin::parse(text).map_err(expected)
    });
    let origin = origin.transpose()?;
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
            output::print(report::sweep::text(&summary, options.units))?;
            if let Some(doubt) = &plan.doubt {
                eprintln!("Warning: {doubt}");
            }
            let csv = if options.csv { ", flights.csv" } else { "" };
            let page = write_page(&plan, out, &summary, origin.as_ref())?;
            let rate = plan.flights as f64 / start.elapsed().as_secs_f64();
            let rate = if is_fresh {
                format!("; {rate:.0} flights a second")
            } else {
                String::new()
            };
            eprintln!(
                "flights.parquet{csv}{page} and summary.json are in {}{rate}",
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

/// Writes the page and the map of a finished sweep beside its table; returns their names.
fn write_page(
    plan: &Plan,
    out: &Path,
    summary: &Value,
    origin: Option<&Origin>,
) -> anyhow::Result<String> {
    let places = landings(plan, out, MAX_LANDINGS)?;
    let landings = Landings::of(summary, places);
    let page = report::sweep::page(summary, landings.as_ref());
    let mut names = String::new();
    let title = page.title.clone();
    for file in page.files() {
        output::write(&out.join(&file.path), &file.contents)?;
        if !file.path.contains('/') {
            names += &format!(", {}", file.path);
        }
    }
    if let Some(origin) = origin {
        let landings = landings.context("--kml: no flight has landed, expected one at least")?;
        let map = report::kml::landings(&title, origin, &landings);
        output::write(&out.join("landings.kml"), map)?;
        names += ", landings.kml";
    }
    Ok(names)
}
