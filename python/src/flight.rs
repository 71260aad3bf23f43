//! Flights: simulated from a release, which is read as a release file is.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use dataset::AXES;
use flight::release::{self, Release, Stop, Vocabulary, overruled, quaternion_fault};
use flight::throw::FlownThrow;
use flight::{CompiledModel, simulate};
use hyzer::program::simulate::{Simulated, files, summary_json};
use model_spec::model::Model as Checked;
use ode::{IntegrationOptions, Trajectory};
use pyo3::prelude::*;

use crate::array::{array, numbers, points};
use crate::errors::{input, raise, warn};
use crate::fit::write;
use crate::model::Model;
use crate::work;

/// Largest number of samples of a flight, as of the program's trajectory.csv.
const MAX_ROWS: f64 = 1e6;

/// Largest number of derivatives by the samples of an input.
const MAX_DERIVATIVES: usize = 100_000_000;

/// A simulated flight.
#[pyclass(frozen, module = "hyzer._hyzer")]
pub struct Flight {
    model: Arc<Checked>,
    body: Arc<CompiledModel>,
    release: Release,
    trajectory: Trajectory,
    title: String,
    rate: f64,
    tolerance: f64,
}

/// A release of a model from the text of a release file, and the model to fly it with: a wind changes the model. Warns of
/// values of the model that the release overrules, but for those that are `set` anyway.
pub fn released(
    py: Python<'_>,
    model: &Model,
    name: &str,
    text: &str,
    set: &[(String, f64)],
) -> PyResult<(Arc<Checked>, Option<Arc<CompiledModel>>, Release)> {
    let vocabulary = Vocabulary::of(&model.checked);
    let (release, vocabulary) =
        release::read_in_wind(name, text, &[], |_| Ok(vocabulary)).map_err(raise)?;
    let stated = release.parameters.iter().chain(&release.coefficients);
    let stated = stated.filter(|(name, _)| !set.iter().any(|(own, _)| own == name));
    let stated = stated.map(|(name, value)| (name, value));
    warn(py, &overruled(model.replaced(), stated, "the release"))?;
    match vocabulary.model.filter(|_| release.wind_field.is_some()) {
        Some(composed) => Ok((composed, None, release)),
        None => Ok((model.checked.clone(), Some(model.compiled_model()), release)),
    }
}

/// Name and text of a release file, or of a built-in release by its name; a file takes precedence.
#[pyfunction]
pub fn release_text(name: &str) -> PyResult<String> {
    match release::built_in(name) {
        Some(text) if !Path::new(name).is_file() => Ok(text.to_owned()),
        _ => std::fs::read_to_string(name).map_err(|error| {
            let known: Vec<&str> = release::BUILT_IN.iter().map(|(name, _)| *name).collect();
            let known = known.join(", ");
            input(format!(
                "{name}: {error}; expected a TOML file, or a release by name: {known}"
            ))
        }),
    }
}

/// Sets parameters, coefficients and initial states of a release by name.
fn set(release: &mut Release, model: &Checked, values: Vec<(String, f64)>) -> PyResult<()> {
    let vocabulary = Vocabulary::of(model);
    for (name, value) in values {
        if let Some(why) = release.overruled(&name) {
            return Err(input(why));
        }
        let constants = vocabulary.parameters.iter().chain(&vocabulary.coefficients);
        if let Some(constant) = constants.clone().find(|constant| constant.name == name) {
            if let Some(expected) = constant.expected_instead_of(value) {
                return Err(input(format!("{name} is {value}, expected {expected}")));
            }
            release.parameters.retain(|(known, _)| *known != name);
            release.coefficients.retain(|(known, _)| *known != name);
            release.coefficients.push((name, value));
            continue;
        }
        if let Some(component) = release.component_of_input(&name, model) {
            *component = value;
            continue;
        }
        let Some(state) = release.initial.iter_mut().find(|(known, _)| *known == name) else {
            let states = vocabulary.states.iter().map(String::as_str);
            let inputs = model.inputs.iter();
            let inputs = inputs.flat_map(|own| AXES.map(|axis| format!("{}_{axis}", own.name)));
            let inputs: Vec<String> = inputs.collect();
            let known = constants
                .map(|constant| constant.name.as_str())
                .chain(inputs.iter().map(String::as_str))
                .chain(states);
            let hint = release::suggestion(&name, known);
            let model = &model.name;
            return Err(input(format!("the model {model} has no {name:?}{hint}")));
        };
        state.1 = value;
    }
    match quaternion_fault(&release.initial, model.quaternions()) {
        Some(fault) => Err(input(fault)),
        None => Ok(()),
    }
}

fn stop(until: &Bound<'_, PyAny>) -> PyResult<Stop> {
    if let Ok(text) = until.extract::<String>()
        && text == "ground"
    {
        return Ok(Stop::Ground);
    }
    let (max, found) = (Release::MAX_DURATION, until.extract::<f64>());
    match found {
        Ok(seconds) if seconds > 0.0 && seconds <= max => Ok(Stop::Duration(seconds)),
        _ => Err(input(format!(
            "until is {until}, expected \"ground\" or a number of seconds above 0, at most {max}"
        ))),
    }
}

/// Simulates the flight of a model from a release, the text of a release file.
#[pyfunction]
#[pyo3(signature = (model, name, text, until, rate, tolerance, values))]
#[expect(
    clippy::too_many_arguments,
    reason = "called from one place, by position"
)]
pub fn fly(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    name: &str,
    text: &str,
    until: Option<&Bound<'_, PyAny>>,
    rate: f64,
    tolerance: f64,
    values: Vec<(String, f64)>,
) -> PyResult<Flight> {
    if !(rate > 0.0 && rate <= MAX_ROWS) {
        return Err(input(format!(
            "rate is {rate}, expected samples per second above 0, at most 1e6"
        )));
    }
    if !(1e-14..=0.1).contains(&tolerance) {
        return Err(input(format!(
            "tolerance is {tolerance}, expected 1e-14 to 0.1"
        )));
    }
    let (checked, body, mut release) = released(py, model.get(), name, text, &values)?;
    set(&mut release, &checked, values)?;
    if let Some(until) = until {
        release.stop = stop(until)?;
    }
    let own = Arc::clone(&checked);
    let flown = work::run(py, None, move |_| {
        let body = body.unwrap_or_else(|| Arc::new(CompiledModel::new(&own)));
        let options = IntegrationOptions::with_tolerance(tolerance);
        simulate(&body, &release, &options).map(|trajectory| (body, release, trajectory))
    })?;
    let (body, release, trajectory) = flown.map_err(raise)?;
    let seconds = trajectory.end - trajectory.start;
    if seconds * rate > MAX_ROWS {
        return Err(input(format!(
            "rate is {rate}: {seconds} s are {:.0} samples, expected at most 1e6",
            seconds * rate
        )));
    }
    let title = format!("{} · {name}", checked.name);
    Ok(Flight {
        model: checked,
        body,
        release,
        trajectory,
        title,
        rate,
        tolerance,
    })
}

impl Flight {
    fn rows(&self) -> impl Iterator<Item = (f64, Vec<f64>)> {
        self.trajectory.at_rate(self.rate)
    }

    fn flown(&self) -> Option<FlownThrow> {
        FlownThrow::of(&self.model, &self.body, &self.release, &self.trajectory)
    }
}

#[pymethods]
impl Flight {
    #[getter]
    fn names(&self) -> Vec<String> {
        self.body.layout().states.clone()
    }

    #[getter]
    fn units(&self) -> Vec<String> {
        self.model
            .states
            .iter()
            .map(|state| state.unit_text.clone())
            .collect()
    }

    #[getter]
    fn title(&self) -> &str {
        &self.title
    }

    #[getter]
    fn duration(&self) -> f64 {
        self.trajectory.end - self.trajectory.start
    }

    #[getter]
    fn ended_by(&self) -> &str {
        self.trajectory.terminal_event.as_deref().unwrap_or("time")
    }

    #[getter]
    fn events(&self) -> Vec<(String, f64)> {
        let events = self.trajectory.events.iter();
        events
            .map(|event| (event.event.to_string(), event.time))
            .collect()
    }

    fn time_array<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let times: Vec<f64> = self.rows().map(|(t, _)| t).collect();
        let len = times.len();
        array(py, times, &[len])
    }

    fn state_array<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let values: Vec<f64> = self.rows().flat_map(|(_, state)| state).collect();
        let n = self.trajectory.states();
        let len = values.len() / n.max(1);
        array(py, values, &[len, n])
    }

    fn at<'py>(&self, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let (times, mut shape) = numbers(t, "t")?;
        let mut values = Vec::with_capacity(times.values().len() * self.trajectory.states());
        for &t in times.values() {
            let state = self.trajectory.sample(t).ok_or_else(|| {
                let (start, end) = (self.trajectory.start, self.trajectory.end);
                input(format!(
                    "t is {t}, expected a time of the flight, {start} to {end} s"
                ))
            });
            values.extend(state?);
        }
        shape.push(self.trajectory.states());
        array(t.py(), values, &shape)
    }

    fn markers<'py>(&self, marker: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let (markers, several) = points(marker, "marker")?;
        if self.body.layout().marker.is_empty() {
            let name = &self.model.name;
            return Err(input(format!(
                "the model {name} does not say what is observed of it"
            )));
        }
        let bound = self.body.bind(self.body.release_parameters(&self.release));
        let mut observer = bound.observer();
        let mut values = Vec::new();
        let mut len = 0;
        for (t, state) in self.rows() {
            len += 1;
            values.extend(
                markers
                    .iter()
                    .flat_map(|marker| observer.position(t, &state, marker)),
            );
        }
        let shape = if several {
            vec![len, markers.len(), 3]
        } else {
            vec![len, 3]
        };
        array(marker.py(), values, &shape)
    }

    fn derivatives<'py>(&self, py: Python<'py>, input_name: &str) -> PyResult<Bound<'py, PyAny>> {
        let layout = self.body.layout();
        let varying = layout.parameter(input_name);
        let Some(id) = varying.filter(|id| layout.varying.contains(id)) else {
            let known = layout
                .varying
                .iter()
                .map(|id| &*layout.parameters[id.index()]);
            let known: Vec<&str> = known.collect();
            return Err(input(match known[..] {
                [] => format!("the model {} has no scalar input", self.model.name),
                _ => format!("found {input_name:?}, expected one of {}", known.join(", ")),
            }));
        };
        let (times, states): (Vec<f64>, Vec<Vec<f64>>) = self.rows().unzip();
        let parameters = self.body.release_parameters(&self.release);
        let series = parameters.inputs.series().find(|(own, _)| *own == id);
        let Some(samples) = series.map(|(_, series)| series.samples().count()) else {
            return Err(input(format!(
                "{input_name} is constant in this flight, expected an input over time"
            )));
        };
        let shape = [samples, times.len(), layout.states.len()];
        if shape.iter().product::<usize>() > MAX_DERIVATIVES {
            return Err(input(format!(
                "{} samples of {input_name} at {} times are too many derivatives; expected at most 1e8 numbers: \
                 fly with a lower rate",
                shape[0], shape[1]
            )));
        }
        let (body, start) = (Arc::clone(&self.body), states[0].clone());
        let options = IntegrationOptions::with_tolerance(self.tolerance);
        let found = work::run(py, None, move |_| {
            let bound = body.bind(parameters);
            bound.derivatives_by_samples(id, (times[0], &start), &times, &options)
        })?;
        array(py, found.map_err(raise)?.concat(), &shape)
    }

    fn summary_json(&self) -> Option<String> {
        self.flown()
            .map(|flown| summary_json(&flown, &self.model.name).to_string())
    }

    fn view_html(&self) -> Option<String> {
        let files = self.files();
        let view = files.into_iter().find(|file| file.path == "flight.html");
        view.map(|file| String::from_utf8_lossy(&file.contents).into_owned())
    }

    fn save_files(&self, folder: PathBuf) -> PyResult<()> {
        write(&folder, &self.files())
    }
}

impl Flight {
    fn files(&self) -> Vec<flight::files::ResultFile> {
        let simulated = Simulated {
            title: &self.title,
            model: &self.model,
            body: &self.body,
            release: &self.release,
            flight: &self.trajectory,
        };
        files(&simulated, self.flown().as_ref(), self.rate)
    }
}
