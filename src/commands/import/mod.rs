//! Command `hyzer import`: recordings of laboratories become a dataset, cut to the free flights.

mod template;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, bail};
use identify::dataset::{Dataset, Flight, Role, write_with};
use takes::words::listed;
use takes::{Axis, Format, LengthUnit, ReadOptions, Take, Throw, ThrowOptions, TimeUnit};

use self::template::Template;
use crate::cli::Import;
use crate::{Answer, output, progress};

/// File of the dataset that says what was decided.
const DECISIONS: &str = "import.txt";

/// Reads the takes, cuts them to their throws, writes the dataset, and prints what was decided.
pub fn run(options: &Import) -> anyhow::Result<Answer> {
    output::new_folder(&options.out)?;
    let template = Template::read(&options.markers)?;
    let labels = labels(&options.label)?;
    let reading = reading(options)?;
    let mut other_files = Vec::new();
    let Some(mut model) = options.model.clone().or_else(|| template.model.clone()) else {
        bail!(
            "no model: found none in {}, expected the option --model",
            options.markers.display()
        );
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
        sigma: None,
        flights: Vec::new(),
    };
    let mut decisions = String::new();
    for file in &options.takes {
        let _ = writeln!(decisions, "{}", file.display());
        let take = takes::read(file, &reading)?;
        let before = dataset.flights.len();
        add(
            &take,
            file,
            &template,
            &labels,
            options,
            &mut dataset.flights,
            &mut decisions,
        )?;
        if dataset.flights.len() == before {
            decisions.push_str("  no throw\n");
        }
    }
    if dataset.flights.is_empty() {
        bail!(
            "found no throw, expected at least one free flight of {} s\n{decisions}",
            ThrowOptions::default().shortest
        );
    }
    other_files.push((DECISIONS.to_owned(), decisions.clone()));
    let other_files: Vec<(&str, String)> = other_files
        .iter()
        .map(|(name, text)| (name.as_str(), text.clone()))
        .collect();
    progress::writing(|| write_with(&options.out, &dataset, &other_files))
        .with_context(|| format!("--out {}", options.out.display()))?;
    let count = dataset.flights.len();
    output::print(format!(
        "{decisions}{}: {count} flights of {}\n",
        options.out.display(),
        dataset.model
    ))?;
    Ok(Answer::Yes)
}

/// What the options state about the files.
fn reading(options: &Import) -> anyhow::Result<ReadOptions> {
    let chosen = |name: &str, text: &Option<String>, expected: &str| match text {
        Some(text) => format!("--{name}: found {text:?}, expected {expected}"),
        None => String::new(),
    };
    let formats: Vec<&str> = Format::ALL.iter().map(|(_, name)| *name).collect();
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

/// Names in the dataset by labels of the file.
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

/// Adds the throws of a take to the flights, and what was decided to the text.
fn add(
    take: &Take,
    file: &Path,
    template: &Template,
    labels: &BTreeMap<String, String>,
    options: &Import,
    flights: &mut Vec<Flight>,
    decisions: &mut String,
) -> anyhow::Result<()> {
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
    let by = if stated.is_some() {
        "by --up"
    } else {
        "as the file states"
    };
    let hand = match (options.left_handed, take.left_handed) {
        (true, _) => "left-handed, by --left-handed",
        (false, Some(false)) => "right-handed",
        (false, _) => "taken as right-handed (otherwise --left-handed)",
    };
    let _ = writeln!(
        decisions,
        "  {}: {} samples, lengths in {}, {up} up {by}, axes {hand}; written in m, z up",
        take.format,
        take.times.len(),
        take.length
    );
    for note in &take.notes {
        let _ = writeln!(decisions, "  note: {note}");
    }
    let followed = template
        .followed(take, labels)
        .with_context(|| file.display().to_string())?;
    let followed_labels: Vec<&str> = followed.labels(take);
    let turned = take.clone().with_z_up(up, options.left_handed);
    let limits = ThrowOptions::default();
    let found = takes::find_throws(&turned, &followed_labels, &limits);
    let _ = writeln!(
        decisions,
        "  followed: {}",
        listed(followed_labels.iter().copied())
    );
    if followed.is_pose() {
        let note = "the pose is written as the positions of the template's markers, whose errors go together";
        let _ = writeln!(decisions, "  note: {note}");
    }
    for note in &found.notes {
        let _ = writeln!(decisions, "  note: {note}");
    }
    if found.throws.is_empty()
        && let Some(other) = other_up(take, &followed_labels, options.left_handed, up)
    {
        bail!(
            "{}: found no throw with {up} up, and free flights with {other} up; expected --up {other}",
            file.display()
        );
    }
    for throw in &found.throws {
        if !is_downwards(throw.acceleration) {
            let [x, y, z] = throw.acceleration;
            let _ = writeln!(
                decisions,
                "  note: a flight accelerates by {x:.1}, {y:.1}, {z:.1} m/s² (z up), not downwards: is {up} up?"
            );
        }
        let name = format!("flight{:02}.csv", flights.len() + 1);
        describe(throw, &name, decisions);
        let positions = throw
            .samples()
            .map(|sample| followed.positions(&turned, sample));
        flights.push(Flight {
            file: name,
            role: Role::Fit,
            known: BTreeMap::new(),
            times: turned.times[throw.samples()].to_vec(),
            positions: positions.collect(),
            readings: Vec::new(),
        });
    }
    Ok(())
}

/// Whether an acceleration, m/s², is more downwards than aside, as that of most flights is.
fn is_downwards([x, y, z]: [f64; 3]) -> bool {
    -z > 0.5 * x.hypot(y)
}

/// The axis with which a take without throws has some.
fn other_up(take: &Take, labels: &[&str], left_handed: bool, up: Axis) -> Option<Axis> {
    let all = ["+z", "+y", "+x", "-z", "-y", "-x"]
        .into_iter()
        .filter_map(Axis::parse);
    all.filter(|axis| *axis != up).find(|&axis| {
        let turned = take.clone().with_z_up(axis, left_handed);
        let found = takes::find_throws(&turned, labels, &ThrowOptions::default());
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
