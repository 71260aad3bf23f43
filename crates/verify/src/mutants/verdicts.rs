//! Verdicts of the checks that a model and its mutants are put to.

use crate::checks::{balances, cases, claim, identities, metamorphic, reference};
use crate::options::Options;
use crate::row::{Row, Verdict};
use crate::subject::Subject;

/// Verdicts of the checks of a model by its vector expressions, in the order of [`CHECKS`](super::status::CHECKS).
pub(super) fn verdicts(subject: &Subject<'_>, options: &Options) -> [Verdict; 6] {
    let verdict = |row: Option<Row>| row.map_or(Verdict::Skipped, |row| row.verdict);
    [
        cases::check(subject).verdict,
        reference::reference(subject, options).verdict,
        identities::check(subject, options).verdict,
        metamorphic::check(subject, options).verdict,
        verdict(claim::check(subject, options)),
        verdict(balances::check(subject, options)),
    ]
}
