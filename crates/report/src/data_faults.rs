//! Table of the errors found in measured data, for the pages of fits and diagnoses.

use identify::DataFault;
use serde::Serialize;

/// Maximum number of faults in the measured data that the table of a report lists.
const MAX_ROWS: usize = 60;

/// Table of the faults found in measured data, as input of the HTML templates.
#[derive(Serialize)]
pub(crate) struct Table {
    /// Total number of faults in the measured data, including those that the table does not list.
    all: usize,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    file: String,
    fault: String,
    detail: String,
    correction: String,
}

/// Builds the table of the faults found in measured data, limited to [`MAX_ROWS`] rows.
pub(crate) fn table(faults: &[DataFault]) -> Table {
    let row = |fault: &DataFault| Row {
        file: fault.file.clone(),
        fault: fault.fault.name().replace('-', " "),
        detail: fault.detail.clone(),
        correction: fault.correction.clone(),
    };
    Table {
        all: faults.len(),
        rows: faults.iter().take(MAX_ROWS).map(row).collect(),
    }
}
