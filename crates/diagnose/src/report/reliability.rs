//! Assessment whether a diagnosis is reliable, with the reasons if it is not.

use identify::{Fit, convergence_caution, exclusion_caution};

use super::types::{Report, Verdict, Verified};

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
            caution(
                self.lack_remains(),
                "the residuals are not noise with what was found either: it is at best a part of what is missing",
            ),
        ];
        self.cautions = cautions.into_iter().flatten().collect();
        self.reliable = self.cautions.is_empty();
        self.verified = verified;
    }

    /// Whether the diagnosis states what is missing, and the residuals with it are not noise.
    fn lack_remains(&self) -> bool {
        let is_stated = matches!(self.verdict, Verdict::Identified | Verdict::Ambiguous);
        let test = self.lack_of_fit.as_ref();
        is_stated && test.is_some_and(|test| test.p_value < self.threshold.alpha)
    }
}
