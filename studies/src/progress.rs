//! Runs of a study on several threads, with a report of the progress.

use std::sync::atomic::{AtomicUsize, Ordering};

use flight::parallel;

/// Function that is called after each finished run with the numbers of finished runs and of all runs.
pub type Progress<'p> = &'p (dyn Fn(usize, usize) + Sync);

/// Executes `run(0)`, …, `run(count - 1)`, `threads` of them in parallel, and calls `progress` after each. Returns the
/// results of the runs in the order of their indices.
pub(crate) fn each_run<R: Send>(
    threads: usize,
    count: usize,
    progress: Progress<'_>,
    run: impl Fn(usize) -> R + Sync,
) -> Vec<R> {
    let finished = AtomicUsize::new(0);
    parallel::each_on(threads, count, |index| {
        let result = run(index);
        progress(1 + finished.fetch_add(1, Ordering::Relaxed), count);
        result
    })
}

/// Number of threads of each run if `parallel` runs share the processors equally.
pub(crate) fn threads_of_each_run(parallel: usize) -> usize {
    (parallel::threads() / parallel.max(1)).max(1)
}
