//! Creates the report of a fit.

use std::collections::BTreeMap;

use flight::batch;
use nalgebra::{DMatrix, DVector};

use super::output_error::OutputError;
use super::post_fit::{ChannelSum, EMPTY_RANGE, PostFit, joined, post_fit};
use super::reweighting::Reweighted;
use super::state::State;
use super::{FitError, solve_error};
use crate::channel::ChannelKind;
use crate::dataset::Flight;
use crate::error::FlightError;
use crate::ids::GlobalId;
use crate::least_squares::{ReducedSystem, StoppingCriteria, eliminate, solve};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::Loss;
use crate::problem::FitProblem;
use crate::report::{
    AxisNoise, Coefficient, Estimate, FitReport, FlightOutcome, FlightReport, Iterations,
    NoiseReport, Profile, ResidualPool, SensorReport,
};
use crate::statistics::median;
use crate::uncertainty::{Covariance, ExcitationRange, interval, non_identifiable, profile};

const AXES: [&str; 3] = ["x", "y", "z"];

/// Ratio of a flight's rms residual to the median over all fitted flights, above which the report contains a note on
/// the flight.
const MISFIT_RATIO: f64 = 4.0;

/// A least-squares solution with its uncertainties and residual statistics.
pub struct Outcome<'a> {
    problem: &'a FitProblem,
    state: &'a State,
    fitted: &'a Reweighted,
    covariance: Covariance,
    flights: Vec<FlightOutcomeData>,
    /// Median over the flights of their root mean square residuals, m.
    median_rms: f64,
    pool: ResidualPool,
    channels: Vec<ChannelSum>,
    ranges: ExcitationRange,
    profiles: Vec<Profile>,
}

struct FlightOutcomeData {
    /// Root mean square residual of one coordinate of the flight, outliers excluded, m.
    rms: f64,
    outliers: usize,
    initial: BTreeMap<String, Estimate>,
}

impl<'a> Outcome<'a> {
    /// Computes uncertainties, profiles and residual statistics of a solution.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a flight does not determine its initial state or its trajectory cannot be computed;
    /// [`FitError::Interrupted`] if the work is cancelled.
    pub fn new(
        problem: &'a FitProblem,
        state: &'a State,
        fitted: &'a Reweighted,
        options: &FitOptions<'_>,
    ) -> Result<Self, FitError> {
        let system = eliminate(&fitted.solution.blocks, 0.0)
            .map_err(|error| solve_error(error.into(), &state.flights))?;
        let covariance = Covariance::new(&system, state.flights.len(), &problem.globals);
        let profiles = profiles(problem, state, fitted, &covariance, options)?;
        let evaluated = evaluate(problem, state, fitted, &system, &covariance, options)?;
        let mut pool = ResidualPool::default();
        let layout = problem.body.layout();
        let names = layout.quantities.iter().chain(&layout.states).cloned();
        let mut ranges = vec![EMPTY_RANGE; layout.quantities.len() + layout.states.len()];
        let mut flights = Vec::with_capacity(evaluated.len());
        let mut channels = vec![ChannelSum::default(); problem.channels.len()];
        for (post_fit, initial) in evaluated {
            pool.join(post_fit.pool);
            for (sum, of_flight) in channels.iter_mut().zip(post_fit.channels) {
                sum.squares += of_flight.squares;
                sum.count += of_flight.count;
                sum.outliers += of_flight.outliers;
            }
            for (range, of_flight) in ranges.iter_mut().zip(post_fit.ranges) {
                *range = joined(*range, of_flight);
            }
            flights.push(FlightOutcomeData {
                rms: post_fit.rms,
                outliers: post_fit.outliers,
                initial,
            });
        }
        let mut rms: Vec<f64> = flights.iter().map(|flight| flight.rms).collect();
        let ranges = names.zip(ranges).filter(|(_, range)| *range != EMPTY_RANGE);
        Ok(Self {
            problem,
            state,
            fitted,
            covariance,
            flights,
            median_rms: median(&mut rms),
            pool,
            channels,
            ranges: ranges.collect(),
            profiles,
        })
    }

    /// Creates the report of the fit. The caller adds the reports of the flights, the data faults, the marker
    /// distances, the assessment of reliability and the computing times.
    pub fn report(&self) -> FitReport {
        let (problem, globals) = (self.problem, &self.problem.globals);
        let effects = problem.model.effects.iter();
        FitReport {
            schema: "hyzer.fit/1".into(),
            model: problem.model.name.clone(),
            effects: effects.map(|effect| effect.name.clone()).collect(),
            reliable: true,
            why: Vec::new(),
            rms_m: self.pool.rms(),
            sees_positions: problem.sees_positions(),
            noise: self.noise_report(),
            coefficients: self.coefficients(),
            correlations: self.correlations(),
            flights: Vec::new(),
            data_faults: Vec::new(),
            marker_distances: Vec::new(),
            sensors: self.sensors(),
            undetermined: non_identifiable(
                &problem.model,
                globals,
                &self.covariance.model,
                &self.ranges,
            ),
            profiles: self.profiles.clone(),
            residuals: self.pool.axes(),
            iterations: Iterations {
                steps: self.state.steps,
                rounds: self.state.rounds,
                converged: self.fitted.status.converged(),
                status: self.fitted.status,
            },
            seconds: BTreeMap::new(),
        }
    }

    fn correlations(&self) -> BTreeMap<String, BTreeMap<String, f64>> {
        let names = || {
            self.problem
                .globals
                .iter()
                .map(|global| global.name.clone())
        };
        let matrix = self.covariance.correlations();
        let rows = names().enumerate().map(|(i, name)| {
            let row = names().enumerate().map(|(j, name)| (name, matrix[(i, j)]));
            (name, row.collect())
        });
        rows.collect()
    }

    fn sensors(&self) -> Vec<SensorReport> {
        let channels = self.problem.channels.iter().enumerate();
        let sensors = channels
            .zip(&self.channels)
            .filter_map(|((index, own), sum)| {
                let measures = match own.kind {
                    ChannelKind::Marker(_) => return None,
                    ChannelKind::Position => "position",
                    ChannelKind::Attitude => "attitude",
                    ChannelKind::Instrument(place) => self.problem.instruments[place].0.name(),
                };
                let noise = self.fitted.noise.of(index);
                Some(SensorReport {
                    name: own.name.clone(),
                    measures: measures.to_owned(),
                    unit: own.unit.to_owned(),
                    rms: (sum.squares / (own.components * sum.count).max(1) as f64).sqrt(),
                    sigma: noise.overall() / own.scale,
                    ar1: noise.ar1.iter().sum::<f64>() / 3.0,
                    points: sum.count + sum.outliers,
                    outliers: sum.outliers,
                })
            });
        sensors.collect()
    }

    fn noise_report(&self) -> NoiseReport {
        let noise = &self.fitted.noise;
        let flights = &self.state.flights;
        let measured = flights.iter().map(|f| f.measured.iter().flatten().count());
        let points: usize = measured.sum();
        let all: usize = flights.iter().map(|f| f.measured.len()).sum();
        let outliers: usize = self.flights.iter().map(|flight| flight.outliers).sum();
        let axis = |(k, name): (usize, &&str)| {
            let (sigma_m, ar1) = (noise.sigma[k], noise.ar1[k]);
            ((*name).to_owned(), AxisNoise { sigma_m, ar1 })
        };
        NoiseReport {
            sigma_m: noise.overall(),
            ar1: noise.ar1.iter().sum::<f64>() / 3.0,
            estimated: self.problem.sigma.is_none(),
            axes: AXES.iter().enumerate().map(axis).collect(),
            interval_s: noise.interval,
            points,
            outliers,
            outlier_fraction: outliers as f64 / points.max(1) as f64,
            dropouts: all - points,
            floor_m: None,
        }
    }

    fn coefficients(&self) -> BTreeMap<String, Coefficient> {
        let errors = self.covariance.errors();
        let clustered = self.covariance.clustered_errors();
        let estimated = self.problem.globals.iter().enumerate().map(|(i, global)| {
            let value = self.fitted.solution.iterate.global[i];
            let (low, high) = global.constraint.bounds;
            let prior = global.constraint.prior;
            let coefficient = Coefficient {
                value,
                std_error: errors[i],
                std_error_clustered: clustered.as_ref().map(|errors| errors[i]),
                interval: interval(value, errors[i]),
                unit: global.unit.clone(),
                at_bound: value <= low || value >= high,
                held: false,
                model_value: global.model_value,
                prior: prior.map(|(value, sigma)| [value, sigma]),
            };
            (global.name.clone(), coefficient)
        });
        let fixed = self.problem.fixed.iter();
        let fixed = fixed.map(|(name, value)| (name.clone(), self.fixed_coefficient(name, *value)));
        estimated.chain(fixed).collect()
    }

    fn fixed_coefficient(&self, name: &str, value: f64) -> Coefficient {
        let mut all = self.problem.model.coefficients.iter();
        let of_model = all.find(|coefficient| coefficient.name == name);
        Coefficient {
            value,
            std_error: 0.0,
            std_error_clustered: None,
            interval: [value; 2],
            unit: of_model.map(|c| c.unit_text.clone()).unwrap_or_default(),
            at_bound: false,
            held: true,
            model_value: of_model.map_or(value, |c| c.value),
            prior: None,
        }
    }

    /// Creates the report of a fitted flight, given its index among the fitted flights.
    pub fn flight(&self, index: usize) -> FlightReport {
        let observations = &self.state.flights[index];
        let flight = &self.flights[index];
        let mut notes = observations.notes.clone();
        if flight.rms > MISFIT_RATIO * self.median_rms {
            notes.push(format!(
                "its residuals are {:.0} times the usual: look at it before you rely on this fit",
                flight.rms / self.median_rms
            ));
        }
        FlightReport {
            file: observations.file.clone(),
            role: observations.role,
            outcome: FlightOutcome::Fitted,
            samples: observations.samples,
            rms_m: Some(flight.rms),
            outliers: flight.outliers,
            initial: flight.initial.clone(),
            cut: observations.truncation.clone(),
            notes,
        }
    }
}

/// Computes the profile likelihoods of the parameters that the options name.
fn profiles(
    problem: &FitProblem,
    state: &State,
    fitted: &Reweighted,
    covariance: &Covariance,
    options: &FitOptions<'_>,
) -> Result<Vec<Profile>, FitError> {
    let errors = covariance.errors();
    let mut profiles = Vec::new();
    for name in options.profiles {
        let index = problem
            .globals
            .iter()
            .position(|global| global.name == *name);
        let Some(index) = index else { continue };
        options.stage_started(&format!("profile of {name}"), state.flights.len());
        let loss = Loss::Whitened(&fitted.noise);
        let mut objective = OutputError::of_all(problem, &state.flights, loss, options);
        let fit_at = |value, start| {
            objective.constraints[index].bounds = (value, value);
            solve(&objective, start, StoppingCriteria::CONVERGED)
        };
        let id = GlobalId::new(index);
        let found = profile(
            fit_at,
            &fitted.solution,
            &problem.globals,
            id,
            errors[index],
        );
        profiles.push(found.map_err(|error| solve_error(error, &state.flights))?);
    }
    Ok(profiles)
}

/// Estimated initial state of a flight, keyed by the names of the states.
type InitialState = BTreeMap<String, Estimate>;

/// Computes the residual statistics and the initial state, with standard errors, of every flight.
fn evaluate(
    problem: &FitProblem,
    state: &State,
    fitted: &Reweighted,
    system: &ReducedSystem<'_>,
    covariance: &Covariance,
    options: &FitOptions<'_>,
) -> Result<Vec<(PostFit, InitialState)>, FitError> {
    let each = batch::each_on(options.threads(), state.flights.len(), |index| {
        if options.is_cancelled() {
            return Err(FitError::Interrupted);
        }
        let observations = &state.flights[index];
        let path = fitted.cache.path(&state.flights, index)?;
        let post_fit = post_fit(problem, observations, &fitted.noise, &state.global, path);
        let covariance = system.local_covariance(index, &covariance.model);
        let local = &fitted.solution.iterate.local[index];
        let initial = initial_state_report(problem, observations, local, &covariance);
        Ok((post_fit, initial))
    });
    each.into_iter().collect()
}

/// Initial state of a flight with standard errors, keyed by the names of the states. `covariance` is that of the local
/// parameters, the directions of the state manifold.
pub fn initial_state_report(
    problem: &FitProblem,
    observations: &Observations,
    local: &DVector<f64>,
    covariance: &DMatrix<f64>,
) -> BTreeMap<String, Estimate> {
    let names = &problem.body.layout().states;
    let manifold = &observations.manifold;
    let mut tangent = DMatrix::zeros(names.len(), manifold.dimension());
    for (state, direction, value) in manifold.tangent(local.as_slice()) {
        tangent[(state, direction)] = value;
    }
    let covariance = &tangent * covariance * tangent.transpose();
    let estimate = |(i, name): (usize, &String)| {
        let std_error = covariance[(i, i)].max(0.0).sqrt();
        let value = local[i];
        (name.clone(), Estimate { value, std_error })
    };
    names.iter().enumerate().map(estimate).collect()
}

/// Creates the report of an excluded flight.
pub fn excluded_report(flight: &Flight, reason: &FlightError) -> FlightReport {
    let reason = reason.to_string();
    FlightReport {
        file: flight.file.clone(),
        role: flight.role,
        samples: flight.times.len(),
        rms_m: None,
        outliers: 0,
        initial: BTreeMap::new(),
        cut: None,
        notes: vec![format!("left out: {reason}")],
        outcome: FlightOutcome::Excluded { reason },
    }
}
