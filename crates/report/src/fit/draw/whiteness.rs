//! Figures of the residual diagnostics: autocorrelation and normal Q–Q plot.

use identify::{AxisResiduals, FitReport};

use crate::figure::Figure;
use crate::figures::{Dots, Layout, Line, Look, Panel};
use crate::thin::{MAX_CURVE_POINTS, stride};

/// Draws the autocorrelation and the normal Q–Q plot of the residuals, one figure for each axis.
pub(in super::super) fn whiteness(report: &FitReport) -> Vec<Figure> {
    let axes = report.residuals.iter().take(3).enumerate();
    let figures = axes.filter_map(|(i, (axis, found))| figure(i, axis, found));
    figures.collect()
}

fn figure(index: usize, axis: &str, found: &AxisResiduals) -> Option<Figure> {
    let mut panels = Vec::new();
    // The autocorrelation at lag 0 is 1 by definition and is omitted.
    let lags = |values: &[f64]| {
        let values = values.iter().enumerate().skip(1).take(MAX_CURVE_POINTS);
        values.map(|(lag, v)| (lag as f64, *v)).collect::<Vec<_>>()
    };
    // The dashed line is drawn over the solid one, so that both are visible if they coincide.
    let lines = [
        ("raw", lags(&found.autocorrelation)),
        ("white", lags(&found.whitened_autocorrelation)),
    ];
    if lines.iter().any(|(_, points)| !points.is_empty()) {
        let dots = lines.iter().enumerate().map(|(i, (_, points))| Dots {
            look: Look::Colour(i),
            points: points.clone(),
        });
        let lines = lines.iter().map(|(name, points)| Line {
            name: (*name).into(),
            points: points.clone(),
        });
        panels.push(Panel {
            title: "Autocorrelation".into(),
            across: "lag, samples".into(),
            dots: dots.collect(),
            lines: lines.collect(),
            band: Some((-found.band, found.band)).filter(|_| found.band.is_finite()),
            ..Panel::default()
        });
    }
    let quantiles: Vec<(f64, f64)> = found.quantiles.iter().map(|q| (q[0], q[1])).collect();
    if !quantiles.is_empty() {
        panels.push(Panel {
            title: "Normal Q–Q: sample quantiles".into(),
            across: "theoretical quantiles".into(),
            dots: vec![Dots {
                look: Look::Colour(0),
                points: stride(&quantiles, MAX_CURVE_POINTS),
            }],
            map: true,
            diagonal: true,
            ..Panel::default()
        });
    }
    if panels.is_empty() {
        return None;
    }
    Some(Figure::of_panels(
        format!("noise-{}", index + 1),
        &format!("Residuals along {axis}"),
        "Above: autocorrelation of the residuals, as they are and whitened by the noise model; the whitened one should be \
         within the shaded 95 % band. Below: normal Q–Q plot; the points should be on the line.",
        Layout::SMALL,
        &panels,
    ))
}
