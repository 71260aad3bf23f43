//! What a fit found, put in order.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};

use super::output_error::OutputError;
use super::post_fit::{NOTHING, PostFit, joined, post_fit};
use super::residual_cache::ResidualCache;
use super::{FitError, State, told};
use crate::dataset::Flight;
use crate::least_squares::Solution;
use crate::least_squares::eliminate;
use crate::noise::{NoiseModel, median};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::Loss;
use crate::problem::FitProblem;
use crate::report::{
    AxisNoise, Coefficient, Estimate, FitReport, FlightReport, Iterations, Profile,
    residuals::ResidualPool,
};
use crate::uncertainty::{Covariance, ExcitationRange, interval, non_identifiable, profile};

const AXES: [&str; 3] = ["x", "y", "z"];

/// A solution with what it is worth.
pub struct Outcome<'a> {
    problem: &'a FitProblem,
    state: &'a State,
    noise: &'a NoiseModel,
    solution: &'a Solution,
    covariance: Covariance,
    flights: Vec<One>,
    /// The median of those root mean squares, m.
    usual: f64,
    pool: ResidualPool,
    support: ExcitationRange,
    profiles: Vec<Profile>,
}

/// One flight.
struct One {
    /// Root mean square of its residuals, m.
    rms: f64,
    /// Points that were left out of it.
    outliers: usize,
    initial: BTreeMap<String, Estimate>,
}

impl<'a> Outcome<'a> {
    /// Works out what a solution is worth, from the flights as it flies them.
    ///
    /// # Errors
    /// [`FitError`] where a flight does not determine its initial state, or is impossible.
    pub fn new(
        problem: &'a FitProblem,
        state: &'a State,
        cache: ResidualCache,
        noise: &'a NoiseModel,
        solution: &'a Solution,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        let system = eliminate(&solution.blocks, 0.0)
            .map_err(|flight| told(flight.into(), &state.observation_sets))?;
        let covariance = Covariance::new(&system, state.observation_sets.len(), &problem.globals);
        let mut profiles = Vec::new();
        let errors = covariance.errors();
        for name in options.profiles {
            let index = problem
                .globals
                .iter()
                .position(|global| global.name == *name);
            let Some(index) = index else { continue };
            options.begins(&format!("profile of {name}"), state.observation_sets.len());
            let loss = Loss::Whitened(noise);
            let objective = OutputError::of_all(problem, &state.observation_sets, loss, options);
            let found = profile(&objective, solution, &problem.globals, index, errors[index]);
            profiles.push(found.map_err(|failure| told(failure, &state.observation_sets))?);
        }
        let looked =
            flight::batch::each_on(options.threads(), state.observation_sets.len(), |index| {
                let (observations, path) = (
                    &state.observation_sets[index],
                    cache.path(&state.observation_sets, index)?,
                );
                let looked = post_fit(problem, observations, noise, &state.global, path);
                let covariance = system.local_covariance(index, &covariance.model);
                let initial = initial(
                    problem,
                    observations,
                    &solution.iterate.local[index],
                    &covariance,
                );
                Ok((looked, initial))
            });
        let mut pool = ResidualPool::default();
        let layout = problem.body.layout();
        let names = layout.quantities.iter().chain(&layout.states);
        let mut support = vec![NOTHING; layout.quantities.len() + layout.states.len()];
        let mut flights = Vec::with_capacity(looked.len());
        for looked in looked {
            let (looked, initial): (PostFit, _) = looked?;
            pool.join(looked.pool);
            for (range, seen) in support.iter_mut().zip(looked.support) {
                *range = joined(*range, seen);
            }
            flights.push(One {
                rms: looked.rms,
                outliers: looked.outliers,
                initial,
            });
        }
        let mut sizes: Vec<f64> = flights.iter().map(|flight| flight.rms).collect();
        Ok(Self {
            problem,
            state,
            noise,
            solution,
            covariance,
            flights,
            usual: median(&mut sizes),
            pool,
            support: names
                .cloned()
                .zip(support)
                .filter(|(_, seen)| *seen != NOTHING)
                .collect(),
            profiles,
        })
    }

    /// The report, without its flights.
    pub fn report(&self) -> FitReport {
        let problem = self.problem;
        let names: Vec<&str> = problem
            .globals
            .iter()
            .map(|global| global.name.as_str())
            .collect();
        let matrix = self.covariance.correlations();
        let correlations = (0..names.len()).map(|i| {
            let row = names
                .iter()
                .enumerate()
                .map(|(j, name)| ((*name).to_owned(), matrix[(i, j)]));
            (names[i].to_owned(), row.collect())
        });
        let points: usize = self
            .state
            .observation_sets
            .iter()
            .map(|observations| observations.measured.iter().flatten().count())
            .sum();
        let all: usize = self
            .state
            .observation_sets
            .iter()
            .map(|observations| observations.measured.len())
            .sum();
        let outliers = self.flights.iter().map(|flight| flight.outliers).sum();
        FitReport {
            schema: "hyzer.fit/1".into(),
            model: problem.model.name.clone(),
            effects: problem
                .model
                .effects
                .iter()
                .map(|effect| effect.name.clone())
                .collect(),
            rms_m: self.pool.rms(),
            noise: self.noise_report(points, outliers, all - points),
            coefficients: self.coefficients(),
            correlations: correlations.collect(),
            flights: Vec::new(),
            undetermined: non_identifiable(
                &problem.model,
                &problem.globals,
                &self.covariance.model,
                &self.support,
            ),
            profiles: self.profiles.clone(),
            residuals: self.pool.axes(),
            iterations: Iterations {
                steps: self.state.steps,
                rounds: self.state.rounds,
                converged: self.solution.converged,
            },
            seconds: BTreeMap::new(),
        }
    }

    fn noise_report(
        &self,
        points: usize,
        outliers: usize,
        dropouts: usize,
    ) -> crate::report::NoiseReport {
        let noise = self.noise;
        let axis = |(k, name): (usize, &&str)| {
            let (sigma_m, ar1) = (noise.sigma[k], noise.ar1[k]);
            ((*name).to_owned(), AxisNoise { sigma_m, ar1 })
        };
        crate::report::NoiseReport {
            sigma_m: noise.overall(),
            ar1: noise.ar1.iter().sum::<f64>() / 3.0,
            estimated: self.problem.sigma.is_none(),
            axes: AXES.iter().enumerate().map(axis).collect(),
            interval_s: noise.interval,
            points,
            outliers,
            outlier_fraction: outliers as f64 / points.max(1) as f64,
            dropouts,
        }
    }

    fn coefficients(&self) -> BTreeMap<String, Coefficient> {
        let errors = self.covariance.errors();
        let clustered = self.covariance.clustered_errors();
        let estimated = self.problem.globals.iter().enumerate().map(|(i, global)| {
            let value = self.solution.iterate.global[i];
            let (low, high) = global.constraint.bounds;
            let coefficient = Coefficient {
                value,
                std_error: errors[i],
                std_error_clustered: clustered.as_ref().map(|errors| errors[i]),
                interval: interval(value, errors[i]),
                unit: global.unit.clone(),
                at_bound: value <= low || value >= high,
                held: false,
                model_value: global.model_value,
                prior: global.constraint.prior.map(|(value, sigma)| [value, sigma]),
            };
            (global.name.clone(), coefficient)
        });
        let constants = &self.problem.model.coefficients;
        let held = self.problem.fixed.iter().map(|(name, value)| {
            let constant = constants.iter().find(|constant| constant.name == *name);
            let coefficient = Coefficient {
                value: *value,
                std_error: 0.0,
                std_error_clustered: None,
                interval: [*value; 2],
                unit: constant.map(|c| c.unit_text.clone()).unwrap_or_default(),
                at_bound: false,
                held: true,
                model_value: constant.map_or(*value, |constant| constant.value),
                prior: None,
            };
            (name.clone(), coefficient)
        });
        estimated.chain(held).collect()
    }

    /// One of the fitted flights.
    pub fn flight(&self, index: usize) -> FlightReport {
        let observations = &self.state.observation_sets[index];
        let flight = &self.flights[index];
        let mut notes = observations.notes.clone();
        if let Some(note) = self.is_outlier(flight.rms) {
            notes.push(note);
        }
        FlightReport {
            file: observations.file.clone(),
            role: observations.role,
            samples: observations.samples,
            rms_m: flight.rms,
            outliers: flight.outliers,
            initial: flight.initial.clone(),
            cut: observations.truncation.clone(),
            notes,
        }
    }

    /// What is said of a flight that is fitted far worse than the others.
    fn is_outlier(&self, rms: f64) -> Option<String> {
        (rms > 4.0 * self.usual).then(|| {
            format!(
                "its residuals are {:.0} times the usual: look at it before you rely on this fit",
                rms / self.usual
            )
        })
    }
}

/// The initial state of a flight with the standard errors by its chart's directions.
pub fn initial(
    problem: &FitProblem,
    observations: &Observations,
    local: &DVector<f64>,
    covariance: &DMatrix<f64>,
) -> BTreeMap<String, Estimate> {
    let names = &problem.body.layout().states;
    let mut along = DMatrix::zeros(names.len(), observations.manifold.dimension());
    for (state, direction, value) in observations.manifold.tangent(local.as_slice()) {
        along[(state, direction)] = value;
    }
    let covariance = &along * covariance * along.transpose();
    let estimate = |(i, name): (usize, &String)| {
        let std_error = covariance[(i, i)].max(0.0).sqrt();
        let value = local[i];
        (name.clone(), Estimate { value, std_error })
    };
    names.iter().enumerate().map(estimate).collect()
}

/// A flight that was left out.
pub fn left_out(flight: &Flight, reason: String) -> FlightReport {
    FlightReport {
        file: flight.file.clone(),
        role: flight.role,
        samples: flight.times.len(),
        rms_m: 0.0,
        outliers: 0,
        initial: BTreeMap::new(),
        cut: None,
        notes: vec![format!("left out: {reason}")],
    }
}
