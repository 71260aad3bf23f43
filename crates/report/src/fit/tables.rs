//! CSV tables of a fit.

use identify::{Fit, FitReport, FlightEvidence, FlightId};

use crate::figures::csv::{CsvTable, Table};

/// Number of lines after which a table of residuals ends; the flights beyond are omitted.
const MAX_ROWS: usize = 1_000_000;

/// Estimates of a fit: one line per coefficient.
pub fn coefficients(report: &FitReport) -> String {
    CsvTable::of(&report.coefficients)
        .column("name", |(name, _)| *name)
        .column("value", |(_, c)| c.value)
        .column("std_error", |(_, c)| c.std_error)
        .optional("std_error_cluster_robust", |(_, c)| {
            c.std_error_cluster_robust
        })
        .column("low_95", |(_, c)| c.interval[0])
        .column("high_95", |(_, c)| c.interval[1])
        .column("unit", |(_, c)| &c.unit)
        .column("at_bound", |(_, c)| c.at_bound)
        .column("fixed", |(_, c)| c.fixed)
        .text()
}

/// Correlation matrix of the estimates.
pub fn correlations(report: &FitReport) -> String {
    let mut table = CsvTable::of(&report.correlations).column("name", |(name, _)| *name);
    for name in report.correlations.keys() {
        table = table.optional(name, |(_, row)| row.get(name).copied());
    }
    table.text()
}

/// Flights of a fit, one line each.
pub fn flights(report: &FitReport) -> String {
    let mut table = CsvTable::of(&report.flights)
        .column("file", |flight| &flight.file)
        .column("role", |flight| flight.role.name())
        .column("outcome", |flight| flight.outcome.name())
        .optional("reason", |flight| flight.outcome.reason())
        .column("samples", |flight| flight.samples);
    for kind in report.residual_rms.keys() {
        table = table.optional(&format!("residual_rms_{kind}"), |flight| {
            flight.residual_rms.get(kind).map(|rms| rms.value)
        });
    }
    table
        .column("outliers", |flight| flight.outliers)
        .optional("cut_at_s", |flight| flight.cut.as_ref().map(|cut| cut.t))
        .column("notes", |flight| flight.notes.join("; "))
        .text()
}

fn evidence(fit: &Fit) -> impl Iterator<Item = FlightEvidence> {
    let flights = (0..fit.report.flights.len()).map(FlightId::new);
    flights.filter_map(|id| fit.evidence(id))
}

/// Residuals (measured − predicted, m), one line for each measured position of a marker.
pub fn residuals(fit: &Fit) -> String {
    let mut table = Table::new(&["file", "t_s", "marker", "x_m", "y_m", "z_m", "outlier"]);
    for flight in evidence(fit) {
        for (sample, time) in flight.times.iter().enumerate() {
            for (marker, name) in flight.markers.iter().enumerate() {
                let Some(seen) = flight.measured[sample][marker] else {
                    continue;
                };
                let predicted = flight.predicted[sample][marker];
                table.text(&flight.file).fixed(*time).text(name);
                for axis in 0..3 {
                    table.fixed(seen[axis] - predicted[axis]);
                }
                let outlier = flight.outlier[sample][marker];
                table.text(&outlier.to_string()).end();
            }
        }
        if table.lines() > MAX_ROWS {
            break;
        }
    }
    table.finish()
}

/// Residuals of sensors (measured − predicted, in the unit of each), one line per measured value.
pub fn sensor_residuals(fit: &Fit) -> String {
    let mut table = Table::new(&["file", "t_s", "sensor", "unit", "x", "y", "z", "outlier"]);
    for flight in evidence(fit) {
        for sensor in &flight.sensors {
            for (sample, time) in flight.times.iter().enumerate() {
                let Some(residual) = sensor.residuals[sample] else {
                    continue;
                };
                table.text(&flight.file).fixed(*time);
                table.text(&sensor.name).text(&sensor.unit);
                for (axis, value) in residual.into_iter().enumerate() {
                    if axis < sensor.components {
                        table.fixed(value);
                    } else {
                        table.text("");
                    }
                }
                table.text(&sensor.outlier[sample].to_string()).end();
            }
        }
        if table.lines() > MAX_ROWS {
            break;
        }
    }
    table.finish()
}
