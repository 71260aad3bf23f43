//! Assessment whether a diagnosis is reliable, with the reasons if it is not.

use identify::{Fit, convergence_caution, exclusion_caution};

use super::types::{Report, Verified};

impl Report {
    /// Records the result of verifying the extended model, `verified`, and assesses whether the diagnosis is reliable.
    /// Large residuals of the model under test do not count against it, because the diagnosis searches for their cause.
    pub(crate) fn assess(&mut self, before: &Fit, after: Option<&Fit>, verified: Option<Verified>) {
        let (fit, name) = match after {
            Some(fit) => (fit, "the fit of the extended model"),
            None => (before, "the fit of the model"),
        };
        let is_refuted = verified.as_ref().is_some_and(|verified| !verified.holds);
        let caution = |applies: bool, text: &str| applies.then(|| text.to_owned());
        let cautions = [
            convergence_caution(&fit.report, name),
            caution(!self.complete, "the search was not completed"),
            exclusion_caution(&before.report),
            caution(is_refuted, "the extended model fails an independent check"),
        ];
        self.cautions = cautions.into_iter().flatten().collect();
        self.reliable = self.cautions.is_empty();
        self.verified = verified;
    }
}
