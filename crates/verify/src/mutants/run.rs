//! All mutants, on all cores; the outcome does not depend on how many there are.

use super::equivalence::Original;
use super::judge::judge;
use super::{KillTable, mutants};
use crate::Options;
use flight::batch;
use model_spec::model::Source;
use model_spec::syntax::ast::File;

/// Random points for each check of a mutant: a fault shows at almost every one.
const CASES: usize = 6;

/// Makes every mutant of a file and puts each to every check.
pub fn run(
    file: &File,
    sources: &[Source],
    original: &Original<'_>,
    options: &Options,
) -> KillTable {
    let options = Options {
        cases: options.cases.min(CASES),
        ..*options
    };
    let mutants = mutants(file, sources);
    let fates = batch::each(mutants.len(), |index| {
        judge(&mutants[index], sources, original, &options)
    });
    KillTable::of(&mutants, &fates)
}
