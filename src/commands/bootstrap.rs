//! Command `hyzer bootstrap`: refits to flights drawn with replacement, and the distribution of their estimates.

mod summary;

use std::fs;
use std::path::Path;

use analysis::sweep::folder::{PartsFolder, fingerprint, share_of};
use anyhow::{Context, ensure};
use dataset::{Dataset, Role};
use identify::{Fit, FitError, FitOptions};
use model_spec::model::Model;
use report::CsvTable;
use serde_json::{Value, json};

use super::fit::{Inputs, overruled_by, reliable};
use crate::cli::Bootstrap;
use crate::progress::{self, Progress};
use crate::{Answer, output};

pub use summary::{json as summary_json, text};

/// Number of refits of a part; the last may have fewer.
const LEN: u64 = 16;
/// Minimum number of fitted flights; fewer have too few different draws.
const MIN_FLIGHTS: usize = 5;

/// Runs `hyzer bootstrap`. `Answer::No` if all refits are done and the fit to the original flights is not reliable.
pub(super) fn run(options: &Bootstrap) -> anyhow::Result<Answer> {
    let share = options.part.as_deref().map(super::share).transpose()?;
    let inputs = Inputs::read(&options.inputs, None)?;
    let (dataset, model) = (&inputs.dataset, &inputs.model);
    let asked = FitOptions {
        unbounded: options.unbounded,
        ..inputs.options()
    };
    asked.validate()?;
    for note in overruled_by(model, dataset) {
        eprintln!("note: {note}");
    }
    progress::resumes();
    let bar = Progress::new()?;
    let shown = FitOptions {
        progress: Some(&bar),
        ..asked
    };
    let fit = || {
        let fit = identify::fit(model, dataset, &shown);
        fit.with_context(|| inputs.failed("fit"))
    };
    let parts = Parts {
        out: &options.out,
        fingerprint: fingerprint_of(&asked, options.refits, options.seed, dataset, model),
        refits: options.refits,
        seed: options.seed,
        share,
        options: &asked,
        begin: &|refits| bar.start("refits", refits),
        progress: &|done| bar.advance(done),
    };
    let summary = in_parts(&parts, fit)?;
    drop(bar);
    let out = options.out.display();
    let Some(summary) = summary else {
        eprintln!(
            "the parts of this share are in {out}; `hyzer bootstrap` without --part joins them when all are there"
        );
        return Ok(Answer::Yes);
    };
    output::print(summary::text(&summary))?;
    eprintln!("refits.csv and summary.json are in {out}");
    Ok(answer(&summary))
}

/// Refits that are done part by part in a folder.
pub struct Parts<'a> {
    /// The folder.
    pub out: &'a Path,
    /// Hash of everything on which the estimates depend.
    pub fingerprint: String,
    /// Number of refits.
    pub refits: u64,
    /// Seed of the draws.
    pub seed: u64,
    /// Share of the refits to do: its number from 1, and the number of shares; `None` for all.
    pub share: Option<(u64, u64)>,
    /// Options of the refits.
    pub options: &'a FitOptions<'a>,
    /// Called with the number of refits before the first.
    pub begin: &'a (dyn Fn(u64) + Sync),
    /// Called with the number of refits finished since its last call.
    pub progress: &'a (dyn Fn(u64) + Sync),
}

/// Refits a share, kept in the folder; without a share, joins all and returns their summary, or an earlier one.
///
/// # Errors
/// If the folder belongs to other work or cannot be written, or a fit fails.
pub fn in_parts(
    asked: &Parts<'_>,
    fit: impl FnOnce() -> anyhow::Result<Fit>,
) -> anyhow::Result<Option<Value>> {
    let count = asked.refits.div_ceil(LEN);
    let parts = match asked.share {
        None => 0..count,
        Some(share) => share_of(count, share)?,
    };
    let begun =
        json!({ "schema": "hyzer.bootstrap-parts/1", "refits": asked.refits, "parts": count });
    let is_share = asked.share.is_some();
    let folder = PartsFolder::open(asked.out, asked.fingerprint.clone(), begun, is_share);
    let folder = folder.context("--out")?;
    if let Some(summary) = folder.summary() {
        return Ok(Some(summary));
    }
    let fit = fit()?;
    enough(&fit)?;
    (asked.begin)((parts.end - parts.start) * LEN);
    let mut refits = Vec::new();
    for part in parts {
        refits.extend(self::part(part, &fit, &folder, asked)?);
    }
    if asked.share.is_some() {
        return Ok(None);
    }
    folder.write(&folder.file("refits.csv"), &table(&fit, &refits))?;
    let mut summary = summary::json(&fit, &refits, asked.seed);
    folder.write_summary(&mut summary)?;
    folder.discard_parts();
    Ok(Some(summary))
}

/// Refuses a fit to too few flights, fewer than five.
///
/// # Errors
/// If there are too few.
pub fn enough(fit: &Fit) -> anyhow::Result<()> {
    let fitted = flights(fit);
    ensure!(
        fitted >= MIN_FLIGHTS,
        "found {fitted} fitted flights, expected at least {MIN_FLIGHTS}: fewer have too few different draws"
    );
    Ok(())
}

/// Whether the fit is reliable by the summary of the bootstrap; prints the reasons if it is not.
fn answer(summary: &Value) -> Answer {
    let why = summary["cautions"].as_array().into_iter().flatten();
    let why: Vec<String> = why.filter_map(Value::as_str).map(str::to_owned).collect();
    reliable("fit", summary["reliable"] == json!(true), &why)
}

fn flights(fit: &Fit) -> usize {
    fit.report.used(Role::Fit).count()
}

/// Hash of everything on which the estimates depend; only a run with the same hash continues earlier results.
pub fn fingerprint_of(
    options: &FitOptions<'_>,
    refits: u64,
    seed: u64,
    dataset: &Dataset,
    model: &Model,
) -> String {
    let (version, source) = (env!("CARGO_PKG_VERSION"), codegen::rust::source_hash(model));
    let (hold, free, prior) = (options.fixed, options.free, options.priors);
    let (unbounded, trust_data) = (options.unbounded, options.trust_data);
    fingerprint(format_args!(
        "hyzer.bootstrap/1 {version} {source:x} {refits} {seed} {hold:?} {free:?} {prior:?} {unbounded} {trust_data} {dataset:?}"
    ))
}

/// Number of a refit and the estimates of the common parameters, SI; `None` if it did not converge.
pub type Refit = (u64, Option<Vec<f64>>);

/// The refits of a part, read from its file or else computed and written.
fn part(
    part: u64,
    fit: &Fit,
    folder: &PartsFolder,
    asked: &Parts<'_>,
) -> anyhow::Result<Vec<Refit>> {
    let numbers = part * LEN..((part + 1) * LEN).min(asked.refits);
    let path = folder.part(part, "csv");
    // A part that cannot be read is computed again.
    if let Some(refits) = read(&path, fit.problem().globals.len())
        && refits.iter().map(|refit| refit.0).eq(numbers.clone())
    {
        (asked.progress)(numbers.end - numbers.start);
        return Ok(refits);
    }
    let refits = refits(fit, asked.seed, numbers, asked.options, asked.progress)?;
    folder.write(&path, &table(fit, &refits))?;
    Ok(refits)
}

/// The refits with the given numbers; `progress` is called with the number finished since its last call.
///
/// # Errors
/// If a refit fails for another reason than that it does not converge.
pub fn refits(
    fit: &Fit,
    seed: u64,
    numbers: std::ops::Range<u64>,
    options: &FitOptions<'_>,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Refit>, FitError> {
    // One thread per refit: refits in parallel are faster than the flights of one refit in parallel.
    let alone = FitOptions {
        threads: Some(1),
        ..*options
    };
    let len = (numbers.end - numbers.start) as usize;
    let done = flight::parallel::each_on(options.threads(), len, |i| {
        let number = numbers.start + i as u64;
        let estimates = fit.bootstrap(seed, number, &alone)?;
        progress(1);
        let estimates = estimates.map(|estimates| estimates.iter().copied().collect());
        Ok((number, estimates))
    });
    done.into_iter().collect()
}

/// CSV table of refits: number, whether it converged, and the estimates, SI, with all digits.
pub fn table(fit: &Fit, refits: &[Refit]) -> String {
    let mut table = CsvTable::of(refits)
        .column("refit", |(number, _)| *number)
        .column("converged", |(_, estimates)| estimates.is_some());
    for (i, global) in fit.problem().globals.iter().enumerate() {
        table = table.optional(&global.name, |(_, estimates)| {
            estimates.as_ref().map(|all| format!("{:?}", all[i]))
        });
    }
    table.text()
}

/// Reads refits with `width` estimates each; `None` if there is no such table.
fn read(path: &Path, width: usize) -> Option<Vec<Refit>> {
    let text = fs::read_to_string(path).ok()?;
    let row = |line: &str| {
        let mut cells = line.split(',');
        let number = cells.next()?.parse().ok()?;
        if cells.next()? == "false" {
            return Some((number, None));
        }
        let estimates: Option<Vec<f64>> = cells.map(|cell| cell.parse().ok()).collect();
        let estimates = estimates.filter(|all| all.len() == width)?;
        Some((number, Some(estimates)))
    };
    text.lines().skip(1).map(row).collect()
}
