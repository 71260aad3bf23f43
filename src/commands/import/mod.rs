//! Command `hyzer import`: converts recordings of laboratories to a dataset, cut to the free flights.

mod estimated;
mod folders;
mod shots;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use dataset::takes::{
    self, Axis, Format, ImportOptions, LengthUnit, ReadOptions, Take, Throw, ThrowOptions,
    TimeUnit, name_of_label,
};
use dataset::{BodyTemplate, Dataset, Flight, Marker, Sensor, SensorKind, write_commented};
use flight::table::listed;
use report::import::{ImportPage, ImportedTake};

use crate::cli::Import;
use crate::{Answer, output, progress};

/// Maximum magnitude of `--centre-height`, m; larger values suggest millimetres.
const MAX_HEIGHT: f64 = 2.0;
const DECISIONS: &str = "import.txt";
const PAGE: &str = "import.html";

#[derive(Default)]
struct Found {
    flights: Vec<Flight>,
    decisions: String,
    /// Name of the body if the flights are recorded as its poses.
    pose: Option<String>,
    /// For the page.
    takes: Vec<ImportedTake>,
}

/// Runs `hyzer import`.
///
/// # Errors
/// If an option or a recording is faulty, or no throw is found.
pub(super) fn run(options: &Import) -> anyhow::Result<Answer> {
    output::new_folder(&options.out)?;
    let made = imported(options)?;
    let (dataset, decisions, out) = (&made.dataset, &made.decisions, &options.out);
    progress::writing(|| write_commented(out, dataset, &made.beside, &made.comments))
        .with_context(|| format!("--out {}", out.display()))?;
    let (count, model) = (dataset.flights.len(), &dataset.model);
    output::print(format!(
        "{decisions}{}: {count} flights of {model}\n",
        out.display()
    ))?;
    if dataset.parameters.is_empty() && !options.launch_monitor {
        output::next(format_args!(
            "state mass and inertia in [parameters] of {}; until then they are those of the model {model}",
            out.join("dataset.toml").display()
        ));
    }
    output::next(format_args!("hyzer fit {} --out fitted", out.display()));
    Ok(Answer::Yes)
}

/// An imported dataset, and the other files of its folder.
pub struct Imported {
    /// The free flights.
    pub dataset: Dataset,
    /// Names and texts of the other files.
    pub beside: Vec<(String, String)>,
    /// Comment on the position of each marker; empty if the positions were given.
    pub comments: Vec<String>,
    /// Text of the choices made.
    pub decisions: String,
    /// Recordings with the files of the flights that were cut from each.
    pub recordings: Vec<(PathBuf, Vec<String>)>,
}

/// Reads recordings and cuts them to the free flights.
pub(crate) fn imported(options: &Import) -> anyhow::Result<Imported> {
    if let Some(height) = options.centre_height {
        ensure!(
            height.abs() <= MAX_HEIGHT,
            "--centre-height: found {height}, expected metres, at most {MAX_HEIGHT} (millimetres?)"
        );
    }
    let takes = folders::recordings(&options.takes)?;
    let options = &Import {
        takes,
        ..options.clone()
    };
    if options.launch_monitor {
        return shots::imported(options);
    }
    let mut labels = labels(&options.label)?;
    let reading = reading(options)?;
    let mut found = Found::default();
    let (mut comments, mut dataset) = (Vec::new(), Dataset::default());
    let template = match (&options.markers, &options.model) {
        (Some(file), _) => BodyTemplate::read(file)?,
        // Poses of a body need no positions of markers.
        (None, Some(_)) if are_poses(options, &reading)? => BodyTemplate::default(),
        (None, Some(model)) => match of_point(model, options, &reading, &mut labels)? {
            Some(template) => template,
            None => {
                let estimated = estimated::estimated(options, &reading, &mut labels)?;
                found.decisions = estimated.decisions;
                comments = estimated.comments;
                dataset.origin_error = Some(estimated.origin_error);
                dataset.axis_error = Some(estimated.axis_error);
                estimated.template
            }
        },
        (None, None) => bail!(
            "no model: expected the option --model, or a template that states it by --markers"
        ),
    };
    let model = options.model.clone().or(template.model);
    dataset.model =
        model.context("no model: found none in the template, expected the option --model")?;
    let mut beside = Vec::new();
    // A model that is not built in is copied into the dataset.
    let path = Path::new(&dataset.model);
    if let Some(name) = path.file_name().filter(|_| path.is_file()) {
        let text = std::fs::read_to_string(path).with_context(|| dataset.model.clone())?;
        let name = name.to_string_lossy().into_owned();
        beside.push((name.clone(), text));
        dataset.model = name;
    }
    let asked = ImportOptions {
        markers: template.markers,
        labels,
        up: up(options)?,
        left_handed: options.left_handed,
    };
    for file in &options.takes {
        let _ = writeln!(found.decisions, "{}", file.display());
        let before = found.flights.len();
        let take = dataset::takes::read(file, &reading);
        let added = take.map_err(anyhow::Error::from);
        match added.and_then(|take| add(&take, file, &asked, &mut found)) {
            Ok(()) if found.flights.len() == before => found.decisions.push_str("  no throw\n"),
            Ok(()) => {}
            // One recording among several does not end the import of the others.
            Err(error) if options.takes.len() > 1 => {
                eprintln!("note: left out: {error}");
                let _ = writeln!(found.decisions, "  left out: {error}");
            }
            Err(error) => return Err(error),
        }
    }
    let decisions = found.decisions;
    ensure!(
        !found.flights.is_empty(),
        "{}; check --length and --up\n{decisions}",
        no_throw()
    );
    dataset.flights = found.flights;
    dataset.parameters = template.parameters;
    match found.pose {
        Some(name) => dataset.sensors = vec![Sensor::new(&name, SensorKind::Pose, [0.0; 3])],
        None => dataset.markers = asked.markers,
    }
    let recordings = found.takes.iter().map(|take| {
        let flights = take.flights.iter().map(|flight| flight.file.clone());
        (PathBuf::from(&take.file), flights.collect())
    });
    let recordings = recordings.collect();
    let name = options.out.file_name().unwrap_or(options.out.as_os_str());
    let page = report::import::html(&ImportPage {
        dataset: name.to_string_lossy().into_owned(),
        model: dataset.model.clone(),
        takes: found.takes,
    });
    beside.push((DECISIONS.to_owned(), decisions.clone()));
    beside.push((PAGE.to_owned(), page));
    Ok(Imported {
        dataset,
        beside,
        comments,
        decisions,
        recordings,
    })
}

/// Template of a point mass whose one point, at the centre, is all that was tracked; `None` for any other.
fn of_point(
    model: &str,
    options: &Import,
    reading: &ReadOptions,
    labels: &mut BTreeMap<String, String>,
) -> anyhow::Result<Option<BodyTemplate>> {
    let checked = model_spec::load::load(model, &[])?;
    if checked.marker.is_none_or(|marker| marker.frame != 0) {
        return Ok(None);
    }
    let mut seen = BTreeSet::new();
    for file in &options.takes {
        let points = dataset::takes::read(file, reading).map(|take| take.points);
        seen.extend(points.into_iter().flatten().map(|point| point.label));
    }
    let (Some(label), 1) = (seen.pop_first(), seen.len() + 1) else {
        return Ok(None);
    };
    let name = dataset_name(&label, labels);
    labels.insert(label, name.clone());
    let position = [0.0; 3];
    Ok(Some(BodyTemplate {
        markers: vec![Marker { name, position }],
        ..BodyTemplate::default()
    }))
}

/// Whether each recording has one tracked body and no single points.
fn are_poses(options: &Import, reading: &ReadOptions) -> anyhow::Result<bool> {
    for file in &options.takes {
        let take = match dataset::takes::read(file, reading) {
            Ok(take) => take,
            // It is told where the recordings are cut.
            Err(_) if options.takes.len() > 1 => continue,
            Err(error) => return Err(error.into()),
        };
        if !take.points.is_empty() || take.bodies.len() != 1 {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Options for reading the recordings.
fn reading(options: &Import) -> anyhow::Result<ReadOptions> {
    let chosen = |name: &str, text: &Option<String>, expected: &str| match text {
        Some(text) => format!("--{name}: found {text:?}, expected {expected}"),
        None => String::new(),
    };
    let formats: Vec<&str> = Format::ALL.iter().map(|(_, name, _)| *name).collect();
    let format = options.format.as_deref().map(Format::parse);
    let length = options.length.as_deref().map(LengthUnit::parse);
    let time = options.time.as_deref().map(TimeUnit::parse);
    match (format, length, time) {
        (Some(None), ..) => bail!(chosen("format", &options.format, &formats.join(", "))),
        (_, Some(None), _) => bail!(chosen("length", &options.length, "m, cm, mm, in or ft")),
        (.., Some(None)) => bail!(chosen("time", &options.time, "s or ms")),
        _ => {}
    }
    Ok(ReadOptions {
        format: format.flatten(),
        length: length.flatten(),
        time: time.flatten(),
        rate: options.rate,
    })
}

/// Parses the values `FILE_LABEL=NAME` of the option `--label`: marker names by label.
fn labels(texts: &[String]) -> anyhow::Result<BTreeMap<String, String>> {
    let mut labels = BTreeMap::new();
    for text in texts {
        let Some((label, name)) = text.rsplit_once('=') else {
            bail!("--label: found {text:?}, expected FILE_LABEL=NAME");
        };
        let before = labels.insert(label.trim().to_owned(), name.trim().to_owned());
        ensure!(
            before.is_none(),
            "--label: found {label:?} twice, expected each label once"
        );
    }
    Ok(labels)
}

/// Adds the flights of a recording, and the choices made.
fn add(take: &Take, file: &Path, options: &ImportOptions, all: &mut Found) -> anyhow::Result<()> {
    let mut found = takes::ImportedTake::new(take, file, options)?;
    let labels = found.followed.labels(&found.take);
    let is_pose = found.followed.is_pose();
    let name = labels.first();
    let name = name.map(|label| dataset_name(label, &options.labels));
    match (&all.pose, is_pose, all.takes.is_empty()) {
        (_, true, true) => all.pose = name,
        (Some(pose), true, false) if name.as_ref() == Some(pose) => {}
        (None, false, _) => {}
        _ => bail!(
            "{}: found {}, expected the same points or the same body as in the recordings before",
            file.display(),
            listed(&labels)
        ),
    }
    for (what, text) in &found.decisions {
        let _ = writeln!(all.decisions, "  {what}: {text}");
    }
    for note in &found.notes {
        let _ = writeln!(all.decisions, "  note: {note}");
    }
    let mut files = Vec::new();
    let flights = std::mem::take(&mut found.flights).into_iter();
    for (mut flight, throw) in flights.zip(&found.throws) {
        flight.file = format!("flight{:02}.csv", all.flights.len() + 1);
        describe(throw, &flight.file, &mut all.decisions);
        files.push(flight.file.clone());
        all.flights.push(flight);
    }
    let (file, markers) = (file.display().to_string(), &options.markers);
    let take = ImportedTake::new(file, &found, markers, &files);
    all.takes.push(take);
    Ok(())
}

/// Name of a label in the dataset, by the option `--label` or made from it.
fn dataset_name(label: &str, labels: &BTreeMap<String, String>) -> String {
    let given = name_of_label(labels, label).cloned();
    given.unwrap_or_else(|| estimated::name(label))
}

fn no_throw() -> String {
    let shortest = ThrowOptions::default().shortest;
    format!("found no throw, expected at least one free flight of {shortest} s")
}

/// Axis that points up by the option `--up`.
fn up(options: &Import) -> anyhow::Result<Option<Axis>> {
    let Some(text) = &options.up else {
        return Ok(None);
    };
    match Axis::parse(text) {
        Some(up) => Ok(Some(up)),
        None => bail!("--up: found {text:?}, expected +z, -z, +y, -y, +x or -x"),
    }
}

fn describe(throw: &Throw, name: &str, decisions: &mut String) {
    let (release, end) = (&throw.release, &throw.end);
    let _ = writeln!(
        decisions,
        "  {name}: {} samples from {:.4} s ({}) to {:.4} s ({}); {} of them unseen",
        throw.samples().len(),
        release.time,
        release.cause,
        end.time,
        end.cause,
        throw.unseen
    );
}
