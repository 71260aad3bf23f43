//! Determines the status of a mutant: killed, survived, equivalent, not covered.

use super::Mutant;
use super::equivalence::Original;
use crate::checks::{cases, claim, identities, metamorphic, reference};
use crate::options::Options;
use crate::row::{Row, Verdict};
use crate::subject::{Interpreted, Subject};
use model_spec::check;
use model_spec::diagnostic::{Diagnostic, Kind};
use model_spec::model::{Model, Source};

/// Names of the checks that are run on mutants, in ascending order of cost. The first three are those of the language
/// checker; the last one applies only to models with a `claim` statement, which declares the meaning of their equations.
pub const CHECKS: [&str; 8] = [
    "units",
    "frames",
    "names and shapes",
    cases::CASES,
    reference::REFERENCE,
    identities::IDENTITIES,
    metamorphic::METAMORPHIC,
    claim::CLAIM,
];

/// Result of running the checks of the verification on a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MutantStatus {
    /// Killed by the checks with these indices in [`CHECKS`]; never empty.
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

/// Indices, in [`CHECKS`], of the checks that refute a mutant by its vector expressions.
fn refusals(model: &Model, original: &Original<'_>, options: &Options) -> Vec<usize> {
    let Ok(equations) = Interpreted::new(model) else {
        return vec![2];
    };
    let mut subject = Subject::new(model, &equations);
    // A mutation must not change the meaning of the states.
    if subject.reference.is_none() {
        subject.chart.clone_from(&original.subject.chart);
    }
    let mut rows: Vec<Row> = vec![
        cases::check(&subject),
        reference::reference(&subject, options),
        identities::check(&subject, options),
        metamorphic::check(&subject, options),
    ];
    rows.extend(claim::check(&subject, options));
    rows.iter()
        .enumerate()
        .filter(|(_, row)| row.verdict == Verdict::Refuted)
        .map(|(k, _)| 3 + k)
        .collect()
}
