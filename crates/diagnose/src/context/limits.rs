//! When refits stop: cancelled by the caller, past the deadline, or after the steps that a search may take.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use identify::{CancellationToken, FitOptions};

/// Greatest number of least-squares steps of all refits of one search.
const MAX_STEPS: usize = 250;

/// Limits of the refits of one search.
#[derive(Debug)]
pub(crate) struct Limits {
    deadline: Option<Instant>,
    cancellation: Option<CancellationToken>,
    /// Number of steps taken so far.
    steps: AtomicUsize,
}

impl Limits {
    /// Limits that the options of a fit set.
    pub fn new(options: &FitOptions<'_>) -> Self {
        Self {
            deadline: options.deadline,
            cancellation: options.cancellation.cloned(),
            steps: AtomicUsize::new(0),
        }
    }

    /// Whether the caller cancelled the work.
    pub fn is_cancelled(&self) -> bool {
        let token = self.cancellation.as_ref();
        token.is_some_and(CancellationToken::is_cancelled)
    }

    /// Whether the deadline has passed.
    pub fn is_past_deadline(&self) -> bool {
        self.deadline
            .is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Counts the steps of a refit.
    pub fn count(&self, steps: usize) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }

    /// Whether the refits have taken all the steps that a search may take.
    pub fn are_steps_used_up(&self) -> bool {
        self.steps.load(Ordering::Relaxed) >= MAX_STEPS
    }
}
