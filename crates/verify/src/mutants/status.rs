//! Determines the status of a mutant: killed, survived, equivalent, not covered.

use super::Mutant;
use super::equivalence::Original;
use super::verdicts::verdicts;
use crate::checks::{balances, cases, claim, identities, metamorphic, reference};
use crate::options::Options;
use crate::row::Verdict;
use crate::subject::{Interpreted, Subject};
use model_spec::check;
use model_spec::diagnostic::{Diagnostic, Kind};
use model_spec::model::{Model, Source};

/// Names of the checks that are run on mutants, in ascending order of cost. The first three are those of the language
/// checker; the last two apply only to models with `claim` statements.
pub const CHECKS: [&str; 9] = [
    "units",
    "frames",
    "names and shapes",
    cases::CASES,
    reference::REFERENCE,
    identities::IDENTITIES,
    metamorphic::METAMORPHIC,
    claim::CLAIM,
    balances::BALANCES,
];

/// Number of [`CHECKS`] that are run on the mutants of every model.
pub(super) const ALWAYS: usize = 7;

/// Result of running the checks of the verification on a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MutantStatus {
    /// Refuted by, or no longer held by, the checks with these indices in [`CHECKS`]; never empty.
    Killed(Vec<usize>),
    /// Proved equivalent to the model, for this reason.
    Equivalent(&'static str),
    /// Not killed, but the model has terms without a reference implementation.
    NotCovered,
    /// Not killed, although the reference implementation contains all terms.
    Survived,
}

/// Runs the checks on a mutant and returns its status.
pub fn evaluate(
    mutant: &Mutant,
    sources: &[Source],
    original: &Original<'_>,
    options: &Options,
) -> MutantStatus {
    let checked = check(&mutant.file, sources);
    let mut killers: Vec<usize> = checked.diagnostics.iter().map(killer).collect();
    if let Some(model) = &checked.model {
        killers.extend(refusals(model, original, options));
    }
    killers.sort_unstable();
    killers.dedup();
    if !killers.is_empty() {
        return MutantStatus::Killed(killers);
    }
    match checked.model.and_then(|model| original.same(&model)) {
        Some(reason) => MutantStatus::Equivalent(reason),
        None if original.has_uncovered_terms() => MutantStatus::NotCovered,
        None => MutantStatus::Survived,
    }
}

fn killer(fault: &Diagnostic) -> usize {
    match fault.kind {
        Kind::Unit => 0,
        Kind::Frame => 1,
        _ => 2,
    }
}

/// Indices, in [`CHECKS`], of the checks by vector expressions that refute a mutant, or hold for the model and no longer
/// for the mutant, such as a relation that the model keeps.
fn refusals(model: &Model, original: &Original<'_>, options: &Options) -> Vec<usize> {
    let Ok(equations) = Interpreted::new(model) else {
        return vec![2];
    };
    let mut subject = Subject::new(model, &equations);
    // A mutation must not change the meaning of the states.
    if subject.reference.is_none() {
        subject.chart.clone_from(&original.subject.chart);
    }
    let found = verdicts(&subject, options);
    let known = original.verdicts(options);
    let is_refusal = |(own, known): (&Verdict, &Verdict)| {
        *own == Verdict::Refuted || *known == Verdict::Holds && *own != Verdict::Holds
    };
    let refusals = found.iter().zip(known).map(is_refusal).enumerate();
    let refusals = refusals.filter(|(_, is_refusal)| *is_refusal);
    refusals.map(|(k, _)| 3 + k).collect()
}
