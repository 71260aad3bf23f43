//! Progress bar on the terminal, and termination of the program by a signal.
//!
//! Ctrl-C (SIGINT), SIGTERM and SIGHUP end a command at once while it computes, because nothing is written then. A
//! write in progress is finished if that takes less than [`WRITING_LIMIT`]; result files and folders are atomic in
//! any case.

use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// The process computes; a signal ends it at once.
const WORKING: u8 = 0;
/// The process writes results; a signal ends it when they are written.
const WRITING: u8 = 1;
/// A signal arrived while the process computed.
const STOPPED: u8 = 2;
/// A signal arrived while results were written.
const STOPPED_WRITING: u8 = 3;

static PHASE: AtomicU8 = AtomicU8::new(WORKING);

/// Whether a later run continues from what was computed before a signal.
static RESUMES: AtomicBool = AtomicBool::new(false);

/// The progress bar on display, which the signal handler removes.
static BAR: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Exit status after a signal (128 + SIGINT).
const INTERRUPTED: u8 = 130;

/// Maximum time for results to be written after a signal.
const WRITING_LIMIT: Duration = Duration::from_millis(400);

/// Maximum time for the message to be printed after a signal.
const MESSAGE_LIMIT: Duration = Duration::from_millis(200);

/// Installs the handler of signals.
pub fn handle_signals() -> anyhow::Result<()> {
    ctrlc::set_handler(|| {
        let change = |from, to| {
            let changed = PHASE.compare_exchange(from, to, Ordering::SeqCst, Ordering::SeqCst);
            changed.is_ok()
        };
        if change(WORKING, STOPPED) {
            end(if RESUMES.load(Ordering::SeqCst) {
                "interrupted; what is done is kept, and the same command goes on from there"
            } else {
                "interrupted; nothing was written"
            });
        }
        if change(WRITING, STOPPED_WRITING) {
            thread::sleep(WRITING_LIMIT);
            end(
                "interrupted while results were written; they are the earlier ones or the new ones",
            );
        }
    })?;
    Ok(())
}

/// Declares that results are kept part by part.
pub fn resumes() {
    RESUMES.store(true, Ordering::SeqCst);
}

/// Runs a function that writes results; a signal ends the process when the function returns.
pub fn writing<T>(write: impl FnOnce() -> T) -> T {
    remove_bar();
    // After a signal nothing is written.
    while PHASE.compare_exchange(WORKING, WRITING, Ordering::SeqCst, Ordering::SeqCst)
        == Err(STOPPED)
    {
        thread::sleep(MESSAGE_LIMIT);
    }
    let written = write();
    if PHASE.swap(WORKING, Ordering::SeqCst) == STOPPED_WRITING {
        end("interrupted; the results had been written");
    }
    written
}

/// Prints a message and exits, without the message if printing blocks.
fn end(message: &str) {
    // Standard error may be a full pipe that nobody reads, so that printing blocks.
    thread::spawn(|| {
        thread::sleep(MESSAGE_LIMIT);
        std::process::exit(INTERRUPTED.into());
    });
    remove_bar();
    eprintln!("{message}");
    std::process::exit(INTERRUPTED.into());
}

fn remove_bar() {
    if let Ok(mut shown) = BAR.try_lock()
        && let Some(bar) = shown.take()
    {
        bar.finish_and_clear();
    }
}

/// Progress bar on standard error; hidden if standard error is not a terminal.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    /// Name, number of flights and number of finished flights of the stage.
    stage: Mutex<(String, usize, usize)>,
}

impl Progress {
    /// Draws a progress bar.
    pub fn new() -> anyhow::Result<Self> {
        let bar = ProgressBar::new(0);
        bar.set_style(
            ProgressStyle::with_template("{msg} [{bar:16}] {pos}/{len} flights, {eta} left")?
                .progress_chars("=> "),
        );
        bar.enable_steady_tick(Duration::from_millis(200));
        if let Ok(mut shown) = BAR.lock() {
            *shown = Some(bar.clone());
        }
        Ok(Self {
            bar,
            stage: Mutex::new((String::new(), 1, 0)),
        })
    }

    /// Starts a stage of the work, of so many flights.
    pub fn start(&self, stage: &str, flights: u64) {
        self.bar.set_length(flights);
        self.bar.set_message(stage.to_owned());
    }

    fn lock(&self) -> MutexGuard<'_, (String, usize, usize)> {
        self.stage.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Adds to the number of finished flights.
    pub fn advance(&self, flights: u64) {
        self.bar.inc(flights);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        remove_bar();
    }
}

impl identify::Progress for Progress {
    fn stage_started(&self, stage: &str, flights: usize) {
        *self.lock() = (stage.to_owned(), flights.max(1), 0);
        self.bar.reset();
        self.start(stage, flights as u64);
    }

    fn flight_done(&self) {
        let mut stage = self.lock();
        let (name, flights, done) = &mut *stage;
        *done += 1;
        // A stage may iterate over all flights until convergence.
        if *done > *flights && *done % *flights == 1 {
            let iteration = *done / *flights + 1;
            self.bar.reset();
            self.bar
                .set_message(format!("{name}, iteration {iteration}"));
        }
        self.bar.set_position(((*done - 1) % *flights + 1) as u64);
    }
}
