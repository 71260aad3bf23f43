//! Checks of a dataset that was built in memory.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::write::read_back;
use super::{Dataset, assemble, manifest, manifest_text, table, table_text, upright};
use crate::input_error::InputError;

/// Reads and checks a dataset from texts in memory, as [`load`](fn@super::load) does from files: the text of
/// `dataset.toml`, and the texts of the tables by the names of their files.
///
/// # Errors
/// [`InputError`] for the first fault, with its place in the texts.
pub fn from_texts(
    manifest: &str,
    tables: &BTreeMap<String, String>,
) -> Result<Dataset, InputError> {
    let manifest = manifest::parse(Path::new("dataset.toml"), manifest)?;
    let recording = manifest.recording;
    let threads = flight::parallel::threads();
    assemble(manifest, threads, |_, entry, markers, sensors| {
        let path = PathBuf::from(&entry.file);
        let names: Vec<&str> = markers.iter().map(|marker| marker.name.as_str()).collect();
        let text = tables
            .get(&entry.file)
            .ok_or_else(|| InputError::of_file(&path, "no such table", "the text of a table"))?;
        table::parse(&path, text, (&names, sensors), &recording)
            .map(|table| (path, upright::upright(&recording, table, sensors)))
    })
}

impl Dataset {
    /// Checks this dataset in the same way as a dataset read from files: names must be valid, units plausible, times
    /// increasing and values finite, for example.
    ///
    /// # Errors
    /// The first fault found; its line and column refer to the files that [`write`](fn@super::write) would write.
    pub fn validate(&self) -> Result<(), InputError> {
        let table = |index: usize, _: &Path| {
            let text = |flight| table_text(flight, &self.markers, &self.sensors);
            Ok(self
                .flights
                .get(index)
                .map_or_else(String::new, text)
                .into())
        };
        if read_back(&manifest_text(self), table)? == *self {
            return Ok(());
        }
        let found = "a time or position that is not finite, or rows of different lengths";
        let expected = "finite samples of every marker";
        Err(InputError::of_file(
            Path::new("dataset.toml"),
            found,
            expected,
        ))
    }
}
