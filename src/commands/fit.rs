//! `hyzer fit`: the coefficients of a model from measured flights.

use std::fmt::Write;
use std::path::Path;

use anyhow::Context;
use comfy_table::Table;
use comfy_table::presets::UTF8_BORDERS_ONLY;
use identify::dataset::{self, Dataset, Role};
use identify::report::Report;

use crate::cli::Fit;
use crate::{Answer, output};

/// Fits and reports.
pub fn run(options: &Fit) -> anyhow::Result<Answer> {
    let dataset = dataset::load(&options.dataset)?;
    let model = model_of(options, &dataset)?;
    let model = model_spec::load::load(&model, &super::names(&options.with))?;
    let asked = identify::options::Options::default();
    let fitted = identify::fit::fit(&model, &dataset, &asked)
        .with_context(|| format!("cannot fit {}", options.dataset.display()))?;
    let report = fitted.report;
    output::print(summary(&report))?;
    if let Some(folder) = &options.out {
        let json = serde_json::to_string_pretty(&report)?;
        output::write(&folder.join("report.json"), json + "\n")?;
        output::write(&folder.join("coefficients.csv"), coefficients(&report))?;
        output::write(&folder.join("flights.csv"), flights(&report))?;
        eprintln!(
            "report.json, coefficients.csv and flights.csv are in {}",
            folder.display()
        );
    }
    if !report.iterations.converged {
        eprintln!(
            "the fit did not converge in {} steps: do not rely on it",
            report.iterations.steps
        );
        return Ok(Answer::No);
    }
    Ok(Answer::Yes)
}

/// The model: as asked for, or the dataset's own, where a path is meant from the dataset's folder.
fn model_of(options: &Fit, dataset: &Dataset) -> anyhow::Result<String> {
    if let Some(model) = &options.model {
        return Ok(model.clone());
    }
    let beside = options.dataset.join(&dataset.model);
    let is_path =
        Path::new(&dataset.model).components().count() > 1 || dataset.model.ends_with(".hyz");
    match beside.to_str() {
        Some(path) if is_path => Ok(path.to_owned()),
        _ => Ok(dataset.model.clone()),
    }
}

fn summary(report: &Report) -> String {
    let fitted = report
        .flights
        .iter()
        .filter(|flight| flight.role == Role::Fit)
        .count();
    let mut text = format!(
        "{}: {fitted} flights fitted, {} held out; rms {:.2} mm in {} steps\n",
        report.model,
        report.flights.len() - fitted,
        1e3 * report.rms_m,
        report.iterations.steps,
    );
    let noise = &report.noise;
    let how = if noise.estimated {
        "estimated"
    } else {
        "given"
    };
    let _ = writeln!(
        text,
        "noise of one coordinate: {:.2} mm ({how})\n",
        1e3 * noise.sigma_m
    );
    let mut table = table(&["coefficient", "value", "standard error", "unit", ""]);
    for (name, found) in &report.coefficients {
        let bound = if found.at_bound { "at its bound" } else { "" };
        table.add_row([
            name,
            &format!("{:.5}", found.value),
            &format!("{:.2e}", found.std_error),
            &found.unit,
            bound,
        ]);
    }
    let _ = writeln!(text, "{table}\n");
    let mut table = self::table(&["flight", "role", "samples", "rms, mm"]);
    for flight in &report.flights {
        let rms = format!("{:.2}", 1e3 * flight.rms_m);
        table.add_row([
            flight.file.as_str(),
            role(flight.role),
            &flight.samples.to_string(),
            &rms,
        ]);
    }
    let _ = writeln!(text, "{table}");
    if fitted < report.flights.len() {
        text.push_str("held out: initial state fitted on the first 30 % of the samples, rms of the rest as predicted\n");
    }
    for undetermined in &report.undetermined {
        let _ = writeln!(
            text,
            "not determined: {}: {}",
            undetermined.combination.join(", "),
            undetermined.why
        );
    }
    text
}

fn table(head: &[&str]) -> Table {
    let mut table = Table::new();
    table
        .load_style(UTF8_BORDERS_ONLY)
        .set_header(head.to_vec());
    table
}

fn role(role: Role) -> &'static str {
    match role {
        Role::Fit => "fit",
        Role::HeldOut => "held-out",
    }
}

fn coefficients(report: &Report) -> String {
    let mut text = "name,value,std_error,unit,at_bound\n".to_owned();
    for (name, found) in &report.coefficients {
        let _ = writeln!(
            text,
            "{name},{},{},{},{}",
            found.value, found.std_error, found.unit, found.at_bound
        );
    }
    text
}

fn flights(report: &Report) -> String {
    let mut text = "file,role,samples,rms_m\n".to_owned();
    for flight in &report.flights {
        let _ = writeln!(
            text,
            "{},{},{},{}",
            flight.file,
            role(flight.role),
            flight.samples,
            flight.rms_m
        );
    }
    text
}
