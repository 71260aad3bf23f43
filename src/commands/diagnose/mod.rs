//! Command `hyzer diagnose`: tests a model for missing effects and extends the model.

mod summary;
mod tables;

use std::path::Path;

use ::diagnose::{Diagnosis, DiagnosisOptions, diagnose_with};
use ::diagnose::{Verdict, Verified};
use anyhow::Context;
use codegen::backend::SourceFile;
use identify::{Fit, FitOptions, dataset};
use report::diagnosis::DiagnosisPage;

use super::fit::{drawn, held, model_of, priors};
use crate::cli::Diagnose;
use crate::progress::Progress;
use crate::{Answer, output};

/// File name of the extended model.
const EXTENDED: &str = "extended.hyz";

/// Random states for each check of the extended model; `hyzer verify` uses more.
const CASES: usize = 12;

/// Diagnoses the model, prints a summary, and writes the report files.
pub fn run(options: &Diagnose) -> anyhow::Result<Answer> {
    let progress = Progress::new()?;
    let (hold, priors) = (held(&options.hold)?, priors(&options.prior)?);
    let dataset = dataset::load(&options.dataset)?;
    let model = model_of(options.model.as_ref(), &options.dataset, &dataset)?;
    let model = model_spec::load::load(&model, &super::names(&options.with))?;
    let name = options.dataset.file_name().map_or_else(
        || options.dataset.display().to_string(),
        |name| name.to_string_lossy().into_owned(),
    );
    let asked = DiagnosisOptions {
        dataset: &name,
        without: &options.without,
        fit: FitOptions {
            fixed: &hold,
            free: &options.free,
            priors: &priors,
            trust_data: options.trust_data,
            threads: options.threads,
            progress: Some(&progress),
            cancellation: Some(progress.cancellation()),
            ..FitOptions::default()
        },
        ..DiagnosisOptions::default()
    };
    progress.working();
    asked
        .validate(&model)
        .map_err(|error| anyhow::anyhow!("--without: {error}"))?;
    let found = diagnose_with(&model, &dataset, &asked, |extension| {
        let told = format!(
            "Extended by {}, found in {name} by `hyzer diagnose`.",
            extension.effects.join(" and ")
        );
        extended(&extension.text(&told))
    });
    progress.writing();
    let (mut found, extended) =
        found.with_context(|| format!("cannot diagnose {}", options.dataset.display()))?;
    let extended = extended.transpose()?;
    found.report.verified = extended.as_ref().map(|extended| extended.verified.clone());
    if let Some(folder) = &options.out {
        if extended.is_some() {
            found.report.extended_model = Some(EXTENDED.to_owned());
        }
        write(folder, extended.as_ref(), &found)?;
    }
    output::print(summary::summary(&found.report))?;
    if found.report.verified.as_ref().is_some_and(|v| !v.holds) {
        eprintln!("a check refutes the extended model: do not rely on it");
        return Ok(Answer::No);
    }
    Ok(Answer::Yes)
}

/// Extended model with its verification and generated code.
struct Extended {
    /// Text of the extended model in the model language.
    text: String,
    /// Results of the independent checks of the extended model.
    verified: Verified,
    /// Generated Rust source files of the extended model.
    code: Vec<SourceFile>,
}

/// Verifies an extended model, given as text, and generates its code.
fn extended(text: &str) -> anyhow::Result<Extended> {
    let loaded = model_spec::load::inspect_text(EXTENDED, text, &[])?;
    let model = match &loaded.model {
        Some(model) if loaded.diagnostics.is_empty() => model,
        _ => {
            let told = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
            anyhow::bail!("the extended model is faulty:\n{told}");
        }
    };
    let settings = verify::Options {
        cases: CASES,
        mutants: false,
        // Effects that could still be added are not part of the extended model.
        effects: false,
        ..verify::Options::default()
    };
    let report = verify::run(&loaded, &settings);
    let checks = report.rows.iter().map(|row| {
        (
            row.check.to_string(),
            format!("{:?}", row.verdict).to_lowercase(),
        )
    });
    Ok(Extended {
        verified: Verified {
            holds: report.refuted.is_empty() && report.holds(),
            checks: checks.collect(),
        },
        code: codegen::rust::emit(&codegen::compile::compile(model), model),
        text: text.to_owned(),
    })
}

fn write(folder: &Path, extended: Option<&Extended>, found: &Diagnosis) -> anyhow::Result<()> {
    let evidence = |fitted: &Fit, flights: &[usize]| {
        let each = flights
            .iter()
            .filter_map(|&flight| fitted.evidence(identify::FlightId::new(flight)));
        each.collect::<Vec<_>>()
    };
    let flights = drawn(&found.before);
    let before = evidence(&found.before, &flights);
    let after = found.after.as_ref();
    let after = after.map_or_else(Vec::new, |(_, fitted)| evidence(fitted, &flights));
    if let (Some(extended), Some((extension, _))) = (extended, &found.after) {
        output::write(&folder.join(EXTENDED), &extended.text)?;
        for effect in &extension.written {
            let name = extension
                .effects
                .iter()
                .find(|name| effect.contains(&format!("effect {name} ")));
            if let Some(name) = name {
                output::write(&folder.join(format!("{name}.hyz")), effect)?;
            }
        }
        for file in &extended.code {
            output::write(&folder.join("extended").join(&file.path), &file.text)?;
        }
    }
    let json = serde_json::to_string_pretty(&found.report)?;
    output::write(&folder.join("report.json"), json + "\n")?;
    let page = DiagnosisPage {
        report: &found.report,
        before: &before,
        after: &after,
        extended: extended.map(|extended| extended.text.as_str()),
    };
    let made = report::diagnosis::make(&page);
    output::write(&folder.join("report.html"), made.html)?;
    for (name, figure) in made.figures {
        output::write(&folder.join(name), figure)?;
    }
    output::write(
        &folder.join("candidates.csv"),
        tables::candidates(&found.report)?,
    )?;
    output::write(
        &folder.join("coefficients.csv"),
        tables::coefficients(&found.report)?,
    )?;
    output::write(&folder.join("flights.csv"), tables::flights(&found.report)?)?;
    let what = match found.report.verdict {
        Verdict::None => "report.html, report.json, figures and tables are",
        _ if extended.is_some() => {
            "report.html, report.json, the extended model, figures and tables are"
        }
        _ => "report.html, report.json, figures and tables are",
    };
    eprintln!("{what} in {}", folder.display());
    Ok(())
}
