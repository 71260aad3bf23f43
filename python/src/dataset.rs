//! Datasets: read from folders, or from texts in memory with the same checks.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use dataset::Dataset as Data;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::errors::raise;
use crate::work;

/// Measured flights of one body.
#[pyclass(subclass, frozen, module = "hyzer._hyzer")]
pub struct Dataset {
    /// The flights, markers and sensors.
    pub data: Arc<Data>,
    /// Name in reports: that of the folder.
    #[pyo3(get)]
    pub name: String,
    /// The folder that was read; `None` for a dataset built in memory.
    #[pyo3(get)]
    pub folder: Option<PathBuf>,
}

#[pymethods]
impl Dataset {
    #[new]
    #[pyo3(signature = (manifest, tables, name = String::new()))]
    fn new(manifest: &str, tables: BTreeMap<String, String>, name: String) -> PyResult<Dataset> {
        let data = dataset::from_texts(manifest, &tables).map_err(raise)?;
        let data = Arc::new(data);
        Ok(Dataset {
            data,
            name,
            folder: None,
        })
    }

    #[staticmethod]
    #[pyo3(signature = (folder, threads = None))]
    fn load(py: Python<'_>, folder: PathBuf, threads: Option<usize>) -> PyResult<Dataset> {
        let name = folder.file_name().unwrap_or(folder.as_os_str());
        let name = name.to_string_lossy().into_owned();
        let path = folder.clone();
        let data = work::run(py, None, move |_| dataset::load_on(&path, threads))?;
        let data = Arc::new(data.map_err(raise)?);
        Ok(Dataset {
            data,
            name,
            folder: Some(folder),
        })
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
