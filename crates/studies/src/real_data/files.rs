//! Text files of measured data.

use std::path::Path;

use crate::error::StudyError;

/// Text of a file.
pub(super) fn text_of(file: &Path) -> Result<String, StudyError> {
    std::fs::read_to_string(file).map_err(|source| StudyError::Unreadable {
        file: file.to_owned(),
        source,
    })
}

/// Lines with their numbers, from 1, without empty ones and the first `header` lines.
pub(super) fn rows(text: &str, header: usize) -> impl Iterator<Item = (usize, &str)> {
    let lines = text.lines().enumerate().skip(header);
    let lines = lines.filter(|(_, line)| !line.trim().is_empty());
    lines.map(|(index, line)| (index + 1, line))
}

/// All numbers of a line, separated by commas.
pub(super) fn numbers(line: &str) -> Vec<f64> {
    let cells = line.split(',');
    cells.filter_map(|cell| cell.trim().parse().ok()).collect()
}

/// A line that is not as expected.
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

/// Something that a file lacks.
pub(super) fn absent(file: &Path, expected: impl Into<String>) -> StudyError {
    StudyError::Absent {
        file: file.to_owned(),
        expected: expected.into(),
    }
}
