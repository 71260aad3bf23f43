//! Opening section of the page: the main finding in sentences, one figure, and the recommended next step.

mod curve;
mod draw;
mod words;

use diagnose::Verdict;

use super::DiagnosisPage;
use crate::figure::Figure;

/// Sentences of the opening section of the diagnosis report.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finding {
    /// Sentences that state which effect the model lacks, and the size of the effect.
    pub(super) what: String,
    /// Sentences that state how certain it is that the model lacks the effect named in `what`.
    pub(super) sure: String,
    /// Sentences that recommend the next step to the user.
    pub(super) next: String,
}

/// Writes the opening section of the diagnosis report and draws its figure; the figure is `None` if there is nothing to
/// draw.
pub(super) fn finding(page: &DiagnosisPage<'_>) -> (Finding, Option<Figure>) {
    let report = page.report;
    let effects = || {
        let first = report.explanations.first();
        first
            .into_iter()
            .flat_map(|explanation| &explanation.effects)
    };
    let is_drawable = report.verdict != Verdict::Adequate;
    let fits = page.fits.as_ref().filter(|_| is_drawable);
    let curve = fits.and_then(|fits| curve::of(fits, effects().map(|e| e.name.as_str())));
    let has_channel = report
        .unattributed
        .as_ref()
        .is_some_and(|found| !found.channels.is_empty());
    let figure = match (&curve, report.verdict) {
        (_, Verdict::Negligible) => draw::estimates(report),
        (Some(curve), _) => Some(draw::curve(curve)),
        (None, Verdict::Adequate | Verdict::Unattributed) => None,
        (None, _) => draw::estimates(report),
    };
    // The load that is missing is drawn instead.
    let is_drawn = report.verdict == Verdict::Unattributed && has_channel;
    let figure = figure.or_else(|| draw::strongest(report).filter(|_| !is_drawn));
    let finding = Finding {
        what: words::what(report, curve.as_ref()),
        sure: words::sure(report),
        next: words::next(page),
    };
    (finding, figure)
}
