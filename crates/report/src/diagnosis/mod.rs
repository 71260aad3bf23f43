//! HTML report of a diagnosis: one self-contained file, and each figure as a separate SVG file.

mod draw;
mod evidence;
mod explanations;
mod finding;
mod page;
pub mod tables;
mod text;
mod words;

use diagnose::Report;

use identify::{Fit, FlightEvidence};

pub use page::page;
pub use text::text;

/// Number of figures of missing loads, and of coefficient curves, that are open.
const OPEN: usize = 6;

/// Input of the report of a diagnosis.
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisPage<'a> {
    /// Report of the diagnosis.
    pub report: &'a Report,
    /// Flights with predictions of the model under test; the first twelve are drawn.
    pub before: &'a [FlightEvidence],
    /// Flights with the predictions of the extended model; empty without one.
    pub after: &'a [FlightEvidence],
    /// Fits, for curves and confidence bands; `None` omits these figures.
    pub fits: Option<Fits<'a>>,
    /// Text of the added effect, or of the extended model.
    pub extended: Option<&'a str>,
}

/// Fits of the model under test and of the extended model.
#[derive(Clone, Copy)]
pub struct Fits<'a> {
    /// Fit of the model under test.
    pub before: &'a Fit,
    /// Fit of the extended model, if there is one.
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
