//! Compares the ends of flights of the old and the new model from the same releases.

use super::pairing::Pairing;
use super::values::Everything;
use crate::integration;
use crate::random::Random;
use crate::sample::{self, is_valid};
use flight::release::{self, Vocabulary};
use model_spec::load::LoadError;
use ode::{IntegrationError, IntegrationOptions};
use oracle::{Chart, Point};
use serde::Serialize;

/// Number of random releases (initial states) from which flights are compared if the model has no built-in release.
const RELEASES: usize = 3;
/// Fraction of the way from the model's default point to a random point at which the initial values of a random release
/// (launch conditions of a flight) lie.
const SPREAD: f64 = 0.2;
/// Relative tolerance with which the compared flights are integrated.
const TOLERANCE: f64 = 1e-10;

/// Difference between the flights of two models that start from the same release (initial state).
#[derive(Clone, Debug, Default, Serialize)]
pub struct FlightShift {
    /// Name of the release (initial state of the flights): that of a built-in release, or `random 1` and so on.
    pub release: String,
    /// Duration of the flights, s.
    pub seconds: f64,
    /// Distance between the final positions of the two flights, m; `None` if one of the models has neither a body nor
    /// an observation, or if a flight failed.
    pub distance_m: Option<f64>,
    /// Name of the state whose final values in the two flights differ most, relative to the magnitude of the state.
    pub state: String,
    /// Value of the state named in `state` at the end of the old model's flight.
    pub old: f64,
    /// Value of the state named in `state` at the end of the new model's flight.
    pub new: f64,
    /// Reason why one of the flights could not be simulated; `old` and `new` are then 0. `None` if both flights were
    /// simulated.
    pub failed: Option<String>,
}

impl FlightShift {
    /// Records that the flight of `model` (the old or the new one) failed, with the first line of the error.
    fn with_failure(mut self, model: &str, error: &IntegrationError) -> FlightShift {
        let text = error.to_string();
        let line = text.lines().next().unwrap_or_default();
        self.failed = Some(format!("{model}: {line}"));
        self
    }
}

/// Simulates flights of `seconds` with both models from the same launch conditions (releases), chosen for the old
/// model. Returns the differences between the final states of the two models' flights, one per release.
pub fn shifts(
    old: &Everything<'_>,
    new: &Everything<'_>,
    pairing: &Pairing,
    seconds: f64,
) -> Vec<FlightShift> {
    let mut releases = named(old, true);
    if releases.is_empty() {
        releases = named(old, false);
    }
    if releases.is_empty() {
        let mut random = Random::new(0, "releases");
        releases.extend((1..=RELEASES).map(|k| {
            let defaults = Point::defaults(old.model);
            let drawn = sample::point(old.model, &mut random);
            let mut point = sample::between(&defaults, &drawn, SPREAD);
            point.params.clone_from(&defaults.params);
            point.coefficients.clone_from(&defaults.coefficients);
            point.time = 0.0;
            if !is_valid(old.model, &point) {
                point = defaults;
            }
            (format!("random {k}"), point, Vec::new())
        }));
    }
    releases
        .into_iter()
        .map(|(name, point, set)| shift(old, new, pairing, name, &point, &set, seconds))
        .collect()
}

/// Built-in releases (launch conditions: initial states and constants of a flight) that fit the old model. Each has its
/// name, its point and the indices of the parameters that it sets. If `own` is true, only releases written for this
/// model are returned. Otherwise releases written for other models are included if the old model has all names that
/// they use.
fn named(old: &Everything<'_>, own: bool) -> Vec<(String, Point<f64>, Vec<usize>)> {
    let model = old.model;
    let read = |&(name, text): &(&str, &str)| {
        let vocabulary = |of: &str| match !own || of == model.name {
            true => Ok(Vocabulary::of(model)),
            false => Err(LoadError::UnknownModel {
                wanted: of.to_owned(),
                known: vec![model.name.clone()],
            }),
        };
        let release = release::read(name, text, vocabulary).ok()?;
        let mut point = Point::defaults(model);
        point.states = release.state();
        let layout = &old.code.layout;
        let constants = release.parameters.iter().chain(&release.coefficients);
        let mut set = Vec::new();
        for (constant, value) in constants {
            let index = layout.parameters.iter().position(|p| p == constant)?;
            set.push(index);
            match index.checked_sub(layout.params) {
                None => point.params[index] = *value,
                Some(k) => *point.coefficients.get_mut(k)? = *value,
            }
        }
        if let Some(wind) = model.inputs.iter().position(|i| i.name == "wind") {
            point.inputs[wind] = release.wind.into();
        }
        (point.states.len() == model.states.len()).then(|| (name.to_owned(), point, set))
    };
    release::BUILT_IN.iter().filter_map(read).collect()
}

fn shift(
    old: &Everything<'_>,
    new: &Everything<'_>,
    pairing: &Pairing,
    release: String,
    here: &Point<f64>,
    set: &[usize],
    seconds: f64,
) -> FlightShift {
    // Values stated in a model file are not carried over to the other model; values set by the release are.
    let parameters = pairing.parameters.iter().enumerate().map(|(k, from)| {
        let is_input = k >= new.model.params.len() + new.model.coefficients.len();
        from.filter(|from| is_input || set.contains(from))
    });
    let of_release = Pairing {
        states: pairing.states.clone(),
        parameters: parameters.collect(),
    };
    let there = of_release.carry(here, &Point::defaults(new.model));
    let mut out = FlightShift {
        release,
        seconds,
        ..FlightShift::default()
    };
    let (a, b) = match (fly(old, here, seconds), fly(new, &there, seconds)) {
        (Ok(a), Ok(b)) => (a, b),
        (Err(error), _) => return out.with_failure("the old model", &error),
        (_, Err(error)) => return out.with_failure("the new model", &error),
    };
    let ends = position(old, &a, here).zip(position(new, &b, &there));
    out.distance_m = ends.map(|(p, q)| {
        let squares = p.iter().zip(&q).map(|(p, q)| (p - q).powi(2));
        squares.sum::<f64>().sqrt()
    });
    let mut worst = -1.0;
    for (k, from) in pairing.states.iter().enumerate() {
        let Some(from) = *from else { continue };
        let size = sample::typical(new.model.states[k].unit);
        let difference = (a[from] - b[k]).abs() / size.max(a[from].abs());
        if difference > worst {
            worst = difference;
            out.state.clone_from(&new.model.states[k].name);
            (out.old, out.new) = (a[from], b[k]);
        }
    }
    out
}

/// Position, m, at the end of a flight with the final states `states`: that of the body if the model has a body,
/// otherwise the observed position, with all other values from `point`. `None` if the model has neither a body nor an
/// observation.
fn position(model: &Everything<'_>, states: &[f64], point: &Point<f64>) -> Option<Vec<f64>> {
    if let Some(chart) = Chart::declared(model.model) {
        return Some(chart.physical(states).position.iter().copied().collect());
    }
    let mut at = point.clone();
    at.states = states.to_vec();
    let count = states.len();
    let values = model.numbers(&at);
    (model.code.observed == 3).then(|| values[count..count + 3].to_vec())
}

fn fly(
    model: &Everything<'_>,
    from: &Point<f64>,
    seconds: f64,
) -> Result<Vec<f64>, IntegrationError> {
    let rates = |at: &Point<f64>| {
        let mut all = model.numbers(at);
        all.truncate(from.states.len());
        all
    };
    let options = IntegrationOptions::with_tolerance(TOLERANCE);
    Ok(integration::fly(&rates, from, seconds, &options)?.states)
}
