//! Verification of a model, and what a change of a model changes.

use std::sync::Arc;

use ::verify::difference::{compare, landing_of_text, operations};
use model_spec::load::{Loaded, inspect, inspect_text};
use model_spec::model::Model as Checked;
use pyo3::prelude::*;

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
    let (name, text) = (model.shown(), model.model_text());
    let found = work::run(py, None, move |_| -> anyhow::Result<Report> {
        let loaded = inspect_text(&name, &text, &[])?;
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
        Ok(Report::of_json("verification.json", json, report.table()))
    })?;
    found.map_err(raise)
}

/// A model to compare: an object, or a name, path or text of one whose units may disagree.
#[derive(FromPyObject)]
pub enum Compared<'py> {
    /// A checked model.
    Model(Bound<'py, Model>),
    /// The name, path or text of a model.
    Source(String),
}

impl Compared<'_> {
    /// The model, and the messages on units that disagree.
    fn load(&self) -> PyResult<(Arc<Checked>, Vec<String>)> {
        let source = match self {
            Compared::Model(model) => return Ok((Arc::clone(&model.get().checked), Vec::new())),
            Compared::Source(source) => source,
        };
        let loaded = match source.contains('\n') {
            true => inspect_text("<text>", source, &[]),
            false => inspect(source, &[]),
        };
        let loaded = loaded.and_then(Loaded::model_and_messages).map_err(raise)?;
        Ok((Arc::new(loaded.0), loaded.1))
    }
}

/// Compares two models: statements, derivatives, operation counts, landings.
#[pyfunction]
#[pyo3(signature = (old, new, releases))]
pub fn diff(
    py: Python<'_>,
    old: Compared<'_>,
    new: Compared<'_>,
    releases: Vec<(String, String)>,
) -> PyResult<Report> {
    let ((old, old_faults), (new, new_faults)) = (old.load()?, new.load()?);
    let found = work::run(py, None, move |_| -> anyhow::Result<Report> {
        let landings = releases.iter();
        let landings = landings.map(|(name, text)| landing_of_text(name, text, &old, &new));
        let landings = landings.collect::<Result<Vec<_>, _>>()?;
        let mut difference = compare(&old, &new);
        difference.set_unit_faults(&old_faults, &new_faults);
        difference.operations = operations(&old, &new);
        difference.landings = landings;
        let json = serde_json::to_string_pretty(&difference)? + "\n";
        Ok(Report::of_json("difference.json", json, difference.text()))
    })?;
    found.map_err(raise)
}
