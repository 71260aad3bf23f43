//! Inputs over time of a flight: those of the model, which must cover the flight.

use std::collections::BTreeSet;

use dataset::levels::ROUNDING;
use dataset::statistics::median_of;
use dataset::{Dataset, Flight};
use flight::{InputSeries, InputsOverTime};

use crate::error::FlightError;
use crate::numbers::significant;
use crate::problem::FitProblem;
use crate::wording::names;

/// Share of the median interval between the samples of an input by which a flight may outlast it: the clocks of two
/// devices round differently.
const OUTLASTING: f64 = 0.5;

/// Gap between two samples of an input, in median intervals, from which the report notes that it is bridged.
const NOTED_GAP: f64 = 3.5;

/// Share of the range of an input by which values between its samples may exceed its bounds without a note.
const NOTED_OVERSHOOT: f64 = 1e-3;

/// Number of samples from which a table is a recording, with gaps where samples are missing; fewer are the corners of a
/// curve.
const RECORDED: usize = 20;

/// Inputs over time of a flight whose measured samples are from `span.0` to `span.1`, s, with the time counted from
/// the first of them; and notes for the report.
///
/// # Errors
/// [`FlightError::UnknownInput`] for an input that the model lacks; [`FlightError::InputBounds`] for a value outside
/// its bounds; [`FlightError::RecordedAndEstimated`] for one that is estimated for all flights;
/// [`FlightError::InputSpan`] for one that does not cover the flight.
pub fn of_flight(
    problem: &FitProblem,
    flight: &Flight,
    span: (f64, f64),
) -> Result<(InputsOverTime, Vec<String>), FlightError> {
    let layout = problem.body.layout();
    let mut notes = Vec::new();
    for (name, series) in &flight.inputs {
        let Some(id) = InputsOverTime::parameter(layout, name) else {
            let varying = layout.varying.iter();
            return Err(FlightError::UnknownInput {
                name: name.clone(),
                model: problem.model.name.clone(),
                available: varying
                    .map(|id| layout.parameters[id.index()].clone())
                    .collect(),
            });
        };
        if problem.globals.iter().any(|global| global.param == id) {
            return Err(FlightError::RecordedAndEstimated { name: name.clone() });
        }
        let declared = problem.model.params.get(id.index());
        if let Some(bounds) = declared.and_then(|own| own.bounds)
            && let Some((time, value)) = outside(series, bounds)
        {
            return Err(FlightError::InputBounds {
                name: name.clone(),
                value,
                time,
                bounds,
            });
        }
        if let Some(bounds) = declared.and_then(|own| own.bounds)
            && let Some((time, value)) = overshoot(series, bounds)
        {
            notes.push(format!(
                "the input {name} is {} at {time:.3} s, between its samples and beyond its bounds {} to {}: \
                 interpolation = \"linear\" stays within",
                significant(value, 3),
                significant(bounds.0, 3),
                significant(bounds.1, 3)
            ));
        }
        let given = series.span();
        let times: Vec<f64> = series.samples().map(|(t, _)| t).collect();
        let intervals = times.windows(2).map(|pair| pair[1] - pair[0]);
        let interval = median_of(intervals).unwrap_or(0.0);
        let slack = OUTLASTING * interval;
        if given.0 > span.0 + slack || given.1 < span.1 - slack {
            return Err(FlightError::InputSpan {
                name: name.clone(),
                given,
                needed: span,
            });
        }
        let gap = widest_gap(&times, span);
        if gap > NOTED_GAP * interval && times.len() >= RECORDED {
            notes.push(format!(
                "the input {name} is bridged over {gap:.3} s without a sample"
            ));
        }
    }
    let inputs = flight.inputs.iter();
    let inputs = inputs.map(|(name, series)| (name.as_str(), series.since(span.0)));
    Ok((InputsOverTime::of(layout, inputs), notes))
}

/// Inputs that some flight of the dataset has over time.
pub fn recorded(dataset: &Dataset) -> BTreeSet<String> {
    let all = dataset.flights.iter().flat_map(|flight| &flight.inputs);
    all.map(|(name, _)| name.clone()).collect()
}

/// What is taken for inputs in flights that do not state them, where others have them over time, in words.
pub fn notes(problem: &FitProblem, dataset: &Dataset) -> Vec<String> {
    let (model, layout) = (&problem.model, problem.body.layout());
    let unknown = model.unknown_states();
    let value = |name: &String| {
        let state = unknown.iter().find(|(own, _)| own == name);
        let id = InputsOverTime::parameter(layout, name)?;
        Some(state.map_or(problem.parameters[id.index()], |(_, of)| {
            model.states[*of].value
        }))
    };
    let recorded = recorded(dataset);
    let each = recorded.iter().filter_map(|name| {
        let value = value(name).filter(|_| !dataset.unknown.contains(name))?;
        let is_open = |flight: &&Flight| {
            flight.inputs.iter().all(|(own, _)| own != name)
                && !flight.known.contains_key(name)
                && !flight.unknown.contains(name)
        };
        let open = dataset.flights.iter().filter(is_open);
        let open: Vec<&str> = open.map(|flight| flight.file.as_str()).collect();
        (!open.is_empty()).then(|| {
            format!(
                "the input {name} has no table in {}, as it has in other flights: it is taken as {value}, its default; give the table, or state it under known",
                names(&open)
            )
        })
    });
    each.collect()
}

/// Value between samples, with its time in s, that is farthest beyond `bounds`; `None` if all are within.
fn overshoot(series: &InputSeries, (least, greatest): (f64, f64)) -> Option<(f64, f64)> {
    let slack = NOTED_OVERSHOOT * (greatest - least);
    let beyond = |value: f64| (value - greatest).max(least - value);
    let farthest = series
        .extremes()
        .fold(None, |most: Option<(f64, f64)>, own| {
            let is_farther = most.is_none_or(|most| beyond(own.1) > beyond(most.1));
            if is_farther { Some(own) } else { most }
        });
    farthest.filter(|own| beyond(own.1) > slack)
}

/// First sample (time in s, value) of an input that is not within `bounds`, but for the rounding of units.
fn outside(series: &InputSeries, (least, greatest): (f64, f64)) -> Option<(f64, f64)> {
    let slack = ROUNDING * (least.abs().max(greatest.abs()));
    let within = least - slack..=greatest + slack;
    series.samples().find(|(_, value)| !within.contains(value))
}

/// Longest time between two samples at `times` within `span`, s.
fn widest_gap(times: &[f64], (from, until): (f64, f64)) -> f64 {
    let pairs = times.windows(2);
    let inside = pairs.filter(|pair| pair[1] > from && pair[0] < until);
    inside.map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
}
