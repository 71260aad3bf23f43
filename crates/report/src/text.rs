//! Text of results for a terminal.

use identify::DataFault;

use crate::page::data_faults;

pub(crate) const MAX_ROWS: usize = 20;
const WIDTH: usize = 100;

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
        let table = data_faults(faults).text(MAX_ROWS);
        text += &format!("faults of the data ({}):\n{table}\n", faults.len());
    }
    text
}

/// Breaks a paragraph into lines; it ends with a line break.
pub(crate) fn wrapped(text: &str) -> String {
    let (mut lines, mut width) = (String::new(), 0);
    for word in text.split_ascii_whitespace() {
        let length = word.chars().count();
        if width + length >= WIDTH {
            lines.push('\n');
            width = 0;
        } else if width > 0 {
            lines.push(' ');
            width += 1;
        }
        lines += word;
        width += length;
    }
    lines + "\n"
}
