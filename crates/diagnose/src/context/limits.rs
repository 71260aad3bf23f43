//! Limits of the refits of one search: cancellation by the caller, the deadline, and a maximum number of steps.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use identify::{CancellationToken, FitOptions};

/// Maximum number of least-squares steps, summed over all refits of one search.
const MAX_STEPS: usize = 250;

/// Cancellation, deadline and step count that limit the refits of one search.
#[derive(Debug)]
pub(crate) struct Limits {
    deadline: Option<Instant>,
    cancellation: Option<CancellationToken>,
    /// Number of least-squares steps taken so far, over all refits.
    steps: AtomicUsize,
}

impl Limits {
    /// Creates limits with the deadline and cancellation token of the fit's options; no step is counted yet.
    pub fn new(options: &FitOptions<'_>) -> Self {
        Self {
            deadline: options.deadline,
            cancellation: options.cancellation.cloned(),
            steps: AtomicUsize::new(0),
        }
    }

    /// Whether the caller cancelled the diagnosis.
    pub fn is_cancelled(&self) -> bool {
        let token = self.cancellation.as_ref();
        token.is_some_and(CancellationToken::is_cancelled)
    }

    /// Whether the deadline has passed.
    pub fn is_past_deadline(&self) -> bool {
        self.deadline
            .is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Adds the number of steps of one refit to the total.
    pub fn count(&self, steps: usize) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }

    /// Whether the refits together have taken the maximum number of steps.
    pub fn are_steps_used_up(&self) -> bool {
        self.steps.load(Ordering::Relaxed) >= MAX_STEPS
    }
}
