//! Fork–join of two tasks, limited by the number of threads.

/// Calls two functions, in parallel if `threads` is greater than 1, and returns both results.
pub(crate) fn join<A: Send, B: Send>(
    threads: usize,
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    match threads <= 1 {
        true => (first(), second()),
        false => rayon::join(first, second),
    }
}
