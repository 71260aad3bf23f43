//! Tests all mutants of a model in parallel. The result does not depend on the number of threads.

use super::equivalence::Original;
use super::status::evaluate;
use super::{MutationMatrix, mutants};
use crate::options::Options;
use flight::parallel;
use model_spec::model::Source;
use model_spec::syntax::ast::File;

/// Maximum number of random points per check of a mutant.
const MAX_CASES: usize = 6;

/// Runs the checks on every mutant of a model file and returns the mutation matrix.
pub fn run(
    file: &File,
    sources: &[Source],
    original: &Original<'_>,
    options: &Options,
) -> MutationMatrix {
    let options = Options {
        cases: options.cases.min(MAX_CASES),
        ..*options
    };
    let mutants = mutants(file, sources);
    let statuses = parallel::each(mutants.len(), |index| {
        evaluate(&mutants[index], sources, original, &options)
    });
    MutationMatrix::of(&mutants, &statuses)
}
