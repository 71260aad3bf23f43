//! Command `hyzer verify`: runs every independent check of a model.

use std::path::Path;

use model_spec::load::{Loaded, MODELS, inspect};
use model_spec::model::Model;
use verify::Options;
use verify::certificate::{Certificate, CertifiedModel, folder_of};
use verify::report::Outcome;

use super::certificate;
use crate::cli::Verify;
use crate::{Answer, output};

/// Built-in models that describe the same motion in different formulations, which `hyzer verify` compares with each
/// other.
const SAME: [&str; 3] = ["disc", "disc_appendix", "disc_quaternion"];

/// Runs `hyzer verify`: verifies each model. Returns `Answer::No` if any check of any model fails, and
/// `Answer::Undecided` if none fails but some applicable checks could not be made. With `--check`, answers whether a
/// certificate is still valid.
pub fn run(options: &Verify) -> anyhow::Result<Answer> {
    if let Some(path) = &options.check {
        return certificate::check(path, options.again, options.json, is_same);
    }
    if options.cases == 0 || options.cases > 100_000 {
        anyhow::bail!("--cases: found {}, expected 1 to 100000", options.cases);
    }
    let all = options.models.is_empty();
    let names: Vec<&str> = match all {
        true => MODELS.iter().map(|(name, _)| *name).collect(),
        false => options.models.iter().map(String::as_str).collect(),
    };
    let settings = Options {
        seed: options.seed,
        cases: options.cases,
        mutants: options.mutants,
        ..Options::default()
    };
    let with = super::names(&options.with);
    let mut outcome = Outcome::Verified;
    let mut reports = Vec::new();
    let mut models: Vec<Model> = Vec::new();
    let mut certified: Vec<CertifiedModel> = Vec::new();
    let mut refused = Vec::new();
    for name in names {
        let loaded = inspect(name, &with)?;
        if loaded.model.is_none() {
            refuse(&loaded);
            outcome = Outcome::Refuted;
            refused.push(name);
            continue;
        }
        let report = verify::run(&loaded, &settings);
        let model = loaded.model.as_ref().filter(|_| options.rounding);
        let rounding = model.map(|model| verify::rounding(model, &settings));
        outcome = outcome.max(report.outcome());
        if let Some(path) = &options.certificate {
            let folder = folder_of(path);
            certified.extend(CertifiedModel::new(&folder, name, &with, &loaded, &report));
        }
        if options.json {
            let mut value = serde_json::to_value(&report)?;
            value["outcome"] = serde_json::to_value(report.outcome())?;
            if let Some(rounding) = rounding {
                value["rounding"] = serde_json::to_value(rounding)?;
            }
            reports.push(value);
        } else {
            output::print(report.table())?;
            if let Some(rounding) = rounding {
                output::print(format!("\n{}", rounding.table()))?;
            }
        }
        models.extend(loaded.model.filter(is_same));
    }
    let same = (models.len() > 1).then(|| verify::same_motion(&models, &settings));
    if same.as_ref().is_some_and(|same| !same.holds()) {
        outcome = Outcome::Refuted;
    }
    if options.json {
        let holds = outcome != Outcome::Refuted;
        let value = serde_json::json!({
            "holds": holds, "outcome": outcome, "models": reports, "same_motion": same
        });
        output::print(serde_json::to_string_pretty(&value)? + "\n")?;
    } else if let Some(same) = &same {
        output::print(same.table())?;
    }
    if let Some(path) = &options.certificate {
        let written = Certificate::new(&settings, certified, same.as_ref());
        write(path, &written, &refused)?;
    }
    Ok(match outcome {
        Outcome::Verified => Answer::Yes,
        Outcome::Refuted => Answer::No,
        Outcome::NotVerified => Answer::Undecided,
    })
}

fn is_same(model: &Model) -> bool {
    SAME.contains(&model.name.as_str())
}

/// Writes a certificate to `path`. If `refused`, the names of the models whose text has errors, is not empty, writes no
/// file, says so on standard error and returns `Ok`.
fn write(path: &Path, certificate: &Certificate, refused: &[&str]) -> anyhow::Result<()> {
    if !refused.is_empty() {
        eprintln!("no certificate is written: {} refused", refused.join(", "));
        return Ok(());
    }
    output::write(path, certificate.text())?;
    eprintln!("{}: {}", path.display(), certificate.summary());
    Ok(())
}

fn refuse(loaded: &Loaded) {
    let text = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
    eprint!("{text}");
}
