//! Refits of the model under test with some candidates estimated as well.

use identify::{
    Constraint, FitOptions, FitProblem, FlightError, Iterate, LeastSquaresProblem, Loss,
    NoiseModel, NormalBlock, Observations, Solution, SolveError, StateManifold, StopReason,
    StoppingCriteria, Unknowns, linearise, solve_with_watchdog,
};
use model_spec::layout::StateId;
use nalgebra::DVector;

use super::ids::{CandidateId, ColumnId};
use super::partition::select_vector;
use super::score_test_model::ScoreTestModel;

/// Stopping criteria of a refit, a fit of the model under test with some candidate effects. The relative tolerance
/// suffices because hypotheses are compared by whole units of χ². A refit that needs more than 30 steps counts as not
/// converged.
const REFIT_STOPPING: StoppingCriteria = StoppingCriteria {
    ftol_rel: 1e-5,
    max_steps: 30,
    ..StoppingCriteria::CONVERGED
};

/// Mean squared whitened residual above which the fit of a hypothesis need not converge: the hypothesis explains so
/// little that its exact minimum does not matter.
const MISFIT_RATIO: f64 = 3.0;

/// Result of fitting the model under test extended by some of the candidate effects.
pub(crate) struct Refitted {
    /// Fitted values of all unknowns; candidate effects that were not fitted have their null values, at which they
    /// vanish.
    pub iterate: Iterate,
    /// Weighted sum of squares of the residuals at the fitted values.
    pub squares: f64,
    /// False if the refit reached the maximum number of steps, or was abandoned because progress was slow at a mean
    /// squared whitened residual above [`MISFIT_RATIO`]; true otherwise.
    pub is_finished: bool,
}

impl ScoreTestModel<'_> {
    /// Fits the unknowns of the model under test and of the candidates `effects`, starting from an iterate in which
    /// all other candidates are at their null value.
    ///
    /// # Errors
    /// [`SolveError`] if the least-squares problem cannot be solved.
    pub fn refit(
        &self,
        effects: &[CandidateId],
        from: &Iterate,
        noise: &NoiseModel,
    ) -> Result<Refitted, SolveError> {
        let columns = self.nuisance_columns(effects);
        let refit = Refit::new(self, effects, &columns, from, noise);
        let start = Iterate {
            global: select_vector(&from.global, &columns),
            local: from.local.clone(),
        };
        let stopping = StoppingCriteria {
            worthwhile_squares: MISFIT_RATIO * self.coordinates() as f64,
            ..REFIT_STOPPING
        };
        let found = solve_with_watchdog(&refit, start, stopping)?;
        let Solution {
            iterate,
            squares,
            iterations,
            stop_reason,
            ..
        } = found;
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

/// Least-squares problem whose unknowns are those of the model under test and of some candidate effects.
struct Refit<'a> {
    problem: FitProblem,
    flights: Vec<Observations>,
    noise: &'a NoiseModel,
    constraints: Vec<Constraint>,
    options: &'a FitOptions<'a>,
}

impl<'a> Refit<'a> {
    fn new(
        model: &'a ScoreTestModel<'_>,
        effects: &[CandidateId],
        columns: &[ColumnId],
        from: &Iterate,
        noise: &'a NoiseModel,
    ) -> Self {
        let problem = model.refit_problem(effects, columns);
        let null_states = model.null_states(effects);
        let flights = model.flights.iter().map(|observations| {
            let known = observations.known_states.iter().map(|(state, _)| *state);
            let known: Vec<StateId> = known.chain(null_states.iter().copied()).collect();
            let mut parameters = observations.parameters.clone();
            for (global, value) in model.problem.globals.iter().zip(from.global.iter()) {
                parameters[global.param.index()] = *value;
            }
            Observations {
                parameters,
                manifold: StateManifold::new(&problem.model, &known),
                ..observations.clone()
            }
        });
        Self {
            flights: flights.collect(),
            constraints: problem.globals.iter().map(|g| g.constraint).collect(),
            problem,
            noise,
            options: &model.context.options.fit,
        }
    }
}

impl LeastSquaresProblem for Refit<'_> {
    fn flights(&self) -> usize {
        self.flights.len()
    }

    fn linearise(
        &self,
        flight: usize,
        unknowns: (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, FlightError> {
        let observations = &self.flights[flight];
        let samples = observations.times.len();
        let loss = Loss::Whitened(self.noise);
        linearise(&self.problem, observations, unknowns, samples, by, loss)
    }

    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.flights[flight].manifold.plus(local, step)
    }

    fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    fn threads(&self) -> usize {
        self.options.threads()
    }

    fn is_cancelled(&self) -> bool {
        self.options.is_cancelled()
    }

    fn is_past_deadline(&self) -> bool {
        self.options.is_past_deadline()
    }
}
