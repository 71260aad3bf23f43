//! Figures of the residual diagnostics: autocorrelation and normal Q–Q plot.

use identify::{AxisResiduals, FitReport};

use crate::figure::Figure;
use crate::figures::{Layout, Look, Panel};
use crate::thin::{MAX_CURVE_POINTS, stride};

/// Draws the autocorrelation and the normal Q–Q plot of the residuals, one figure for each axis.
pub(in super::super) fn whiteness(report: &FitReport) -> Vec<Figure> {
    let axes = report.residuals.iter().take(3).enumerate();
    let figures = axes.filter_map(|(i, (axis, found))| figure(i, axis, found));
    figures.collect()
}

fn figure(index: usize, axis: &str, found: &AxisResiduals) -> Option<Figure> {
    // The autocorrelation at lag 0 is 1 by definition and is omitted.
    let lags = |values: &[f64]| {
        let values = values.iter().enumerate().skip(1).take(MAX_CURVE_POINTS);
        values.map(|(lag, v)| (lag as f64, *v)).collect::<Vec<_>>()
    };
    let (raw, white) = (
        lags(&found.autocorrelation),
        lags(&found.whitened_autocorrelation),
    );
    let mut panels = Vec::new();
    if !raw.is_empty() || !white.is_empty() {
        // The dashed line is drawn over the solid one, so that both are visible if they coincide.
        let panel = Panel::new("Autocorrelation", "lag, samples")
            .dots(Look::Colour(0), raw.clone())
            .dots(Look::Colour(1), white.clone())
            .line("raw", raw)
            .line("white", white);
        panels.push(Panel {
            band: Some((-found.band, found.band)).filter(|_| found.band.is_finite()),
            ..panel
        });
    }
    let quantiles: Vec<(f64, f64)> = found.quantiles.iter().map(|q| (q[0], q[1])).collect();
    if !quantiles.is_empty() {
        panels.push(Panel {
            map: true,
            diagonal: true,
            ..Panel::new("Normal Q–Q: sample quantiles", "theoretical quantiles")
                .dots(Look::Colour(0), stride(&quantiles, MAX_CURVE_POINTS))
        });
    }
    let name = format!("noise-{}", index + 1);
    let title = format!("Residuals along {axis}");
    let caption = "Above: autocorrelation of the residuals, as they are and whitened by the noise model; the whitened one should be \
                   within the shaded 95 % band. Below: normal Q–Q plot; the points should be on the line.";
    let draw = || Figure::of_panels(name, &title, caption, Layout::SMALL, &panels);
    (!panels.is_empty()).then(draw)
}
