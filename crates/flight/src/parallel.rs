//! Parallel evaluation of independent tasks on several threads, by rayon.

use crate::cancellation::{carried, current, stop_if_cancelled};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Runs `task(0)`, …, `task(count - 1)` on all processors; results are in the order of the index.
///
/// ```
/// let squares = flight::parallel::each(4, |i| i * i);
/// assert_eq!(squares, [0, 1, 4, 9]);
/// ```
///
/// # Panics
/// If `task` panics.
pub fn each<R: Send>(count: usize, task: impl Fn(usize) -> R + Sync) -> Vec<R> {
    each_on(threads(), count, task)
}

/// Number of processors available to this process; 1 if it cannot be determined.
pub fn threads() -> usize {
    // The operating system is asked once: reading the limits of a container takes longer than many a task.
    static THREADS: OnceLock<usize> = OnceLock::new();
    *THREADS.get_or_init(|| std::thread::available_parallelism().map_or(1, std::num::NonZero::get))
}

/// `threads`, but at most four for each processor: more would take longer to start than they save.
fn bounded(threads: usize) -> usize {
    threads.min(4 * self::threads())
}

/// Runs `task(0)`, …, `task(count - 1)` on `threads` threads, at most four for each processor; results are in index
/// order and do not depend on `threads`. Uses the current rayon pool if it has this number of threads, otherwise a pool that later calls share.
/// With a single thread or task, everything runs on the calling thread. Work that was cancelled begins no further task.
///
/// # Panics
/// If `task` panics.
pub fn each_on<R: Send>(threads: usize, count: usize, task: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let threads = bounded(threads);
    if threads.min(count) <= 1 {
        let unless_cancelled = |index| {
            stop_if_cancelled();
            task(index)
        };
        let results = (0..count).map(unless_cancelled).collect();
        stop_if_cancelled();
        return results;
    }
    let slots: Vec<Mutex<Option<R>>> = (0..count).map(|_| Mutex::default()).collect();
    spread(threads, count, &|index| {
        let result = task(index);
        *slots[index].lock().unwrap_or_else(PoisonError::into_inner) = Some(result);
    });
    let results = slots.into_iter().map(Mutex::into_inner);
    results
        .filter_map(|slot| slot.unwrap_or_else(PoisonError::into_inner))
        .collect()
}

/// Runs the tasks on `threads` threads. Not generic, as the machinery of rayon, compiled for each of the tasks of the
/// workspace, would be half of the code of some crates.
fn spread(threads: usize, count: usize, task: &(dyn Fn(usize) + Sync)) {
    let flag = current();
    // To leave a task out is faster than to unwind from each.
    let unless_cancelled = |index: usize| match &flag {
        Some(flag) if flag.load(Ordering::Relaxed) => {}
        Some(_) => carried(flag.clone(), || task(index)),
        None => task(index),
    };
    // One task at a time per thread, since their durations differ.
    let parallel = || {
        let tasks = (0..count).into_par_iter().with_max_len(1);
        tasks.for_each(unless_cancelled);
    };
    if is_in_pool(threads) {
        parallel();
    } else {
        match shared_pool(threads) {
            Ok(pool) => pool.install(parallel),
            // The operating system refuses further threads.
            Err(_) => (0..count).for_each(unless_cancelled),
        }
    }
    stop_if_cancelled();
}

/// Runs `task` in the pool with `threads` threads that [`each_on`] uses, so that its calls of [`each_on`] start sooner:
/// a thread outside would have to wake one of the pool. On the calling thread if `threads` is at most 1 or it belongs
/// to a pool.
///
/// # Panics
/// If `task` panics.
pub fn within<R: Send>(threads: usize, task: impl FnOnce() -> R + Send) -> R {
    let threads = bounded(threads);
    if threads <= 1 || rayon::current_thread_index().is_some() {
        return task();
    }
    let flag = current();
    match shared_pool(threads) {
        Ok(pool) => pool.install(|| carried(flag, task)),
        // The operating system refuses further threads.
        Err(_) => task(),
    }
}

/// Calls two functions, in parallel if `threads` is greater than 1, and returns both results.
pub fn join<A: Send, B: Send>(
    threads: usize,
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    if threads <= 1 {
        (first(), second())
    } else {
        let flag = current();
        let second = || carried(flag, second);
        within(threads, || rayon::join(first, second))
    }
}

/// Whether the calling thread belongs to a pool of `threads` threads.
fn is_in_pool(threads: usize) -> bool {
    rayon::current_thread_index().is_some() && rayon::current_num_threads() == threads
}

/// The pool of the last call if it has `threads` threads, otherwise a new one: a fit calls this thousands of times. A
/// forked process gets its own, without its parent's threads; for the same reason nothing uses rayon's global pool,
/// which cannot be replaced.
fn shared_pool(threads: usize) -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    static LAST: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    let process = std::process::id();
    let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    match last.take() {
        Some((owner, pool)) if owner == process && pool.current_num_threads() == threads => {
            *last = Some((owner, Arc::clone(&pool)));
            return Ok(pool);
        }
        // Dropped, it would wait for its threads.
        Some((owner, pool)) if owner != process => std::mem::forget(pool),
        _ => {}
    }
    let pool = Arc::new(ThreadPoolBuilder::new().num_threads(threads).build()?);
    *last = Some((process, Arc::clone(&pool)));
    Ok(pool)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_threads_than_four_for_each_processor_are_not_started() {
        let most = 4 * super::threads();
        assert_eq!(within(100_000, rayon::current_num_threads), most);
        let seen = each_on(100_000, 2, |_| rayon::current_num_threads());
        assert_eq!(seen, [most, most]);
    }

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
        // In the same test, since another test that runs at the same time would replace the pool.
        let pool = shared_pool(13).expect("13 threads");
        let again = shared_pool(13).expect("the same 13 threads");
        assert!(Arc::ptr_eq(&pool, &again));
        assert_eq!(
            shared_pool(11).expect("11 threads").current_num_threads(),
            11
        );
        for threads in [1, 3, super::threads()] {
            let place = || (rayon::current_thread_index(), rayon::current_num_threads());
            let (thread, of) = within(threads, place);
            assert_eq!(thread.is_some(), threads > 1, "{threads} threads");
            assert!(of == threads || threads == 1, "{of} of {threads} threads");
        }
    }
}
