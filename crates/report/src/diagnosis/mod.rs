//! HTML report of a diagnosis: one self-contained file, and each figure as a separate SVG file.

mod causes;
mod coefficients;
mod draw;
mod finding;
mod limits;
mod page;
mod words;

use crate::certificate::CertificateNote;
use diagnose::Report;

use identify::{Fit, FlightEvidence};

pub use words::{lack_of_fit as lack_of_fit_sentence, paired as paired_gain_sentence};

/// Input of the HTML report of a diagnosis.
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisPage<'a> {
    /// Report of the diagnosis.
    pub report: &'a Report,
    /// Measured flights with predictions of the model under test; at most the first twelve are drawn.
    pub before: &'a [FlightEvidence],
    /// Measured flights with the predictions of the extended model, to be drawn; empty if the model was not extended.
    pub after: &'a [FlightEvidence],
    /// Fits of both models, from which curves and confidence bands are computed; `None` omits these figures.
    pub fits: Option<Fits<'a>>,
    /// Reasons not to rely on the diagnosis; empty if there are none.
    pub reasons_against: &'a [String],
    /// Text of the added effect or of the extended model file, in the model language; `None` if the model was not
    /// extended.
    pub extended: Option<&'a str>,
    /// Verification status of the model according to its certificate.
    pub certificate: &'a CertificateNote,
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

/// HTML report of a diagnosis, with the SVG and CSV text of its figures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// Self-contained HTML page.
    pub html: String,
    /// File name and SVG text of each figure, in the order in which the figures appear on the page.
    pub figures: Vec<(String, String)>,
    /// File name and CSV text of the data of each figure, in the same order as `figures`.
    pub tables: Vec<(String, String)>,
}

/// Draws all figures and renders the HTML page.
pub fn make(page: &DiagnosisPage<'_>) -> Made {
    let (finding, figure) = finding::finding(page);
    let figures = draw::Figures::of(page, figure);
    let html = page::html(page, &finding, &figures);
    let (mut svg, mut csv) = (Vec::new(), Vec::new());
    for drawn in figures.into_all() {
        let figure = drawn.figure;
        csv.push((format!("{}.csv", figure.name), figure.csv));
        svg.push((figure.name + ".svg", figure.svg));
    }
    Made {
        html,
        figures: svg,
        tables: csv,
    }
}
