//! Flies a release with the old and the new model: where and when each flight ends.

use flight::release::{Release, ReleaseError, Vocabulary, read, read_named};
use flight::{CompiledModel, simulate};
use model_spec::model::Model;
use ode::IntegrationOptions;
use serde::Serialize;
use std::collections::BTreeMap;

/// Relative tolerance with which the flights are integrated.
const TOLERANCE: f64 = 1e-10;

/// Ends of the flights of the old and the new model from one release.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Landing {
    /// Name or path of the release.
    pub release: String,
    /// The old model's flight.
    pub old: Flown,
    /// The new model's flight.
    pub new: Flown,
}

/// Result of simulating a flight.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Flown {
    /// Where and when the flight ended.
    End(End),
    /// Why the flight could not be simulated.
    Failed(String),
}

/// End of a flight.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct End {
    /// Time from the release, s.
    pub time_s: f64,
    /// Event that ended the flight, such as `ground`, or `time`.
    pub reason: String,
    /// Position of the body, m, by name; without a body x, y and z, or all states, SI.
    pub state: BTreeMap<String, f64>,
}

/// A release that one of the compared models cannot use.
#[derive(Debug, thiserror::Error)]
#[error("the {which} model cannot fly the release")]
pub struct LandingError {
    /// The model concerned: `old` or `new`.
    pub which: &'static str,
    /// What is wrong with the release for this model.
    pub source: ReleaseError,
}

/// Flies a release, a file or a built-in one, with both models; the model that it names is ignored.
///
/// # Errors
/// [`LandingError`] if the release cannot be read, or contains names that one of the models does not have.
pub fn landing(release: &str, old: &Model, new: &Model) -> Result<Landing, LandingError> {
    ends(release, old, new, |model| {
        let vocabulary = |_: &str| Ok(Vocabulary::of(model));
        Ok(read_named(release, false, vocabulary)?.0)
    })
}

/// Flies the release of a text with both models, as [`landing`] does.
///
/// # Errors
/// As [`landing`].
pub fn landing_of_text(
    name: &str,
    text: &str,
    old: &Model,
    new: &Model,
) -> Result<Landing, LandingError> {
    ends(name, old, new, |model| {
        read(name, text, |_: &str| Ok(Vocabulary::of(model)))
    })
}

fn ends(
    release: &str,
    old: &Model,
    new: &Model,
    read: impl Fn(&Model) -> Result<Release, ReleaseError>,
) -> Result<Landing, LandingError> {
    let fly = |which, model| {
        let read = read(model).map_err(|source| LandingError { which, source });
        read.map(|release| fly(&release, model))
    };
    Ok(Landing {
        old: fly("old", old)?,
        new: fly("new", new)?,
        release: release.to_owned(),
    })
}

fn fly(release: &Release, model: &Model) -> Flown {
    let options = IntegrationOptions::with_tolerance(TOLERANCE);
    let flight = simulate(&CompiledModel::new(model), release, &options);
    let is_axis = |index: usize| ["x", "y", "z"].contains(&model.states[index].name.as_str());
    let has_axes = (0..model.states.len())
        .filter(|&index| is_axis(index))
        .count()
        == 3;
    let is_shown = |index: usize| match &model.body {
        Some(body) => body.position.contains(&index),
        None => !has_axes || is_axis(index),
    };
    match flight {
        Ok(flight) => Flown::End(End {
            time_s: flight.end,
            reason: flight.terminal_event.unwrap_or_else(|| "time".into()),
            state: (0..model.states.len())
                .filter(|&index| is_shown(index))
                .map(|index| (model.states[index].name.clone(), flight.end_state[index]))
                .collect(),
        }),
        Err(error) => Flown::Failed(error.to_string()),
    }
}
