//! Command `hyzer import`: converts recordings of laboratories to a dataset, cut to the free flights.

mod estimated;
mod page;
mod template;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::Range;
use std::path::Path;

use anyhow::{Context, bail};
use dataset::takes::words::listed;
use dataset::takes::{Axis, Format, LengthUnit, ReadOptions, Take, Throw, ThrowOptions, TimeUnit};
use dataset::{Dataset, Flight, Sensor, SensorKind, write_commented};
use report::import::{ImportPage, ImportedTake};

use self::page::Shown;
use self::template::{Followed, Template};
use crate::cli::Import;
use crate::{Answer, output, progress};

/// File in the dataset's folder that lists the choices made in the import, such as units, axes and the samples of each
/// flight.
const DECISIONS: &str = "import.txt";
/// File name of the report page of the import, with the choices made (units, axes, samples) and plots of each flight.
const PAGE: &str = "import.html";

/// Result of the import of all recordings: flights, choices made (such as axes and tracked points) and data for the
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
    let mut labels = labels(&options.label)?;
    let reading = reading(options)?;
    let mut decisions = String::new();
    let (mut comments, mut origin_error) = (Vec::new(), None);
    let template = match (&options.markers, &options.model) {
        (Some(file), _) => Template::read(file)?,
        (None, Some(_)) => {
            let found = estimated::estimated(options, &reading, &mut labels)?;
            decisions = found.decisions;
            comments = found.comments;
            origin_error = Some(found.origin_error);
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
        sigma: None,
        flights: Vec::new(),
    };
    let mut found = Found {
        decisions,
        ..Found::default()
    };
    for file in &options.takes {
        let _ = writeln!(found.decisions, "{}", file.display());
        let take = dataset::takes::read(file, &reading)?;
        let before = found.flights.len();
        add(&take, file, &template, &labels, options, &mut found)?;
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
    let other_files: Vec<(&str, String)> = other_files
        .iter()
        .map(|(name, text)| (name.as_str(), text.clone()))
        .collect();
    progress::writing(|| write_commented(&options.out, &dataset, &other_files, &comments))
        .with_context(|| format!("--out {}", options.out.display()))?;
    let count = dataset.flights.len();
    output::print(format!(
        "{decisions}{}: {count} flights of {}\n",
        options.out.display(),
        dataset.model
    ))?;
    Ok(Answer::Yes)
}

/// Options for reading the recordings (format, units, frame rate), parsed from the command-line options.
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

/// Adds to `all` the flights in the recording `take`, the choices made in their import (such as units and axes), and
/// their figures.
fn add(
    take: &Take,
    file: &Path,
    template: &Template,
    labels: &BTreeMap<String, String>,
    options: &Import,
    all: &mut Found,
) -> anyhow::Result<()> {
    let (up, is_option) = up_of(take, file, options)?;
    let by = if is_option {
        "by --up"
    } else {
        "as the file states"
    };
    let hand = match (options.left_handed, take.left_handed) {
        (true, _) => "left-handed, by --left-handed",
        (false, Some(false)) => "right-handed",
        (false, _) => "taken as right-handed (otherwise --left-handed)",
    };
    let followed = template
        .followed(take, labels)
        .with_context(|| file.display().to_string())?;
    let followed_labels: Vec<&str> = followed.labels(take);
    let turned = take.clone().with_z_up(up, options.left_handed);
    let found = dataset::takes::find_throws(&turned, &followed_labels, &ThrowOptions::default());
    let mut notes = take.notes.clone();
    if followed.is_pose() {
        notes.push(
            "the poses are written as those of the body frame, in which the template is".into(),
        );
    }
    notes.extend(found.notes.iter().cloned());
    if found.throws.is_empty()
        && let Some(other) = other_up(take, &followed_labels, options.left_handed, up)
    {
        bail!(
            "{}: found no throw with {up} up, and free flights with {other} up; expected --up {other}",
            file.display()
        );
    }
    let is_pose = followed.is_pose();
    let name = followed_labels
        .first()
        .map(|label| dataset_name(label, labels));
    match (&all.pose, is_pose, all.takes.is_empty()) {
        (_, true, true) => all.pose = name,
        (Some(pose), true, false) if name.as_ref() == Some(pose) => {}
        (None, false, _) => {}
        _ => bail!(
            "{}: found {}, expected the same points or the same body as in the recordings before",
            file.display(),
            listed(&followed_labels)
        ),
    }
    let motion = dataset::takes::motion(&turned, &followed_labels);
    let shown = Shown {
        take: &turned,
        followed: &followed,
        markers: &template.markers,
        motion: motion.as_ref(),
    };
    let mut flights = Vec::new();
    let mut lines = String::new();
    for throw in &found.throws {
        if !is_downwards(throw.acceleration) {
            let [x, y, z] = throw.acceleration;
            notes.push(format!(
                "a flight accelerates by {x:.1}, {y:.1}, {z:.1} m/s² (z up), not downwards: is {up} up?"
            ));
        }
        let positions = throw
            .samples()
            .map(|sample| followed.positions(&turned, sample));
        let flight = Flight {
            file: format!("flight{:02}.csv", all.flights.len() + 1),
            times: turned.times[throw.samples()].to_vec(),
            positions: positions.collect(),
            ..Flight::default()
        };
        describe(throw, &flight.file, &mut lines);
        flights.push(shown.flight(throw, &flight));
        all.flights.push(match followed.is_pose() {
            true => of_poses(flight, &throw.samples(), &followed, &turned),
            false => flight,
        });
    }
    let labels = listed(&followed_labels);
    let samples = take.times.len();
    let _ = writeln!(
        all.decisions,
        "  {}: {samples} samples, lengths in {}, {up} up {by}, axes {hand}; written in m, z up\n  followed: {labels}",
        take.format, take.length
    );
    for note in &notes {
        let _ = writeln!(all.decisions, "  note: {note}");
    }
    all.decisions += &lines;
    let decision = |what: &str, text: String| (what.to_owned(), text);
    all.takes.push(ImportedTake {
        file: file.display().to_string(),
        decisions: vec![
            decision("format", take.format.to_string()),
            decision("samples", samples.to_string()),
            decision("lengths", format!("in {}, written in m", take.length)),
            decision("up", format!("{up}, {by}; written with z up")),
            decision("axes", hand.to_owned()),
            decision("followed", labels),
        ],
        notes,
        heights: page::heights(motion.as_ref()),
        flights,
    });
    Ok(())
}

/// Replaces the marker positions of a flight by poses: position and attitude of the tracked body in `followed`, in the
/// samples `samples` of the recording `take`. All poses are missing if `followed` selects points instead of a body.
fn of_poses(flight: Flight, samples: &Range<usize>, followed: &Followed, take: &Take) -> Flight {
    let readings = samples
        .clone()
        .map(|sample| match followed.pose(take, sample) {
            Some(pose) => {
                let [x, y, z] = pose.position;
                vec![Some([x, y, z, 0.0]), Some(pose.quaternion)]
            }
            None => vec![None; 2],
        });
    Flight {
        positions: vec![Vec::new(); flight.times.len()],
        readings: readings.collect(),
        ..flight
    }
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

/// Axis of the recording `take` that points up, and whether it is specified by the option `--up` instead of in the
/// file. An error if neither specifies it, or if the value of the option is not an axis.
fn up_of(take: &Take, file: &Path, options: &Import) -> anyhow::Result<(Axis, bool)> {
    let stated = match &options.up {
        Some(text) => match Axis::parse(text) {
            Some(up) => Some(up),
            None => bail!("--up: found {text:?}, expected +z, -z, +y, -y, +x or -x"),
        },
        None => None,
    };
    let Some(up) = stated.or(take.up) else {
        bail!(
            "{}: found no statement of the axis that points up, expected the option --up, such as --up +z or --up +y",
            file.display()
        );
    };
    Ok((up, stated.is_some()))
}

/// Whether an acceleration, m/s², in axes with z up, is directed mainly downwards, as expected in free flight.
fn is_downwards([x, y, z]: [f64; 3]) -> bool {
    -z > 0.5 * x.hypot(y)
}

/// Tries the axes other than `up` as the upward axis of the recording `take`. Returns the first axis with which throws
/// are found; `None` if there is none.
fn other_up(take: &Take, labels: &[&str], left_handed: bool, up: Axis) -> Option<Axis> {
    let all = ["+z", "+y", "+x", "-z", "-y", "-x"]
        .into_iter()
        .filter_map(Axis::parse);
    all.filter(|axis| *axis != up).find(|&axis| {
        let turned = take.clone().with_z_up(axis, left_handed);
        let found = dataset::takes::find_throws(&turned, labels, &ThrowOptions::default());
        !found.throws.is_empty()
    })
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
