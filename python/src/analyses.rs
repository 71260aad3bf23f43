//! Throws for a purpose, stability, sweeps, and refits to flights drawn with replacement.

use std::path::PathBuf;
use std::sync::Arc;

use analysis::design::{Bounds, Goal, SearchOptions, ThrownBody};
use analysis::stability::Body;
use analysis::sweep::{SweepOptions, plan, run as sweep_run};
use flight::files::ResultFile;
use hyzer::program;
use hyzer::program::bootstrap::{Parts, in_parts};
use hyzer::program::design::{Asked, designed};
use identify::Progress;
use pyo3::prelude::*;

use crate::dataset::Dataset;
use crate::errors::{self, input, raise, raise_or};
use crate::fit::{Options, model_of};
use crate::flight::released;
use crate::model::Model;
use crate::report::Report;
use crate::work;

fn goal(name: &str, target: Option<[f64; 3]>) -> PyResult<Goal> {
    match (name, target) {
        ("range", None) => Ok(Goal::Range),
        ("hangtime", None) => Ok(Goal::HangTime),
        ("range" | "hangtime", Some(_)) => Err(input(format!("the goal {name} has no target"))),
        ("hit", Some(target)) => Ok(Goal::Hit(target)),
        ("curve", Some(target)) => Ok(Goal::Curve(target)),
        ("flare", Some(target)) => Ok(Goal::Flare(target)),
        ("spread", Some([x, y, 0.0])) => Ok(Goal::Spread([x, y])),
        ("spread", Some([.., z])) => Err(input(format!(
            "target: found a height of {z} m, expected a point on the ground, (x, y, 0)"
        ))),
        ("hit" | "curve" | "flare" | "spread", None) => Err(input(format!(
            "the goal {name} needs a target, as in target=(30, 0, 0)"
        ))),
        _ => Err(input(format!(
            "goal is {name:?}, expected range, hangtime, hit, curve, flare or spread"
        ))),
    }
}

/// What the search for a throw takes besides the model and the goal.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct DesignOptions {
    target: Option<[f64; 3]>,
    bounds: Option<String>,
    wind: Option<String>,
    fit: Option<String>,
    starts: usize,
    samples: usize,
    seed: u64,
    threads: Option<usize>,
}

/// Searches for the throw that serves a goal best. `bounds` is the text of a file of bounds, `wind` three components or the
/// path of a file, `fit` the JSON of a fit. The second result names coefficients of the fit that the model does not have.
#[pyfunction]
#[pyo3(signature = (model, goal_name, options))]
pub fn design(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    goal_name: &str,
    options: &Bound<'_, PyAny>,
) -> PyResult<(Report, Vec<String>)> {
    let options: DesignOptions = errors::options(options)?;
    let goal = goal(goal_name, options.target)?;
    let (starts, samples) = (options.starts, options.samples);
    if !(1..=100_000).contains(&starts) || samples > 1_000_000 {
        return Err(input(format!(
            "starts is {starts} and samples {samples}, expected 1 to 100000 and at most 1000000"
        )));
    }
    let model = model.get();
    let (checked, named) = (Arc::clone(&model.checked), model.shown());
    let threads = options.threads;
    let threads = threads.unwrap_or_else(flight::parallel::threads).max(1);
    let found = work::run(py, None, move |_| -> anyhow::Result<_> {
        let bounds = |body: &ThrownBody| match &options.bounds {
            Some(text) => Ok(Some(Bounds::read("bounds", text, body)?)),
            None => Ok(None),
        };
        let asked = Asked {
            name: &named,
            model: (*checked).clone(),
            goal,
            bounds: &bounds,
            wind: options.wind.as_deref(),
            units: report::Units::Si,
            set: &[],
            fit: options.fit.map(|text| ("fit".to_owned(), text)),
            samples,
            search: SearchOptions {
                starts,
                seed: options.seed,
                threads,
                ..SearchOptions::default()
            },
        };
        designed(asked, |made, flights| {
            let report = Report {
                json: made.json(&checked.name),
                text: made.text(report::Units::Si),
                files: made.files(flights)?,
            };
            Ok((report, made.left_out.clone()))
        })
    })?;
    found.map_err(|error| raise_or("InputError", error))
}

/// Modes and criteria of stability at a release.
#[pyfunction]
#[pyo3(signature = (model, name, text, times))]
pub fn stability(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    name: &str,
    text: &str,
    times: usize,
) -> PyResult<Report> {
    if times > 100_000 {
        return Err(input(format!("times is {times}, expected at most 100000")));
    }
    // A model without attitude is told before a throw with spin, which the caller may not have stated.
    Body::new((*model.get().checked).clone()).map_err(raise)?;
    let (checked, _, release) = released(py, model.get(), name, text, &[])?;
    let found = work::run(py, None, move |_| -> anyhow::Result<Report> {
        let body = Body::new((*checked).clone())?;
        let (found, _) = program::stability::found(&body, &release, times)?;
        Ok(Report {
            json: program::stability::json(&body.model, &found),
            text: report::stability::text(&body.model.name, &found),
            files: program::stability::files(&body.model, &found),
        })
    })?;
    found.map_err(raise)
}

/// Share of work that is done in parts: its number from 1, and the number of shares.
type Share = (u64, u64);

fn check_share(share: Option<Share>) -> PyResult<()> {
    match share {
        Some((part, of)) if !(1..=of).contains(&part) => Err(input(format!(
            "part is ({part}, {of}), expected (i, n) with i from 1 to n, as in (2, 8)"
        ))),
        _ => Ok(()),
    }
}

/// Plan of a sweep: name in messages, text and the folder of its files.
type PlanText = (String, String, PathBuf);

/// Flies the plan of a sweep and writes its table and summary to a folder; returns the summary, or nothing for a share.
#[pyfunction]
#[pyo3(signature = (plan, out, csv, threads, part = None, progress = None))]
pub fn sweep(
    py: Python<'_>,
    plan: PlanText,
    out: PathBuf,
    csv: bool,
    threads: Option<usize>,
    part: Option<Share>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Option<String>> {
    if threads == Some(0) {
        return Err(input("threads is 0, expected a number above 0"));
    }
    check_share(part)?;
    let found = work::run(py, progress, move |watch| -> anyhow::Result<_> {
        let (name, text, folder) = plan;
        let plan = plan::read(&name, &text, &folder)?;
        let flights = part.map_or(plan.flights, |(_, of)| plan.flights / of);
        watch.stage_started(&plan.model.name, flights as usize);
        let options = SweepOptions {
            threads: threads.unwrap_or_else(flight::parallel::threads),
            share: part,
            csv,
            progress: &|flights| watch.advance(flights as usize),
            is_cancelled: &|| watch.token.is_cancelled(),
        };
        let summary = sweep_run(&plan, &out, &options)?;
        Ok(summary.map(|summary| summary.to_string()))
    })?;
    found.map_err(raise)
}

/// The built-in plan of a sweep.
#[pyfunction]
pub fn sweep_plan() -> &'static str {
    program::sweep::EXAMPLE
}

/// Refits a model to flights drawn with replacement: in memory, or part by part in the folder `out`, where a share returns
/// nothing.
#[pyfunction]
#[pyo3(signature = (dataset, model, options, refits, seed, out = None, part = None, progress = None))]
#[expect(
    clippy::too_many_arguments,
    reason = "called from one place, by position"
)]
pub fn bootstrap(
    py: Python<'_>,
    dataset: &Bound<'_, Dataset>,
    model: Option<&Bound<'_, Model>>,
    options: &Bound<'_, PyAny>,
    refits: u64,
    seed: u64,
    out: Option<PathBuf>,
    part: Option<Share>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Option<Report>> {
    let options = Options::of(options)?;
    check_share(part)?;
    if !(2..=1_000_000).contains(&refits) {
        return Err(input(format!("refits is {refits}, expected 2 to 1000000")));
    }
    let dataset = dataset.get();
    let (model, data) = (model_of(model, dataset)?, Arc::clone(&dataset.data));
    errors::warn(py, &program::fit::overruled_by(&model, &data))?;
    let found = work::run(py, progress, move |watch| {
        options.with(watch, |options| -> anyhow::Result<Option<Report>> {
            let begin = |refits: u64| watch.stage_started("refits", refits as usize);
            let advance = |done| watch.advance(done as usize);
            let unseen = identify::FitOptions {
                progress: None,
                ..*options
            };
            let fit = || Ok(identify::fit(&model, &data, options)?);
            let Some(out) = &out else {
                let fit = fit()?;
                program::bootstrap::enough(&fit)?;
                begin(refits);
                let made = program::bootstrap::refits(&fit, seed, 0..refits, &unseen, &advance)?;
                let summary = program::bootstrap::summary_json(&fit, &made, seed);
                let table = program::bootstrap::table(&fit, &made);
                return Ok(Some(refitted(&summary, table)));
            };
            let parts = Parts {
                out,
                fingerprint: program::bootstrap::fingerprint_of(
                    options, refits, seed, &data, &model,
                ),
                refits,
                seed,
                share: part,
                options: &unseen,
                begin: &begin,
                progress: &advance,
            };
            let Some(summary) = in_parts(&parts, fit)? else {
                return Ok(None);
            };
            let table = std::fs::read_to_string(out.join("refits.csv"))?;
            Ok(Some(refitted(&summary, table)))
        })
    })?;
    found.map_err(raise)
}

fn refitted(summary: &serde_json::Value, table: String) -> Report {
    let text = program::bootstrap::text(summary);
    let mut report = Report::of_json("summary.json", format!("{summary:#}\n"), text);
    report.files.insert(0, ResultFile::new("refits.csv", table));
    report
}
