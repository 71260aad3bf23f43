//! Throws for a purpose, stability, sweeps, and refits to flights drawn with replacement.

use std::path::PathBuf;
use std::sync::Arc;

use analysis::design::{
    Bounds, Goal, SampleOptions, Scattered, SearchOptions, ThrownBody, design as search, spread,
};
use analysis::stability::Body;
use analysis::sweep::{SweepOptions, plan, run as sweep_run};
use anyhow::Context;
use flight::files::ResultFile;
use flight::release::Release;
use hyzer::program;
use identify::Progress;
use pyo3::prelude::*;

use crate::dataset::Dataset;
use crate::errors::{input, raise};
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

/// Searches for the throw that serves a goal best; `bounds` is the text of a file of bounds.
#[pyfunction]
#[pyo3(signature = (model, goal_name, target, bounds, starts, samples, seed, threads))]
#[expect(
    clippy::too_many_arguments,
    reason = "called from one place, by position"
)]
pub fn design(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    goal_name: &str,
    target: Option<[f64; 3]>,
    bounds: Option<String>,
    starts: usize,
    samples: usize,
    seed: u64,
    threads: Option<usize>,
) -> PyResult<Report> {
    let goal = goal(goal_name, target)?;
    if !(1..=100_000).contains(&starts) || samples > 1_000_000 {
        return Err(input(format!(
            "starts is {starts} and samples {samples}, expected 1 to 100000 and at most 1000000"
        )));
    }
    let model = model.get();
    let (checked, named) = (Arc::clone(&model.checked), model.shown());
    let threads = threads.unwrap_or_else(flight::parallel::threads).max(1);
    let found = work::run(py, None, move |_| -> anyhow::Result<Report> {
        let release = Release {
            model: named.clone(),
            initial: Vec::new(),
            ..Release::of(&checked)
        };
        let body = ThrownBody::new((*checked).clone())?;
        let flights = body.with(&release);
        let mut limits = match &bounds {
            Some(text) => Bounds::read("bounds", text, &body)?,
            None => Bounds::standard(&body),
        };
        // In still air neither range nor time depends on the heading.
        if bounds.is_none() && matches!(goal, Goal::Range | Goal::HangTime) {
            limits.set("heading", 0.0, 0.0);
        }
        let options = SearchOptions {
            starts,
            seed,
            threads,
            ..SearchOptions::default()
        };
        let found = search(&flights, goal, &limits, &options)?;
        let aims = program::design::aims(&found, &limits);
        let scattered = Scattered::of(&flights, &limits.scatter);
        let options = SampleOptions {
            count: samples,
            seed,
            threads,
        };
        let spread = spread(&flights, &found.throw, &aims, &scattered, &options)?;
        let made = program::design::Designed {
            model: &named,
            release: &release,
            found,
            bounds: limits,
            spread,
        };
        let files = made.files(&flights)?;
        Ok(Report {
            json: made.json(&checked.name),
            text: made.text(),
            files,
        })
    })?;
    found.map_err(raise)
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
    let (checked, _, release) = released(model.get(), name, text)?;
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

/// Flies the plan of a sweep and writes its table and summary to a folder; returns the summary.
#[pyfunction]
#[pyo3(signature = (name, text, folder, out, csv, threads, progress = None))]
#[expect(
    clippy::too_many_arguments,
    reason = "called from one place, by position"
)]
pub fn sweep(
    py: Python<'_>,
    name: String,
    text: String,
    folder: PathBuf,
    out: PathBuf,
    csv: bool,
    threads: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<String> {
    if threads == Some(0) {
        return Err(input("threads is 0, expected a number above 0"));
    }
    let found = work::run(py, progress, move |watch| -> anyhow::Result<String> {
        let plan = plan::read(&name, &text, &folder)?;
        watch.stage_started(&plan.model.name, plan.flights as usize);
        let options = SweepOptions {
            threads: threads.unwrap_or_else(flight::parallel::threads),
            share: None,
            csv,
            progress: &|flights| watch.advance(flights as usize),
            is_cancelled: &|| watch.token.is_cancelled(),
        };
        let summary = sweep_run(&plan, &out, &options)?.context("no summary")?;
        Ok(summary.to_string())
    })?;
    found.map_err(raise)
}

/// The built-in plan of a sweep.
#[pyfunction]
pub fn sweep_plan() -> &'static str {
    program::sweep::EXAMPLE
}

/// Refits a model to flights drawn with replacement.
#[pyfunction]
#[pyo3(signature = (dataset, model, options, refits, seed, progress = None))]
pub fn bootstrap(
    py: Python<'_>,
    dataset: &Bound<'_, Dataset>,
    model: Option<&Bound<'_, Model>>,
    options: Options,
    refits: u64,
    seed: u64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Report> {
    options.check()?;
    if !(2..=1_000_000).contains(&refits) {
        return Err(input(format!("refits is {refits}, expected 2 to 1000000")));
    }
    let dataset = dataset.get();
    let (model, data) = (model_of(model, dataset)?, Arc::clone(&dataset.data));
    let found = work::run(py, progress, move |watch| {
        options.with(watch, |options| -> anyhow::Result<Report> {
            let fit = identify::fit(&model, &data, options)?;
            program::bootstrap::enough(&fit)?;
            watch.stage_started("refits", refits as usize);
            let unseen = identify::FitOptions {
                progress: None,
                ..*options
            };
            let advance = |done| watch.advance(done as usize);
            let made = program::bootstrap::refits(&fit, seed, 0..refits, &unseen, &advance)?;
            let summary = program::bootstrap::summary_json(&fit, &made, seed);
            let json = format!("{summary:#}\n");
            let table = program::bootstrap::table(&fit, &made);
            let files = vec![
                ResultFile::new("refits.csv", table),
                ResultFile::new("summary.json", json.clone()),
            ];
            Ok(Report {
                json,
                text: program::bootstrap::text(&summary),
                files,
            })
        })
    })?;
    found.map_err(raise)
}
