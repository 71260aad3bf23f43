//! Runs a sweep: computes the parts on several threads, writes each part to a file, and skips parts whose file
//! exists.
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use flight::parallel::each_on;
use flight::release::{Release, ReleaseError, Stop};
use flight::throw::{ThrowError, ThrownModel, speed_and_spin};
use flight::{CompiledModel, LaneModel, LaneObserver};
use ode::FlightSpan;
use parquet::errors::ParquetError;
use serde_json::{Value, json};

use crate::sweep::folder::{FolderError, PartsFolder, share_of};
use crate::sweep::inputs::InputModel;
use crate::sweep::plan::Plan;
use crate::sweep::rows::Flier;
use crate::sweep::summary::Summary;
use crate::sweep::table;

/// Reason why a sweep cannot be computed or its results cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The plan has faults; the message lists all of them.
    #[error(transparent)]
    Plan(#[from] ReleaseError),
    /// No state of the model has the motion of the table `[throw]`.
    #[error(transparent)]
    Throw(#[from] ThrowError),
    /// The flights end at the ground, but no state of the model is a height.
    #[error(
        "no state of the model {model} is a height, whose fall to 0 is the landing; expected a plan with duration = … (s)"
    )]
    NoHeight {
        /// Name of the model.
        model: String,
    },
    /// The number of threads is 0.
    #[error("the number of threads is 0, expected at least 1")]
    NoThreads,
    /// The output folder cannot be used.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A table of flights cannot be read or written.
    #[error("{}: {source}", path.display())]
    Table {
        /// Path of the table.
        path: PathBuf,
        /// Error of reading or writing.
        source: ParquetError,
    },
}

impl SweepError {
    fn of_table(path: &Path) -> impl FnOnce(ParquetError) -> SweepError {
        let path = path.to_path_buf();
        |source| SweepError::Table { path, source }
    }
}

/// Options of a sweep; none of them affects the results.
#[derive(Clone, Copy)]
pub struct SweepOptions<'a> {
    /// Number of threads; at least 1.
    pub threads: usize,
    /// Share of the parts to compute, its number from 1 and the number of shares; `None` for all, joined.
    pub share: Option<(u64, u64)>,
    /// Whether the table of flights is also written as CSV.
    pub csv: bool,
    /// Called after each part, with its number of flights.
    pub progress: &'a (dyn Fn(u64) + Sync),
    /// Whether to stop, asked before each part; the parts computed until then are kept.
    pub is_cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// Parts per thread that are computed before they are merged; bounds the memory.
const AHEAD: u64 = 8;

const FLIGHTS: &str = "flights.parquet";

/// Simulates the flights of a plan and writes `flights.parquet` and `summary.json` to the folder `out`, which is new,
/// empty or holds earlier parts of the same plan. Returns the summary; `None` for a share, or if the caller cancelled.
///
/// # Errors
/// [`SweepError`] if the number of threads is 0, the plan needs a state that the model does not have, or a file cannot be
/// read or written. A flight that fails is not an error: its row in the table has a status other than the intended end.
pub fn run(
    plan: &Plan,
    out: &Path,
    options: &SweepOptions<'_>,
) -> Result<Option<Value>, SweepError> {
    if options.threads == 0 {
        return Err(SweepError::NoThreads);
    }
    let count = plan.parts();
    let parts = match options.share {
        None => 0..count,
        Some(share) => share_of(count, share)?,
    };
    let compiled = CompiledModel::new(&plan.model);
    let position = compiled.place();
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
    let folder = PartsFolder::open(out, plan.fingerprint(), about, options.share.is_some())?;
    if folder.file(FLIGHTS).is_file()
        && let Some(summary) = folder.summary()
    {
        (options.progress)(plan.flights);
        return finish(&folder, plan, options, summary).map(Some);
    }
    let inputs = InputModel::new(plan, &compiled)?;
    let release = compiled.release_parameters(&plan.release);
    let model = LaneModel::new(&plan.model).with_inputs(release.inputs);
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
        table::write(&path, &rows).map_err(SweepError::of_table(&path))?;
        Ok(Some(Summary::of(&rows, end)))
    };
    let summary = in_order(parts, options, plan, &work)?;
    let (None, Some(summary)) = (options.share, summary) else {
        return Ok(None);
    };
    let flights = folder.file(FLIGHTS);
    let files = (0..count).map(|part| folder.part(part, "parquet"));
    table::join(&flights, files).map_err(SweepError::of_table(&flights))?;
    let mut json = summary.json(plan);
    folder.write_summary(&mut json)?;
    finish(&folder, plan, options, json).map(Some)
}

/// Landing places, m, of about `most` of the flights that landed, from the finished sweep of `plan` in the folder `out`.
///
/// # Errors
/// [`SweepError::Table`] if the table of flights cannot be read.
pub fn landings(plan: &Plan, out: &Path, most: usize) -> Result<Vec<[f64; 2]>, SweepError> {
    let path = out.join(FLIGHTS);
    table::landings(&path, plan.axes.len(), most).map_err(SweepError::of_table(&path))
}

/// Removes the files of the parts, and writes the CSV if requested.
fn finish(
    folder: &PartsFolder,
    plan: &Plan,
    options: &SweepOptions<'_>,
    summary: Value,
) -> Result<Value, SweepError> {
    folder.discard_parts();
    let path = folder.file("flights.csv");
    if options.csv && !path.is_file() {
        let table = folder.file(FLIGHTS);
        table::to_csv(&table, &path, plan.axes.len()).map_err(SweepError::of_table(&path))?;
    }
    Ok(summary)
}

/// Computes the parts on several threads, and merges their summaries in order; `None` if `work` stops.
fn in_order(
    parts: std::ops::Range<u64>,
    options: &SweepOptions<'_>,
    plan: &Plan,
    work: &(dyn Fn(u64) -> Result<Option<Summary>, SweepError> + Sync),
) -> Result<Option<Summary>, SweepError> {
    let threads = options.threads;
    let is_stopped = AtomicBool::new(false);
    let mut total: Option<Summary> = None;
    for first in parts.clone().step_by(AHEAD as usize * threads) {
        let count = (parts.end - first).min(AHEAD * threads as u64);
        let summaries = each_on(threads, count as usize, |i| {
            if is_stopped.load(Ordering::Relaxed) {
                return Ok(None);
            }
            let part = first + i as u64;
            let summary = work(part);
            if matches!(summary, Ok(Some(_))) {
                let len = plan.part_len();
                (options.progress)((plan.flights - part * len).min(len));
            } else {
                is_stopped.store(true, Ordering::Relaxed);
            }
            summary
        });
        // An error is reported although parts before it were left out because of it.
        let summaries = summaries.into_iter().collect::<Result<Vec<_>, _>>()?;
        for summary in summaries {
            let Some(summary) = summary else {
                return Ok(None);
            };
            match &mut total {
                Some(total) => total.merge(&summary),
                None => total = Some(summary),
            }
        }
    }
    Ok(total)
}
