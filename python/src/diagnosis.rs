//! Diagnoses of what a model is missing.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use ::diagnose::{Diagnosis as Found, DiagnosisError, DiagnosisOptions};
use dataset::Dataset as Data;
use flight::files::ResultFile;
use hyzer::program;
use pyo3::prelude::*;

use crate::dataset::Dataset;
use crate::errors::{raise, with_keywords};
use crate::fit::{Options, model_of, write};
use crate::model::Model;
use crate::report::named;
use crate::work;

/// Result of a diagnosis.
#[pyclass(frozen, module = "hyzer._hyzer")]
pub struct Diagnosis {
    found: Arc<Mutex<Found>>,
    data: Arc<Data>,
}

impl Diagnosis {
    fn with<T>(&self, read: impl FnOnce(&Found) -> T) -> T {
        read(&self.found.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn files(&self, py: Python<'_>) -> PyResult<Vec<ResultFile>> {
        let (found, data) = (Arc::clone(&self.found), Arc::clone(&self.data));
        work::run(py, None, move |_| {
            let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
            program::diagnose::files(&mut found, &data)
        })?
        .map_err(raise)
    }
}

#[pymethods]
impl Diagnosis {
    fn report_json(&self) -> PyResult<String> {
        let json = self.with(|found| serde_json::to_string(&found.report));
        Ok(with_keywords(&json.map_err(raise)?))
    }

    fn summary_text(&self) -> String {
        with_keywords(&self.with(|found| report::diagnosis::text(&found.report)))
    }

    fn model_text(&self) -> PyResult<Option<String>> {
        let text = self.with(|found| {
            let after = found.after.as_ref();
            after.map(|(extension, fit)| fit.fitted_text(&extension.model, &self.data, ""))
        });
        text.transpose().map_err(raise)
    }

    #[pyo3(name = "files")]
    fn named_files(&self, py: Python<'_>) -> PyResult<Vec<(String, Vec<u8>)>> {
        Ok(named(self.files(py)?))
    }

    fn save_files(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        write(&folder, &self.files(py)?)
    }
}

/// Tests a model for missing effects with measured flights, and extends it.
#[pyfunction]
#[pyo3(signature = (dataset, model, options, without, progress = None))]
pub fn diagnose(
    py: Python<'_>,
    dataset: &Bound<'_, Dataset>,
    model: Option<&Bound<'_, Model>>,
    options: &Bound<'_, PyAny>,
    without: Vec<String>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Diagnosis> {
    let options = Options::of(options)?;
    let dataset = dataset.get();
    let model = model_of(model, dataset)?;
    let (data, name) = (Arc::clone(&dataset.data), dataset.name.clone());
    let on = Arc::clone(&data);
    let found = work::run(py, progress, move |watch| {
        options.with(watch, |fit| {
            let options = DiagnosisOptions {
                dataset: &name,
                without: &without,
                fit: *fit,
                ..DiagnosisOptions::default()
            };
            options.validate(&model).map_err(DiagnosisError::from)?;
            program::diagnose::diagnosis(&model, &on, &options)
        })
    })?;
    let found = Arc::new(Mutex::new(found.map_err(raise)?));
    Ok(Diagnosis { found, data })
}
