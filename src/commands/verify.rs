//! Command `hyzer verify`: runs every independent check of a model.

use std::path::Path;

use anyhow::{Context, ensure};
use flight::files::bounded_text;
use model_spec::load::{Loaded, MODELS, inspect};
use model_spec::model::Model;
use serde_json::{Value, json};
use verify::record::{self, Record};
use verify::report::Outcome;
use verify::{Options, Report};

use crate::cli::Verify;
use crate::{Answer, output};

/// Built-in models of the same motion, which are compared with each other.
const SAME: [&str; 3] = ["disc", "disc_appendix", "disc_quaternion"];

/// A model to be verified: name or path, effects, and what was loaded.
struct Candidate<'a> {
    source: &'a str,
    with: Vec<&'a str>,
    loaded: Loaded,
}

/// Runs `hyzer verify`. `Answer::No` if a check fails, `Answer::Undecided` if none fails and one that applies could not be
/// made; with `--check`, whether an earlier verification has the same hashes and verdicts.
pub(super) fn run(options: &Verify) -> anyhow::Result<Answer> {
    if let Some(path) = &options.check {
        return check(path, options.json);
    }
    check_cases("--cases", options.cases)?;
    let names: Vec<&str> = if options.models.is_empty() {
        MODELS.iter().map(|(name, _)| *name).collect()
    } else {
        options.models.iter().map(String::as_str).collect()
    };
    let settings = Options {
        seed: options.seed,
        cases: options.cases,
        mutants: options.mutants,
        ..Options::default()
    };
    let with = super::names(&options.with);
    let candidate = |source| -> anyhow::Result<Candidate<'_>> {
        Ok(Candidate {
            source,
            with: with.clone(),
            loaded: inspect(source, &with)?,
        })
    };
    let candidates = names.into_iter().map(candidate);
    let candidates = candidates.collect::<anyhow::Result<Vec<_>>>()?;
    let (outcome, value) = verify_all(candidates, &settings, options.rounding, !options.json)?;
    if options.json {
        output::print(serde_json::to_string_pretty(&value)? + "\n")?;
    }
    Ok(match outcome {
        Outcome::Verified => Answer::Yes,
        Outcome::Refuted => Answer::No,
        Outcome::NotVerified => Answer::Undecided,
    })
}

/// Verifies models, prints their tables if `print`, and returns the worst outcome and the verification as JSON.
fn verify_all(
    candidates: Vec<Candidate<'_>>,
    settings: &Options,
    rounding: bool,
    print: bool,
) -> anyhow::Result<(Outcome, Value)> {
    let mut outcome = Outcome::Verified;
    let mut values = Vec::new();
    let mut same: Vec<Model> = Vec::new();
    for candidate in candidates {
        let Some(model) = &candidate.loaded.model else {
            refuse(&candidate.loaded);
            outcome = Outcome::Refuted;
            continue;
        };
        let report = verify::run(&candidate.loaded, settings);
        outcome = outcome.max(report.outcome());
        let mut value = of_model(&candidate, model, &report)?;
        if print {
            output::print(report.table())?;
        }
        if rounding {
            let rounding = verify::rounding(model, settings);
            if print {
                output::print(format!("\n{}", rounding.table()))?;
            }
            value["rounding"] = serde_json::to_value(rounding)?;
        }
        values.push(value);
        let of_group = |model: &Model| SAME.contains(&model.name.as_str());
        same.extend(candidate.loaded.model.filter(of_group));
    }
    let same = (same.len() > 1).then(|| verify::same_motion(&same, settings));
    if same.as_ref().is_some_and(|same| !same.holds()) {
        outcome = Outcome::Refuted;
    }
    if let Some(same) = same.as_ref().filter(|_| print) {
        output::print(same.table())?;
    }
    let value = json!({
        "schema": record::SCHEMA,
        "program": env!("CARGO_PKG_VERSION"),
        "seed": settings.seed,
        "cases": settings.cases,
        "mutants": settings.mutants,
        "holds": outcome != Outcome::Refuted,
        "outcome": outcome,
        "models": values,
        "same_motion": same,
    });
    Ok((outcome, value))
}

/// The verification of one model as JSON, with the hashes of text and code.
fn of_model(
    candidate: &Candidate<'_>,
    model: &Model,
    report: &Report,
) -> serde_json::Result<Value> {
    let mut value = serde_json::to_value(report)?;
    value["outcome"] = serde_json::to_value(report.outcome())?;
    value["source"] = json!(candidate.source);
    value["with"] = json!(candidate.with);
    value["text_sha256"] = json!(record::text_hash(&candidate.loaded.sources));
    value["code_sha256"] = json!(record::code_hash(model));
    Ok(value)
}

/// Repeats the verification whose JSON is in a file, and prints the differences of hashes and verdicts.
fn check(path: &Path, json: bool) -> anyhow::Result<Answer> {
    let shown = path.display();
    let record = read(path).with_context(|| format!("--check: {shown}"))?;
    let settings = Options {
        seed: record.seed,
        cases: record.cases,
        mutants: record.mutants,
        ..Options::default()
    };
    let mut candidates = Vec::new();
    for model in &record.models {
        let with = super::names(&model.with);
        match inspect(&model.source, &with) {
            Ok(loaded) => candidates.push(Candidate {
                source: &model.source,
                with,
                loaded,
            }),
            Err(error) => eprintln!("{error}"),
        }
    }
    let (_, now) = verify_all(candidates, &settings, false, false)?;
    let differences = record.differences(&Record::parse(&now.to_string())?);
    let agrees = differences.is_empty();
    output::print(if json {
        let value = json!({ "agrees": agrees, "differences": differences });
        serde_json::to_string_pretty(&value)? + "\n"
    } else if agrees {
        format!("{shown}: hashes and verdicts agree\n")
    } else {
        differences.join("\n") + "\n"
    })?;
    Ok(Answer::of(agrees))
}

fn read(path: &Path) -> anyhow::Result<Record> {
    let text = bounded_text(path, record::MAX_BYTES, record::WHAT).map_err(anyhow::Error::msg)?;
    let record = Record::parse(&text)?;
    check_cases("cases", record.cases)?;
    Ok(record)
}

fn check_cases(what: &str, cases: usize) -> anyhow::Result<()> {
    ensure!(
        (1..=100_000).contains(&cases),
        "{what}: found {cases}, expected 1 to 100000"
    );
    Ok(())
}

fn refuse(loaded: &Loaded) {
    let text = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
    eprint!("{text}");
}
