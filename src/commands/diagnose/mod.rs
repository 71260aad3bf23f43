//! Command `hyzer diagnose`: tests a model for missing effects and extends the model.

use ::diagnose::{Diagnosis, DiagnosisOptions, ExtendedModel, Verified, diagnose};
use anyhow::Context;
use codegen::generate::generate_with;
use dataset::Dataset;
use flight::files::ResultFile;
use identify::FitOptions;
use model_spec::model::Model;
use report::diagnosis::{DiagnosisPage, Fits, tables};
use report::viewer::View;

use super::fit::{FLIGHTS, Inputs, deadline, drawn, evidence, overruled_by, reliable};
use crate::cli::Diagnose;
use crate::progress::Progress;
use crate::{Answer, output};

const EXTENDED: &str = "extended.hyz";

const CODE: &str = "extended";

/// Number of random states for each check of the extended model; `hyzer verify` uses more.
const CASES: usize = 12;

/// Runs `hyzer diagnose`. `Answer::No` if there are reasons not to rely on the diagnosis.
pub(super) fn run(options: &Diagnose) -> anyhow::Result<Answer> {
    let deadline = deadline(options.max_seconds)?;
    let out = output::results(options.out.as_deref(), &options.figures, &options.tables)?;
    let inputs = Inputs::read(&options.inputs, out)?;
    let (dataset, model, name) = (&inputs.dataset, &inputs.model, &inputs.name);
    let progress = Progress::new()?;
    let asked = DiagnosisOptions {
        dataset: name,
        without: &options.without,
        fit: FitOptions {
            deadline,
            progress: Some(&progress),
            ..inputs.options()
        },
        ..DiagnosisOptions::default()
    };
    let checked = asked.validate(model);
    checked.map_err(|error| anyhow::anyhow!("--without: {error}"))?;
    let found = diagnosis(model, dataset, &asked);
    drop(progress);
    let mut found = found.with_context(|| inputs.failed("diagnose"))?;
    if let Some(out) = &inputs.out {
        let extended = found.after.as_ref().map_or("", |_| "the extended model, ");
        let what = format!("report.html, report.json, {extended}figures and tables");
        out.write(files(&mut found, dataset)?, &what)?;
    }
    output::print(report::diagnosis::text(&found.report))?;
    Ok(reliable(
        "diagnosis",
        found.report.reliable,
        &found.report.cautions,
    ))
}

/// Diagnoses a model, and verifies its extension.
///
/// # Errors
/// Those of [`diagnose()`], or if the extended model is faulty.
pub fn diagnosis(
    model: &Model,
    dataset: &Dataset,
    options: &DiagnosisOptions<'_>,
) -> anyhow::Result<Diagnosis> {
    let mut found = diagnose(model, dataset, options)?;
    if let Some((extension, _)) = &found.after {
        let text = extension.text(&note(&extension.effects, options.dataset));
        found.set_verified(Some(verified(&text)?));
    }
    found.report.notes.extend(overruled_by(model, dataset));
    Ok(found)
}

/// Sentence in the documentation of an extended model.
fn note(effects: &[String], dataset: &str) -> String {
    let effects = effects.join(" and ");
    format!("Extended by {effects}, found in {dataset} by `hyzer diagnose`.")
}

/// Runs the checks of `hyzer verify` on the text of an extended model.
fn verified(text: &str) -> anyhow::Result<Verified> {
    let loaded = model_spec::load::inspect_text(EXTENDED, text, &[])?;
    if loaded.model.is_none() || !loaded.diagnostics.is_empty() {
        let faults = model_spec::render(&loaded.diagnostics, &loaded.sources, false);
        anyhow::bail!("the extended model is faulty:\n{faults}");
    }
    let settings = verify::Options {
        cases: CASES,
        mutants: false,
        // Effects that could still be added are not part of the extended model.
        effects: false,
        ..verify::Options::default()
    };
    let report = verify::run(&loaded, &settings);
    let checks = report.rows.iter().map(|row| {
        let verdict = format!("{:?}", row.verdict).to_lowercase();
        (row.check.to_string(), verdict)
    });
    Ok(Verified {
        holds: report.refuted.is_empty() && report.holds(),
        checks: checks.collect(),
    })
}

/// Result files of a diagnosis, whose report then names the file of the extended model.
///
/// # Errors
/// If the report has no form in JSON, or the estimates cannot be written into the text of the extended model.
pub fn files(found: &mut Diagnosis, dataset: &Dataset) -> anyhow::Result<Vec<ResultFile>> {
    if found.after.is_some() {
        found.report.extended_model = Some(EXTENDED.to_owned());
    }
    let found = &*found;
    let name = &found.report.dataset;
    let json = serde_json::to_string_pretty(&found.report)?;
    let mut files = vec![
        ResultFile::new("report.json", json + "\n"),
        ResultFile::new("candidates.csv", tables::candidates(&found.report)),
        ResultFile::new("coefficients.csv", tables::coefficients(&found.report)),
        ResultFile::new("flights.csv", tables::flights(&found.report)),
    ];
    let mut extended = None;
    if let Some((extension, fitted)) = &found.after {
        let note = note(&extension.effects, name) + " Its default values were fitted to it.";
        let text = fitted.fitted_text(&extension.model, dataset, &note)?;
        let model = model_spec::load::from_text(EXTENDED, &text, &[])?;
        let code = generate_with(&codegen::rust::PlainRust, &[model]).into_iter();
        files.extend(code.map(|file| ResultFile::new(format!("{CODE}/{}", file.path), file.text)));
        files.extend(written_effects(extension));
        files.push(ResultFile::new(EXTENDED, text.clone()));
        extended = Some(text);
    }
    let flights = drawn(&found.before);
    let after = found.after.as_ref();
    let page = DiagnosisPage {
        report: &found.report,
        before: &evidence(&found.before, &flights),
        after: &after.map_or_else(Vec::new, |(_, fitted)| evidence(fitted, &flights)),
        fits: Some(Fits {
            before: &found.before,
            after: after.map(|(_, fitted)| fitted),
        }),
        extended: extended.as_deref(),
    };
    files.extend(report::diagnosis::page(&page).files());
    let view = match after {
        Some((_, fitted)) => {
            View::of_fit(fitted, "extended").join(View::of_fit(&found.before, "original"))
        }
        None => View::of_fit(&found.before, ""),
    };
    let view = view.html(&format!("{} · {name}", found.report.model));
    files.extend(view.map(|html| ResultFile::new(FLIGHTS, html)));
    Ok(files)
}

fn written_effects(extension: &ExtendedModel) -> Vec<ResultFile> {
    let each = extension.written.iter().filter_map(|effect| {
        let declares = |name: &&String| effect.contains(&format!("effect {name} "));
        let name = extension.effects.iter().find(declares)?;
        Some(ResultFile::new(format!("{name}.hyz"), effect.clone()))
    });
    each.collect()
}
