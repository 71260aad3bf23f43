//! HTML report of a fit: one self-contained file, and each figure as a separate SVG file.

mod coefficients;
pub(crate) mod draw;
mod flights;
mod page;
mod summaries;
pub mod tables;
mod text;
pub(crate) mod words;

pub use crate::figure::Figure;
use identify::{Coefficient, Fit, FitReport, FlightEvidence};
use model_spec::model::Model;
pub use page::page;
pub use summaries::csv as summaries_csv;
pub use text::text;

/// Input of the report of a fit.
#[derive(Clone, Copy)]
pub struct FitPage<'a> {
    /// Report of the fit.
    pub report: &'a FitReport,
    /// The fit, for figures of predictions; `None` omits them.
    pub fit: Option<&'a Fit>,
    /// Measurements and predictions of the flights; the first twelve are drawn.
    pub evidence: &'a [FlightEvidence],
    /// The fitted model.
    pub model: &'a Model,
    /// Name of the dataset.
    pub dataset: &'a str,
}

impl FitPage<'_> {
    /// Position of a coefficient or parameter in the model; a name that it does not declare is last.
    fn place(&self, name: &str) -> usize {
        let known = self.model.coefficients.iter().chain(&self.model.params);
        known.take_while(|known| known.name != name).count()
    }

    /// Names and estimates of all coefficients, fixed ones too, in the order of the model.
    fn coefficients(&self) -> Vec<(&str, &Coefficient)> {
        let all = self.report.coefficients.iter();
        let mut all: Vec<_> = all.map(|(n, c)| (n.as_str(), c)).collect();
        all.sort_by_key(|(name, _): &(&str, _)| self.place(name));
        all
    }
}
