//! Two tasks at once.

/// Calls both functions, in parallel if `threads` exceeds 1, and returns both results.
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
