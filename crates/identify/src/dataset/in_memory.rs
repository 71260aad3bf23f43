//! Checks of a dataset that was built in memory.

use std::path::{Path, PathBuf};

use super::recording::Recording;
use super::{Dataset, assemble, manifest, manifest_text, table, table_text};
use crate::input_error::InputError;

impl Dataset {
    /// Runs all checks of dataset files on this dataset, such as valid names, plausible units, increasing times and
    /// finite values.
    ///
    /// # Errors
    /// The first fault found; its line and column refer to the files that [`write`](fn@super::write) would write.
    pub fn validate(&self) -> Result<(), InputError> {
        let file = Path::new("dataset.toml");
        let manifest = manifest::parse(file, &manifest_text(self))?;
        let read = assemble(manifest, 1, |index, entry, markers, sensors| {
            let path = PathBuf::from(&entry.file);
            let names: Vec<&str> = markers.iter().map(|marker| &*marker.name).collect();
            let flight = self.flights.get(index);
            let text = flight.map(|flight| table_text(flight, markers, sensors));
            table::parse(
                &path,
                &text.unwrap_or_default(),
                (&names, sensors),
                &Recording::default(),
            )
            .map(|table| (path, table))
        })?;
        if read == *self {
            return Ok(());
        }
        let found = "a time or position that is not finite, or rows of different lengths";
        Err(InputError::of_file(
            file,
            found,
            "finite samples of every marker",
        ))
    }
}
