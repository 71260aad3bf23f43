//! Helpers to read text files of measured data.

use std::path::Path;

use crate::error::StudyError;

/// Returns the contents of a file of measured data as text.
pub(super) fn text_of(file: &Path) -> Result<String, StudyError> {
    std::fs::read_to_string(file).map_err(|source| StudyError::Unreadable {
        file: file.to_owned(),
        source,
    })
}

/// Lines of a text with their numbers (from 1), without the first `header` lines and without empty lines.
pub(super) fn rows(text: &str, header: usize) -> impl Iterator<Item = (usize, &str)> {
    let lines = text.lines().enumerate().skip(header);
    let lines = lines.filter(|(_, line)| !line.trim().is_empty());
    lines.map(|(index, line)| (index + 1, line))
}

/// Parses the comma-separated cells of a line as numbers; cells that are not numbers are skipped.
pub(super) fn numbers(line: &str) -> Vec<f64> {
    let cells = line.split(',');
    cells.filter_map(|cell| cell.trim().parse().ok()).collect()
}

/// Builds the error for a line, given by its number (from 1) and text, that does not have the form described by
/// `expected`.
pub(super) fn bad_line(
    file: &Path,
    (line, text): (usize, &str),
    expected: &'static str,
) -> StudyError {
    StudyError::Line {
        file: file.to_owned(),
        line,
        found: text.to_owned(),
        expected,
    }
}

/// Builds the error for a file that lacks required content; `expected` describes this content.
pub(super) fn absent(file: &Path, expected: impl Into<String>) -> StudyError {
    StudyError::Absent {
        file: file.to_owned(),
        expected: expected.into(),
    }
}
