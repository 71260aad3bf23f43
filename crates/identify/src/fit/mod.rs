//! One set of coefficients for all flights, and each flight's initial state.
//!
//! Output error: the differences between observed and predicted markers are made as small as their noise allows,
//! and the noise (its scale and its first-order correlation along each axis, its outliers) is estimated with them.

mod held_out;
mod horizon_continuation;
mod initial_guess;
mod multistart;
mod outcome;
mod output_error;
mod post_fit;
mod residual_cache;
mod reweighting;
mod spin_aliases;
mod warm_start;

use std::borrow::Borrow;
use std::time::Instant;

use model_spec::model::Model;
use nalgebra::DVector;

use crate::dataset::{Dataset, Role};
use crate::least_squares::{Iterate, Solution, SolveError};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict;
pub use crate::problem::FitError;
use crate::problem::FitProblem;
use crate::report::{FitReport, FlightEvidence};
pub use held_out::CONDITIONING_FRACTION;

/// A dataset that was fitted.
pub struct Fit {
    /// What was found.
    pub report: FitReport,
    problem: FitProblem,
    names: Vec<String>,
    /// Tracks of the flights by index in the dataset; none for those that were left out.
    observation_sets: Vec<Option<(Observations, DVector<f64>)>>,
    global: DVector<f64>,
    noise: NoiseModel,
}

/// What the stages of a fit work on.
#[derive(Clone)]
pub(crate) struct State {
    /// The flights that are fitted.
    pub observation_sets: Vec<Observations>,
    /// The shared unknowns.
    pub global: DVector<f64>,
    /// Each flight's initial state.
    pub local: Vec<DVector<f64>>,
    /// The usual time between samples, s.
    pub interval: f64,
    /// Steps tried so far.
    pub steps: usize,
    /// Estimates of the noise so far.
    pub rounds: usize,
}

/// Fits a model to a dataset's flights.
///
/// # Errors
/// See [`FitError`].
pub fn fit(model: &Model, dataset: &Dataset, options: &FitOptions<'_>) -> Result<Fit, FitError> {
    let clock = Instant::now();
    let mut problem = FitProblem::new(model, dataset, options)?;
    let of_role = |role: Role| move |flight: &usize| dataset.flights[*flight].role == role;
    let all = 0..dataset.flights.len();
    let fitted: Vec<usize> = all.clone().filter(of_role(Role::Fit)).collect();
    if fitted.is_empty() {
        let reason = "every flight is held out: none is left to fit".to_owned();
        return Err(FitError::Mismatch(reason));
    }
    let (observation_sets, sigma0) =
        initial_guess::observation_sets(&problem, dataset, &fitted, options);
    problem.sigma0 = sigma0;
    problem.tolerance = predict::tolerance(model, fitted.len());
    let mut begun = initial_guess::initial_guesses(&problem, dataset, observation_sets, options)?;
    let (used, left_out) = (
        std::mem::take(&mut begun.flights),
        std::mem::take(&mut begun.left_out),
    );
    let started = clock.elapsed().as_secs_f64();

    let (mut state, cache) = spin_aliases::resolve_spin_aliases(&problem, begun, options)?;
    let cache = multistart::multistart(&problem, &mut state, cache, options)?;
    let (noise, solution, cache) = reweighting::reweight(&problem, &mut state, cache, options)?;
    let solved = clock.elapsed().as_secs_f64();

    let outcome = outcome::Outcome::new(&problem, &state, cache, &noise, &solution, options)?;
    let mut report = outcome.report();
    let reports: Vec<_> = (0..used.len()).map(|index| outcome.flight(index)).collect();
    drop(outcome);
    let held_out: Vec<usize> = all.clone().filter(of_role(Role::HeldOut)).collect();
    let held = held_out::held_out(&problem, dataset, &held_out, &state, &noise, options)?;
    let mut observation_sets: Vec<Option<(Observations, DVector<f64>)>> =
        vec![None; dataset.flights.len()];
    let mut flights = vec![None; dataset.flights.len()];
    for (flight, reason) in left_out {
        flights[flight] = Some(outcome::left_out(&dataset.flights[flight], reason));
    }
    let solved_tracks = state
        .observation_sets
        .into_iter()
        .zip(solution.iterate.local);
    for ((flight, report), observations) in used.into_iter().zip(reports).zip(solved_tracks) {
        flights[flight] = Some(report);
        observation_sets[flight] = Some(observations);
    }
    for (flight, held) in held_out.into_iter().zip(held) {
        flights[flight] = Some(held.report);
        observation_sets[flight] = held.observations;
    }
    report.flights = flights.into_iter().flatten().collect();
    report.seconds.insert("start".into(), started);
    report.seconds.insert("fit".into(), solved - started);
    report
        .seconds
        .insert("total".into(), clock.elapsed().as_secs_f64());
    Ok(Fit {
        report,
        global: solution.iterate.global,
        problem,
        noise,
        names: dataset
            .markers
            .iter()
            .map(|marker| marker.name.clone())
            .collect(),
        observation_sets,
    })
}

impl Fit {
    /// The model with what was estimated of it.
    pub fn problem(&self) -> &FitProblem {
        &self.problem
    }

    /// The shared unknowns, in the order of [`FitProblem::shared`].
    pub fn global(&self) -> &DVector<f64> {
        &self.global
    }

    /// The noise that residuals were weighed by.
    pub fn noise(&self) -> &NoiseModel {
        &self.noise
    }

    /// Samples and initial state of a flight of the dataset, by index; none where it was left out.
    pub fn flight(&self, flight: usize) -> Option<(&Observations, &DVector<f64>)> {
        let (observations, local) = self.observation_sets.get(flight)?.as_ref()?;
        Some((observations, local))
    }

    /// A flight of the dataset, by index, as measured and as predicted; none where it was left out.
    pub fn evidence(&self, flight: usize) -> Option<FlightEvidence> {
        let (observations, local) = self.observation_sets.get(flight)?.as_ref()?;
        post_fit::evidence(
            &self.problem,
            &self.names,
            observations,
            (&self.global, local),
        )
    }
}

/// A failure of the least squares over these tracks, for the user.
fn told(failure: SolveError, observation_sets: &[impl Borrow<Observations>]) -> FitError {
    let file = |flight: usize| observation_sets[flight].borrow().file.clone();
    match failure {
        SolveError::InitialGuess { flight, reason } => FitError::Flight {
            file: file(flight),
            reason,
        },
        SolveError::UndeterminedFlight(crate::least_squares::UndeterminedFlight(flight)) => {
            FitError::Flight {
                file: file(flight),
                reason: "its samples do not determine its initial state".into(),
            }
        }
        SolveError::Stopped => FitError::Interrupted,
    }
}

impl State {
    /// Where the unknowns are.
    fn point(&self) -> Iterate {
        Iterate {
            global: self.global.clone(),
            local: self.local.clone(),
        }
    }

    /// Takes over where an iteration ended.
    fn take(&mut self, solution: &Solution) {
        self.global.clone_from(&solution.iterate.global);
        self.local.clone_from(&solution.iterate.local);
        self.steps += solution.iterations;
    }
}

/// White noise of this size, where nothing better is known.
fn white(problem: &FitProblem, state: &State) -> NoiseModel {
    NoiseModel::white(problem.sigma0, state.interval)
}
