//! Inputs over time of a flight: columns of its own table, or a table of their own rate.

use std::path::Path;

use flight::{InputInterpolation, InputSeries, read_inputs};

use super::lines::Lines;
use super::recording::Recording;
use super::words::shown;
use crate::input_error::InputError;

/// Samples of the inputs of a flight, as read: the columns of a table with their values over time.
#[derive(Debug, Default, PartialEq)]
pub(super) struct InputColumns {
    columns: Vec<Column>,
}

#[derive(Debug, PartialEq)]
struct Column {
    name: String,
    index: usize,
    /// Times (s) and values; missing values are left out.
    samples: Vec<(f64, f64)>,
}

impl InputColumns {
    /// Whether a column may be an input beside those of `devices`: one of an unknown marker ends in an axis.
    pub fn may_be(name: &str, devices: &[&str]) -> bool {
        let axes = ["_x", "_y", "_z", "_qw", "_qx", "_qy", "_qz"];
        let is_of = |device: &&str| {
            let rest = name.strip_prefix(*device);
            rest.is_some_and(|rest| rest.starts_with('_'))
        };
        let is_word = name.chars().all(|c| c == '_' || c.is_alphanumeric());
        is_word
            && name.starts_with(|c: char| c == '_' || c.is_alphabetic())
            && !axes.iter().any(|axis| name.ends_with(axis))
            && !devices.iter().any(is_of)
    }

    /// Columns with these names and indices.
    pub fn new(columns: Vec<(String, usize)>) -> InputColumns {
        let columns = columns.into_iter().map(|(name, index)| Column {
            name,
            index,
            samples: Vec::new(),
        });
        InputColumns {
            columns: columns.collect(),
        }
    }

    pub fn len(&self) -> usize {
        self.columns.len()
    }

    /// Reads the current row, whose time is `time`, s.
    pub fn row(&mut self, lines: &Lines<'_>, time: f64) -> Result<(), InputError> {
        for column in &mut self.columns {
            let read = lines.number(column.index)?;
            column.samples.extend(read.map(|value| (time, value)));
        }
        Ok(())
    }

    /// The inputs as functions of time.
    ///
    /// # Errors
    /// [`InputError`] for a column of `file` without a value.
    pub fn series(
        self,
        file: &Path,
        interpolation: InputInterpolation,
    ) -> Result<Vec<(String, InputSeries)>, InputError> {
        let each = self.columns.into_iter().map(|column| {
            if column.samples.is_empty() {
                let found = format!("no value in the column {}", shown(&column.name));
                return Err(InputError::of_file(
                    file,
                    found,
                    "the values of an input over time",
                ));
            }
            let series = InputSeries::new(&column.samples, interpolation);
            Ok((column.name, series))
        });
        each.collect()
    }
}

/// Reads a table of inputs: a column `t`, and one for each input by its name.
pub(super) fn parse(
    file: &Path,
    text: &str,
    recording: &Recording,
    interpolation: InputInterpolation,
) -> Result<Vec<(String, InputSeries)>, InputError> {
    let read = read_inputs(text, interpolation, |time| recording.seconds(time));
    read.map_err(|fault| InputError::at(file, fault.location.place(), fault.found, fault.expected))
}

/// Text of a table of inputs: a row for each time at which one of them has a sample.
pub(super) fn text(inputs: &[(String, InputSeries)]) -> String {
    let mut times: Vec<f64> = inputs
        .iter()
        .flat_map(|(_, series)| series.samples().map(|(t, _)| t))
        .collect();
    times.sort_unstable_by(f64::total_cmp);
    times.dedup();
    let names = inputs.iter().map(|(name, _)| format!(",{name}"));
    let mut text = format!("t{}\n", names.collect::<String>());
    let mut samples: Vec<_> = inputs
        .iter()
        .map(|(_, series)| series.samples().peekable())
        .collect();
    for time in times {
        text += &time.to_string();
        for own in &mut samples {
            text.push(',');
            if let Some((_, value)) = own.next_if(|(t, _)| *t == time) {
                text += &value.to_string();
            }
        }
        text.push('\n');
    }
    text
}
