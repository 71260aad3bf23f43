//! Histogram of the RMS residuals of the fitted flights.

use dataset::Role;
use identify::FitReport;
use identify::numbers::{displayed, with_unit};

use super::not_drawn;
use crate::figure::Figure;
use crate::figures::{Bar, Layout, Panel};

/// Minimum number of fitted flights for which the histogram of their residuals is drawn.
const MIN_FLIGHTS: usize = 8;

/// Draws the histogram of the RMS residuals of the fitted flights; `None` for fewer than [`MIN_FLIGHTS`] flights.
pub(in super::super) fn histogram(report: &FitReport) -> Option<Figure> {
    let (scale, unit) = displayed(&report.leading_noise().unit);
    let flights = report.used(Role::Fit);
    let mut rms: Vec<f64> = flights.map(|flight| scale * flight.rms()).collect();
    rms.retain(|v| v.is_finite());
    if rms.len() < MIN_FLIGHTS {
        return None;
    }
    rms.sort_by(f64::total_cmp);
    let low = rms[0];
    // The upper limit is the 98 % quantile, so that a few flights with large residuals do not compress the others
    // into one bar.
    let quantile = rms[(rms.len() - 1) * 98 / 100];
    let high = if quantile > low {
        quantile
    } else {
        low + 1e-3_f64.max(0.01 * low.abs())
    };
    let number = ((rms.len() as f64).sqrt().ceil() as usize).clamp(5, 24);
    let step = (high - low) / number as f64;
    let mut counts = vec![0_usize; number];
    for value in rms.iter().filter(|v| **v <= high) {
        counts[(((value - low) / step) as usize).min(number - 1)] += 1;
    }
    let bars = counts.iter().enumerate().map(|(i, count)| Bar {
        from: low + step * i as f64,
        to: low + step * (i + 1) as f64,
        height: *count as f64,
    });
    let panel = Panel {
        bars: bars.collect(),
        ..Panel::new("Flights", with_unit("RMS residual of a flight", unit))
    };
    let beyond = rms.iter().filter(|v| **v > high).count();
    let more = not_drawn(beyond, "with larger residuals");
    let (title, caption) = (
        "Residuals by flight",
        format!("Number of fitted flights by RMS residual.{more}"),
    );
    Some(Figure::of_panels(
        "rms",
        title,
        caption,
        Layout::SMALL,
        &[panel],
    ))
}
