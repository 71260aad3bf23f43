//! Command `hyzer bootstrap`: refits to flights drawn with replacement, and the distribution of their estimates.

mod parts;
mod summary;

use analysis::sweep::folder::{PartsFolder, fingerprint, share_of};
use anyhow::{Context, bail};
use dataset::{Dataset, Role};
use identify::{Fit, FitOptions};
use model_spec::model::Model;
use serde_json::{Value, json};

use super::fit::Inputs;
use crate::cli::{Bootstrap, FitInputs};
use crate::progress::{self, Progress};
use crate::{Answer, output};

pub use parts::{refits, table};
pub use summary::{json as summary_json, text};

/// Minimum number of fitted flights for a bootstrap; with fewer flights, drawing with replacement gives too few
/// different samples.
const MIN_FLIGHTS: usize = 5;

/// Runs `hyzer bootstrap`: fits the model, and refits it to flights drawn with replacement. Only the refits that the
/// output folder does not hold yet are computed. Prints the distribution of the estimates over all refits. Returns
/// `Answer::No` if this run completes the refits and the fit to the original flights is not reliable.
pub fn run(options: &Bootstrap) -> anyhow::Result<Answer> {
    let share = options.part.as_deref().map(super::share).transpose()?;
    let inputs = Inputs::read(&options.inputs, None, &[])?;
    let (dataset, model) = (&inputs.dataset, &inputs.model);
    let asked = FitOptions {
        unbounded: options.unbounded,
        ..inputs.options()
    };
    asked.validate()?;
    let count = parts::count(options.refits);
    let parts = match share {
        None => 0..count,
        Some(share) => share_of(count, share)?,
    };
    let begun =
        json!({ "schema": "hyzer.bootstrap-parts/1", "refits": options.refits, "parts": count });
    let folder = PartsFolder::open(&options.out, work(options, dataset, model), begun);
    let folder = folder.context("--out")?;
    if let Some(summary) = folder.summary() {
        output::print(summary::text(&summary))?;
        return Ok(answer(&summary));
    }
    progress::resumes();
    let bar = Progress::new()?;
    let shown = FitOptions {
        progress: Some(&bar),
        ..asked
    };
    let fit = identify::fit(model, dataset, &shown);
    let fit = fit.with_context(|| inputs.failed("fit"))?;
    enough(&fit)?;
    bar.start("refits", (parts.end - parts.start) * parts::LEN);
    let work = parts::Work {
        fit: &fit,
        folder: &folder,
        refits: options.refits,
        seed: options.seed,
        options: &asked,
    };
    let mut refits = Vec::new();
    for part in parts {
        refits.extend(work.part(part, &|done| bar.advance(done))?);
    }
    drop(bar);
    let out = options.out.display();
    if share.is_some() {
        eprintln!(
            "the parts of this share are in {out}; `hyzer bootstrap` without --part joins them when all are there"
        );
        return Ok(Answer::Yes);
    }
    folder.write(&folder.file("refits.csv"), &parts::table(&fit, &refits))?;
    let mut summary = summary::json(&fit, &refits, options.seed);
    folder.write_summary(&mut summary)?;
    folder.discard_parts();
    output::print(summary::text(&summary))?;
    eprintln!("refits.csv and summary.json are in {out}");
    Ok(answer(&summary))
}

/// Refuses a fit to too few flights.
///
/// # Errors
/// With fewer than five fitted flights.
pub fn enough(fit: &Fit) -> anyhow::Result<()> {
    let fitted = flights(fit);
    if fitted < MIN_FLIGHTS {
        bail!(
            "found {fitted} fitted flights, expected at least {MIN_FLIGHTS}: fewer have too few different draws"
        );
    }
    Ok(())
}

/// Whether the fit that was refitted is reliable, by the summary of the bootstrap. If it is not, prints the reasons.
fn answer(summary: &Value) -> Answer {
    if summary["reliable"] == json!(true) {
        return Answer::Yes;
    }
    let why = summary["cautions"].as_array().into_iter().flatten();
    let why: Vec<&str> = why.filter_map(Value::as_str).collect();
    eprintln!("do not rely on this fit: {}", why.join("; "));
    Answer::No
}

/// Number of flights to which `fit` fitted the model, without the excluded flights.
fn flights(fit: &Fit) -> usize {
    fit.report.used(Role::Fit).count()
}

/// Hash of everything on which the estimates of a bootstrap depend: program version, model, options and dataset. A run
/// continues earlier results only if their hash is the same.
fn work(options: &Bootstrap, dataset: &Dataset, model: &Model) -> String {
    let Bootstrap {
        inputs,
        refits,
        seed,
        unbounded,
        ..
    } = options;
    let FitInputs {
        hold,
        free,
        prior,
        trust_data,
        ..
    } = inputs;
    let (version, source) = (env!("CARGO_PKG_VERSION"), codegen::rust::source_hash(model));
    fingerprint(format_args!(
        "hyzer.bootstrap/1 {version} {source:x} {refits} {seed} {hold:?} {free:?} {prior:?} {unbounded} {trust_data} {dataset:?}"
    ))
}
