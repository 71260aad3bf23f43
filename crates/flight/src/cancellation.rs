//! Cancellation of work that has no token of its own: it unwinds at the next task or flight.

use std::cell::RefCell;
use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Flag that cancels work where it is true.
pub type Flag = Arc<AtomicBool>;

/// What cancelled work unwinds with, for [`std::panic::catch_unwind`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

thread_local! {
    static CURRENT: RefCell<Option<Flag>> = const { RefCell::new(None) };
}

/// Sets the flag of the thread again when it is dropped.
struct Restored(Option<Flag>);

impl Drop for Restored {
    fn drop(&mut self) {
        CURRENT.replace(self.0.take());
    }
}

/// Runs `work`, which unwinds with [`Cancelled`] soon after `flag` is true; so do the threads of [`parallel`](crate::parallel)
/// that it uses. The caller catches that, as no message is printed; a program whose panics abort must not set the flag.
pub fn cancellable<R>(flag: Flag, work: impl FnOnce() -> R) -> R {
    carried(Some(flag), work)
}

/// Runs `work` with the flag of another thread.
pub(crate) fn carried<R>(flag: Option<Flag>, work: impl FnOnce() -> R) -> R {
    let _restored = Restored(CURRENT.replace(flag));
    work()
}

/// The flag of this thread.
pub(crate) fn current() -> Option<Flag> {
    CURRENT.with_borrow(Option::clone)
}

/// Unwinds if the work of this thread was cancelled.
pub fn stop_if_cancelled() {
    let is_set = |flag: &Option<Flag>| flag.as_ref().is_some_and(|f| f.load(Ordering::Relaxed));
    if CURRENT.with_borrow(is_set) {
        resume_unwind(Box::new(Cancelled));
    }
}

#[cfg(test)]
mod tests {
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::sync::atomic::AtomicUsize;

    use super::*;
    use crate::parallel::each_on;

    #[test]
    fn tasks_after_a_cancellation_do_not_begin() {
        for threads in [1, 2] {
            let (flag, begun) = (Flag::default(), AtomicUsize::new(0));
            let work = || {
                each_on(threads, 1000, |_| {
                    begun.fetch_add(1, Ordering::Relaxed);
                    flag.store(true, Ordering::Relaxed);
                })
            };
            let caught = catch_unwind(AssertUnwindSafe(|| cancellable(flag.clone(), work)));
            assert!(caught.is_err_and(|payload| payload.is::<Cancelled>()));
            assert!(begun.load(Ordering::Relaxed) <= threads);
            // Neither this thread nor those of the pool are cancelled from then on.
            stop_if_cancelled();
            assert_eq!(each_on(threads, 3, |i| i), [0, 1, 2]);
        }
    }
}
