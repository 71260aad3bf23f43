//! Verification of a model, and what a change of a model changes.

use std::sync::Arc;

use flight::files::ResultFile;
use model_spec::load::inspect_text;
use pyo3::prelude::*;
use ::verify::difference::{compare, landing, operations};

use crate::errors::{input, raise};
use crate::model::Model;
use crate::report::Report;
use crate::work;

/// Runs every independent check of a model.
#[pyfunction]
#[pyo3(signature = (model, cases, seed, mutants))]
pub fn verify(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    cases: usize,
    seed: u64,
    mutants: bool,
) -> PyResult<Report> {
    if !(1..=100_000).contains(&cases) {
        return Err(input(format!("cases is {cases}, expected 1 to 100000")));
    }
    let model = model.get();
    let (name, text) = (model.checked.name.clone(), model.tree.to_text(""));
    let found = work::run(py, None, move |_| -> anyhow::Result<Report> {
        let loaded = inspect_text(&format!("{name}.hyz"), &text, &[])?;
        let options = ::verify::Options {
            cases,
            seed,
            mutants,
            ..::verify::Options::default()
        };
        let report = ::verify::run(&loaded, &options);
        let mut value = serde_json::to_value(&report)?;
        value["outcome"] = serde_json::to_value(report.outcome())?;
        let json = format!("{value:#}\n");
        let files = vec![ResultFile::new("verification.json", json.clone())];
        Ok(Report {
            json,
            text: report.table(),
            files,
        })
    })?;
    found.map_err(raise)
}

/// Compares two models: statements, derivatives, operation counts, landings.
#[pyfunction]
#[pyo3(signature = (old, new, releases))]
pub fn diff(
    py: Python<'_>,
    old: &Bound<'_, Model>,
    new: &Bound<'_, Model>,
    releases: Vec<String>,
) -> PyResult<Report> {
    let (old, new) = (
        Arc::clone(&old.get().checked),
        Arc::clone(&new.get().checked),
    );
    let found = work::run(py, None, move |_| -> anyhow::Result<Report> {
        let landings = releases.iter().map(|release| landing(release, &old, &new));
        let landings = landings.collect::<Result<Vec<_>, _>>()?;
        let mut difference = compare(&old, &new);
        difference.operations = operations(&old, &new);
        difference.landings = landings;
        let json = serde_json::to_string_pretty(&difference)? + "\n";
        let files = vec![ResultFile::new("difference.json", json.clone())];
        Ok(Report {
            json,
            text: difference.text(),
            files,
        })
    })?;
    found.map_err(raise)
}
