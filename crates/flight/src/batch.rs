//! Independent tasks on several threads, by rayon.

use rayon::prelude::*;

/// Runs `task(0)`, …, `task(count - 1)` on all processors; results are in the order of the index.
///
/// ```
/// let squares = flight::batch::each(4, |i| i * i);
/// assert_eq!(squares, [0, 1, 4, 9]);
/// ```
///
/// # Panics
/// Where `task` does.
pub fn each<R: Send>(count: usize, task: impl Fn(usize) -> R + Sync) -> Vec<R> {
    each_on(threads(), count, task)
}

/// Number of processors of the machine.
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, |n| n.get())
}

/// Runs `task(0)`, …, `task(count - 1)` on `threads` threads; results are in index order and do not depend on
/// `threads`. Uses the current rayon pool if it has as many threads, else a new pool; the calling thread for a single
/// thread or task.
///
/// # Panics
/// Where `task` does.
pub fn each_on<R: Send>(threads: usize, count: usize, task: impl Fn(usize) -> R + Sync) -> Vec<R> {
    if threads.min(count) <= 1 {
        return (0..count).map(task).collect();
    }
    // One task at a time per thread, since their durations differ.
    let parallel = || {
        let tasks = (0..count).into_par_iter().with_max_len(1);
        tasks.map(&task).collect()
    };
    if threads == rayon::current_num_threads() {
        return parallel();
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.min(count));
    match pool.build() {
        Ok(pool) => pool.install(parallel),
        // The system refuses further threads.
        Err(_) => (0..count).map(&task).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order_on_any_number_of_threads() {
        for threads in [0, 1, 2, 7, 100] {
            let work = |i: usize| {
                (0..1000 * (40 - i as u64))
                    .fold(i as u64, |a, b| a.wrapping_mul(31).wrapping_add(b))
            };
            let results = each_on(threads, 40, work);
            assert_eq!(results, (0..40).map(work).collect::<Vec<_>>());
        }
        assert!(each(0, |i| i).is_empty());
    }
}
