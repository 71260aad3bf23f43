//! CSV tables of a diagnosis.

use diagnose::Report;

use crate::figures::csv::CsvTable;

/// Score tests, one line per candidate effect.
pub fn candidates(report: &Report) -> String {
    CsvTable::of(&report.tests)
        .column("name", |test| &test.name)
        .column("site", |test| &test.site)
        .column("score_chi2", |test| test.score_chi2)
        .column("degrees_of_freedom", |test| test.degrees_of_freedom)
        .column("ln_p_value", |test| test.ln_p_value)
        .column("z", |test| test.z)
        .column("significant", |test| test.significant)
        .column("tolerance", |test| test.tolerance)
        .text()
}

/// Coefficients, one line each, with their estimates without and with the added effects.
pub fn coefficients(report: &Report) -> String {
    CsvTable::of(&report.coefficients)
        .column("name", |(name, _)| *name)
        .optional("before", |(_, c)| c.before)
        .column("value", |(_, c)| c.value)
        .column("std_error", |(_, c)| c.std_error)
        .column("unit", |(_, c)| &c.unit)
        .text()
}

/// Flights, one line each, with the RMS residual (m) without and with the added effects.
pub fn flights(report: &Report) -> String {
    let tested = report.lack_of_fit.as_ref().map(|test| &test.flights);
    CsvTable::of(&report.flights)
        .column("file", |flight| &flight.file)
        .column("role", |flight| flight.role.name())
        .column("outcome", |flight| flight.outcome.name())
        .optional("reason", |flight| flight.outcome.reason())
        .optional("rms_before_m", |flight| flight.rms_before_m)
        .optional("rms_after_m", |flight| flight.rms_after_m)
        .optional("p_value", |flight| tested?.get(&flight.file).copied())
        .text()
}
