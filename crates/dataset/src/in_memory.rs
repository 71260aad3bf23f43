//! Checks of a dataset that was built in memory.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::write::{read_back, tables, text_of};
use super::{Dataset, assemble, manifest, manifest_text};
use crate::input_error::InputError;

/// Reads and checks a dataset from texts, as [`load`](fn@super::load) does: `dataset.toml`, and the tables by name.
///
/// # Errors
/// [`InputError`] for the first fault, with its place in the texts.
pub fn from_texts(
    manifest: &str,
    tables: &BTreeMap<String, String>,
) -> Result<Dataset, InputError> {
    let manifest = manifest::parse(Path::new("dataset.toml"), manifest)?;
    assemble(manifest, flight::parallel::threads(), |file| {
        let path = PathBuf::from(file);
        match tables.get(file) {
            Some(text) => Ok((path, text.as_bytes().into(), false)),
            None => Err(InputError::of_file(
                &path,
                "no such table",
                "the text of a table",
            )),
        }
    })
}

impl Dataset {
    /// Checks this dataset as one read from files: valid names, plausible units, increasing times, finite values.
    ///
    /// # Errors
    /// The first fault found; its line and column refer to the files that [`write`](fn@super::write) would write.
    pub fn validate(&self) -> Result<(), InputError> {
        let tables = tables(self);
        if read_back(&manifest_text(self), |path| Ok(text_of(&tables, path)))? == *self {
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
