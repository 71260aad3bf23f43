//! Command `hyzer import`: converts recordings of laboratories to a dataset, cut to the free flights.

mod estimated;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, bail};
use dataset::takes::words::listed;
use dataset::takes::{
    self, Axis, Format, ImportOptions, LengthUnit, ReadOptions, Take, Throw, ThrowOptions, TimeUnit,
};
use dataset::{BodyTemplate, Dataset, Flight, Sensor, SensorKind, write_commented};
use report::import::{ImportPage, ImportedTake};

use crate::cli::Import;
use crate::{Answer, output, progress};

/// File in the dataset's folder that lists the choices made in the import, such as units, axes and the samples of each
/// flight.
const DECISIONS: &str = "import.txt";
/// File name of the report page of the import, with the choices made and plots of each flight.
const PAGE: &str = "import.html";

/// Result of the import of all recordings: flights, choices made and data for the
/// plots on the report page.
#[derive(Default)]
struct Found {
    flights: Vec<Flight>,
    /// Text of the choices made in the import: axes, tracked points, and the first and last sample of each flight.
    decisions: String,
    /// Name of the body if the flights are recorded as its poses; `None` if they are recorded as marker positions.
    pose: Option<String>,
    /// Choices made in the import and plotted curves of each recording, for the report page.
    takes: Vec<ImportedTake>,
}

/// Runs `hyzer import`: reads the recordings, extracts the free flight of each throw, writes the dataset, and prints
/// the choices made, such as units and axes. Always returns `Answer::Yes`; an error if no throw is found.
pub fn run(options: &Import) -> anyhow::Result<Answer> {
    output::new_folder(&options.out)?;
    let made = imported(options)?;
    let (dataset, decisions) = (&made.dataset, &made.decisions);
    let beside: Vec<(&str, String)> = made
        .beside
        .iter()
        .map(|(name, text)| (name.as_str(), text.clone()))
        .collect();
    progress::writing(|| write_commented(&options.out, dataset, &beside, &made.comments))
        .with_context(|| format!("--out {}", options.out.display()))?;
    let count = dataset.flights.len();
    output::print(format!(
        "{decisions}{}: {count} flights of {}\n",
        options.out.display(),
        dataset.model
    ))?;
    Ok(Answer::Yes)
}

/// An imported dataset with the other files of its folder.
pub struct Imported {
    /// The free flights.
    pub dataset: Dataset,
    /// Names and texts of the files beside those of the dataset.
    pub beside: Vec<(String, String)>,
    /// Comment on the position of each marker; empty if the positions were given.
    pub comments: Vec<String>,
    /// Text of the choices made in the import.
    pub decisions: String,
}

/// Reads recordings and cuts them to the free flights.
///
/// # Errors
/// If an option or a recording is faulty, or no throw is found.
pub fn imported(options: &Import) -> anyhow::Result<Imported> {
    let mut labels = labels(&options.label)?;
    let reading = reading(options)?;
    let mut decisions = String::new();
    let (mut comments, mut origin_error, mut axis_error) = (Vec::new(), None, None);
    let template = match (&options.markers, &options.model) {
        (Some(file), _) => BodyTemplate::read(file)?,
        // Poses of a body need no positions of markers.
        (None, Some(_)) if are_poses(options, &reading)? => BodyTemplate::default(),
        (None, Some(_)) => {
            let found = estimated::estimated(options, &reading, &mut labels)?;
            decisions = found.decisions;
            comments = found.comments;
            origin_error = Some(found.origin_error);
            axis_error = Some(found.axis_error);
            found.template
        }
        (None, None) => bail!(
            "no model: expected the option --model, or a template that states it by --markers"
        ),
    };
    let mut other_files = Vec::new();
    let Some(mut model) = options.model.clone().or_else(|| template.model.clone()) else {
        bail!("no model: found none in the template, expected the option --model");
    };
    // A model that is not built in is copied into the dataset.
    if Path::new(&model).is_file() {
        let text = std::fs::read_to_string(&model).with_context(|| model.clone())?;
        let name = Path::new(&model)
            .file_name()
            .map(|name| name.to_string_lossy().into_owned());
        model = name.unwrap_or(model);
        other_files.push((model.clone(), text));
    }
    let mut dataset = Dataset {
        model,
        parameters: template.parameters.clone(),
        markers: template.markers.clone(),
        sensors: Vec::new(),
        unknown_vertical: false,
        origin_error,
        axis_error,
        sigma: None,
        flights: Vec::new(),
    };
    let mut found = Found {
        decisions,
        ..Found::default()
    };
    let asked = ImportOptions {
        markers: template.markers.clone(),
        labels,
        up: up(options)?,
        left_handed: options.left_handed,
    };
    for file in &options.takes {
        let _ = writeln!(found.decisions, "{}", file.display());
        let take = dataset::takes::read(file, &reading)?;
        let before = found.flights.len();
        add(&take, file, &asked, &mut found)?;
        if found.flights.len() == before {
            found.decisions.push_str("  no throw\n");
        }
    }
    let Found {
        flights,
        decisions,
        pose,
        takes,
    } = found;
    dataset.flights = flights;
    if let Some(name) = pose {
        dataset.markers.clear();
        dataset.sensors = vec![Sensor::new(&name, SensorKind::Pose, [0.0; 3])];
    }
    if dataset.flights.is_empty() {
        bail!("{}\n{decisions}", no_throw());
    }
    other_files.push((DECISIONS.to_owned(), decisions.clone()));
    let name = options.out.file_name().unwrap_or(options.out.as_os_str());
    let page = report::import::html(&ImportPage {
        dataset: name.to_string_lossy().into_owned(),
        model: dataset.model.clone(),
        takes,
    });
    other_files.push((PAGE.to_owned(), page));
    Ok(Imported {
        dataset,
        beside: other_files,
        comments,
        decisions,
    })
}

/// Whether each recording has one tracked body and no single points.
fn are_poses(options: &Import, reading: &ReadOptions) -> anyhow::Result<bool> {
    for file in &options.takes {
        let take = dataset::takes::read(file, reading)?;
        if !take.points.is_empty() || take.bodies.len() != 1 {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Options for reading the recordings, parsed from the command-line options.
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

/// Parses the values `FILE_LABEL=NAME` of the option `--label`. The result maps labels of the recordings to marker
/// names.
fn labels(texts: &[String]) -> anyhow::Result<BTreeMap<String, String>> {
    let mut labels = BTreeMap::new();
    for text in texts {
        let Some((label, name)) = text.rsplit_once('=') else {
            bail!("--label: found {text:?}, expected FILE_LABEL=NAME");
        };
        if labels
            .insert(label.trim().to_owned(), name.trim().to_owned())
            .is_some()
        {
            bail!("--label: found {label:?} twice, expected each label once");
        }
    }
    Ok(labels)
}

/// Adds to `all` the flights in the recording `take`, the choices made in their import, and their figures.
fn add(take: &Take, file: &Path, options: &ImportOptions, all: &mut Found) -> anyhow::Result<()> {
    let mut found = takes::ImportedTake::new(take, file, options)?;
    let labels = found.followed.labels(&found.take);
    let is_pose = found.followed.is_pose();
    let name = labels
        .first()
        .map(|label| dataset_name(label, &options.labels));
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
    for (mut flight, throw) in std::mem::take(&mut found.flights)
        .into_iter()
        .zip(&found.throws)
    {
        flight.file = format!("flight{:02}.csv", all.flights.len() + 1);
        describe(throw, &flight.file, &mut all.decisions);
        files.push(flight.file.clone());
        all.flights.push(flight);
    }
    let (file, markers) = (file.display().to_string(), &options.markers);
    all.takes
        .push(ImportedTake::new(file, &found, markers, &files));
    Ok(())
}

/// Marker name in the dataset for a label of a recording: the name given by the option `--label`, or else one made from
/// the label.
fn dataset_name(label: &str, labels: &BTreeMap<String, String>) -> String {
    labels
        .get(label)
        .cloned()
        .unwrap_or_else(|| estimated::name(label))
}

/// Error message for recordings in which no throw is found.
fn no_throw() -> String {
    let shortest = ThrowOptions::default().shortest;
    format!("found no throw, expected at least one free flight of {shortest} s")
}

/// Axis that points up by the option `--up`; `None` without it.
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
