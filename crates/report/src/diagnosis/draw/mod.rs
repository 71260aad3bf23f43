//! Figures of the diagnosis report.

mod channels;
mod curves;
mod gain;
mod scores;

pub(super) use channels::channels;
pub(super) use curves::{curves, unmoved};
pub(super) use gain::{flights, gain};
pub(super) use scores::{chart as chart_of_tests, score_correlations, score_tests};

use super::DiagnosisPage;
use crate::figure::Figure;
use crate::fit::draw::predictions;

/// Predictions of the held-out flights by the extended model, or by the model under test if there is none.
pub(super) fn held_out(page: &DiagnosisPage<'_>) -> Vec<Figure> {
    let Some(fits) = &page.fits else {
        return Vec::new();
    };
    match fits.after {
        Some(after) => predictions(after, page.after, page.before),
        None => predictions(fits.before, page.before, &[]),
    }
}
