//! The page of a fit: one file for a colleague, that loads nothing, and each of its figures by itself.

mod coefficients;
pub(crate) mod draw;
pub(crate) mod flights;
mod noise;
pub(crate) mod numbers;
pub(crate) mod page;
pub(crate) mod thin;
pub(crate) mod words;

use identify::{Coefficient, FitReport, FlightEvidence};
use model_spec::model::Model;

/// What the page is made of.
#[derive(Clone, Copy, Debug)]
pub struct FitPage<'a> {
    /// What was found.
    pub report: &'a FitReport,
    /// The flights that are drawn; the first twelve of them, if there are more.
    pub evidence: &'a [FlightEvidence],
    /// The model that was fitted.
    pub model: &'a Model,
    /// Name of the dataset.
    pub dataset: &'a str,
}

impl FitPage<'_> {
    /// Where the model declares a coefficient or a parameter; what it does not know comes last.
    fn place(&self, name: &str) -> usize {
        let known = self.model.coefficients.iter().chain(&self.model.params);
        known.take_while(|known| known.name != name).count()
    }

    /// What was estimated, in the model's own order.
    fn coefficients(&self) -> Vec<(&str, &Coefficient)> {
        let all = self.report.coefficients.iter();
        let mut all: Vec<(&str, &Coefficient)> = all.map(|(n, c)| (n.as_str(), c)).collect();
        all.sort_by_key(|(name, _)| self.place(name));
        all
    }
}

/// A figure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Name of its file, without `.svg`: letters, digits and hyphens.
    pub name: String,
    /// What it shows.
    pub title: String,
    /// How it is read.
    pub caption: String,
    /// The file.
    pub svg: String,
}

/// The page: one file, that loads nothing.
pub fn html(page: &FitPage<'_>) -> String {
    page::written(page, &Figures::of(page))
}

/// Every figure of the page, in its order.
pub fn figures(page: &FitPage<'_>) -> Vec<Figure> {
    Figures::of(page).in_order()
}

/// The page and every figure of it, drawn once.
pub fn html_and_figures(page: &FitPage<'_>) -> (String, Vec<Figure>) {
    let figures = Figures::of(page);
    (page::written(page, &figures), figures.in_order())
}

/// The figures by their place on the page.
struct Figures {
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
        Figures {
            profiles: draw::profiles(page.report),
            tracks: draw::tracks(page.evidence),
            residuals: draw::residuals(page.evidence, &page.report.noise),
            states: draw::states(page.evidence, page.model),
            correlations: draw::correlations(page),
            whiteness: draw::whiteness(page.report),
            histogram: draw::histogram(page.report),
        }
    }

    /// All of them, in the order of the page.
    fn in_order(self) -> Vec<Figure> {
        let all = [
            self.profiles,
            self.tracks,
            self.residuals,
            self.states,
            self.correlations.into_iter().collect(),
            self.whiteness,
            self.histogram.into_iter().collect(),
        ];
        all.into_iter().flatten().map(|d| d.figure).collect()
    }
}

/// A figure, and the same for a narrow screen where it is too wide for one.
pub(crate) struct Drawn {
    pub(crate) figure: Figure,
    pub(crate) narrow: Option<String>,
}

impl Drawn {
    pub(crate) fn new(name: String, title: String, caption: String, svg: String) -> Drawn {
        let figure = Figure {
            name,
            title,
            caption,
            svg,
        };
        Drawn {
            figure,
            narrow: None,
        }
    }
}
