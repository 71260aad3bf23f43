//! Progress bar on the terminal, and termination of the program by a signal.
//!
//! Ctrl-C (SIGINT), SIGTERM and SIGHUP end a command at once while it computes, because nothing is written then. A
//! write in progress is finished if that takes less than [`WRITING_LIMIT`]; result files and folders are atomic in
//! any case.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// State of the `hyzer` process in which it computes; a signal then ends the process at once.
const WORKING: u8 = 0;
/// State of the `hyzer` process in which it writes result files; a signal then ends the process when the files are
/// written.
const WRITING: u8 = 1;
/// State of the `hyzer` process after a signal that arrived during the computation: the process is about to exit.
const STOPPED: u8 = 2;
/// State of the `hyzer` process after a signal that arrived while result files were written: the process exits when the
/// files are complete.
const STOPPED_WRITING: u8 = 3;

static PHASE: AtomicU8 = AtomicU8::new(WORKING);

/// Whether a later run of the same command continues from the results computed before a signal.
static RESUMES: AtomicBool = AtomicBool::new(false);

/// The progress bar on display, kept here so that the signal handler can remove it.
static BAR: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Exit status of a `hyzer` process that a signal interrupted (128 + SIGINT).
const INTERRUPTED: u8 = 130;

/// Maximum time that the signal handler waits for results to be written before it ends the `hyzer` process.
const WRITING_LIMIT: Duration = Duration::from_millis(400);

/// Maximum time that `hyzer` waits, after a signal, for the message to be printed before it exits.
const MESSAGE_LIMIT: Duration = Duration::from_millis(200);

/// Installs the handler of interrupt and termination signals, for all commands.
pub fn handle_signals() -> anyhow::Result<()> {
    ctrlc::set_handler(|| {
        let change = |from, to| {
            let changed = PHASE.compare_exchange(from, to, Ordering::SeqCst, Ordering::SeqCst);
            changed.is_ok()
        };
        if change(WORKING, STOPPED) {
            end(match RESUMES.load(Ordering::SeqCst) {
                true => {
                    "interrupted; what is done is kept, and the same command goes on from there"
                }
                false => "interrupted; nothing was written",
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

/// Declares that the command writes its results part by part, so that results computed before a signal are kept.
pub fn resumes() {
    RESUMES.store(true, Ordering::SeqCst);
}

/// Runs a function that writes results. A signal that arrives while the function runs ends `hyzer` only when the
/// function returns.
pub fn writing<T>(write: impl FnOnce() -> T) -> T {
    remove_bar();
    enter(WORKING, WRITING);
    let written = write();
    if PHASE.swap(WORKING, Ordering::SeqCst) == STOPPED_WRITING {
        end("interrupted; the results had been written");
    }
    written
}

/// Changes the state of the process, `PHASE`, from `from` to `to`. If a signal has already begun to end the process,
/// the function does not return, so that nothing is written after the message of the signal handler.
fn enter(from: u8, to: u8) {
    let entered = PHASE.compare_exchange(from, to, Ordering::SeqCst, Ordering::SeqCst);
    while entered == Err(STOPPED) {
        thread::sleep(MESSAGE_LIMIT);
    }
}

/// Prints `message` to standard error and exits with the status [`INTERRUPTED`]; exits without the message if printing
/// blocks for longer than [`MESSAGE_LIMIT`].
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
    stage: Mutex<String>,
    parts: AtomicUsize,
    done: AtomicUsize,
}

impl Progress {
    /// Creates and draws a progress bar.
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
            stage: Mutex::default(),
            parts: AtomicUsize::new(0),
            done: AtomicUsize::new(0),
        })
    }
}

impl Progress {
    /// Starts a stage of the work: the bar then shows the name `stage` and the total number of flights of the stage.
    pub fn start(&self, stage: &str, flights: u64) {
        self.bar.set_length(flights);
        self.bar.set_message(stage.to_owned());
    }

    /// Adds `flights` to the number of finished flights that the bar shows.
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
    fn stage_started(&self, stage: &str, parts: usize) {
        *self
            .stage
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner) = stage.to_owned();
        self.parts.store(parts, Ordering::Relaxed);
        self.done.store(0, Ordering::Relaxed);
        self.bar.reset();
        self.bar.set_length(parts as u64);
        self.bar.set_message(stage.to_owned());
    }

    fn flight_done(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        let parts = self.parts.load(Ordering::Relaxed).max(1);
        // A stage may iterate over all flights until convergence.
        if done > parts && done % parts == 1 {
            let stage = self
                .stage
                .lock()
                .unwrap_or_else(std::sync::PoisonError::into_inner);
            self.bar.reset();
            self.bar
                .set_message(format!("{stage}, iteration {}", done / parts + 1));
        }
        self.bar.set_position(((done - 1) % parts + 1) as u64);
    }
}
