//! Faults of the data and reasons not to rely on a result, for terminal and page.

use identify::DataFault;

use crate::table::Table;
use crate::text;
use crate::thin::MAX_ROWS;

/// Reasons not to rely on a result, `what`, and faults of the data with their corrections.
pub(crate) fn cautions(what: &str, reasons: &[String], faults: &[DataFault]) -> String {
    let mut text = String::new();
    if !reasons.is_empty() {
        let reasons = reasons.join("\n  ");
        text += &format!(
            "DO NOT RELY ON THIS {}:\n  {reasons}\n\n",
            what.to_uppercase()
        );
    }
    if !faults.is_empty() {
        let table = data_faults(faults).text(text::MAX_ROWS);
        text += &format!("faults of the data ({}):\n{table}\n", faults.len());
    }
    text
}

/// Table of the first [`MAX_ROWS`] faults of the measured data.
pub(crate) fn data_faults(faults: &[DataFault]) -> Table {
    Table::of(faults.iter().take(MAX_ROWS))
        .file("flight", |fault| &fault.file)
        .plain("fault", |fault| fault.fault.to_string().replace('_', " "))
        .text("found", |fault| &fault.detail)
        .text("correction", |fault| &fault.correction)
        .table()
}
