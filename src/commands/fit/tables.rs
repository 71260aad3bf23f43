//! CSV tables of a fit.

use dataset::{Dataset, Role};
use identify::{Fit, FitReport};

/// CSV table of the estimates of a fit: one line per coefficient, with its standard errors and 95 % interval.
pub fn coefficients(report: &FitReport) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record([
        "name",
        "value",
        "std_error",
        "std_error_cluster_robust",
        "low_95",
        "high_95",
        "unit",
        "at_bound",
        "fixed",
    ])?;
    for (name, found) in &report.coefficients {
        let clustered = found
            .std_error_cluster_robust
            .map(|error| error.to_string());
        table.write_record([
            name,
            &found.value.to_string(),
            &found.std_error.to_string(),
            &clustered.unwrap_or_default(),
            &found.interval[0].to_string(),
            &found.interval[1].to_string(),
            &found.unit,
            &found.at_bound.to_string(),
            &found.fixed.to_string(),
        ])?;
    }
    Ok(table.into_inner()?)
}

/// CSV table of the correlation matrix of the estimated coefficients.
pub fn correlations(report: &FitReport) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_field("name")?;
    table.write_record(report.correlations.keys())?;
    for (name, row) in &report.correlations {
        table.write_field(name)?;
        table.write_record(row.values().map(f64::to_string))?;
    }
    Ok(table.into_inner()?)
}

/// CSV table of the flights of a fit: one line per flight, with its role, its number of samples, the RMS residual of
/// each kind of sensor in its unit, the number of outliers and the time (s) at which the flight was truncated.
pub fn flights(report: &FitReport) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    let kinds: Vec<&String> = report.residual_rms.keys().collect();
    let mut header: Vec<String> = ["file", "role", "outcome", "reason", "samples"]
        .map(str::to_owned)
        .into();
    header.extend(kinds.iter().map(|kind| format!("residual_rms_{kind}")));
    header.extend(["outliers", "cut_at_s", "notes"].map(str::to_owned));
    table.write_record(header)?;
    for flight in &report.flights {
        let cut = flight.cut.as_ref().map(|cut| cut.t.to_string());
        let rms = kinds.iter().map(|kind| {
            let rms = flight.residual_rms.get(*kind);
            rms.map(|rms| rms.value.to_string()).unwrap_or_default()
        });
        let mut row = vec![
            flight.file.clone(),
            role(flight.role).to_owned(),
            flight.outcome.name().to_owned(),
            flight.outcome.reason().unwrap_or_default().to_owned(),
            flight.samples.to_string(),
        ];
        row.extend(rms);
        row.extend([
            flight.outliers.to_string(),
            cut.unwrap_or_default(),
            flight.notes.join("; "),
        ]);
        table.write_record(row)?;
    }
    Ok(table.into_inner()?)
}

/// Maximum number of lines of a CSV table of residuals; the flights beyond it are omitted.
const MAX_ROWS: usize = 1_000_000;

/// CSV table of residuals (measured − predicted, m): one line for each measured position of a marker.
pub fn residuals(dataset: &Dataset, fitted: &Fit) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(["file", "t_s", "marker", "x_m", "y_m", "z_m", "outlier"])?;
    let mut rows = 0;
    for index in 0..dataset.flights.len() {
        let Some(flight) = fitted.evidence(identify::FlightId::new(index)) else {
            continue;
        };
        for (sample, time) in flight.times.iter().enumerate() {
            for (marker, name) in flight.markers.iter().enumerate() {
                let Some(seen) = flight.measured[sample][marker] else {
                    continue;
                };
                let predicted = flight.predicted[sample][marker];
                let [x, y, z] =
                    [0, 1, 2].map(|axis| format!("{:.6}", seen[axis] - predicted[axis]));
                let outlier = flight.outlier[sample][marker].to_string();
                table.write_record([
                    &flight.file,
                    &format!("{time:.6}"),
                    name,
                    &x,
                    &y,
                    &z,
                    &outlier,
                ])?;
                rows += 1;
            }
        }
        if rows > MAX_ROWS {
            break;
        }
    }
    Ok(table.into_inner()?)
}

/// CSV table of the residuals of sensors (measured − predicted, in the unit of each sensor): one line per measured
/// value of a sensor.
pub fn sensor_residuals(dataset: &Dataset, fitted: &Fit) -> anyhow::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(["file", "t_s", "sensor", "unit", "x", "y", "z", "outlier"])?;
    let mut rows = 0;
    for index in 0..dataset.flights.len() {
        let Some(flight) = fitted.evidence(identify::FlightId::new(index)) else {
            continue;
        };
        for sensor in &flight.sensors {
            for (sample, time) in flight.times.iter().enumerate() {
                let Some(residual) = sensor.residuals[sample] else {
                    continue;
                };
                let part = |axis: usize| {
                    if axis < sensor.components {
                        format!("{:.6}", residual[axis])
                    } else {
                        String::new()
                    }
                };
                table.write_record([
                    &flight.file,
                    &format!("{time:.6}"),
                    &sensor.name,
                    &sensor.unit,
                    &part(0),
                    &part(1),
                    &part(2),
                    &sensor.outlier[sample].to_string(),
                ])?;
                rows += 1;
            }
        }
        if rows > MAX_ROWS {
            break;
        }
    }
    Ok(table.into_inner()?)
}

/// Role of a flight as spelled in dataset files.
pub fn role(role: Role) -> &'static str {
    match role {
        Role::Fit => "fit",
        Role::HeldOut => "held-out",
    }
}
