//! HTML report of a diagnosis: one self-contained file, and each figure as a separate SVG file.

mod coefficients;
mod draw;
mod evidence;
mod explanations;
mod finding;
mod limits;
mod page;
pub mod tables;
mod text;
mod words;

use crate::figure::Figure;
use diagnose::Report;

use identify::{Fit, FlightEvidence};

pub use text::text;

/// Maximum number of figures of missing loads, and of coefficient curves, that are expanded when the page is opened.
const OPEN: usize = 6;

/// Input of the HTML report of a diagnosis.
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisPage<'a> {
    /// Report of the diagnosis, as written to `report.json`: verdict, tests and estimates.
    pub report: &'a Report,
    /// Measured flights with predictions of the model under test; at most the first twelve are drawn.
    pub before: &'a [FlightEvidence],
    /// Measured flights with the predictions of the extended model, to be drawn; empty if the model was not extended.
    pub after: &'a [FlightEvidence],
    /// Fits of the model under test and of the extended model, from which curves and confidence bands are computed;
    /// `None` omits these figures.
    pub fits: Option<Fits<'a>>,
    /// Text of the effect that the diagnosis added, or of the extended model file, in the model language; `None` if the
    /// model was not extended.
    pub extended: Option<&'a str>,
}

/// Fits of the model under test and of the extended model.
#[derive(Clone, Copy)]
pub struct Fits<'a> {
    /// Fit of the model under test.
    pub before: &'a Fit,
    /// Fit of the extended model; `None` if the model was not extended.
    pub after: Option<&'a Fit>,
}

impl std::fmt::Debug for Fits<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let model = |fit: &Fit| fit.report.model.clone();
        let mut shown = f.debug_struct("Fits");
        shown.field("before", &model(self.before));
        shown.field("after", &self.after.map(model)).finish()
    }
}

/// Renders the HTML report of a diagnosis as one self-contained page, and returns it with its figures in the order in
/// which they appear on the page.
pub fn html_and_figures(page: &DiagnosisPage<'_>) -> (String, Vec<Figure>) {
    let (finding, figure) = finding::finding(page);
    let figures = draw::Figures::of(page, figure);
    (page::html(page, &finding, &figures), figures.in_order())
}
