//! Figures of the residuals of all flights, plotted one flight after the other, for the model under test and the
//! extended model.

use identify::FlightEvidence;
use identify::dataset::Role;

use super::super::DiagnosisPage;
use super::drawn;
use crate::figures::csv::of_panels;
use crate::figures::{Dots, Layout, Look, Panel, figure_of};
use crate::fit::Drawn;
use crate::fit::draw::MOST_FLIGHTS;
use crate::fit::draw::residuals::panel;
use crate::fit::thin::stride;

/// Maximum number of dots of each series on a narrow screen.
const NARROW_DOTS: usize = 400;

/// Draws one figure for the residuals of the fitted flights and one for the held-out flights; no figure for a role
/// without flights.
pub(super) fn residuals(page: &DiagnosisPage<'_>) -> Vec<Drawn> {
    let kinds = [
        (
            Role::Fit,
            "residuals",
            "Residuals of the fitted flights",
            "",
        ),
        (
            Role::HeldOut,
            "residuals-held-out",
            "Residuals of the held-out flights",
            " The first 30\u{a0}% of each were used for its initial state; the rest is a prediction.",
        ),
    ];
    let figures = kinds.into_iter().filter_map(|(role, name, title, meaning)| {
        let before = of(page.before, role);
        let after = of(page.after, role);
        if before.is_empty() {
            return None;
        }
        let sigma = page.report.noise.sigma_m;
        let axes = ["x", "y", "z"].iter().enumerate();
        let panels = axes.map(|(i, axis)| both(&before, &after, i, axis, sigma));
        let panels: Vec<Panel> = panels.collect();
        let files = before.iter().enumerate();
        let files: Vec<String> = files.map(|(i, f)| format!("{} {}", i + 1, f.file)).collect();
        let colours = if after.is_empty() {
            "one colour per marker"
        } else {
            "grey for the model, blue for the extended model"
        };
        let caption = format!(
            "Residuals (measured − predicted), one flight after the other, {colours}; shaded: ±2 standard deviations of \
             the noise; crosses: outliers.{meaning} Flights: {}.",
            files.join(", ")
        );
        let texts = [caption, of_panels(&panels)];
        Some(drawn(name, title, texts, Layout::WIDE, |layout| {
            if layout == Layout::WIDE {
                return figure_of(layout, title, &panels);
            }
            let mut fewer = panels.clone();
            let dots = fewer.iter_mut().flat_map(|panel| &mut panel.dots);
            dots.for_each(|dots| dots.points = stride(&dots.points, NARROW_DOTS));
            figure_of(layout, title, &fewer)
        }))
    });
    figures.collect()
}

/// Flights with the given role, among the first `MOST_FLIGHTS` flights; the figures show no others.
fn of(evidence: &[FlightEvidence], role: Role) -> Vec<&FlightEvidence> {
    let drawn = evidence.iter().take(MOST_FLIGHTS);
    drawn.filter(|f| f.role == role).collect()
}

/// Panel of one axis, with index `axis` and name `name`: residuals of the model under test (`before`) in grey, with
/// residuals of the extended model (`after`) drawn on top. `sigma` is the standard deviation of the noise, m.
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
