//! The output-error objective: sum of squared residuals over all or the first samples of some flights.

use nalgebra::DVector;

use super::state::State;
use crate::error::FlightError;
use crate::least_squares::{
    Constraint, Iterate, LeastSquaresProblem, NormalBlock, Solution, SolveError, StoppingCriteria,
    Unknowns, solve,
};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::{FlightAt, Loss, robust_scale};
use crate::problem::FitProblem;
use dataset::levels::CLEARLY_SMALLER;

/// Objective of a fit: the sum of squared residuals, or of a loss of them, over the first samples of `flights`.
pub struct OutputError<'a> {
    pub problem: &'a FitProblem,
    pub flights: Vec<&'a Observations>,
    /// Number of samples of each flight that are used, counted from its first sample.
    pub samples: Vec<usize>,
    pub loss: Loss<'a>,
    /// Values of the global parameters if they are fixed; `None` if they are estimated.
    pub fixed_global: Option<&'a DVector<f64>>,
    pub constraints: Vec<Constraint>,
    pub threads: usize,
    pub options: &'a FitOptions<'a>,
}

impl<'a> OutputError<'a> {
    /// Sum over all samples of the given flights, as a function of the global parameters and the initial states.
    pub fn of_all(
        problem: &'a FitProblem,
        flights: impl IntoIterator<Item = &'a Observations>,
        loss: Loss<'a>,
        options: &'a FitOptions<'a>,
    ) -> Self {
        let flights: Vec<&Observations> = flights.into_iter().collect();
        let globals = problem.globals.iter();
        Self {
            problem,
            samples: flights.iter().map(|flight| flight.times.len()).collect(),
            flights,
            loss,
            fixed_global: None,
            constraints: globals.map(|global| global.constraint).collect(),
            threads: options.threads(),
            options,
        }
    }
}

impl OutputError<'_> {
    /// The used samples of a flight at `unknowns`, or at the fixed global parameters; an error if the fit is cancelled.
    fn at<'f>(
        &'f self,
        flight: usize,
        (global, local): (&'f DVector<f64>, &'f DVector<f64>),
    ) -> Result<FlightAt<'f>, FlightError> {
        self.options.check_flight()?;
        let unknowns = (self.fixed_global.unwrap_or(global), local);
        let at = FlightAt::new(self.problem, self.flights[flight], unknowns);
        Ok(at.first(self.samples[flight]))
    }
}

impl LeastSquaresProblem for OutputError<'_> {
    fn flights(&self) -> usize {
        self.flights.len()
    }

    fn linearise(
        &self,
        flight: usize,
        unknowns: (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, FlightError> {
        let by = self.fixed_global.map_or(by, |_| Unknowns::Local);
        let block = self.at(flight, unknowns)?.linearise(by, self.loss);
        if by == Unknowns::All {
            self.options.flight_done();
        }
        block
    }

    fn squares(
        &self,
        flight: usize,
        unknowns: (&DVector<f64>, &DVector<f64>),
    ) -> Result<f64, FlightError> {
        self.at(flight, unknowns)?.squares(self.loss)
    }

    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.flights[flight].manifold.plus(local, step)
    }

    fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    fn threads(&self) -> usize {
        self.threads
    }

    fn is_past_deadline(&self) -> bool {
        self.options.is_past_deadline()
    }
}

// Fits of the initial state of one flight at fixed global parameters.

/// Maximum number of fits of one flight with a robust loss whose scale decreases from fit to fit.
pub const MAX_SCALES: usize = 8;

/// Global parameters held at fixed values, so that the initial state of each flight can be fitted separately.
#[derive(Clone, Copy)]
pub struct FixedGlobal<'a> {
    pub problem: &'a FitProblem,
    pub global: &'a DVector<f64>,
    pub options: &'a FitOptions<'a>,
}

impl State<'_> {
    /// A flight at the present global parameters.
    pub fn alone(&self, flight: usize) -> FlightAlone<'_> {
        self.fixed_global().flight(&self.flights[flight])
    }

    /// The present global parameters, held fixed.
    pub fn fixed_global(&self) -> FixedGlobal<'_> {
        FixedGlobal {
            problem: self.problem,
            global: &self.global,
            options: self.options,
        }
    }
}

impl<'a> FixedGlobal<'a> {
    /// A flight at these global parameters.
    pub fn flight(self, observations: &'a Observations) -> FlightAlone<'a> {
        FlightAlone {
            at: self,
            observations,
            samples: observations.times.len(),
        }
    }
}

/// A flight whose initial state alone is fitted.
#[derive(Clone, Copy)]
pub struct FlightAlone<'a> {
    pub at: FixedGlobal<'a>,
    pub observations: &'a Observations,
    /// Number of samples that are used, counted from the first one.
    pub samples: usize,
}

impl FlightAlone<'_> {
    /// The first samples of the flight alone.
    pub fn first(self, samples: usize) -> Self {
        Self { samples, ..self }
    }

    /// Fits the initial state from `start`. Returns the minimum of the robust loss of scale `sigma0`, and the initial state.
    pub fn fit(self, start: DVector<f64>) -> Result<(f64, DVector<f64>), FlightError> {
        self.fit_below(start, f64::INFINITY)
    }

    /// [`fit`](Self::fit) that gives up where progress is slow and the loss above `below`.
    pub fn fit_below(
        self,
        start: DVector<f64>,
        below: f64,
    ) -> Result<(f64, DVector<f64>), FlightError> {
        let sigma0 = self.at.problem.sigma0;
        let solve = |local: DVector<f64>, scale: f64, criteria: StoppingCriteria| {
            self.solve(local, Loss::Huber(scale), criteria)
        };
        let (mut local, mut scale) = (start, f64::INFINITY);
        for _ in 0..MAX_SCALES {
            let next = self.scale(&local).unwrap_or(1.0).max(sigma0);
            // The last fit uses the scale sigma0.
            if next > CLEARLY_SMALLER * scale || CLEARLY_SMALLER * next < sigma0 {
                break;
            }
            scale = next;
            local = solve(local, scale, StoppingCriteria::HORIZON)?.0;
        }
        let criteria = StoppingCriteria {
            worthwhile_squares: below,
            ..StoppingCriteria::COARSE
        };
        let (local, solution) = solve(local, sigma0, criteria)?;
        if !solution.blocks[0].determines_local() {
            return Err(FlightError::SingularInitialState);
        }
        Ok((solution.squares, local))
    }

    /// Fits the initial state under `loss`, from `local`. Returns it with the solution.
    pub fn solve(
        self,
        local: DVector<f64>,
        loss: Loss<'_>,
        criteria: StoppingCriteria,
    ) -> Result<(DVector<f64>, Solution), FlightError> {
        let FixedGlobal {
            problem,
            global,
            options,
        } = self.at;
        let objective = OutputError {
            samples: vec![self.samples],
            fixed_global: Some(global),
            constraints: Vec::new(),
            threads: 1,
            ..OutputError::of_all(problem, [self.observations], loss, options)
        };
        let start = Iterate {
            global: DVector::zeros(0),
            local: vec![local],
        };
        let solution = solve(&objective, start, criteria);
        let solution = solution.map_err(|SolveError(failures)| {
            let first = failures.into_iter().next();
            first.map_or(FlightError::NoMatchingState, |(_, reason)| reason)
        })?;
        Ok((solution.iterate.local[0].clone(), solution))
    }

    /// Robust standard deviation of the residuals, m, from the initial state `local`.
    pub fn scale(self, local: &DVector<f64>) -> Option<f64> {
        let unknowns = (self.at.global, local);
        let at = FlightAt::new(self.at.problem, self.observations, unknowns);
        robust_scale(&at.first(self.samples).residuals().ok()?)
    }
}
