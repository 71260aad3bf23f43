//! Modes and criteria along a flight, and over a grid of speeds and spins.

use flight::throw::Throw;
use nalgebra::Vector3;
use ode::Trajectory;

use crate::criteria::{AxisDerivatives, Criteria};
use crate::linearise::{BoundBody, StabilityError};
use crate::modes::{Modes, modes};

/// Modes and criteria at a state.
#[derive(Clone, Debug)]
pub struct Instant {
    /// Time of the flight, s; 0 for a release.
    pub time: f64,
    /// Motion there.
    pub throw: Throw,
    /// Its modes.
    pub modes: Modes,
    /// Derivatives of the axis in the stream.
    pub derivatives: AxisDerivatives,
    /// What the criteria say.
    pub criteria: Criteria,
}

/// Modes and criteria at a state.
///
/// # Errors
/// [`StabilityError`]
pub fn at(body: &BoundBody<'_>, time: f64, state: &[f64]) -> Result<Instant, StabilityError> {
    let linearised = body.linearise(time, state)?;
    let derivatives = AxisDerivatives::of(&linearised, body.wind());
    Ok(Instant {
        time,
        throw: body.body.thrown.throw(state, &body.parameters),
        modes: modes(&linearised, 0.0),
        criteria: derivatives.criteria(),
        derivatives,
    })
}

/// Modes and criteria at `count` times of a flight, its ends among them.
///
/// # Errors
/// [`StabilityError`]
pub fn along(
    body: &BoundBody<'_>,
    flight: &Trajectory,
    count: usize,
) -> Result<Vec<Instant>, StabilityError> {
    let last = count.max(2) - 1;
    let times =
        (0..=last).map(|k| flight.start + (flight.end - flight.start) * k as f64 / last as f64);
    times
        .filter_map(|t| Some((t, flight.sample(t)?)))
        .map(|(t, state)| at(body, t, &state))
        .collect()
}

/// Modes and criteria of a throw with other speeds (m/s) and spins (rpm), speed by speed; those whose motion the model cannot have
/// are left out.
pub fn map(body: &BoundBody<'_>, throw: &Throw, speeds: &[f64], spins: &[f64]) -> Vec<Instant> {
    let pairs = speeds
        .iter()
        .flat_map(|speed| spins.iter().map(move |spin| (*speed, *spin)));
    let instants = pairs.filter_map(|(speed, spin)| {
        let own = Throw {
            speed,
            spin: Some(spin),
            wobble: None,
            ..*throw
        };
        let state = body
            .body
            .thrown
            .state(&own, [0.0; 2], &body.parameters)
            .ok()?;
        let instant = at(body, 0.0, &state).ok()?;
        // As asked for, without the rounding of the state.
        Some(Instant {
            throw: own,
            ..instant
        })
    });
    instants.collect()
}

impl BoundBody<'_> {
    /// Velocity of the air, m/s, of a model that has the input `wind`; still air otherwise.
    pub fn wind(&self) -> Vector3<f64> {
        let components = self.body.compiled.layout().components("wind");
        let values = components
            .into_iter()
            .flatten()
            .map(|c| self.parameters[c.index()]);
        let values: Vec<f64> = values.collect();
        match values[..] {
            [x, y, z] => Vector3::new(x, y, z),
            _ => Vector3::zeros(),
        }
    }
}
