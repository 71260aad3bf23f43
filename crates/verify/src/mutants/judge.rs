//! What becomes of one mutant.

use super::Mutant;
use super::equivalence::Original;
use crate::Options;
use crate::checks::{cases, identities, reference, symmetries};
use crate::report::{Row, Verdict};
use crate::subject::{Interpreted, Subject};
use crate::values::Values;
use model_spec::check;
use model_spec::diagnostic::{Diagnostic, Kind};
use model_spec::model::{Model, Source};

/// Kill by the checker's units.
pub const UNITS: &str = "units";
/// Kill by the checker's frames.
pub const FRAMES: &str = "frames";
/// Kill by anything else that the checker refuses.
pub const GRAMMAR: &str = "names and shapes";

/// Every check that mutants are put to, cheapest first: the first that refuses one is said to kill it.
pub const CHECKS: [&str; 7] = [
    UNITS,
    FRAMES,
    GRAMMAR,
    cases::CASES,
    reference::REFERENCE,
    identities::IDENTITIES,
    symmetries::SYMMETRIES,
];

/// What became of a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// Refused by these checks, as indices into [`CHECKS`]; never empty.
    Killed(Vec<usize>),
    /// Shown to be the same model, and how.
    Equivalent(&'static str),
    /// Changes nothing where the terms that the reference does not know vanish: nobody says what is right.
    Unwatched,
    /// Noticed by nobody.
    Survived,
}

/// Puts a mutant to every check.
pub fn judge(
    mutant: &Mutant,
    sources: &[Source],
    original: &Original<'_>,
    options: &Options,
) -> Fate {
    let checked = check(&mutant.file, sources);
    let mut killers: Vec<usize> = checked.diagnostics.iter().map(killer).collect();
    if let Some(model) = &checked.model {
        killers.extend(refusals(model, original, options));
    }
    killers.sort_unstable();
    killers.dedup();
    if !killers.is_empty() {
        return Fate::Killed(killers);
    }
    match checked
        .model
        .and_then(|model| original.same(&Values::of(&model)))
    {
        Some(reason) => Fate::Equivalent(reason),
        None if original.unwatched() => Fate::Unwatched,
        None => Fate::Survived,
    }
}

fn killer(fault: &Diagnostic) -> usize {
    match fault.kind {
        Kind::Unit => 0,
        Kind::Frame => 1,
        _ => 2,
    }
}

/// Checks that refuse a mutant's equations, as the vector tree gives them: whether the compiler follows
/// the tree is another question, and another check.
fn refusals(model: &Model, original: &Original<'_>, options: &Options) -> Vec<usize> {
    let Ok(equations) = Interpreted::new(model) else {
        return vec![2];
    };
    let mut subject = Subject::new(model, &equations);
    // A mutant cannot change what it claims to be, nor what its states stand for.
    if subject.reference.is_none() {
        subject.chart.clone_from(&original.subject.chart);
    }
    let rows: [Row; 4] = [
        cases::check(&subject),
        reference::reference(&subject, options),
        identities::check(&subject, options),
        symmetries::check(&subject, options),
    ];
    rows.iter()
        .enumerate()
        .filter(|(_, row)| row.verdict == Verdict::Refuted)
        .map(|(k, _)| 3 + k)
        .collect()
}
