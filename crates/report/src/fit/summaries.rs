//! Flights that are summaries: what was seen of them beside what the model predicts.

use dataset::Role;
use identify::numbers::{plain, quantity, significant};
use identify::{FitReport, FlightReport, SeenValue};

use crate::figures::csv::CsvTable;
use crate::table::Table;
use crate::thin::MAX_ROWS;

/// Whether every flight that was used is a summary.
pub(super) fn only(report: &FitReport) -> bool {
    let mut used = report.flights.iter().filter(|flight| flight.is_used());
    used.clone().next().is_some() && used.all(|flight| flight.is_summary)
}

/// Flights that are summaries.
fn flights(report: &FitReport) -> impl Iterator<Item = &FlightReport> {
    report.flights.iter().filter(|flight| flight.is_summary)
}

/// Number of values that were seen of the fitted flights.
pub(super) fn values(report: &FitReport) -> usize {
    report.used(Role::Fit).map(|flight| flight.seen.len()).sum()
}

/// Root mean square residuals of the quantities, in words.
pub(super) fn residuals(report: &FitReport) -> Option<String> {
    let mut names: Vec<&str> = Vec::new();
    for value in flights(report).flat_map(|flight| &flight.seen) {
        if !names.contains(&&*value.measures) {
            names.push(&value.measures);
        }
    }
    let held_out: Vec<&FlightReport> = report.used(Role::HeldOut).collect();
    let each = names.iter().filter_map(|name| {
        let rms = report.residual_rms.get(*name)?;
        let mut text = format!("{name} {}", quantity(rms.value, &rms.unit));
        let own = held_out.iter().flat_map(|flight| &flight.seen);
        let own = own.filter(|value| value.measures == *name);
        let squares: Vec<f64> = own.map(|v| (v.predicted - v.measured).powi(2)).collect();
        if !squares.is_empty() {
            let rms_held = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
            text += &format!(" (held out {})", quantity(rms_held, &rms.unit));
        }
        Some(text)
    });
    let each: Vec<String> = each.collect();
    (!each.is_empty()).then(|| format!("RMS residuals: {}.", each.join(", ")))
}

/// Table with a row per flight: for each quantity the measured value, and the predicted one after an arrow.
pub(super) fn table(report: &FitReport) -> Table {
    let all: Vec<&FlightReport> = flights(report).collect();
    let mut columns: Vec<&SeenValue> = Vec::new();
    for value in all.iter().flat_map(|flight| &flight.seen) {
        if !columns.iter().any(|own| own.measures == value.measures) {
            columns.push(value);
        }
    }
    let mut rows = Table::of(all.iter().take(MAX_ROWS))
        .file("flight", |flight| flight.file.clone())
        .plain("role", |flight| flight.role.name());
    for column in columns {
        let head = format!("{} ({})", column.measures, column.unit);
        rows = rows.number(&head, |flight| {
            let own = flight
                .seen
                .iter()
                .find(|own| own.measures == column.measures);
            own.map_or_else(String::new, |own| {
                let digits = decimals(own.sigma);
                let (seen, predicted) = (plain(own.measured, digits), plain(own.predicted, digits));
                format!("{seen} → {predicted}")
            })
        });
    }
    rows.table()
}

/// Decimals that show a tenth of a standard deviation.
fn decimals(sigma: f64) -> usize {
    let tenth = (sigma / 10.0).log10().floor();
    if tenth.is_finite() {
        (-tenth).clamp(0.0, 6.0) as usize
    } else {
        3
    }
}

/// Values of all summaries: one line for each.
pub fn csv(report: &FitReport) -> Option<String> {
    let rows = flights(report).flat_map(|flight| flight.seen.iter().map(move |own| (flight, own)));
    let rows: Vec<(&FlightReport, &SeenValue)> = rows.collect();
    (!rows.is_empty()).then(|| {
        CsvTable::of(rows)
            .column("file", |(flight, _)| &flight.file)
            .column("role", |(flight, _)| flight.role.name())
            .column("quantity", |(_, own)| &own.measures)
            .column("unit", |(_, own)| &own.unit)
            .column("measured", |(_, own)| own.measured)
            .column("predicted", |(_, own)| own.predicted)
            .column("sigma", |(_, own)| own.sigma)
            .text()
    })
}

/// Noise of the columns, in words.
pub(super) fn noise(report: &FitReport) -> String {
    let each = report.noise.iter().map(|(name, noise)| {
        let how = if noise.estimated {
            "estimated"
        } else {
            "given"
        };
        let sigma = significant(noise.sigma, 3);
        format!(
            "{name} {sigma} {} ({how}, {} values)",
            noise.unit, noise.points
        )
    });
    let each: Vec<String> = each.collect();
    format!("Standard deviation of each column: {}.", each.join(", "))
}

#[cfg(test)]
mod tests {
    use super::decimals;

    #[test]
    fn a_tenth_of_a_standard_deviation_is_shown() {
        let sigmas = [30.0, 5.0, 0.5, 0.02, 1e-9, 0.0];
        assert_eq!(sigmas.map(decimals), [0, 1, 2, 3, 6, 3]);
    }
}
