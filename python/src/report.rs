//! Results that are whole when they are returned: JSON, text and the files of the program.

use std::path::PathBuf;

use flight::files::ResultFile;
use pyo3::prelude::*;

use crate::fit::write;

/// Result of a command of the program.
#[pyclass(frozen, module = "hyzer._hyzer")]
pub struct Report {
    /// The report.
    pub json: String,
    /// What the program prints.
    pub text: String,
    /// What the program writes.
    pub files: Vec<ResultFile>,
}

impl Report {
    /// Report whose one file is its JSON.
    pub fn of_json(file: &str, json: String, text: String) -> Report {
        Report {
            files: vec![ResultFile::new(file, json.clone())],
            json,
            text,
        }
    }
}

#[pymethods]
impl Report {
    fn report_json(&self) -> &str {
        &self.json
    }

    fn summary_text(&self) -> &str {
        &self.text
    }

    fn model_text(&self) -> Option<String> {
        None
    }

    fn files(&self) -> Vec<(String, Vec<u8>)> {
        named(self.files.clone())
    }

    fn file_text(&self, name: &str) -> Option<String> {
        let file = self.files.iter().find(|file| file.path == name);
        file.map(|file| String::from_utf8_lossy(&file.contents).into_owned())
    }

    fn save_files(&self, folder: PathBuf) -> PyResult<()> {
        write(&folder, &self.files)
    }
}

/// Contents of files by their names.
pub fn named(files: Vec<ResultFile>) -> Vec<(String, Vec<u8>)> {
    let files = files.into_iter();
    files.map(|file| (file.path, file.contents)).collect()
}

/// Replaces the results in a folder by files, contents by name.
#[pyfunction]
pub fn write_files(folder: PathBuf, files: Vec<(String, Vec<u8>)>) -> PyResult<()> {
    let files = files.into_iter();
    let files: Vec<ResultFile> = files
        .map(|(path, contents)| ResultFile::new(path, contents))
        .collect();
    write(&folder, &files)
}
