//! Fits of a model to a dataset.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use dataset::Dataset as Data;
use flight::files::{ResultFile, ResultFolder};
use hyzer::program;
use identify::{FitOptions, Prior};
use model_spec::ModelTree;
use model_spec::model::Model as Checked;
use pyo3::prelude::*;

use crate::dataset::Dataset;
use crate::errors::{input, raise, with_keywords};
use crate::model::Model;
use crate::report::named;
use crate::work::{self, Watch};

/// Options of a fit, as Python states them.
#[derive(Clone, Default, FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    fixed: Vec<(String, Option<f64>)>,
    free: Vec<String>,
    priors: Vec<(String, f64, f64)>,
    profiles: Vec<String>,
    unbounded: bool,
    trust_data: bool,
    threads: Option<usize>,
    max_seconds: Option<f64>,
}

impl Options {
    /// The options of a dict, with the checks of what those of the library cannot hold.
    pub fn of(options: &Bound<'_, PyAny>) -> PyResult<Options> {
        let found: Options = crate::errors::options(options)?;
        match found.max_seconds {
            Some(seconds) if !(seconds > 0.0 && seconds.is_finite()) => Err(input(format!(
                "max_seconds is {seconds}, expected a number above 0"
            ))),
            _ => Ok(found),
        }
    }

    /// Calls `work` with the options of the library.
    pub fn with<T>(&self, watch: &Watch, work: impl FnOnce(&FitOptions<'_>) -> T) -> T {
        let priors = self.priors.iter().cloned();
        let priors: Vec<Prior> = priors
            .map(|(name, value, sigma)| Prior { name, value, sigma })
            .collect();
        let limit = self
            .max_seconds
            .and_then(|s| Duration::try_from_secs_f64(s).ok());
        work(&FitOptions {
            fixed: &self.fixed,
            free: &self.free,
            priors: &priors,
            profiles: &self.profiles,
            unbounded: self.unbounded,
            trust_data: self.trust_data,
            threads: self.threads,
            progress: Some(watch),
            cancellation: Some(&watch.token),
            deadline: limit.and_then(|limit| Instant::now().checked_add(limit)),
            ..FitOptions::default()
        })
    }
}

/// The model of a fit: the one given, or that of the dataset.
pub fn model_of(model: Option<&Bound<'_, Model>>, dataset: &Dataset) -> PyResult<Arc<Checked>> {
    if let Some(model) = model {
        return Ok(Arc::clone(&model.get().checked));
    }
    let (name, own) = dataset.named_model();
    let tree = match own {
        Some(text) => ModelTree::parse(&dataset.data.model, text),
        None => ModelTree::load(&name),
    };
    Ok(Model::of(tree.map_err(raise)?, name)?.checked)
}

/// Replaces the results in a folder, all at once.
pub fn write(folder: &Path, files: &[ResultFile]) -> PyResult<()> {
    let folder = ResultFolder::open(folder).map_err(raise)?;
    folder.replace(files).map_err(raise)
}

/// Result of a fit.
#[pyclass(frozen, module = "hyzer._hyzer")]
pub struct Fit {
    fit: Arc<identify::Fit>,
    model: Arc<Checked>,
    data: Arc<Data>,
}

impl Fit {
    /// A fit of `model` to `data`.
    pub fn new(fit: Arc<identify::Fit>, model: Arc<Checked>, data: Arc<Data>) -> Fit {
        Fit { fit, model, data }
    }

    fn fitted_text(&self) -> PyResult<String> {
        let text = self.fit.fitted_text(&self.model, &self.data, "");
        text.map_err(raise)
    }
}

#[pymethods]
impl Fit {
    fn report_json(&self) -> PyResult<String> {
        let json = serde_json::to_string(&self.fit.report).map_err(raise)?;
        Ok(with_keywords(&json))
    }

    fn summary_text(&self) -> String {
        with_keywords(&program::fit::text(&self.fit, &self.model))
    }

    fn model_text(&self) -> PyResult<String> {
        self.fitted_text()
    }

    #[pyo3(name = "files")]
    fn named_files(&self, py: Python<'_>) -> PyResult<Vec<(String, Vec<u8>)>> {
        Ok(named(self.files(py)?))
    }

    fn save_files(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        let files = self.files(py)?;
        write(&folder, &files)
    }
}

impl Fit {
    fn files(&self, py: Python<'_>) -> PyResult<Vec<ResultFile>> {
        let (fit, model, data) = (self.fit.clone(), self.model.clone(), self.data.clone());
        work::run(py, None, move |_| program::fit::files(&fit, &model, &data))?.map_err(raise)
    }
}

/// Estimates the coefficients of a model from measured flights.
#[pyfunction]
#[pyo3(signature = (dataset, model, options, progress = None))]
pub fn fit(
    py: Python<'_>,
    dataset: &Bound<'_, Dataset>,
    model: Option<&Bound<'_, Model>>,
    options: &Bound<'_, PyAny>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Fit> {
    let options = Options::of(options)?;
    let dataset = dataset.get();
    let model = model_of(model, dataset)?;
    let (data, name) = (Arc::clone(&dataset.data), dataset.name.clone());
    let (of, on) = (Arc::clone(&model), Arc::clone(&data));
    let found = work::run(py, progress, move |watch| {
        options.with(watch, |options| {
            let mut fit = identify::fit(&of, &on, options)?;
            fit.report.dataset = name;
            let notes = program::fit::overruled_by(&of, &on);
            fit.report.notes.extend(notes);
            fit.with_lack_of_fit(options.threads())
        })
    })?;
    let fit = Arc::new(found.map_err(raise)?);
    Ok(Fit { fit, model, data })
}
