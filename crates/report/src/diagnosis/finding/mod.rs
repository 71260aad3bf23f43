//! Opening section of the page: the main finding in sentences, one figure, and the recommended next step.

mod curve;
mod draw;
mod words;

use diagnose::Verdict;

use super::DiagnosisPage;
use crate::figure::Figure;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finding {
    /// Which effect the model lacks, and its size.
    pub(super) what: String,
    /// How certain that is.
    pub(super) sure: String,
    /// What to do next.
    pub(super) next: String,
}

pub(super) fn finding(page: &DiagnosisPage<'_>) -> (Finding, Option<Figure>) {
    let report = page.report;
    let effects = || report.explanations.iter().take(1).flat_map(|e| &e.effects);
    let is_drawable = report.verdict != Verdict::Adequate;
    let fits = page.fits.as_ref().filter(|_| is_drawable);
    let curve = fits.and_then(|fits| curve::of(fits, effects().map(|e| e.name.as_str())));
    let channels = report.unattributed.as_ref().map(|found| &found.channels);
    let has_channel = channels.is_some_and(|channels| !channels.is_empty());
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
