//! Command `hyzer simulate`: simulates a release; writes a CSV table and a figure.

mod flown;
mod launches;
mod techdisc;
pub(super) mod throws;

use std::fmt::Write;

use anyhow::{Context, anyhow, bail, ensure};
use flight::files::ResultFile;
use flight::release::{
    BUILT_IN, Release, Stop, Vocabulary, overruled, quaternion_fault, read_named, replaced,
};
use flight::throw::{FlownThrow, Throw};
use flight::{CompiledModel, simulate, trajectory_csv};
use model_spec::load::load;
use model_spec::model::{Body, Model};
use model_spec::syntax::spelling::joined;
use ode::{IntegrationOptions, Trajectory};
use report::Units;
use report::figures::{StateLabel, flight as picture};
use report::viewer::View;

use super::number;
use crate::cli::Simulate;
use crate::{Answer, output};

pub use flown::json as summary_json;

/// Runs `hyzer simulate`. `Answer::No` only if all throws of a launch monitor's file are flown and one cannot be.
pub(super) fn run(options: &Simulate) -> anyhow::Result<Answer> {
    if options.list {
        for (name, text) in BUILT_IN {
            let about = text.lines().next().unwrap_or_default();
            let about = about.trim_start_matches(['#', ' ']);
            output::print(format!("{name:9} {about}\n"))?;
        }
        return Ok(Answer::Yes);
    }
    check_numbers(options)?;
    let out = output::results(options.out.as_deref(), &options.figures, &[])?;
    let mut rows = match &options.throw.techdisc {
        Some(file) => techdisc::read(file)?,
        None => Vec::new(),
    };
    if let Some(name) = &options.throw.row {
        rows = vec![techdisc::choose(rows, name)?];
    }
    let (model, mut release) = prepare(options)?;
    let is_thrown = options.throw.given().next().is_some();
    let bare = (options.release.is_none() && is_thrown).then(|| Throw::at_speed(0.0));
    if bare.is_some() || options.throw.techdisc.is_some() {
        throws::check_sets(&options.set, &model)?;
    }
    let body = CompiledModel::new(&model);
    if options.throw.techdisc.is_some() && options.throw.row.is_none() {
        return launches::run(options, &rows, (&model, &body, &release), out.as_ref());
    }
    let first = rows.first().map(|row| row.throw);
    throws::apply(
        &options.throw,
        options.units,
        first.or(bare),
        &model,
        &mut release,
    )?;
    let turns = model.has_rotating_body();
    if turns && first.is_none() && bare.is_some() && options.throw.spin.is_none() {
        eprintln!("note: thrown without spin; --spin states it, in rpm");
    }
    let settings = IntegrationOptions::with_tolerance(options.tolerance);
    let flight = simulate(&body, &release, &settings)?;
    let flown = FlownThrow::of(&model, &body, &release, &flight);
    if let Some(out) = &out {
        check_rows(options, flight.end)?;
        let title = match options.release.as_deref() {
            Some(name) => format!("{} · {name}", model.name),
            None => release.model.clone(),
        };
        let simulated = Simulated {
            title: &title,
            model: &model,
            body: &body,
            release: &release,
            flight: &flight,
        };
        let summary = flown.as_ref().map_or("", |_| "summary.json, ");
        let what = format!("trajectory.csv, {summary}flight.svg and flight.html");
        out.write(files(&simulated, flown.as_ref(), options.rate), &what)?;
    }
    let mut text = summary(&model, &body, &flight, options.units);
    text.extend(flown.iter().map(|flown| flown::table(flown, options.units)));
    output::print(text)?;
    Ok(Answer::Yes)
}

/// Result file with the characteristics of a flight as JSON.
fn summary_file(path: &str, flown: &FlownThrow, model: &Model) -> ResultFile {
    let text = format!("{:#}\n", flown::json(flown, &model.name));
    ResultFile::new(path, text)
}

const MAX_ROWS: f64 = 1e6;

/// Refuses too many rows of `trajectory.csv` for a flight of `seconds`.
fn check_rows(options: &Simulate, seconds: f64) -> anyhow::Result<()> {
    let (rate, rows) = (options.rate, seconds * options.rate);
    if options.out.is_some() && rows > MAX_ROWS {
        bail!(
            "--rate: {rate} rows per second for {seconds} s are {rows:.0} rows, expected at most {MAX_ROWS}; \
             choose a --rate of at most {:.0}, or a shorter --until",
            (MAX_ROWS / seconds).floor()
        );
    }
    Ok(())
}

fn check_numbers(options: &Simulate) -> anyhow::Result<()> {
    let (rate, tolerance) = (options.rate, options.tolerance);
    ensure!(
        rate > 0.0 && rate <= 1e6,
        "--rate: found {rate}, expected rows per second above 0, at most 1e6"
    );
    ensure!(
        (1e-14..=0.1).contains(&tolerance),
        "--tolerance: found {tolerance}, expected 1e-14 to 0.1"
    );
    Ok(())
}

/// The model and the release with the changes by options, such as wind and parameters.
fn prepare(options: &Simulate) -> anyhow::Result<(Model, Release)> {
    let is_thrown = options.throw.speed.is_some() || options.throw.techdisc.is_some();
    let (mut model, mut release) = match (&options.release, &options.model) {
        (Some(name), model) => released(name, true, model.as_deref(), &options.with)?,
        (None, None) if !is_thrown => {
            let names: Vec<&str> = BUILT_IN.iter().map(|(name, _)| *name).collect();
            bail!(
                "no --release: name one of {} or a TOML file, or state a throw by --speed or --techdisc",
                names.join(", ")
            );
        }
        (None, None) => bail!(
            "no MODEL: expected one before the options of a throw, as in hyzer simulate disc --speed 20"
        ),
        (None, Some(name)) => {
            let model = load(name, &super::names(&options.with))?;
            // Equations stated outright also state where they start, and a body may: at a height, at rest.
            let is_at_rest = |body: &Body| {
                let mut motion = body.position.iter().chain(&body.velocity);
                motion.all(|state| model.states[*state].value == 0.0)
            };
            ensure!(
                is_thrown
                    || !model.body.as_ref().is_some_and(is_at_rest)
                    || !options.set.is_empty(),
                "no release of {name}: state one by --release, a throw by --speed or --techdisc, or initial states by --set"
            );
            let release = throws::at_defaults(name, &model);
            (model, release)
        }
    };
    if let Some(wind) = &options.wind {
        model = super::wind::apply(wind, options.units, model, &mut release)?;
    }
    apply_all(&options.set, &model, &mut release)?;
    match options.until.as_deref() {
        None => {}
        Some("ground") => release.stop = Stop::Ground,
        Some(text) => {
            let most = Release::MAX_DURATION;
            let seconds = text.trim().parse().ok();
            let seconds = seconds.filter(|own| *own > 0.0 && *own <= most);
            release.stop = Stop::Duration(seconds.with_context(|| {
                format!(
                    "--until: found {text}, expected a time above 0, at most {most} s, or ground"
                )
            })?);
        }
    }
    match release.stop {
        Stop::Duration(seconds) => check_rows(options, seconds)?,
        Stop::Ground => ensure!(
            model.place()[2].is_some(),
            "--until: no state of the model {} is a height, whose fall to 0 is the landing; expected a time, as in --until 2",
            model.name
        ),
    }
    Ok((model, release))
}

/// A release by name or file, with the model of an option or its own; other winds than constant only if `in_wind`.
pub(super) fn released(
    name: &str,
    in_wind: bool,
    named: Option<&str>,
    with: &[String],
) -> anyhow::Result<(Model, Release)> {
    let with = super::names(with);
    let vocabulary =
        |own: &str| load(named.unwrap_or(own), &with).map(|model| Vocabulary::of(&model));
    let (release, vocabulary) = read_named(name, in_wind, vocabulary)?;
    let model = vocabulary.model;
    let model = model.ok_or_else(|| anyhow!("{name}: the release names no model"))?;
    let stated = release.parameters.iter().chain(&release.coefficients);
    let stated = stated.map(|(name, value)| (name, value));
    for note in overruled(&replaced(&model), stated, "the release") {
        eprintln!("note: {note}");
    }
    Ok((Model::clone(&model), release))
}

/// Applies the values `NAME=VALUE` of the option `--set`, SI.
pub(super) fn apply_all(
    sets: &[String],
    model: &Model,
    release: &mut Release,
) -> anyhow::Result<()> {
    for set in sets {
        apply(set, model, release)?;
    }
    if let Some(fault) = release.inertia_fault(model) {
        bail!("--set: {fault}");
    }
    let is_set = |state: &usize| {
        let name = &model.states[*state].name;
        let names = sets.iter().filter_map(|set| set.split_once('='));
        names
            .map(|(set, _)| joined(set.trim()))
            .any(|set| set == *name)
    };
    let quaternions = model.quaternions();
    let quaternions = quaternions.filter(|states| states.iter().any(is_set));
    match quaternion_fault(&release.initial, quaternions) {
        Some(fault) => bail!("--set: {fault}: set all four components"),
        None => Ok(()),
    }
}

/// Sets a parameter, coefficient or initial state.
fn apply(set: &str, model: &Model, release: &mut Release) -> anyhow::Result<()> {
    let expected = || format!("--set: found {set:?}, expected NAME=VALUE");
    let (name, value) = set.split_once('=').with_context(expected)?;
    let (name, value) = (&*joined(name.trim()), number("--set", value)?);
    if let Some(why) = release.overruled(name) {
        bail!("--set: {why}");
    }
    let vocabulary = Vocabulary::of(model);
    for (names, values) in [
        (&vocabulary.parameters, &mut release.parameters),
        (&vocabulary.coefficients, &mut release.coefficients),
    ] {
        let Some(constant) = names.iter().find(|constant| constant.name == name) else {
            continue;
        };
        if let Some(expected) = constant.expected_instead_of(value) {
            bail!("--set: found {name} = {value}, expected {expected}");
        }
        let field = release.wind_field.as_mut();
        if field.is_some_and(|field| field.set(name, value)) {
            return Ok(());
        }
        values.retain(|(known, _)| known != name);
        values.push((name.to_owned(), value));
        return Ok(());
    }
    if vocabulary.is_computed(name) {
        bail!("--set: {name} is computed from other parameters; set those");
    }
    if let Some(component) = release.component_of_input(name, model) {
        *component = value;
        return Ok(());
    }
    let Some((_, state)) = release.initial.iter_mut().find(|(known, _)| known == name) else {
        let constants = vocabulary.parameters.iter().chain(&vocabulary.coefficients);
        let mut known: Vec<&str> = constants.map(|constant| constant.name.as_str()).collect();
        known.extend(release.initial.iter().map(|(name, _)| name.as_str()));
        let inputs = model.inputs.iter();
        let inputs: Vec<String> = inputs.map(|own| format!("{}_x", own.name)).collect();
        known.extend(inputs.iter().map(String::as_str));
        let (model, known) = (&model.name, known.join(", "));
        bail!("--set: the model {model} has no {name:?}; it has {known}");
    };
    *state = value;
    Ok(())
}

fn summary(model: &Model, body: &CompiledModel, flight: &Trajectory, units: Units) -> String {
    let layout = body.layout();
    let why = flight.terminal_event.as_deref().unwrap_or("time");
    let mut text = format!("{}: {:.4} s, ended by {why}\n", model.name, flight.end);
    for state in &model.states {
        let end = layout.state(&state.name);
        let value = end.map_or(f64::NAN, |state| flight.end_state[state.index()]);
        let (unit, size) = units.instead_of(&state.unit_text);
        let value = value / size;
        let _ = writeln!(text, "  {:9} {value:>13.6} {unit}", state.name);
    }
    for event in &flight.events {
        let z = body.place()[2].map_or(f64::NAN, |height| event.state[height]);
        let (name, time) = (&event.event, event.time);
        let (z, m) = (units.of_metres(z), units.length());
        let _ = writeln!(text, "  {name} at {time:.4} s, z = {z:.4} {m}");
    }
    let is_generated = body.is_generated();
    let by = if is_generated {
        "generated code"
    } else {
        "the tape"
    };
    let (steps, evaluations) = (flight.stats.steps, flight.stats.evaluations);
    let _ = writeln!(text, "  {steps} steps, {evaluations} evaluations of {by}");
    text
}

/// A simulated flight, with all that its result files show.
pub struct Simulated<'a> {
    /// Title of figure and page.
    pub title: &'a str,
    /// The model.
    pub model: &'a Model,
    /// The compiled model.
    pub body: &'a CompiledModel,
    /// Initial conditions.
    pub release: &'a Release,
    /// States over time.
    pub flight: &'a Trajectory,
}

/// Result files of a flight: trajectory, figure, three-dimensional view and, of a thrown body, the summary.
pub fn files(simulated: &Simulated<'_>, flown: Option<&FlownThrow>, rate: f64) -> Vec<ResultFile> {
    let Simulated {
        title,
        model,
        body,
        release,
        flight,
    } = simulated;
    let names: Vec<&str> = model.states.iter().map(|state| &*state.name).collect();
    let labels = model.states.iter().map(|state| StateLabel {
        name: &state.name,
        unit: &state.unit_text,
    });
    let labels: Vec<StateLabel<'_>> = labels.collect();
    let inputs = release.inputs.iter().filter_map(|(name, series)| {
        let input = model.params.iter().find(|own| own.name == *name)?;
        let label = StateLabel {
            name,
            unit: &input.unit_text,
        };
        Some((label, series.clone()))
    });
    let inputs: Vec<_> = inputs.collect();
    let mut files = vec![
        ResultFile::new("trajectory.csv", trajectory_csv(flight, &names, rate)),
        ResultFile::new("flight.svg", picture(title, flight, &labels, &inputs)),
    ];
    let view = View::of_trajectory(title, model, body, release, flight).html(title);
    files.extend(view.map(|html| ResultFile::new("flight.html", html)));
    files.extend(flown.map(|flown| summary_file("summary.json", flown, model)));
    files
}
