//! Figures of the residuals of all flights, plotted one flight after the other, for the model under test and the
//! extended model.

use identify::FlightEvidence;

use super::super::DiagnosisPage;
use crate::figure::Figure;
use crate::figures::csv::of_panels;
use crate::figures::{Dots, Layout, Look, Panel};
use crate::fit::draw::residuals::{FlightsOfRole, flights_of, panel, residual_figure};

/// Maximum number of dots of each series of residuals in the version of a figure for narrow screens.
const NARROW_DOTS: usize = 400;

/// Draws one figure for the residuals of the fitted flights and one for those of the held-out flights: grey for the
/// model under test, blue for the extended model. If the model was not extended, the colours distinguish the markers
/// instead. A figure without flights is omitted.
pub(super) fn residuals(page: &DiagnosisPage<'_>) -> Vec<Figure> {
    let sigma = page.report.leading_noise().sigma;
    let figure = |before: FlightsOfRole<'_>| {
        let after = flights_of(page.after, before.role());
        let axes = ["x", "y", "z"].into_iter().enumerate();
        let panels = axes.map(|(i, axis)| both(&before.flights, &after, i, axis, sigma));
        let panels: Vec<Panel> = panels.collect();
        let colours = if after.is_empty() {
            "one colour per marker"
        } else {
            "grey for the model, blue for the extended model"
        };
        let caption = format!(
            "Residuals (measured − predicted), one flight after the other, {colours}; shaded: ±2 standard deviations of \
             the noise; crosses: outliers.{}",
            before.notes
        );
        let texts = [caption, of_panels(&panels)];
        Figure::in_layouts(before.name, before.title, texts, Layout::WIDE, &|layout| {
            residual_figure(layout, before.title, &panels, NARROW_DOTS)
        })
    };
    FlightsOfRole::all(page.before).map(figure).collect()
}

/// Panel of the residuals along one axis, with index `axis` and name `name`: those of the model under test (`before`)
/// in grey, with those of the extended model (`after`) drawn on top. `sigma` is the standard deviation of the noise, m.
fn both(
    before: &[&FlightEvidence],
    after: &[&FlightEvidence],
    axis: usize,
    name: &str,
    sigma: f64,
) -> Panel {
    let mut first = panel(before, axis, name, sigma);
    if after.is_empty() {
        return first;
    }
    let second = panel(after, axis, name, sigma);
    let points = |panel: &Panel| -> Vec<(f64, f64)> {
        let seen = panel.dots.iter().filter(|d| d.look != Look::Cross);
        seen.flat_map(|d| d.points.iter().copied()).collect()
    };
    let dots = |look, points| Dots { look, points };
    let crosses = second
        .dots
        .iter()
        .filter(|d| d.look == Look::Cross)
        .cloned();
    first.dots = [
        dots(Look::Pale, points(&first)),
        dots(Look::Colour(0), points(&second)),
    ]
    .into_iter()
    .chain(crosses)
    .collect();
    let reach = |panel: &Panel| panel.up.map_or(0.0, |(_, high)| high);
    let reach = reach(&first).max(reach(&second));
    first.up = Some((-reach, reach));
    first
}
