//! HTML report of a fit: one self-contained file, and each figure as a separate SVG file.

mod coefficients;
pub(crate) mod draw;
mod flights;
mod page;
pub mod tables;
mod text;
pub(crate) mod words;

pub use crate::figure::Figure;
use identify::{Coefficient, Fit, FitReport, FlightEvidence};
use model_spec::model::Model;
pub use text::text;

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

/// Renders the HTML report of a fit as one self-contained page, and returns it with its figures in the order in which
/// they appear on the page.
pub fn html_and_figures(page: &FitPage<'_>) -> (String, Vec<Figure>) {
    let figures = Figures::of(page);
    (page::written(page, &figures), figures.in_order())
}

/// Figures of the report of a fit, grouped by its sections.
struct Figures {
    precision: Option<Figure>,
    predictions: Vec<Figure>,
    profiles: Vec<Figure>,
    tracks: Vec<Figure>,
    residuals: Vec<Figure>,
    states: Vec<Figure>,
    correlations: Option<Figure>,
    whiteness: Vec<Figure>,
    histogram: Option<Figure>,
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
            residuals: draw::residuals(page.evidence, &[], page.report.leading_noise()),
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
        all.chain(self.histogram).collect()
    }
}
