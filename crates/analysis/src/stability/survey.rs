//! Modes and criteria along a flight, and over a grid of speeds and spins.

use flight::throw::Throw;
use nalgebra::Vector3;
use ode::Trajectory;

use crate::stability::criteria::{AxisDerivatives, Criteria};
use crate::stability::linearise::{BoundBody, StabilityError};
use crate::stability::modes::{Modes, modes};

/// Modes and stability criteria of a body at one instant of a flight.
#[derive(Clone, Debug)]
pub struct Instant {
    /// Time since release, s.
    pub time: f64,
    /// Motion of the body at this instant, expressed by the quantities of a throw, such as speed, angles and spin.
    pub throw: Throw,
    /// Modes of the motion linearised about the state of the body at this instant.
    pub modes: Modes,
    /// Derivatives, at this instant, that determine how the body axis moves in the air stream.
    pub derivatives: AxisDerivatives,
    /// Stability criteria of the body axis at this instant.
    pub criteria: Criteria,
}

/// Computes the modes and stability criteria of a body at a state in flight; `time` is the time since release, s.
///
/// # Errors
/// [`StabilityError`] if the motion cannot be linearised at the state.
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

/// Computes the modes and stability criteria at `count` equidistant times of a flight, including both ends.
///
/// # Errors
/// [`StabilityError`] if the motion cannot be linearised at one of these times.
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

/// Computes the modes and stability criteria of throws that equal `throw` except for speed (m/s), spin (rpm) and wobble
/// (none). There is one throw for every pair of a speed and a spin, in the order of the speeds and, for each speed, of
/// the spins. A pair is left out if no state of the model has the motion of its throw.
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
        // The throw as requested, without the rounding errors of the state.
        Some(Instant {
            throw: own,
            ..instant
        })
    });
    instants.collect()
}

impl BoundBody<'_> {
    /// Wind velocity, m/s, in inertial axes, given by the model's input `wind`; zero if the model has no such input.
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
