//! Command `hyzer fit`: estimates the coefficients of a model from measured flights.
use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{Context, ensure};
use dataset::{Dataset, Role};
use flight::files::ResultFile;
use flight::release::{overruled, replaced};
use identify::{FitOptions, FlightEvidence, FlightId, Prior};
use model_spec::model::Model;
use model_spec::{ModelTree, sort_by_number};
use report::fit::{FitPage, tables};
use report::viewer::View;

use super::number;
use crate::cli::{Fit, FitInputs};
use crate::progress::Progress;
use crate::{Answer, output};

const FITTED: &str = "fitted.hyz";

pub(super) const FLIGHTS: &str = "flights.html";

/// Runs `hyzer fit`. `Answer::No` if the estimates are not reliable.
pub(super) fn run(options: &Fit) -> anyhow::Result<Answer> {
    let deadline = deadline(options.max_seconds)?;
    let out = output::results(options.out.as_deref(), &options.figures, &options.tables)?;
    let inputs = Inputs::read(&options.inputs, out)?;
    let (dataset, model, name) = (&inputs.dataset, &inputs.model, &inputs.name);
    let progress = Progress::new()?;
    let asked = FitOptions {
        unbounded: options.unbounded,
        profiles: &options.profile,
        progress: Some(&progress),
        deadline,
        ..inputs.options()
    };
    let threads = asked.threads();
    let fitted = identify::fit(model, dataset, &asked);
    drop(progress);
    let mut fitted = fitted.with_context(|| inputs.failed("fit"))?;
    fitted.report.dataset.clone_from(name);
    fitted.report.notes.extend(overruled_by(model, dataset));
    let fitted = fitted.with_lack_of_fit(threads)?;
    if let Some(out) = &inputs.out {
        let what = format!("report.html, report.json, {FITTED}, figures and tables");
        out.write(files(&fitted, model, dataset)?, &what)?;
    }
    output::print(text(&fitted, model))?;
    output::next(format_args!(
        "hyzer diagnose {} --out found  # what the model lacks",
        options.inputs.dataset.display()
    ));
    Ok(reliable(
        "fit",
        fitted.report.reliable,
        &fitted.report.cautions,
    ))
}

/// Notes on values that were replaced in the model and do not count, as the dataset states others.
pub fn overruled_by(model: &Model, dataset: &Dataset) -> Vec<String> {
    overruled(&replaced(model), &dataset.parameters, "the dataset")
}

/// Whether a result, `what`, is reliable; prints the reasons if it is not.
pub(super) fn reliable(what: &str, is_reliable: bool, cautions: &[String]) -> Answer {
    if !is_reliable {
        eprintln!("do not rely on this {what}: {}", cautions.join("; "));
    }
    Answer::of(is_reliable)
}

/// Dataset, model and options of the arguments of a fit, and the folder of its results.
pub(super) struct Inputs<'a> {
    given: &'a FitInputs,
    fixed: Vec<(String, Option<f64>)>,
    priors: Vec<Prior>,
    pub(super) out: Option<output::Results<'a>>,
    pub(super) dataset: Dataset,
    pub(super) model: Model,
    /// Name of the dataset in reports: the name of its folder.
    pub(super) name: String,
}

impl<'a> Inputs<'a> {
    pub(super) fn read(
        given: &'a FitInputs,
        out: Option<output::Results<'a>>,
    ) -> anyhow::Result<Inputs<'a>> {
        let fixed = given.hold.iter().map(|text| held(text));
        let fixed = fixed.collect::<anyhow::Result<Vec<_>>>()?;
        let priors = given.prior.iter().map(|text| prior(text));
        let priors = priors.collect::<anyhow::Result<Vec<_>>>()?;
        let held = || fixed.iter().map(|(name, _)| ("--hold", &**name));
        once(held().chain(given.free.iter().map(|name| ("--free", &**name))))?;
        once(held().chain(priors.iter().map(|own| ("--prior", &*own.name))))?;
        let dataset = dataset::load_on(&given.dataset, given.threads)?;
        let own = || model_of(&given.dataset, &dataset);
        let model = given.model.clone().unwrap_or_else(own);
        let name = given.dataset.file_name();
        let name = name.unwrap_or(given.dataset.as_os_str());
        Ok(Inputs {
            model: model_spec::load::load(&model, &super::names(&given.with))?,
            name: name.to_string_lossy().into_owned(),
            given,
            fixed,
            priors,
            out,
            dataset,
        })
    }

    pub(super) fn options(&self) -> FitOptions<'_> {
        FitOptions {
            fixed: &self.fixed,
            free: &self.given.free,
            priors: &self.priors,
            trust_data: self.given.trust_data,
            threads: self.given.threads,
            ..FitOptions::default()
        }
    }

    /// Context of an error of the work `what`.
    pub(super) fn failed(&self, what: &str) -> String {
        format!("cannot {what} {}", self.given.dataset.display())
    }
}

/// Maximum numbers of drawn flights: the first fitted ones, further ones with the largest residuals, held-out ones.
const DRAWN: (usize, usize, usize) = (6, 3, 3);

pub(super) fn drawn(fitted: &identify::Fit) -> Vec<usize> {
    let flights = &fitted.report.flights;
    let is_of = |i: usize, role: Role| flights[i].role == role && flights[i].is_used();
    let of_role = |role: Role| (0..flights.len()).filter(move |&i| is_of(i, role));
    let mut drawn: Vec<usize> = of_role(Role::Fit).take(DRAWN.0).collect();
    let mut worst: Vec<usize> = of_role(Role::Fit).skip(DRAWN.0).collect();
    sort_by_number(&mut worst, |&index| -flights[index].rms());
    drawn.extend(worst.into_iter().take(DRAWN.1));
    drawn.extend(of_role(Role::HeldOut).take(DRAWN.2));
    drawn.sort_unstable();
    drawn
}

/// Measurements and predictions of flights by index; those without predictions are omitted.
pub(super) fn evidence(fitted: &identify::Fit, flights: &[usize]) -> Vec<FlightEvidence> {
    let flights = flights.iter().copied().map(FlightId::new);
    flights
        .filter_map(|flight| fitted.evidence(flight))
        .collect()
}

/// Summary of a fit.
pub fn text(fitted: &identify::Fit, model: &Model) -> String {
    report::fit::text(&page(fitted, model, &[]))
}

fn page<'a>(
    fitted: &'a identify::Fit,
    model: &'a Model,
    evidence: &'a [FlightEvidence],
) -> FitPage<'a> {
    FitPage {
        report: &fitted.report,
        fit: Some(fitted),
        evidence,
        model,
        dataset: &fitted.report.dataset,
    }
}

/// Result files of a fit.
///
/// # Errors
/// If the report has no form in JSON, or the estimates cannot be written into the text of the model.
pub fn files(
    fitted: &identify::Fit,
    model: &Model,
    dataset: &Dataset,
) -> anyhow::Result<Vec<ResultFile>> {
    let name = &fitted.report.dataset;
    let json = serde_json::to_string_pretty(&fitted.report)?;
    let evidence = evidence(fitted, &drawn(fitted));
    let page = report::fit::page(&page(fitted, model, &evidence));
    let note = format!("Default values fitted to {name} by `hyzer fit`.");
    let fitted_model = fitted.fitted_text(model, dataset, &note)?;
    let mut files = vec![
        ResultFile::new("report.json", json + "\n"),
        ResultFile::new(FITTED, fitted_model),
        ResultFile::new("coefficients.csv", tables::coefficients(&fitted.report)),
        ResultFile::new("correlations.csv", tables::correlations(&fitted.report)),
        ResultFile::new("flights.csv", tables::flights(&fitted.report)),
        ResultFile::new("residuals.csv", tables::residuals(fitted)),
    ];
    if let Some(table) = report::fit::summaries_csv(&fitted.report) {
        files.push(ResultFile::new("summaries.csv", table));
    }
    if !dataset.sensors.is_empty() {
        let table = tables::sensor_residuals(fitted);
        files.push(ResultFile::new("sensors.csv", table));
    }
    files.extend(page.files());
    let view = View::of_fit(fitted, "").html(&format!("{} · {name}", model.name));
    files.extend(view.map(|html| ResultFile::new(FLIGHTS, html)));
    Ok(files)
}

/// Path or name of the model of the dataset, whose paths are relative to its folder.
pub fn model_of(folder: &Path, dataset: &Dataset) -> String {
    let beside = folder.join(&dataset.model);
    let is_path =
        Path::new(&dataset.model).components().count() > 1 || dataset.model.ends_with(".hyz");
    match beside.to_str() {
        Some(path) if is_path => path.to_owned(),
        _ => dataset.model.clone(),
    }
}

/// File name and text of a model that is a file, for a folder that is to hold it; `None` of a built-in one.
///
/// # Errors
/// If the file has faults.
pub fn model_file(named: &str) -> anyhow::Result<Option<(String, String)>> {
    let Some(stem) = Path::new(named)
        .file_stem()
        .filter(|_| Path::new(named).is_file())
    else {
        return Ok(None);
    };
    let tree = ModelTree::load(named)?;
    // A text that names other files would not stand alone.
    let text = match tree.sources() {
        [only] => only.text.clone(),
        _ => tree.to_text(""),
    };
    Ok(Some((format!("{}.hyz", stem.to_string_lossy()), text)))
}

/// Time at which a computation with the option `--max-seconds` ends.
pub(super) fn deadline(seconds: Option<f64>) -> anyhow::Result<Option<Instant>> {
    let Some(seconds) = seconds else {
        return Ok(None);
    };
    ensure!(
        seconds > 0.0 && seconds.is_finite(),
        "--max-seconds: found {seconds}, expected a number above 0"
    );
    let limit = Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX);
    Ok(Instant::now().checked_add(limit))
}

/// Refuses a name that options state twice, as each of them alone says what becomes of a coefficient.
fn once<'a>(stated: impl Iterator<Item = (&'a str, &'a str)>) -> anyhow::Result<()> {
    let mut known: Vec<(&str, &str)> = Vec::new();
    for (option, name) in stated {
        if let Some((first, _)) = known.iter().find(|(_, own)| *own == name) {
            anyhow::bail!("found {first} {name} and {option} {name}; expected one of them");
        }
        known.push((option, name));
    }
    Ok(())
}

/// Parses a coefficient to hold, `NAME` or `NAME=VALUE`.
fn held(text: &str) -> anyhow::Result<(String, Option<f64>)> {
    match text.split_once('=') {
        None => Ok((text.to_owned(), None)),
        Some((name, value)) => Ok((name.to_owned(), Some(number("--hold", value)?))),
    }
}

/// Parses a prior, `NAME=VALUE+-SIGMA` or with `±`.
fn prior(text: &str) -> anyhow::Result<Prior> {
    let parts = text.split_once('=').and_then(|(name, rest)| {
        let (value, sigma) = rest.split_once("+-").or_else(|| rest.split_once('±'))?;
        Some((name, value, sigma))
    });
    let (name, value, sigma) = parts.with_context(|| {
        format!("--prior: found {text:?}, expected NAME=VALUE+-SIGMA, such as C_D0=0.1+-0.02")
    })?;
    let (value, sigma) = (number("--prior", value)?, number("--prior", sigma)?);
    ensure!(
        sigma > 0.0,
        "--prior: found a standard deviation of {sigma} in {text:?}, expected one above 0"
    );
    Ok(Prior {
        name: name.to_owned(),
        value,
        sigma,
    })
}
