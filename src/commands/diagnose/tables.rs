//! CSV tables of a diagnosis.

use diagnose::Report;

use crate::commands::fit::role;

/// CSV table of the score tests of a diagnosis: one line per candidate effect.
pub fn candidates(report: &Report) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record([
        "name",
        "site",
        "score_chi2",
        "degrees_of_freedom",
        "ln_p_value",
        "z",
        "significant",
        "tolerance",
    ])?;
    for candidate in &report.tests {
        table.write_record([
            &candidate.name,
            &candidate.site,
            &candidate.score_chi2.to_string(),
            &candidate.degrees_of_freedom.to_string(),
            &candidate.ln_p_value.to_string(),
            &candidate.z.to_string(),
            &candidate.significant.to_string(),
            &candidate.tolerance.to_string(),
        ])?;
    }
    Ok(table.into_inner()?)
}

/// CSV table of the coefficients: one line per coefficient, with its estimates without and with the effects added to
/// the model.
pub fn coefficients(report: &Report) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(["name", "before", "value", "std_error", "unit"])?;
    for (name, found) in &report.coefficients {
        let before = found.before.map(|before| before.to_string());
        table.write_record([
            name,
            &before.unwrap_or_default(),
            &found.value.to_string(),
            &found.std_error.to_string(),
            &found.unit,
        ])?;
    }
    Ok(table.into_inner()?)
}

/// CSV table of the flights: one line per flight, with the RMS residual (m) without and with the effects added to the
/// model, and the p-value of the lack-of-fit test.
pub fn flights(report: &Report) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record([
        "file",
        "role",
        "outcome",
        "reason",
        "rms_before_m",
        "rms_after_m",
        "p_value",
    ])?;
    for flight in &report.flights {
        let before = flight.rms_before_m.map(|before| before.to_string());
        let after = flight.rms_after_m.map(|after| after.to_string());
        let tested = report.lack_of_fit.as_ref();
        let p = tested.and_then(|test| test.flights.get(&flight.file));
        table.write_record([
            &flight.file,
            role(flight.role),
            flight.outcome.name(),
            flight.outcome.reason().unwrap_or_default(),
            &before.unwrap_or_default(),
            &after.unwrap_or_default(),
            &p.map(f64::to_string).unwrap_or_default(),
        ])?;
    }
    Ok(table.into_inner()?)
}
