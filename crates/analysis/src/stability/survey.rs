//! Modes and criteria along a flight, and over a grid of speeds and spins.

use flight::throw::Throw;
use nalgebra::Vector3;
use ode::Trajectory;

use crate::stability::criteria::{AxisDerivatives, Criteria};
use crate::stability::linearise::{BoundBody, StabilityError};
use crate::stability::modes::{Modes, modes};
use crate::stability::state_space::StateSpace;

/// Modes and stability criteria at one instant of a flight.
#[derive(Clone, Debug)]
pub struct Instant {
    /// Time since release, s.
    pub time: f64,
    /// Motion, by the quantities of a throw.
    pub throw: Throw,
    /// Modes of the linearised motion.
    pub modes: Modes,
    /// Derivatives of the motion of the axis.
    pub derivatives: AxisDerivatives,
    /// Stability criteria of the axis.
    pub criteria: Criteria,
    /// Linearised equations of the model, in its own states.
    pub state_space: StateSpace,
}

/// Modes and stability criteria at a state; `time` is that since release, s.
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
        state_space: linearised.state_space,
    })
}

/// Modes and stability criteria at `count` equidistant times of a flight, both ends among them.
///
/// # Errors
/// [`StabilityError`] if the motion cannot be linearised at one of these times.
pub fn along(
    body: &BoundBody<'_>,
    flight: &Trajectory,
    count: usize,
) -> Result<Vec<Instant>, StabilityError> {
    let last = count.max(2) - 1;
    let step = |k: usize| flight.start + (flight.end - flight.start) * k as f64 / last as f64;
    let states = (0..=last).filter_map(|k| Some((step(k), flight.sample(step(k))?)));
    states.map(|(t, state)| at(body, t, &state)).collect()
}

/// Modes and stability criteria of throws that equal `throw` except for speed (m/s), spin (rpm) and wobble (none): for
/// each speed, every spin. A pair is left out if no state of the model has the motion of its throw.
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
        let thrown = &body.body.thrown;
        let state = thrown.state(&own, [0.0; 2], &body.parameters).ok()?;
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
    /// Wind velocity, m/s, by the model's input `wind`; zero without it.
    pub fn wind(&self) -> Vector3<f64> {
        let components = self.body.compiled.layout().components("wind");
        components.map_or_else(Vector3::zeros, |components| {
            Vector3::from(components.map(|c| self.parameters[c.index()]))
        })
    }
}
