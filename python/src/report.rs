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

#[pymethods]
impl Report {
    fn report_json(&self) -> &str {
        &self.json
    }

    fn summary_text(&self) -> &str {
        &self.text
    }

    fn page_html(&self) -> String {
        self.file_text("report.html").unwrap_or_default()
    }

    fn file_text(&self, name: &str) -> Option<String> {
        let file = self.files.iter().find(|file| file.path == name);
        file.map(|file| String::from_utf8_lossy(&file.contents).into_owned())
    }

    fn save_files(&self, folder: PathBuf) -> PyResult<()> {
        write(&folder, &self.files)
    }
}
