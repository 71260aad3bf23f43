//! One integration of a flight with sensitivities, which visits each residual with its derivatives.

use std::ops::Range;

use flight::{BoundModel, ModelState, ObservationJacobians};
use model_spec::layout::ParamId;
use nalgebra::DVector;
use ode::{
    DifferentiableRhs, IntegrationError, IntegrationFailure, Sensitivities, SensitivityLayout,
};

use super::jacobian_columns::JacobianColumns;
use super::observed_point::{ObservedPoint, Residuals, integration_options};
use super::{PointResidual, summary_pass};
use crate::error::FlightError;
use crate::observations::Observations;
use crate::observers::ChannelConditions;
use crate::problem::FitProblem;
use dataset::statistics::robust_sigma;

/// One integration of a flight with sensitivities, which evaluates every residual.
pub(crate) struct TrajectoryPass<'a> {
    pub problem: &'a FitProblem,
    pub observations: &'a Observations,
    pub global: &'a DVector<f64>,
    pub local: &'a DVector<f64>,
    /// Number of samples that are integrated, counted from the first one.
    pub samples: usize,
    pub tolerance: f64,
    /// Whether measured values that are marked as outliers are processed too; if `false`, they are skipped.
    pub with_outliers: bool,
}

impl TrajectoryPass<'_> {
    /// Integrates the flight, or reuses the trajectory in `cache`, and calls `each` with every measured value. Returns the
    /// layout of the states in the cache.
    pub fn each_point(
        &self,
        motion: &mut dyn DifferentiableRhs,
        columns: &JacobianColumns<'_>,
        cache: Option<&mut Option<Vec<f64>>>,
        mut each: impl FnMut(ObservedPoint<'_>),
    ) -> Result<SensitivityLayout, FlightError> {
        let (problem, observations) = (self.problem, self.observations);
        let parameters: Vec<usize> = columns
            .parameters
            .iter()
            .copied()
            .map(ParamId::index)
            .collect();
        let mut variations = Sensitivities::new(motion, columns.integrated, &parameters);
        let places = variations.layout();
        let tangent = observations.manifold.tangent(self.local.as_slice());
        let start = variations.initial_state(self.local.as_slice(), &columns.tangent(&tangent));
        if observations.is_summary {
            let of = ((problem, observations), self.global, self.tolerance);
            summary_pass::each_point(of, &mut variations, &start, columns, each)?;
            return Ok(places);
        }
        let values = observations.parameters(problem, self.global);
        let conditions = ChannelConditions::new(problem, &values);
        let mut observers = conditions.observers();
        let mut rows = columns.empty_rows();
        let times = &observations.times[..self.samples];
        let mut visit = |sample: usize, both: &[f64]| {
            let (time, state) = (times[sample], places.state(both));
            for channel in 0..observations.channels {
                let Some(measured) = self.measured(sample, channel) else {
                    continue;
                };
                let derive = |by: &ObservationJacobians<'_>, rows: &mut [Vec<f64>; 3]| {
                    columns.derive(by, (places, both), rows);
                };
                let residual =
                    observers.linearise((time, state), channel, measured, &mut rows, derive);
                each(ObservedPoint {
                    channel,
                    sample,
                    time,
                    residual,
                    rows: &mut rows,
                });
            }
        };
        let length = variations.len();
        if let Some(Some(trajectory)) = cache {
            for (sample, both) in trajectory.chunks(length).enumerate() {
                visit(sample, both);
            }
            return Ok(places);
        }
        let (from, options) = (
            (times[0], &start),
            integration_options(self.tolerance, times.len()),
        );
        let beyond = |error| beyond_limit(problem, &problem.body.bind(values.clone()), error);
        match cache {
            Some(cache) => {
                let mut trajectory = vec![0.0; length * times.len()];
                variations
                    .integrate_at(from, times, &options, &mut [], &mut trajectory)
                    .map_err(beyond)?;
                for (sample, both) in cache.insert(trajectory).chunks(length).enumerate() {
                    visit(sample, both);
                }
            }
            None => {
                let instruments = problem
                    .instruments
                    .iter()
                    .flat_map(|(_, own)| own.observed_states());
                let mut observed = problem.body.observed_states();
                observed.extend(instruments);
                observed.sort_unstable();
                observed.dedup();
                let observed = observed.into_iter().map(|state| places.row_range(state));
                let shown = joined(std::iter::once(places.state_range()).chain(observed));
                variations
                    .integrate_with_callback(from, times, &options, &shown, &mut visit)
                    .map_err(beyond)?;
            }
        }
        Ok(places)
    }

    /// As [`each_point`](Self::each_point), with the derivatives by the local parameters first, then by the selected ones.
    pub fn each_residual(
        &self,
        motion: &mut dyn DifferentiableRhs,
        columns: &JacobianColumns<'_>,
        cache: Option<&mut Option<Vec<f64>>>,
        each: &mut dyn FnMut(PointResidual<'_>),
    ) -> Result<SensitivityLayout, FlightError> {
        let order = columns.local_then_parameters();
        let mut rows = [0; 3].map(|_| vec![0.0; order.len()]);
        self.each_point(motion, columns, cache, |point| {
            for (to, from) in rows.iter_mut().zip(point.rows.iter()) {
                for (to, &column) in to.iter_mut().zip(&order) {
                    *to = from[column];
                }
            }
            each(PointResidual {
                channel: point.channel,
                sample: point.sample,
                residual: point.residual,
                rows: &rows,
            });
        })
    }

    fn measured(&self, sample: usize, channel: usize) -> Option<[f64; 3]> {
        match self.with_outliers {
            true => self.observations.value(sample, channel),
            false => self.observations.inlier(sample, channel),
        }
    }
}

/// Returns `ranges` after merging each range that begins at the end of the preceding one with that one.
fn joined(ranges: impl Iterator<Item = Range<usize>>) -> Vec<Range<usize>> {
    let mut joined: Vec<Range<usize>> = Vec::new();
    for range in ranges {
        match joined.last_mut() {
            Some(last) if last.end == range.start => last.end = range.end,
            _ => joined.push(range),
        }
    }
    joined
}

// Trajectories and residuals without derivatives.

/// Integrates a flight and returns the model states at its first `samples` samples, concatenated sample by sample.
pub fn states(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Vec<f64>, FlightError> {
    let tolerance = observations.residual_tolerance(problem);
    states_within(problem, observations, (global, local), samples, tolerance)
}

/// As [`states`], within a given integration tolerance, m.
pub(super) fn states_within(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
    tolerance: f64,
) -> Result<Vec<f64>, FlightError> {
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let start: ModelState = local.as_slice().into();
    if observations.is_summary {
        return Ok(start.into());
    }
    let times = &observations.times[..samples];
    let mut states = vec![0.0; start.len() * times.len()];
    let options = integration_options(tolerance, times.len());
    let from = (times[0], &start);
    conditions
        .integrate_at(from, times, &options, &mut [], &mut states)
        .map_err(|error| beyond_limit(problem, &conditions, error))?;
    Ok(states)
}

/// The failure of an integration, which is that of a limit of the model if its last state is beyond one: trajectories of a
/// search may cross limits, and often fail there, as at the singular point of an attitude by angles.
fn beyond_limit(
    problem: &FitProblem,
    conditions: &BoundModel<'_>,
    mut error: IntegrationError,
) -> IntegrationError {
    let names = problem.body.layout().states.iter();
    let value = |name: &String| Some(error.states.iter().find(|(own, _)| own == name)?.1);
    let state: Option<Vec<f64>> = names.map(value).collect();
    if let Some(state) = state
        && let Some(reason) = conditions.observer().passed_limit(error.time, &state)
    {
        error.cause = IntegrationFailure::Limit {
            reason: reason.to_owned(),
        };
    }
    error
}

/// Residuals at the first `samples` samples of a flight.
pub fn residuals(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Residuals, FlightError> {
    let states = states(problem, observations, unknowns, samples)?;
    residuals_of(problem, observations, unknowns.0, &states)
}

/// Residuals at the samples of `trajectory`, the model states concatenated sample by sample; for a summary, the
/// initial state.
pub fn residuals_of(
    problem: &FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
    trajectory: &[f64],
) -> Result<Residuals, FlightError> {
    if observations.is_summary {
        return summary_pass::residuals(problem, observations, global, trajectory);
    }
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
    Ok(residuals)
}

/// Robust standard deviation of one flight's residuals, m; `None` if there are no residuals.
pub fn robust_scale(residuals: &Residuals) -> Option<f64> {
    let all = residuals.iter().flatten().flatten().flatten();
    let mut sizes = Vec::with_capacity(3 * residuals.iter().map(Vec::len).sum::<usize>());
    sizes.extend(all.map(|residual| residual.abs()));
    (!sizes.is_empty()).then(|| robust_sigma(&mut sizes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::FitOptions;
    use dataset::synthesize::Plan;

    #[test]
    fn a_failure_beyond_a_limit_is_told_as_that() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 1,
            duration: Some(0.1),
            ..Plan::default()
        };
        let dataset = crate::fit::tests::simulated(&model, "backhand", &plan);
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let conditions = problem.body.bind(problem.parameters.clone());
        let layout = problem.body.layout();
        let told = |theta: f64| {
            let values = layout.states.iter().zip(layout.default_states());
            let states = values.map(|(name, value)| match &**name {
                "theta" => (name.clone(), theta),
                _ => (name.clone(), value),
            });
            let error = IntegrationError {
                time: 0.1,
                states: states.collect(),
                cause: IntegrationFailure::TooManySteps { steps: 7 },
            };
            beyond_limit(&problem, &conditions, error).to_string()
        };
        assert!(told(1.568).contains("the plane of the disc stands vertical"));
        assert!(told(0.1).contains("7 steps"));
    }
}
