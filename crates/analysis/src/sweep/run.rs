//! Runs a sweep: computes the parts on several threads, writes each part to a file, and skips parts whose file
//! exists.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, PoisonError, mpsc};

use flight::CompiledModel;
use flight::release::{Release, Stop};
use flight::throw::{ThrownModel, speed_and_spin};
use flight::{LaneModel, LaneObserver};
use ode::FlightSpan;
use serde_json::{Value, json};

use crate::sweep::error::SweepError;
use crate::sweep::folder::{PartsFolder, share_of};
use crate::sweep::inputs::InputModel;
use crate::sweep::plan::Plan;
use crate::sweep::rows::Flier;
use crate::sweep::summary::Summary;
use crate::sweep::table;

/// Options of running a sweep; none of them affects the results.
#[derive(Clone, Copy)]
pub struct SweepOptions<'a> {
    /// Number of threads that simulate flights; at least 1.
    pub threads: usize,
    /// If several processes compute one sweep in the same folder: the share of the parts to compute, as (share number
    /// from 1, number of shares). `None` computes all parts and joins them.
    pub share: Option<(u64, u64)>,
    /// Whether the table of flights is also written as CSV.
    pub csv: bool,
    /// Called after each completed part, with the number of flights in the part.
    pub progress: &'a (dyn Fn(u64) + Sync),
    /// Whether to stop; asked before each part. The parts computed until then are kept.
    pub is_cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// Maximum number of parts, per thread, that are computed while an earlier part is not yet merged into the summary; it
/// bounds the memory.
const AHEAD: u64 = 8;

/// File name of the Parquet table of all flights of the sweep.
const FLIGHTS: &str = "flights.parquet";

/// Simulates the flights of a plan and writes `flights.parquet` and `summary.json` to the folder `out`, which is new,
/// empty or holds earlier parts of the same plan. Returns the contents of `summary.json`; `None` if `options.share`
/// restricts the computation to a share of the parts, or if the caller cancelled it.
///
/// # Errors
/// [`SweepError`] if the plan needs a state that the model does not have, or a file cannot be read or written. A flight
/// that fails is not an error: its row in the table has a status other than the intended end.
pub fn run(
    plan: &Plan,
    out: &Path,
    options: &SweepOptions<'_>,
) -> Result<Option<Value>, SweepError> {
    let count = plan.parts();
    let parts = match options.share {
        None => 0..count,
        Some(share) => share_of(count, share)?,
    };
    let compiled = CompiledModel::new(&plan.model);
    let state = |name: &str| {
        compiled
            .layout()
            .state(name)
            .map(codegen::layout::StateId::index)
    };
    let position = ["x", "y", "z"].map(state);
    let until_ground = plan.release.stop == Stop::Ground;
    if until_ground && position[2].is_none() {
        return Err(SweepError::NoHeight {
            model: plan.model.name.clone(),
        });
    }
    let about = json!({
        "schema": "hyzer.sweep-parts/1",
        "flights": plan.flights,
        "parts": plan.parts(),
        "flights_per_part": plan.part_len(),
    });
    let folder = PartsFolder::open(out, plan.fingerprint(), about)?;
    if folder.file(FLIGHTS).is_file()
        && let Some(summary) = folder.summary()
    {
        (options.progress)(plan.flights);
        return finish(&folder, plan, options, summary).map(Some);
    }
    let inputs = InputModel::new(plan, &compiled)?;
    let model = LaneModel::new(&plan.model);
    let observer = speed_and_spin(&plan.model).map(|model| LaneObserver::new(&model));
    let flier = Flier {
        plan,
        inputs: &inputs,
        model: &model,
        observer: observer.as_ref(),
        span: FlightSpan {
            t_end: match plan.release.stop {
                Stop::Duration(duration) => duration,
                Stop::Ground => Release::MAX_DURATION,
            },
            height: position[2],
            seeks_apex: true,
            until_ground,
        },
        position,
        has_spin: ThrownModel::new(&plan.model).is_ok_and(|thrown| thrown.has_attitude()),
    };
    let end = u8::from(!until_ground);
    let work = |part: u64| -> Result<Option<Summary>, SweepError> {
        let path = folder.part(part, "parquet");
        let len = (plan.flights - part * plan.part_len()).min(plan.part_len());
        // A part that cannot be read is computed again.
        if let Ok(rows) = table::read(&path, plan.axes.len())
            && rows.status.len() as u64 == len
        {
            return Ok(Some(Summary::of(&rows, end)));
        }
        if (options.is_cancelled)() {
            return Ok(None);
        }
        let rows = flier.fly(part);
        table::write(&path, &rows).map_err(|source| SweepError::Table { path, source })?;
        Ok(Some(Summary::of(&rows, end)))
    };
    let summary = in_order(parts, options, plan, &work)?;
    let (None, Some(summary)) = (options.share, summary) else {
        return Ok(None);
    };
    let flights = folder.file(FLIGHTS);
    let files = (0..count).map(|part| folder.part(part, "parquet"));
    table::join(&flights, files).map_err(|source| SweepError::Table {
        path: flights,
        source,
    })?;
    let mut json = summary.json(plan);
    folder.write_summary(&mut json)?;
    finish(&folder, plan, options, json).map(Some)
}

/// Finishes a completed sweep: removes the files of the parts, writes the CSV if requested, and returns `summary`.
fn finish(
    folder: &PartsFolder,
    plan: &Plan,
    options: &SweepOptions<'_>,
    summary: Value,
) -> Result<Value, SweepError> {
    folder.discard_parts();
    let path = folder.file("flights.csv");
    if options.csv && !path.is_file() {
        table::to_csv(&folder.file(FLIGHTS), &path, plan.axes.len())
            .map_err(|source| SweepError::Table { path, source })?;
    }
    Ok(summary)
}

/// Calls `work` for each part with its number, on several threads, and merges the summaries in the order of the parts.
/// `None` if `parts` is empty; the first error or `None` of `work` that arrives stops all threads.
fn in_order(
    parts: std::ops::Range<u64>,
    options: &SweepOptions<'_>,
    plan: &Plan,
    work: &(dyn Fn(u64) -> Result<Option<Summary>, SweepError> + Sync),
) -> Result<Option<Summary>, SweepError> {
    let threads = options.threads.max(1);
    let next = AtomicU64::new(parts.start);
    let is_stopped = AtomicBool::new(false);
    // The first part that is not merged yet, and a signal of its change.
    let merged = (Mutex::new(parts.start), Condvar::new());
    let (sender, receiver) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..threads {
            let sender = sender.clone();
            let (next, is_stopped, merged, last) = (&next, &is_stopped, &merged, parts.end);
            scope.spawn(move || {
                loop {
                    let part = next.fetch_add(1, Ordering::Relaxed);
                    if part >= last {
                        return;
                    }
                    let ahead = |first: &mut u64| {
                        part >= *first + AHEAD * threads as u64
                            && !is_stopped.load(Ordering::Relaxed)
                    };
                    let first = merged.0.lock().unwrap_or_else(PoisonError::into_inner);
                    drop(merged.1.wait_while(first, ahead));
                    if is_stopped.load(Ordering::Relaxed) {
                        return;
                    }
                    if sender.send((part, work(part))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        let mut waiting = BTreeMap::new();
        let mut total: Option<Summary> = None;
        let mut first = parts.start;
        for (part, summary) in receiver {
            match summary {
                Ok(Some(summary)) => waiting.insert(part, summary),
                stopped => {
                    // Stored under the lock, so that no thread starts to wait between the store and the notification.
                    let lock = merged.0.lock().unwrap_or_else(PoisonError::into_inner);
                    is_stopped.store(true, Ordering::Relaxed);
                    drop(lock);
                    merged.1.notify_all();
                    return stopped;
                }
            };
            let len = plan.part_len();
            (options.progress)((plan.flights - part * len).min(len));
            while let Some(summary) = waiting.remove(&first) {
                match &mut total {
                    Some(total) => total.merge(&summary),
                    None => total = Some(summary),
                }
                first += 1;
            }
            *merged.0.lock().unwrap_or_else(PoisonError::into_inner) = first;
            merged.1.notify_all();
        }
        Ok(total)
    })
}
