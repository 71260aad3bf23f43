//! Normal equations and residuals of the flights, with derivatives by all columns of the score-test model.

use flight::BoundModel;
use flight::parallel;
use identify::{
    FitError, FitProblem, FlightError, GlobalId, Iterate, LocalId, Loss, NoiseModel, NormalBlock,
    Observations, PointResidual, Unknowns, each_residual, linearise, linearise_with,
};
use model_spec::layout::ParamId;
use nalgebra::DVector;
use ode::DifferentiableRhs;

use super::library_terms::LibraryTerms;
use super::score_test_model::ScoreTestModel;
use super::trajectory_cache::LinearizationPoint;

impl ScoreTestModel<'_> {
    /// Normal equations of every flight for its local parameters (initial state) and the global parameters, with
    /// residuals whitened by the noise model `noise`.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a trajectory cannot be integrated; [`FitError::Interrupted`] if the caller cancelled.
    pub fn normal_equations(
        &self,
        problem: &FitProblem,
        iterate: &Iterate,
        noise: &NoiseModel,
    ) -> Result<Vec<NormalBlock>, FitError> {
        self.each_flight(|flight| {
            let observations = &self.flights[flight];
            let unknowns = (&iterate.global, &iterate.local[flight]);
            let samples = observations.times.len();
            let loss = Loss::Whitened(noise);
            linearise(
                problem,
                observations,
                unknowns,
                samples,
                Unknowns::All,
                loss,
            )
        })
    }

    /// Normal equations of every flight for its local parameters (initial state), the global parameters and the
    /// coefficients of the library terms, with residuals whitened by the noise model `noise`.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a trajectory cannot be integrated; [`FitError::Interrupted`] if the caller cancelled.
    pub fn normal_equations_with_terms(
        &self,
        at: LinearizationPoint<'_>,
        noise: &NoiseModel,
    ) -> Result<Vec<NormalBlock>, FitError> {
        let LinearizationPoint {
            problem,
            iterate,
            cache,
        } = at;
        let Some(terms) = &self.terms else {
            return self.normal_equations(problem, iterate, noise);
        };
        self.each_flight(|flight| {
            let observations = &self.flights[flight];
            let conditions = conditions(problem, observations, &iterate.global);
            let (mut motion, parameters) = self.motion_with_terms(&conditions, terms);
            let unknowns = (&iterate.global, &iterate.local[flight]);
            let samples = observations.times.len();
            let loss = Loss::Whitened(noise);
            let by: (&mut dyn DifferentiableRhs, _) = (&mut motion, parameters.as_slice());
            cache.with_flight(flight, |stored| {
                linearise_with(
                    problem,
                    observations,
                    unknowns,
                    samples,
                    loss,
                    by,
                    Some(stored),
                )
            })
        })
    }

    /// Calls `each` with every residual of a flight, predicted − measured, in m and not whitened, and the derivatives
    /// of this residual with respect to all unknowns. Their order is: tangent directions of the flight's initial state,
    /// global parameters, coefficients of the library terms.
    ///
    /// # Errors
    /// [`FitError::Flight`] if the trajectory cannot be integrated.
    pub fn each_residual(
        &self,
        at: LinearizationPoint<'_>,
        flight: usize,
        each: &mut dyn FnMut(PointResidual<'_>),
    ) -> Result<(), FitError> {
        let LinearizationPoint {
            problem, iterate, ..
        } = at;
        let observations = &self.flights[flight];
        let unknowns = (&iterate.global, &iterate.local[flight]);
        let conditions = conditions(problem, observations, unknowns.0);
        let mut visit = |motion: &mut dyn DifferentiableRhs, parameters: &[ParamId]| {
            each_residual(problem, observations, unknowns, motion, parameters, each)
        };
        let done = match &self.terms {
            Some(terms) => {
                let (mut motion, parameters) = self.motion_with_terms(&conditions, terms);
                visit(&mut motion, &parameters)
            }
            None => visit(
                &mut conditions.rhs(),
                &self.global_parameters(),
            ),
        };
        done.map_err(|reason| self.flight_error(flight, reason))
    }

    /// Copy of the normal equations of one flight without the columns that belong to coefficients of library terms.
    pub fn without_terms(&self, block: &NormalBlock) -> NormalBlock {
        let locals = (0..block.local.nrows()).map(LocalId::new);
        let globals = (0..self.global_columns()).map(GlobalId::new);
        block.select(&locals.collect::<Vec<_>>(), &globals.collect::<Vec<_>>())
    }

    /// Removes the flight with the file name `file` from the model and from `iterate`, so that no test uses it; returns
    /// whether the flight was found.
    pub fn set_aside(&mut self, file: &str, iterate: &mut Iterate) -> bool {
        let Some(flight) = self.flights.iter().position(|flight| flight.file == file) else {
            return false;
        };
        self.flights.remove(flight);
        iterate.local.remove(flight);
        true
    }

    /// Converts `reason`, the error of the flight with index `flight`, to a fit error that names the file of the
    /// flight.
    pub fn flight_error(&self, flight: usize, reason: FlightError) -> FitError {
        FitError::Flight {
            file: self.flights[flight].file.clone(),
            reason,
        }
    }

    fn each_flight<R: Send>(
        &self,
        work: impl Fn(usize) -> Result<R, FlightError> + Sync,
    ) -> Result<Vec<R>, FitError> {
        let done = parallel::each_on(self.threads(), self.flights.len(), |flight| {
            self.context.check_cancelled()?;
            work(flight).map_err(|reason| self.flight_error(flight, reason))
        });
        done.into_iter().collect()
    }

    fn global_parameters(&self) -> Vec<ParamId> {
        let globals = self.problem.globals.iter();
        globals.map(|global| global.param).collect()
    }

    /// Equations of motion extended by the library terms, and the index, in these equations, of the parameter of each
    /// global column of the normal equations.
    fn motion_with_terms<'c>(
        &self,
        conditions: &'c BoundModel<'c>,
        terms: &'c LibraryTerms,
    ) -> (impl DifferentiableRhs + use<'c>, Vec<ParamId>) {
        let first = self.problem.body.layout().parameters.len();
        let mut parameters = self.global_parameters();
        parameters.extend((first..first + terms.terms.len()).map(ParamId::new));
        (terms.motion(conditions, first), parameters)
    }
}

fn conditions<'a>(
    problem: &'a FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
) -> BoundModel<'a> {
    problem.body.bind(observations.parameters(problem, global))
}
