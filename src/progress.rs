//! Progress bar on the terminal, and handling of Ctrl-C.

use std::sync::Arc;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU8, AtomicUsize, Ordering};
use std::time::Duration;

use identify::CancellationToken;
use indicatif::{ProgressBar, ProgressStyle};

/// Phase before any work: Ctrl-C ends the program at once.
const READING: u8 = 0;
/// Phase of cancellable work: Ctrl-C cancels the token.
const WORKING: u8 = 1;
/// Phase in which result files are written: Ctrl-C is ignored.
const WRITING: u8 = 2;
/// Phase after Ctrl-C during work: the token is cancelled.
const STOPPED: u8 = 3;

/// Exit status of an interrupted program (128 + SIGINT).
pub const INTERRUPTED: u8 = 130;

/// Progress bar on standard error (hidden where that is not a terminal) and cancellation by Ctrl-C.
#[derive(Debug)]
pub struct Progress {
    phase: Arc<AtomicU8>,
    cancellation: CancellationToken,
    bar: ProgressBar,
    stage: Mutex<String>,
    parts: AtomicUsize,
    done: AtomicUsize,
}

impl Progress {
    /// Installs the Ctrl-C handler; draws no progress bar yet.
    pub fn new() -> anyhow::Result<Self> {
        let phase = Arc::new(AtomicU8::new(READING));
        let heard = Arc::clone(&phase);
        let cancellation = CancellationToken::default();
        let token = cancellation.clone();
        ctrlc::set_handler(move || {
            let was = heard.compare_exchange(WORKING, STOPPED, Ordering::SeqCst, Ordering::SeqCst);
            if was.is_ok() {
                token.cancel();
            }
            if was == Err(READING) {
                eprintln!("interrupted; nothing was written");
                std::process::exit(INTERRUPTED.into());
            }
        })?;
        let bar = ProgressBar::new(0);
        bar.set_style(
            ProgressStyle::with_template("{msg} [{bar:16}] {pos}/{len} flights, {eta} left")?
                .progress_chars("=> "),
        );
        Ok(Self {
            phase,
            cancellation,
            bar,
            stage: Mutex::default(),
            parts: AtomicUsize::new(0),
            done: AtomicUsize::new(0),
        })
    }

    /// The token that Ctrl-C cancels while work is under way.
    pub fn cancellation(&self) -> &CancellationToken {
        &self.cancellation
    }

    /// Enters the phase of cancellable work and starts the progress bar.
    pub fn working(&self) {
        self.phase.store(WORKING, Ordering::SeqCst);
        self.bar.enable_steady_tick(Duration::from_millis(200));
    }

    /// Enters the phase of writing files, which Ctrl-C does not interrupt; removes the progress bar.
    pub fn writing(&self) {
        let _ = self
            .phase
            .compare_exchange(WORKING, WRITING, Ordering::SeqCst, Ordering::SeqCst);
        self.bar.finish_and_clear();
    }
}

impl identify::Progress for Progress {
    fn stage_started(&self, stage: &str, parts: usize) {
        *self
            .stage
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner()) = stage.to_owned();
        self.parts.store(parts, Ordering::Relaxed);
        self.done.store(0, Ordering::Relaxed);
        self.bar.reset();
        self.bar.set_length(parts as u64);
        self.bar.set_message(stage.to_owned());
    }

    fn flight_done(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        let parts = self.parts.load(Ordering::Relaxed).max(1);
        // A stage iterates over all flights repeatedly until convergence.
        if done > parts && done % parts == 1 {
            let stage = self
                .stage
                .lock()
                .unwrap_or_else(|poisoned| poisoned.into_inner());
            self.bar.reset();
            self.bar
                .set_message(format!("{stage}, iteration {}", done / parts + 1));
        }
        self.bar.set_position(((done - 1) % parts + 1) as u64);
    }
}
