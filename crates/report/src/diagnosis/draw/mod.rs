//! Figures of the diagnosis report, one kind of figure per file.

mod channels;
mod curves;
mod flights;
mod gain;
mod score_correlations;
mod score_tests;

pub(super) use curves::unmoved;
pub(super) use score_tests::chart as chart_of_tests;

use super::DiagnosisPage;
use crate::figure::Figure;
use crate::fit::draw::{predictions, residuals};

/// Figures of the diagnosis report, grouped by its sections.
pub(super) struct Figures {
    pub(super) finding: Option<Figure>,
    pub(super) gain: Option<Figure>,
    pub(super) score_tests: Option<Figure>,
    pub(super) score_correlations: Option<Figure>,
    pub(super) predictions: Vec<Figure>,
    pub(super) residuals: Vec<Figure>,
    pub(super) curves: Vec<Figure>,
    pub(super) flights: Option<Figure>,
    pub(super) channels: Vec<Figure>,
}

impl Figures {
    pub(super) fn of(page: &DiagnosisPage<'_>, finding: Option<Figure>) -> Figures {
        Figures {
            finding,
            gain: gain::gain(page.report),
            score_tests: score_tests::score_tests(page.report),
            score_correlations: score_correlations::score_correlations(page.report),
            predictions: held_out(page),
            residuals: residuals(page.before, page.after, page.report.leading_noise()),
            curves: curves::curves(page.report),
            flights: flights::flights(page.report),
            channels: channels::channels(page.report),
        }
    }

    /// Figure of a load that the model lacks, for the opening of a page that has no figure of the finding.
    pub(super) fn opening_channel(&self) -> impl Iterator<Item = &Figure> {
        self.channels
            .iter()
            .take(usize::from(self.finding.is_none()))
    }

    /// Returns all figures in the order in which they appear in the report.
    pub(super) fn in_order(self) -> Vec<Figure> {
        let first = [self.finding, self.gain, self.score_tests]
            .into_iter()
            .flatten();
        let first = first.chain(self.predictions).chain(self.residuals);
        let all = first.chain(self.curves).chain(self.score_correlations);
        let all = all.chain(self.flights).chain(self.channels);
        all.collect()
    }
}

/// Draws the predictions of the held-out flights by the model with the effects that the diagnosis added, or by the
/// model under test if none were added. Empty if the fits are not available.
fn held_out(page: &DiagnosisPage<'_>) -> Vec<Figure> {
    let Some(fits) = &page.fits else {
        return Vec::new();
    };
    match fits.after {
        Some(after) => predictions(after, page.after, page.before),
        None => predictions(fits.before, page.before, &[]),
    }
}
