//! HTML report of a fit: one self-contained file, and each figure as a separate SVG file.

mod coefficients;
pub(crate) mod draw;
pub(crate) mod flights;
mod noise;
pub(crate) mod page;
pub(crate) mod words;

use crate::figures::csv::of_panels;
use crate::figures::{Layout, Panel, figure_of};
use identify::{Coefficient, Fit, FitReport, FlightEvidence};
use model_spec::model::Model;

/// Input of the HTML report of a fit.
#[derive(Clone, Copy)]
pub struct FitPage<'a> {
    /// Report of the fit, as written to `report.json`: estimates, noise and flights.
    pub report: &'a FitReport,
    /// The fit, from which confidence bands of predictions are computed; `None` omits the figures of predictions.
    pub fit: Option<&'a Fit>,
    /// Measurements and predictions of the flights; at most the first twelve are drawn.
    pub evidence: &'a [FlightEvidence],
    /// The fitted model.
    pub model: &'a Model,
    /// Name of the dataset to which the model was fitted.
    pub dataset: &'a str,
}

impl FitPage<'_> {
    /// Position of the coefficient or parameter `name` in the order of declaration in the model; for a name that the
    /// model does not declare, the total number of coefficients and parameters, so that it is sorted last.
    fn place(&self, name: &str) -> usize {
        let known = self.model.coefficients.iter().chain(&self.model.params);
        known.take_while(|known| known.name != name).count()
    }

    /// Names and estimates of all coefficients of the fit, including fixed ones, in the order of declaration in the
    /// model.
    fn coefficients(&self) -> Vec<(&str, &Coefficient)> {
        let all = self.report.coefficients.iter();
        let mut all: Vec<(&str, &Coefficient)> = all.map(|(n, c)| (n.as_str(), c)).collect();
        all.sort_by_key(|(name, _)| self.place(name));
        all
    }
}

/// Figure of a report, written as an SVG file and as a CSV table of its data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// File name without `.svg`; consists of letters, digits and hyphens.
    pub name: String,
    /// Title of the figure.
    pub title: String,
    /// Caption, which explains how to read the figure.
    pub caption: String,
    /// SVG text of the figure.
    pub svg: String,
    /// CSV table of the data shown in the figure.
    pub csv: String,
}

/// Renders the HTML report of a fit as one self-contained page, and returns it with its figures in the order in which
/// they appear on the page.
pub fn html_and_figures(page: &FitPage<'_>) -> (String, Vec<Figure>) {
    let figures = Figures::of(page);
    (page::written(page, &figures), figures.in_order())
}

/// Figures of the report of a fit, grouped by its sections.
struct Figures {
    precision: Option<Drawn>,
    predictions: Vec<Drawn>,
    profiles: Vec<Drawn>,
    tracks: Vec<Drawn>,
    residuals: Vec<Drawn>,
    states: Vec<Drawn>,
    correlations: Option<Drawn>,
    whiteness: Vec<Drawn>,
    histogram: Option<Drawn>,
}

impl Figures {
    fn of(page: &FitPage<'_>) -> Figures {
        let predictions = page
            .fit
            .map(|fit| draw::predictions(fit, page.evidence, &[]));
        Figures {
            precision: draw::precision(page),
            predictions: predictions.unwrap_or_default(),
            profiles: draw::profiles(page.report),
            tracks: draw::tracks(page.evidence),
            residuals: draw::residuals(page.evidence, page.report.leading_noise()),
            states: draw::states(page.evidence, page.model),
            correlations: draw::correlations(page),
            whiteness: draw::whiteness(page.report),
            histogram: draw::histogram(page.report),
        }
    }

    /// Returns all figures in the order in which they appear in the report.
    fn in_order(self) -> Vec<Figure> {
        let all = self.precision.into_iter().chain(self.predictions);
        let all = all.chain(self.profiles).chain(self.tracks);
        let all = all.chain(self.residuals).chain(self.states);
        let all = all.chain(self.correlations).chain(self.whiteness);
        all.chain(self.histogram).map(|d| d.figure).collect()
    }
}

/// A figure, with a second SVG version for narrow screens (`None` if the first version fits narrow screens).
pub(crate) struct Drawn {
    pub(crate) figure: Figure,
    pub(crate) narrow: Option<String>,
}

impl Drawn {
    /// Creates a figure, without a version for narrow screens, from its name, its title and the texts of its caption,
    /// SVG and CSV table.
    pub(crate) fn new(name: String, title: String, [caption, svg, csv]: [String; 3]) -> Drawn {
        let figure = Figure {
            name,
            title,
            caption,
            svg,
            csv,
        };
        Drawn {
            figure,
            narrow: None,
        }
    }

    /// Creates a figure from its caption and CSV table (`texts`) by calling `draw` for the layout `wide` and, if that
    /// is not the small layout, also for the small one, for narrow screens.
    pub(crate) fn in_layouts(
        name: impl Into<String>,
        title: &str,
        [caption, csv]: [String; 2],
        wide: Layout,
        draw: &dyn Fn(Layout) -> String,
    ) -> Drawn {
        let drawn = Drawn::new(name.into(), title.to_owned(), [caption, draw(wide), csv]);
        Drawn {
            narrow: (wide != Layout::SMALL).then(|| draw(Layout::SMALL)),
            ..drawn
        }
    }

    /// Creates a figure of panels, with their data as CSV table, for the layout `wide` and, if that is not the small
    /// layout, also for narrow screens.
    pub(crate) fn of_panels(
        name: impl Into<String>,
        title: &str,
        caption: String,
        wide: Layout,
        panels: &[Panel],
    ) -> Drawn {
        Drawn::in_layouts(name, title, [caption, of_panels(panels)], wide, &|layout| {
            figure_of(layout, title, panels)
        })
    }
}
