//! Command `hyzer verify`: runs every independent check of a model.

use model_spec::load::{Loaded, MODELS, inspect};
use model_spec::model::Model;
use verify::Options;
use verify::report::Outcome;

use crate::cli::Verify;
use crate::{Answer, output};

/// Built-in models that describe one motion in different formulations.
const SAME: [&str; 3] = ["disc", "disc_appendix", "disc_quaternion"];

/// Verifies each model; answers no if any check of any model fails, and undecided if none fails and some that apply could
/// not be made.
pub fn run(options: &Verify) -> anyhow::Result<Answer> {
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
    let mut outcome = Outcome::Verified;
    let mut reports = Vec::new();
    let mut models: Vec<Model> = Vec::new();
    for name in names {
        let loaded = inspect(name, &super::names(&options.with))?;
        if loaded.model.is_none() {
            refuse(&loaded);
            outcome = Outcome::Refuted;
            continue;
        }
        let report = verify::run(&loaded, &settings);
        let model = loaded.model.as_ref().filter(|_| options.rounding);
        let rounding = model.map(|model| verify::rounding(model, &settings));
        outcome = outcome.max(report.outcome());
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
        models.extend(
            loaded
                .model
                .filter(|model| SAME.contains(&model.name.as_str())),
        );
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
    Ok(match outcome {
        Outcome::Verified => Answer::Yes,
        Outcome::Refuted => Answer::No,
        Outcome::NotVerified => Answer::Undecided,
    })
}

fn refuse(loaded: &Loaded) {
    let text = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
    eprint!("{text}");
}
