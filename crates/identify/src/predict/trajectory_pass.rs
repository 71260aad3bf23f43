//! One integration of a flight with sensitivities, which visits each residual with its derivatives.

use std::ops::Range;

use flight::{BoundModel, ModelState, ObservationJacobians};
use ode::{
    DifferentiableRhs, IntegrationError, IntegrationFailure, Sensitivities, SensitivityLayout,
};

use super::jacobian_columns::JacobianColumns;
use super::observed_point::{ObservedPoint, Residuals, integration_options};
use super::{FlightAt, PointResidual, summary_pass};
use crate::error::FlightError;
use crate::observers::ChannelConditions;
use crate::problem::FitProblem;
use dataset::statistics::robust_sigma;

/// One integration of a flight with sensitivities, which evaluates every residual.
pub(crate) struct TrajectoryPass<'a> {
    pub at: FlightAt<'a>,
    /// Tolerance of the integration, m.
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
        let FlightAt {
            problem,
            observations,
            global,
            local,
            samples,
        } = self.at;
        let parameters = columns.parameters.iter().map(|own| own.index());
        let parameters: Vec<usize> = parameters.collect();
        let mut variations = Sensitivities::new(motion, columns.integrated, &parameters);
        let places = variations.layout();
        let tangent = observations.manifold.tangent(local.as_slice());
        let start = variations.initial_state(local.as_slice(), &columns.tangent(&tangent));
        if observations.is_summary {
            let at = (self.at, self.tolerance);
            summary_pass::each_point(at, &mut variations, &start, columns, each)?;
            return Ok(places);
        }
        let values = observations.parameters(problem, global);
        let conditions = ChannelConditions::new(problem, &values);
        let mut observers = conditions.observers();
        let mut rows = columns.empty_rows();
        let times = &observations.times[..samples];
        let mut visit = |sample: usize, both: &[f64]| {
            let (time, state) = (times[sample], places.state(both));
            for channel in 0..observations.channels {
                let measured = observations.seen(sample, channel, self.with_outliers);
                let Some(measured) = measured else {
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

impl FlightAt<'_> {
    /// Integrates the flight and returns the model states at its samples, concatenated sample by sample; for a summary, the
    /// initial state.
    pub(crate) fn states(self) -> Result<Vec<f64>, FlightError> {
        self.states_within(self.observations.residual_tolerance(self.problem))
    }

    /// As [`states`](Self::states), within a given integration tolerance, m.
    pub(super) fn states_within(self, tolerance: f64) -> Result<Vec<f64>, FlightError> {
        let start: ModelState = self.local.as_slice().into();
        if self.observations.is_summary {
            return Ok(start.into());
        }
        let conditions = self.bound();
        let times = &self.observations.times[..self.samples];
        let mut states = vec![0.0; start.len() * times.len()];
        let options = integration_options(tolerance, times.len());
        let from = (times[0], &start);
        conditions
            .integrate_at(from, times, &options, &mut [], &mut states)
            .map_err(|error| beyond_limit(self.problem, &conditions, error))?;
        Ok(states)
    }

    /// Residuals at the samples of the flight.
    pub(crate) fn residuals(self) -> Result<Residuals, FlightError> {
        self.residuals_along(&self.states()?)
    }

    /// Residuals at the samples of a trajectory, that of [`states`](Self::states).
    pub(crate) fn residuals_along(self, trajectory: &[f64]) -> Result<Residuals, FlightError> {
        let (problem, observations) = (self.problem, self.observations);
        if observations.is_summary {
            return summary_pass::residuals(self);
        }
        let parameters = observations.parameters(problem, self.global);
        let conditions = ChannelConditions::new(problem, &parameters);
        let mut observers = conditions.observers();
        let samples = trajectory.len() / observations.manifold.states();
        let mut residuals = vec![Vec::with_capacity(samples); observations.channels];
        for (sample, time, state) in observations.along(trajectory) {
            for (channel, residuals) in residuals.iter_mut().enumerate() {
                let measured = observations.value(sample, channel);
                residuals.push(measured.map(|seen| observers.residual(time, state, channel, seen)));
            }
        }
        Ok(residuals)
    }
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
