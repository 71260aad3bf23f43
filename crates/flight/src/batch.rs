//! Many flights at once, over the machine's processors.

use rayon::prelude::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// `fly(0)`, `fly(1)`, … `fly(count - 1)`, on as many threads as the machine has processors; the results in that
/// order. Each flight is computed alone, so that the results do not depend on how many threads there are.
///
/// ```
/// use flight::batch;
/// use ode::{Event, IntegrationOptions, integrate_to_event, rhs_from_fn};
///
/// let heights = [1.0, 5.0, 20.0];
/// let times = batch::each(heights.len(), |i| {
///     let mut stone = rhs_from_fn(&["z", "vz"], |_, x: &[f64; 2], dx: &mut [f64; 2]| *dx = [x[1], -9.81]);
///     let ground = Event::falls_to("ground", 0, 0.0).terminal();
///     integrate_to_event(&mut stone, (0.0, &[heights[i], 0.0]), 60.0, &IntegrationOptions::default(), &mut [ground]).map(|f| f.end)
/// });
/// assert!(times[2].as_ref().unwrap() > times[1].as_ref().unwrap());
/// ```
///
/// # Panics
/// Where `fly` does.
pub fn each<R: Send>(count: usize, fly: impl Fn(usize) -> R + Sync) -> Vec<R> {
    each_on(threads(), count, fly)
}

/// As many threads as the machine has processors.
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, |n| n.get())
}

/// As [`each`], on so many threads.
pub fn each_on<R: Send>(threads: usize, count: usize, fly: impl Fn(usize) -> R + Sync) -> Vec<R> {
    if threads.min(count) <= 1 {
        return (0..count).map(fly).collect();
    }
    // Threads that wait for work take it up sooner than new ones begin.
    if threads == rayon::current_num_threads() {
        let each = (0..count).into_par_iter().with_max_len(1);
        return each.map(&fly).collect();
    }
    on_new(threads.min(count), count, fly)
}

/// The same on threads that begin with it and end with it.
fn on_new<R: Send>(threads: usize, count: usize, fly: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<Option<R>>> = Mutex::new((0..count).map(|_| None).collect());
    let work = || {
        // A thread takes what is next when it is free, and hands its results in once.
        let take = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|i| *i < count);
        let own: Vec<(usize, R)> = std::iter::from_fn(take).map(|i| (i, fly(i))).collect();
        let mut done = done.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        for (i, result) in own {
            done[i] = Some(result);
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        // This thread is one of them.
        work();
    });
    let done = done
        .into_inner()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    done.into_iter()
        .map(|result| result.expect("each was flown"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_the_flights_on_any_number_of_threads() {
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
