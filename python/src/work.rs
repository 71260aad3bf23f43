//! Long work on a thread of its own, while the calling thread watches for signals and reports the progress.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use flight::cancellation::{Flag, cancellable};
use identify::{CancellationToken, Progress};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::errors::of_class;

/// Time between two looks for signals.
const PAUSE: Duration = Duration::from_millis(20);

/// Progress of running work, and its cancellation.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    /// Cancels a fit or a sweep.
    pub token: CancellationToken,
    /// Cancels any work at its next task or flight.
    flag: Flag,
    state: Arc<State>,
}

#[derive(Debug, Default)]
struct State {
    stage: Mutex<(String, usize)>,
    done: AtomicUsize,
}

impl Watch {
    fn cancel(&self) {
        self.token.cancel();
        self.flag.store(true, Ordering::Relaxed);
    }

    /// Counts finished parts of the work.
    pub fn advance(&self, parts: usize) {
        self.state.done.fetch_add(parts, Ordering::Relaxed);
    }

    fn read(&self) -> (String, usize, usize) {
        let stage = self.state.stage.lock();
        let (stage, total) = stage.unwrap_or_else(PoisonError::into_inner).clone();
        let done = self.state.done.load(Ordering::Relaxed);
        // A stage may process each of its flights several times.
        let done = match done {
            0 => 0,
            done => (done - 1) % total.max(1) + 1,
        };
        (stage, done, total)
    }
}

impl Progress for Watch {
    fn stage_started(&self, stage: &str, flights: usize) {
        let mut now = self
            .state
            .stage
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        *now = (stage.to_owned(), flights);
        self.state.done.store(0, Ordering::Relaxed);
    }

    fn flight_done(&self) {
        self.advance(1);
    }
}

/// Runs `work` without the lock of the interpreter. A signal or an exception of `progress`, which is called with stage,
/// number done and total, cancels the work and is raised at once; the work then ends at its next task or flight.
pub fn run<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> T + Send + 'static,
) -> PyResult<T> {
    let (watch, (sender, mut receiver)) = (Watch::default(), mpsc::channel());
    let watched = watch.clone();
    let thread = std::thread::Builder::new().name("hyzer".into());
    // As much as the main thread of the program has.
    let thread = thread.stack_size(8 << 20);
    let spawned = thread.spawn(move || {
        let flag = Flag::clone(&watched.flag);
        let done = catch_unwind(AssertUnwindSafe(|| cancellable(flag, || work(&watched))));
        // Nobody waits any more for work that was cancelled.
        let _ = sender.send(done);
    });
    spawned?;
    let mut told = None;
    loop {
        let (back, got) = py.detach(move || {
            let got = receiver.recv_timeout(PAUSE);
            (receiver, got)
        });
        receiver = back;
        match got {
            Ok(Ok(done)) => return Ok(done),
            Ok(Err(panic)) => return Err(internal(&*panic)),
            Err(RecvTimeoutError::Disconnected) => return Err(internal(&"the thread ended")),
            Err(RecvTimeoutError::Timeout) => {}
        }
        let seen = py
            .check_signals()
            .and_then(|()| tell(progress, &watch, &mut told));
        if let Err(error) = seen {
            watch.cancel();
            return Err(cancelled(py, error));
        }
    }
}

fn tell(
    progress: Option<&Bound<'_, PyAny>>,
    watch: &Watch,
    told: &mut Option<(String, usize, usize)>,
) -> PyResult<()> {
    let Some(progress) = progress else {
        return Ok(());
    };
    let now = watch.read();
    if told.as_ref() != Some(&now) && now.2 > 0 {
        progress.call1(now.clone())?;
        *told = Some(now);
    }
    Ok(())
}

/// Ctrl-C as `hyzer.Cancelled`, which is a `KeyboardInterrupt`; any other exception as it is.
pub fn cancelled(py: Python<'_>, error: PyErr) -> PyErr {
    if !error.is_instance_of::<PyKeyboardInterrupt>(py) {
        return error;
    }
    let text = "interrupted; nothing was written that is not whole";
    let raised = of_class("Cancelled", text);
    raised.set_cause(py, Some(error));
    raised
}

/// A panic as an exception: a mistake of hyzer, not of the caller.
fn internal(panic: &(dyn Any + Send)) -> PyErr {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
    let text = text.unwrap_or_else(|| "no message".into());
    of_class(
        "InternalError",
        &format!("a mistake in hyzer, please report it: {text}"),
    )
}
