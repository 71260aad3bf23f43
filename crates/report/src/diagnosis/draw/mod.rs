//! Figures of the diagnosis report, one kind of figure per file.

mod channels;
mod curves;
mod flights;
mod gain;
mod residuals;
mod score_correlations;
mod score_tests;

pub(super) use curves::unmoved;

use super::DiagnosisPage;
use crate::figures::chart::Chart;
use crate::figures::csv::of_panels;
use crate::figures::{Layout, Panel, figure_of};
use crate::fit::draw::predictions;
use crate::fit::{Drawn, Figure};

/// Style sheet of the diagnosis figures; supplements the common style sheet of figures.
pub(super) const STYLE: &str = r"rect.bar.explanation { fill: #0072b2 } rect.bar.alarm { fill: #d9813f } rect.bar.calm { fill: #b4b9c0 }
circle.before { fill: #fff; stroke: #d55e00; stroke-width: 2 } circle.after { fill: #0072b2 } line.join { stroke: #9aa0a8; stroke-width: 2 }
line.reach { stroke: #0072b2; stroke-width: 2 } text.strong { font-weight: 600; fill: #0060a0 } text.weak { fill: #777 }
rect.alike { fill: #00437c } rect.unknown { fill: #c9b9b9 }
path.history { stroke: #0072b2; stroke-width: 1.4 } path.dots-after { stroke: #0072b2; stroke-width: 3; stroke-linecap: round }
";

/// Figures of the diagnosis report, grouped by its sections.
pub(super) struct Figures {
    pub(super) finding: Option<Drawn>,
    pub(super) gain: Option<Drawn>,
    pub(super) score_tests: Option<Drawn>,
    pub(super) score_correlations: Option<Drawn>,
    pub(super) predictions: Vec<Drawn>,
    pub(super) residuals: Vec<Drawn>,
    pub(super) curves: Vec<Drawn>,
    pub(super) flights: Option<Drawn>,
    pub(super) channels: Vec<Drawn>,
}

impl Figures {
    pub(super) fn of(page: &DiagnosisPage<'_>, finding: Option<Drawn>) -> Figures {
        Figures {
            finding,
            gain: gain::gain(page.report),
            score_tests: score_tests::score_tests(page.report),
            score_correlations: score_correlations::score_correlations(page.report),
            predictions: held_out(page),
            residuals: residuals::residuals(page),
            curves: curves::curves(page.report),
            flights: flights::flights(page.report),
            channels: channels::channels(page.report),
        }
    }

    /// Returns all figures in the order in which they appear in the report.
    pub(super) fn in_order(self) -> Vec<Figure> {
        let first = [self.finding, self.gain, self.score_tests]
            .into_iter()
            .flatten();
        let first = first.chain(self.predictions).chain(self.residuals);
        let all = first.chain(self.curves).chain(self.score_correlations);
        let all = all.chain(self.flights).chain(self.channels);
        all.map(|drawn| drawn.figure).collect()
    }
}

/// Draws the predictions of the held-out flights by the model with the effects that the diagnosis added, or by the
/// model under test if none were added. Empty if the fits are not available.
fn held_out(page: &DiagnosisPage<'_>) -> Vec<Drawn> {
    let Some(fits) = &page.fits else {
        return Vec::new();
    };
    let drawn = match fits.after {
        Some(after) => predictions(after, page.after, page.before),
        None => predictions(fits.before, page.before, &[]),
    };
    let described = drawn.into_iter().map(|mut drawn| {
        drawn.figure.svg = described(&drawn.figure.svg, &drawn.figure.caption);
        drawn
    });
    described.collect()
}

/// Creates a figure from its caption and CSV table (`texts`) by calling `draw` for the layout `wide` and for narrow
/// screens. The caption also becomes the description for screen readers.
pub(super) fn drawn(
    name: &str,
    title: &str,
    texts: [String; 2],
    wide: Layout,
    draw: impl Fn(Layout) -> String,
) -> Drawn {
    let caption = texts[0].clone();
    Drawn::in_layouts(name, title, texts, wide, &|layout| {
        described(&draw(layout), &caption)
    })
}

/// Creates a figure of panels; the caption also becomes the description for screen readers.
pub(super) fn drawn_panels(
    name: &str,
    title: &str,
    caption: &str,
    wide: Layout,
    panels: &[Panel],
) -> Drawn {
    let texts = [caption.to_owned(), of_panels(panels)];
    drawn(name, title, texts, wide, |l| figure_of(l, title, panels))
}

/// Creates a figure of a chart, drawn in the layout `wide` for pages and in a narrow one for phones; `name` is its file
/// name without extension. The caption also becomes the description for screen readers.
pub(super) fn drawn_chart(name: &str, chart: &Chart, caption: &str, wide: Layout) -> Drawn {
    let texts = [caption.to_owned(), chart.csv()];
    drawn(name, &chart.title, texts, wide, |l| chart.draw(l))
}

/// Adds a text description for screen readers and the style sheet of the diagnosis figures to an SVG.
fn described(svg: &str, words: &str) -> String {
    let words = crate::figures::svg::escape(words);
    let more = format!("</title>\n<desc>{words}</desc>\n<style>\n{STYLE}</style>\n");
    svg.replacen("</title>\n", &more, 1)
}
