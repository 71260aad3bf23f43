//! Checks of a dataset that was built in memory.

use std::path::Path;

use super::write::read_back;
use super::{Dataset, manifest_text, table_text};
use crate::input_error::InputError;

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
