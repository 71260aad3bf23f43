//! Datasets: read from folders, or from texts in memory with the same checks.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use dataset::{Dataset as Data, Role};
use hyzer::program;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::errors::{of_class, raise};
use crate::work;

/// Measured flights of one body.
#[pyclass(frozen, module = "hyzer._hyzer")]
pub struct Dataset {
    /// The flights, markers and sensors.
    pub data: Arc<Data>,
    /// Name in reports: that of the folder.
    #[pyo3(get)]
    pub name: String,
    /// The folder that was read; `None` for a dataset built in memory.
    #[pyo3(get)]
    pub folder: Option<PathBuf>,
    /// Further files of the folder, such as the true values of a synthetic dataset.
    pub beside: Vec<(String, String)>,
    /// Comments above the positions of the markers.
    pub comments: Vec<String>,
    /// What was decided when takes were imported.
    pub decisions: String,
}

/// Further files, comments and decisions of a dataset.
type About = (Vec<(String, String)>, Vec<String>, String);

impl Dataset {
    /// A dataset with a name in reports.
    pub fn of(data: Data, name: String, folder: Option<PathBuf>) -> Dataset {
        Dataset {
            data: Arc::new(data),
            name,
            folder,
            beside: Vec::new(),
            comments: Vec::new(),
            decisions: String::new(),
        }
    }

    /// Name or path of the model, and its text where that is among the files of the dataset.
    pub fn named_model(&self) -> (String, Option<&str>) {
        let folder = self.folder.as_deref().unwrap_or(Path::new(""));
        let own = self.beside.iter();
        let own = own.filter(|(file, _)| *file == self.data.model);
        let text = own.map(|(_, text)| text.as_str()).next();
        (program::fit::model_of(folder, &self.data), text)
    }
}

#[pymethods]
impl Dataset {
    #[new]
    #[pyo3(signature = (manifest, tables, name = String::new(), folder = None, about = Default::default()))]
    fn new(
        manifest: &str,
        tables: BTreeMap<String, String>,
        name: String,
        folder: Option<PathBuf>,
        about: About,
    ) -> PyResult<Dataset> {
        let data = dataset::from_texts(manifest, &tables).map_err(raise)?;
        let (beside, comments, decisions) = about;
        Ok(Dataset {
            beside,
            comments,
            decisions,
            ..Dataset::of(data, name, folder)
        })
    }

    /// What `new` makes the same dataset of.
    fn parts(
        &self,
    ) -> (
        String,
        BTreeMap<String, String>,
        &str,
        Option<&PathBuf>,
        About,
    ) {
        let (manifest, tables) = self.texts();
        let about = (
            self.beside.clone(),
            self.comments.clone(),
            self.decisions.clone(),
        );
        (
            manifest,
            tables.into_iter().collect(),
            &self.name,
            self.folder.as_ref(),
            about,
        )
    }

    /// The dataset with flights, by their files, that a fit does not use.
    fn held_out(&self, files: Vec<String>) -> Dataset {
        let mut data = (*self.data).clone();
        for flight in &mut data.flights {
            if files.contains(&flight.file) {
                flight.role = Role::HeldOut;
            }
        }
        Dataset {
            beside: self.beside.clone(),
            comments: self.comments.clone(),
            decisions: self.decisions.clone(),
            ..Dataset::of(data, self.name.clone(), self.folder.clone())
        }
    }

    #[staticmethod]
    #[pyo3(signature = (folder, threads = None))]
    fn load(py: Python<'_>, folder: PathBuf, threads: Option<usize>) -> PyResult<Dataset> {
        let name = folder.file_name().unwrap_or(folder.as_os_str());
        let name = name.to_string_lossy().into_owned();
        let path = folder.clone();
        let data = work::run(py, None, move |_| dataset::load_on(&path, threads))?;
        Ok(Dataset::of(data.map_err(raise)?, name, Some(folder)))
    }

    /// Texts of `dataset.toml` and of the tables, by file.
    fn texts(&self) -> (String, Vec<(String, String)>) {
        let Data {
            markers,
            sensors,
            flights,
            ..
        } = &*self.data;
        let tables = flights.iter().map(|flight| {
            (
                flight.file.clone(),
                dataset::table_text(flight, markers, sensors),
            )
        });
        (dataset::manifest_text(&self.data), tables.collect())
    }

    fn save_files(&self, folder: PathBuf) -> PyResult<()> {
        let mut data = Cow::Borrowed(&*self.data);
        let mut beside = Cow::Borrowed(&self.beside[..]);
        if let (named, None) = self.named_model()
            && let Some(own) = program::fit::model_file(&named).map_err(raise)?
        {
            data.to_mut().model.clone_from(&own.0);
            beside.to_mut().push(own);
        }
        dataset::write_commented(&folder, &data, &beside, &self.comments).map_err(|error| {
            let text = format!("{}: {error}", folder.display());
            of_class("FolderError", &text)
        })
    }

    #[getter]
    fn decisions(&self) -> String {
        self.decisions.clone()
    }

    #[getter]
    fn model(&self) -> &str {
        &self.data.model
    }

    #[getter]
    fn parameters(&self) -> BTreeMap<String, f64> {
        self.data.parameters.clone()
    }

    #[getter]
    fn markers(&self) -> BTreeMap<String, [f64; 3]> {
        let markers = self.data.markers.iter();
        markers
            .map(|marker| (marker.name.clone(), marker.position))
            .collect()
    }

    #[getter]
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.data.flights.iter().map(|flight| &flight.file))
    }
}
