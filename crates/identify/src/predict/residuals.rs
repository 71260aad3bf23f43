//! Trajectories and residuals without derivatives.

use flight::ModelState;
use nalgebra::DVector;

use super::trajectory_pass::integration_options;
use crate::channel_observers::ChannelConditions;
use crate::error::FlightError;
use crate::observations::Observations;
use crate::problem::FitProblem;
use crate::tolerance::RESIDUAL_TOLERANCE;

/// Residuals `[channel][sample]`, (predicted − measured) × scale of the channel, m; `None` for a missing value.
/// Outliers are included.
pub type Residuals = Vec<Vec<Option<[f64; 3]>>>;

/// Integrates a flight and returns the model states at its first `samples` samples, concatenated sample by sample.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub fn states(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Vec<f64>, FlightError> {
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let start: ModelState = local.as_slice().into();
    let times = &observations.times[..samples];
    let mut states = vec![0.0; start.len() * times.len()];
    let tolerance = RESIDUAL_TOLERANCE * problem.sigma0 * observations.tolerance_factor;
    let options = integration_options(tolerance, times.len());
    let from = (times[0], &start);
    conditions.integrate_at(from, times, &options, &mut [], &mut states)?;
    Ok(states)
}

/// Residuals `[channel][sample]` at the first `samples` samples of a flight, (predicted − measured) × scale of the
/// channel, m. `None` for a missing value; outliers are included.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub fn residuals(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Residuals, FlightError> {
    let states = states(problem, observations, unknowns, samples)?;
    Ok(residuals_of(problem, observations, unknowns.0, &states))
}

/// Residuals `[channel][sample]` at the first samples of a flight, (predicted − measured) × scale of the channel, m.
/// `trajectory` contains the model states at these samples, concatenated sample by sample. `None` for a missing value;
/// outliers are included.
pub fn residuals_of(
    problem: &FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
    trajectory: &[f64],
) -> Residuals {
    let parameters = observations.parameters(problem, global);
    let conditions = ChannelConditions::new(problem, &parameters);
    let mut observers = conditions.observers();
    let states = observations.manifold.states();
    let samples = trajectory.len() / states;
    let mut residuals = vec![Vec::with_capacity(samples); observations.channels];
    for (sample, state) in trajectory.chunks(states).enumerate() {
        let time = observations.times[sample];
        for (channel, residuals) in residuals.iter_mut().enumerate() {
            let measured = observations.value(sample, channel);
            residuals.push(measured.map(|seen| observers.residual(time, state, channel, seen)));
        }
    }
    residuals
}
