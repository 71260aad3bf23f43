//! HTML report of a diagnosis: one self-contained file, and each figure as a separate SVG file.

mod causes;
mod coefficients;
mod draw;
mod limits;
mod page;
mod words;

use crate::certificate::CertificateNote;
use diagnose::Report;

use identify::FlightEvidence;
pub use words::{lack_of_fit as lack_of_fit_sentence, paired as paired_gain_sentence};

/// Contents of the HTML report of a diagnosis.
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisPage<'a> {
    /// Results of the diagnosis.
    pub report: &'a Report,
    /// Flights as predicted by the original model; at most the first twelve are drawn.
    pub before: &'a [FlightEvidence],
    /// Flights as predicted by the extended model; empty if the model was not extended.
    pub after: &'a [FlightEvidence],
    /// Reasons not to rely on the diagnosis; empty if there are none.
    pub reasons_against: &'a [String],
    /// Text of the added effect or of the extended model file, in the model language.
    pub extended: Option<&'a str>,
    /// What the certificate of the model says.
    pub certificate: &'a CertificateNote,
}

/// HTML report of a diagnosis with its figures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// Self-contained HTML page.
    pub html: String,
    /// File name and SVG text of each figure, in the order of the page.
    pub figures: Vec<(String, String)>,
}

/// Draws every figure once and renders the HTML page.
pub fn make(page: &DiagnosisPage<'_>) -> Made {
    let figures = draw::Figures::of(page);
    let html = page::html(page, &figures);
    let files = figures.into_all().into_iter();
    let files = files.map(|drawn| (drawn.figure.name + ".svg", drawn.figure.svg));
    Made {
        html,
        figures: files.collect(),
    }
}
