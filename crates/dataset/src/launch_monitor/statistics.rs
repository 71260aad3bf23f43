//! Rows of an export that are statistics of its shots, such as their averages.

use super::Row;
use crate::words::shown;

/// Labels of such rows, in small letters without all else.
const LABELS: &str = "average averages avg mean deviation standarddeviation stddeviation stddev stdev std sd variance \
    consistency min minimum max maximum range median total totals sum";

/// Takes the rows out that are statistics, and tells each with its line.
pub(super) fn take_statistics(rows: &mut Vec<Row>) -> Vec<String> {
    let labels: Vec<Option<String>> = rows.iter().map(|(_, cells)| label(cells)).collect();
    let labelled = |row: Option<usize>| labels.get(row?)?.as_deref();
    // No statistic follows itself: a label in row after row is a name, as of a player called Max.
    let is_statistic = |row: usize| {
        let own = labelled(Some(row));
        own.is_some() && own != labelled(row.checked_sub(1)) && own != labelled(Some(row + 1))
    };
    let mut lines = Vec::new();
    let mut row = 0;
    rows.retain(|(line, _)| {
        let taken = is_statistic(row);
        if let Some(label) = labelled(Some(row)).filter(|_| taken) {
            lines.push(format!("line {line} left out: {}, no shot", shown(label)));
        }
        row += 1;
        !taken
    });
    lines
}

/// The first cell of a row that is a label of a statistic.
fn label(cells: &[String]) -> Option<String> {
    let is_label = |cell: &&String| {
        let letters = cell.chars().filter(|c| c.is_alphabetic());
        let word: String = letters.flat_map(char::to_lowercase).collect();
        LABELS.split(' ').any(|own| own == word)
    };
    cells.iter().find(is_label).cloned()
}
