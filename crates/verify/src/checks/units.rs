//! Check of units and frames, from the diagnostics of the language checker.

use crate::row::Row;
use model_spec::diagnostic::Diagnostic;
use model_spec::load::Loaded;
use model_spec::location::line_of;
use model_spec::model::Source;

/// Name of this check in reports: errors, such as wrong units or frames, that the language checker reports.
pub const UNITS: &str = "units and frames";

/// Checks that the language checker reports no errors; the detail has a line for each, with its location.
pub fn check(loaded: &Loaded) -> Row {
    let lines: Vec<String> = loaded
        .diagnostics
        .iter()
        .map(|fault| line(fault, &loaded.sources))
        .collect();
    Row::counted(UNITS, loaded.file.items.len(), &lines, "")
}

fn line(fault: &Diagnostic, sources: &[Source]) -> String {
    let source = sources.get(usize::from(fault.span.source));
    let line = source.map_or(1, |s| line_of(&s.text, fault.span.range().start));
    format!("line {line}: {}", fault.message)
}
