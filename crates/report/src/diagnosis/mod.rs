//! The page of a diagnosis: one file that loads nothing, and each of its figures by itself.

mod causes;
mod coefficients;
mod draw;
mod limits;
mod page;
mod words;

use diagnose::Report;
use identify::FlightEvidence;

/// What the page is made of.
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisPage<'a> {
    /// What was found.
    pub report: &'a Report,
    /// The flights as the model has them; the first twelve are drawn.
    pub before: &'a [FlightEvidence],
    /// The same flights as the extended model has them; empty where nothing was extended.
    pub after: &'a [FlightEvidence],
    /// Text of the effect, or of the file, that extends the model.
    pub extended: Option<&'a str>,
}

/// The page and its figures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// The page.
    pub html: String,
    /// Name of each figure's file and its text, in the order of the page.
    pub figures: Vec<(String, String)>,
}

/// Draws every figure once, and writes the page about them.
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
