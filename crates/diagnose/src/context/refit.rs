//! Refits of the model under test with some candidates estimated as well.

use identify::{
    Iterate, NoiseModel, Observations, Solution, SolveError, StateManifold, StopReason,
    StoppingCriteria, fit_observations,
};
use model_spec::layout::StateId;

use super::columns::{CandidateId, select_vector};
use super::score_test_model::ScoreTestModel;

/// Stopping criteria of a refit: hypotheses are compared by whole units of χ².
const REFIT_STOPPING: StoppingCriteria = StoppingCriteria {
    ftol_rel: 1e-5,
    max_steps: 30,
    ..StoppingCriteria::CONVERGED
};

/// Mean squared whitened residual above which the fit of a hypothesis need not converge.
const MISFIT_RATIO: f64 = 3.0;

/// Result of fitting the model under test extended by some of the candidate effects.
pub(crate) struct Refitted {
    /// Fitted values; other candidates are at their null values.
    pub iterate: Iterate,
    pub squares: f64,
    /// False after the maximum number of steps, or if abandoned above [`MISFIT_RATIO`].
    pub is_finished: bool,
}

impl ScoreTestModel<'_> {
    /// Fits the model under test with the candidates `effects`, from `from`. An error if it cannot be solved.
    pub fn refit(
        &self,
        effects: &[CandidateId],
        from: &Iterate,
        noise: &NoiseModel,
    ) -> Result<Refitted, SolveError> {
        let columns = self.nuisance_columns(effects);
        let problem = self.refit_problem(effects, &columns);
        let null_states = self.null_states(effects);
        let flights = self.flights.iter().map(|observations| {
            let known = observations.known_states.iter().map(|(state, _)| *state);
            let known: Vec<StateId> = known.chain(null_states.iter().copied()).collect();
            let parameters = observations.parameters(&self.problem, &from.global);
            let parameters = parameters.constants;
            Observations {
                manifold: StateManifold::new(&problem.model, &known)
                    .held_by(&problem.body, &parameters),
                parameters,
                ..observations.clone()
            }
        });
        let start = Iterate {
            global: select_vector(&from.global, &columns),
            local: from.local.clone(),
        };
        let stopping = StoppingCriteria {
            worthwhile_squares: MISFIT_RATIO * self.coordinates() as f64,
            ..REFIT_STOPPING
        };
        let flights: Vec<Observations> = flights.collect();
        let by = (stopping, &self.context.options.fit);
        let Solution {
            iterate,
            squares,
            iterations,
            stop_reason,
            ..
        } = fit_observations(&problem, &flights, noise, start, by)?;
        self.count_steps(iterations);
        let mut global = from.global.clone();
        for (column, value) in columns.iter().zip(iterate.global.iter()) {
            global[column.index()] = *value;
        }
        let iterate = Iterate {
            global,
            local: iterate.local,
        };
        Ok(Refitted {
            iterate,
            squares,
            is_finished: !matches!(stop_reason, StopReason::MaxSteps | StopReason::GivenUp),
        })
    }
}
