//! CSV tables of a diagnosis.

use diagnose::Report;

use crate::figures::csv::CsvTable;

/// CSV table of the score tests of a diagnosis: one line per candidate effect.
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

/// CSV table of the coefficients: one line per coefficient, with its estimates without and with the effects added to
/// the model.
pub fn coefficients(report: &Report) -> String {
    CsvTable::of(&report.coefficients)
        .column("name", |(name, _)| *name)
        .column("before", |(_, c)| c.before)
        .column("value", |(_, c)| c.value)
        .column("std_error", |(_, c)| c.std_error)
        .column("unit", |(_, c)| &c.unit)
        .text()
}

/// CSV table of the flights: one line per flight, with the RMS residual (m) without and with the effects added to the
/// model, and the p-value of the lack-of-fit test.
pub fn flights(report: &Report) -> String {
    let tested = report.lack_of_fit.as_ref().map(|test| &test.flights);
    CsvTable::of(&report.flights)
        .column("file", |flight| &flight.file)
        .column("role", |flight| flight.role.name())
        .column("outcome", |flight| flight.outcome.name())
        .column("reason", |flight| flight.outcome.reason())
        .column("rms_before_m", |flight| flight.rms_before_m)
        .column("rms_after_m", |flight| flight.rms_after_m)
        .column("p_value", |flight| tested?.get(&flight.file).copied())
        .text()
}
