//! All mutants, on all cores; the outcome does not depend on how many there are.

use super::equivalence::Original;
use super::judge::{Fate, judge};
use super::{KillTable, mutants};
use crate::Options;
use model_spec::model::Source;
use model_spec::syntax::ast::File;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

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
    let next = AtomicUsize::new(0);
    let work = || {
        let mut judged = Vec::new();
        while let index = next.fetch_add(1, Ordering::Relaxed)
            && let Some(mutant) = mutants.get(index)
        {
            judged.push((index, judge(mutant, sources, original, &options)));
        }
        judged
    };
    let cores = thread::available_parallelism().map_or(1, |n| n.get());
    let mut judged: Vec<(usize, Fate)> = thread::scope(|scope| {
        let threads: Vec<_> = (0..cores).map(|_| scope.spawn(work)).collect();
        threads
            .into_iter()
            .flat_map(|thread| {
                thread
                    .join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            })
            .collect()
    });
    judged.sort_by_key(|(index, _)| *index);
    let fates: Vec<Fate> = judged.into_iter().map(|(_, fate)| fate).collect();
    KillTable::of(&mutants, &fates)
}
