//! Table of the estimated noise on the fit page.

use identify::FitReport;
use serde::Serialize;

use crate::numbers::{millimetres, plain};

/// Table row of the estimated measurement noise along one axis, or along all axes together, with all values formatted
/// as text.
#[derive(Serialize)]
pub(super) struct Row {
    axis: String,
    sigma: String,
    ar1: String,
    /// Correlation time of the noise, ms: the lag at which the autocorrelation has fallen to 1/e; `–` if the noise is
    /// nearly uncorrelated.
    memory: String,
}

/// Rows of the table of the measurement noise: one for each axis, then one for all axes together.
pub(super) fn rows(report: &FitReport) -> Vec<Row> {
    let noise = report.leading_noise();
    let row = |axis: &str, sigma: f64, ar1: f64| Row {
        axis: axis.to_owned(),
        sigma: millimetres(sigma),
        ar1: plain(ar1, 2),
        memory: memory(ar1, noise.interval_s),
    };
    let axes = noise.axes.iter().take(3);
    let mut rows: Vec<Row> = axes
        .map(|(name, n)| row(name, n.sigma, n.lag1_autocorrelation))
        .collect();
    rows.push(row("all", noise.sigma, noise.lag1_autocorrelation));
    rows
}

fn memory(ar1: f64, interval: f64) -> String {
    let time = -interval / ar1.ln();
    if ar1 > 0.05 && time.is_finite() {
        format!("{} ms", plain(1e3 * time, 1))
    } else {
        "–".to_owned()
    }
}
