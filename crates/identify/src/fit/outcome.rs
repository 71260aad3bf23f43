//! Creates the report of a fit and the reports of its flights.

use std::collections::{BTreeMap, BTreeSet};

use flight::parallel;
use nalgebra::{DMatrix, DVector};

use super::error_trial::contradicted_errors;
use super::open_side::open_side;
use super::output_error::OutputError;
use super::post_fit::{ChannelSum, EMPTY_RANGE, PostFit, joined, post_fit, square_sums};
use super::reweighting::Reweighted;
use super::state::State;
use super::{FitError, filtered, flight_error, marker_distances, summary_noise};
use crate::channel::{MARKER, POSITION};
use crate::error::FlightError;
use crate::ids::GlobalId;
use crate::least_squares::{ReducedSystem, StoppingCriteria, eliminate, solve};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::predict::{Loss, Residuals};
use crate::problem::FitProblem;
use crate::report::{
    AxisNoise, Coefficient, Estimate, FitReport, FlightOutcome, FlightReport, Iterations,
    NoiseReport, Profile, ResidualPool, Rms, SeenValue, SensorReport,
};
use crate::uncertainty::{Covariance, interval, non_identifiable, profile};
use dataset::AXES;
use dataset::statistics::median_of;

/// Ratio of a flight's rms residual to the median over the flights, above which a note is added.
const MISFIT_RATIO: f64 = 4.0;

/// Creates the reports of the fit and of its flights, with uncertainties and residual statistics. The caller adds what
/// concerns other flights, data faults, marker distances, reliability and times.
pub fn reports(
    state: &State<'_>,
    fitted: &Reweighted,
) -> Result<(FitReport, Vec<FlightReport>), FitError> {
    let problem = state.problem;
    let system = eliminate(&fitted.solution.blocks, 0.0).map_err(|undetermined| {
        let flight = &state.flights[undetermined.0];
        flight_error(flight, FlightError::SingularInitialState)
    })?;
    let covariance = Covariance::new(&system, state.flights.len(), &problem.globals);
    let profiles = profiles(state, fitted, &covariance);
    let evaluated = evaluate(state, fitted, &system, &covariance)?;
    let mut pool = ResidualPool::default();
    let layout = problem.body.layout();
    let names = layout.quantities.iter().chain(&layout.states).cloned();
    let mut ranges = vec![EMPTY_RANGE; layout.quantities.len() + layout.states.len()];
    let mut flights = Vec::with_capacity(evaluated.len());
    let mut channels = vec![ChannelSum::default(); problem.channels.len()];
    for (post_fit, flight) in evaluated {
        pool.join(post_fit.pool);
        for (sum, of_flight) in channels.iter_mut().zip(post_fit.channels) {
            sum.squares += of_flight.squares;
            sum.count += of_flight.count;
            sum.outliers += of_flight.outliers;
        }
        for (range, of_flight) in ranges.iter_mut().zip(post_fit.ranges) {
            *range = joined(*range, of_flight);
        }
        flights.push(flight);
    }
    note_misfits(&mut flights);
    let ranges = names.zip(ranges).filter(|(_, range)| *range != EMPTY_RANGE);
    let effects = problem.model.effects.iter();
    let sensors = sensors(problem, &fitted.noise, &channels);
    let not_identifiable = non_identifiable(
        &problem.model,
        &problem.globals,
        &covariance.model,
        &ranges.collect(),
    );
    let mut doubts = state.doubts.clone();
    let at = (&system, &covariance);
    doubts.extend(contradicted_errors(state, fitted, at, &not_identifiable));
    let doubt_of_summaries = summary_noise::doubt(state, &fitted.noise, &covariance.model)
        .map_err(|reason| flight_error(&state.flights[0], reason))?;
    let report = FitReport {
        schema: "hyzer.fit/2".into(),
        model: problem.model.name.clone(),
        effects: effects.map(|effect| effect.name.clone()).collect(),
        residual_rms: square_sums(problem, &channels).rms(),
        noise: noise_by_kind(state, &fitted.noise, &sensors),
        coefficients: coefficients(problem, fitted, &covariance),
        correlations: correlations(problem, &covariance),
        sensors,
        doubts,
        doubt_of_summaries,
        open_side: open_side(state.problem, &state.flights),
        excess: marker_distances::excess(state, &fitted.cache),
        contradicted: filtered::filtered(state).into_iter().collect(),
        not_identifiable,
        profiles,
        residuals: pool.axes(),
        iterations: Iterations {
            steps: state.steps,
            rounds: state.rounds,
            converged: fitted.status.converged(),
            status: fitted.status,
        },
        ..FitReport::default()
    };
    Ok((report, flights))
}

/// Adds a note to the report of each flight whose residuals are far larger than those of the other flights.
fn note_misfits(flights: &mut [FlightReport]) {
    let (summaries, tracks): (Vec<_>, Vec<_>) =
        flights.iter_mut().partition(|flight| flight.is_summary);
    for mut alike in [summaries, tracks] {
        let median = median_of(alike.iter().map(|flight| flight.misfit())).unwrap_or(0.0);
        for flight in &mut alike {
            let misfit = flight.misfit();
            if misfit > MISFIT_RATIO * median {
                flight.notes.push(format!(
                    "its residuals are {:.0} times the usual: look at it before you rely on this fit",
                    misfit / median
                ));
            }
        }
    }
}

fn correlations(
    problem: &FitProblem,
    covariance: &Covariance,
) -> BTreeMap<String, BTreeMap<String, f64>> {
    let names = || problem.globals.iter().map(|global| global.name.clone());
    let matrix = covariance.correlations();
    let rows = names().enumerate().map(|(i, name)| {
        let row = names().enumerate().map(|(j, name)| (name, matrix[(i, j)]));
        (name, row.collect())
    });
    rows.collect()
}

/// Reports of the channels other than markers. `sums` contains the squared residuals and numbers of values by channel.
fn sensors(problem: &FitProblem, noise: &NoiseModel, sums: &[ChannelSum]) -> Vec<SensorReport> {
    let channels = problem.channels.iter().enumerate().zip(sums);
    let sensors = channels.filter_map(|((index, own), sum)| {
        let measures = problem
            .measures(own)
            .filter(|measures| *measures != MARKER)?;
        let noise = noise.of(index);
        Some(SensorReport {
            name: own.name.clone(),
            measures: measures.to_owned(),
            unit: own.unit.to_owned(),
            rms: (sum.squares / (own.components * sum.count).max(1) as f64).sqrt(),
            sigma: noise.overall() / own.scale,
            lag1_autocorrelation: noise.ar1.iter().sum::<f64>() / 3.0,
            points: sum.count + sum.outliers,
            outliers: sum.outliers,
        })
    });
    sensors.collect()
}

/// Noise by kind of sensor: that of the positions, and the mean over the sensors of each other kind.
fn noise_by_kind(
    state: &State<'_>,
    noise: &NoiseModel,
    sensors: &[SensorReport],
) -> BTreeMap<String, NoiseReport> {
    let mut by_kind = BTreeMap::new();
    if state.problem.sees_positions() {
        by_kind.insert(MARKER.to_owned(), noise_report(state, noise));
    }
    let others = sensors.iter().filter(|sensor| sensor.measures != POSITION);
    let kinds: BTreeSet<&str> = others.map(|sensor| &*sensor.measures).collect();
    let channel = |kind: &str| {
        let mut channels = state.problem.channels.iter();
        channels.find(|own| own.summary() == Some(kind))
    };
    let means = state.problem.noise_by_kind(noise);
    for kind in kinds {
        let own: Vec<&SensorReport> = sensors.iter().filter(|s| s.measures == kind).collect();
        let [sigma, lag1_autocorrelation] = means[kind];
        let points = own.iter().map(|s| s.points).sum();
        let outliers = own.iter().map(|s| s.outliers).sum();
        let report = NoiseReport {
            sigma,
            unit: own[0].unit.clone(),
            lag1_autocorrelation,
            estimated: channel(kind).is_none_or(|own| own.sigma.is_none()),
            interval_s: noise.interval,
            points,
            outliers,
            outlier_fraction: outliers as f64 / f64::max(points as f64, 1.0),
            ..NoiseReport::default()
        };
        by_kind.insert(kind.to_owned(), report);
    }
    by_kind
}

fn noise_report(state: &State<'_>, noise: &NoiseModel) -> NoiseReport {
    let flights = state.flights.iter().filter(|flight| !flight.is_summary);
    let measured = flights.clone().map(|f| f.measured.iter().flatten().count());
    let points: usize = measured.sum();
    let all: usize = flights.clone().map(|f| f.measured.len()).sum();
    let outliers: usize = flights.map(Observations::outliers).sum();
    let noise = state.problem.position_noise(noise);
    let axis = |(k, name): (usize, &&str)| {
        let axis = AxisNoise {
            sigma: noise.sigma[k],
            lag1_autocorrelation: noise.ar1[k],
        };
        ((*name).to_owned(), axis)
    };
    NoiseReport {
        sigma: noise.overall(),
        unit: "m".to_owned(),
        lag1_autocorrelation: noise.ar1.iter().sum::<f64>() / 3.0,
        estimated: state.problem.sigma.is_none(),
        axes: AXES.iter().enumerate().map(axis).collect(),
        interval_s: noise.interval,
        points,
        outliers,
        outlier_fraction: outliers as f64 / points.max(1) as f64,
        missing: all - points,
        floor: None,
    }
}

fn coefficients(
    problem: &FitProblem,
    fitted: &Reweighted,
    covariance: &Covariance,
) -> BTreeMap<String, Coefficient> {
    let errors = covariance.errors();
    let clustered = covariance.clustered_errors();
    let estimated = problem.globals.iter().enumerate().map(|(i, global)| {
        let value = fitted.solution.iterate.global[i];
        let (low, high) = global.constraint.bounds;
        let prior = global.constraint.prior;
        let at_bound = value <= low || value >= high;
        // The likelihood has no maximum there, whose curvature could give an error.
        let std_error = if at_bound { f64::NAN } else { errors[i] };
        let coefficient = Coefficient {
            value,
            std_error,
            std_error_cluster_robust: clustered
                .as_ref()
                .filter(|_| !at_bound)
                .map(|errors| errors[i]),
            interval: interval(value, std_error),
            unit: global.unit.clone(),
            at_bound,
            fixed: false,
            model_value: global.model_value,
            prior: prior.map(|(value, sigma)| [value, sigma]),
        };
        (global.name.clone(), coefficient)
    });
    let fixed = problem.fixed.iter().map(|(name, value)| {
        let mut all = problem.model.coefficients.iter();
        let of_model = all.find(|coefficient| coefficient.name == *name);
        let coefficient = Coefficient {
            value: *value,
            interval: [*value; 2],
            unit: of_model.map(|c| c.unit_text.clone()).unwrap_or_default(),
            fixed: true,
            model_value: of_model.map_or(*value, |c| c.value),
            ..Coefficient::default()
        };
        (name.clone(), coefficient)
    });
    estimated.chain(fixed).collect()
}

/// Profile likelihoods of the parameters in [`FitOptions::profiles`](crate::FitOptions::profiles).
fn profiles(state: &State<'_>, fitted: &Reweighted, covariance: &Covariance) -> Vec<Profile> {
    let (problem, options) = (state.problem, state.options);
    let errors = covariance.errors();
    let mut profiles = Vec::new();
    for name in options.profiles {
        let mut globals = problem.globals.iter();
        let Some(index) = globals.position(|global| global.name == *name) else {
            continue;
        };
        options.stage_started(&format!("profile of {name}"), state.flights.len());
        let loss = Loss::Whitened(&fitted.noise);
        let mut objective = OutputError::of_all(problem, &state.flights, loss, options);
        let fit_at = |value, start| {
            objective.constraints[index].bounds = (value, value);
            solve(&objective, start, StoppingCriteria::CONVERGED)
        };
        let (id, error) = (GlobalId::new(index), errors[index]);
        let found = profile(fit_at, &fitted.solution, &problem.globals, id, error);
        profiles.push(found);
    }
    profiles
}

/// Residual statistics and report of every fitted flight.
fn evaluate(
    state: &State<'_>,
    fitted: &Reweighted,
    system: &ReducedSystem<'_>,
    covariance: &Covariance,
) -> Result<Vec<(PostFit, FlightReport)>, FitError> {
    let (problem, options) = (state.problem, state.options);
    let each = parallel::each_on(options.threads(), state.flights.len(), |index| {
        let observations = &state.flights[index];
        let path = fitted.cache.path(&state.flights, index)?;
        let post_fit = post_fit(problem, observations, &fitted.noise, &state.global, path);
        let covariance = system.local_covariance(index, &covariance.model);
        let local = &fitted.solution.iterate.local[index];
        let rms = square_sums(problem, &post_fit.channels).rms();
        let initial = initial_state_report(problem, observations, local, &covariance);
        let mut report = flight_report(problem, observations, FlightOutcome::Fitted, rms, initial);
        report.seen = seen(problem, observations, &path.residuals, &fitted.noise);
        Ok((post_fit, report))
    });
    each.into_iter().collect()
}

pub fn flight_report(
    problem: &FitProblem,
    observations: &Observations,
    outcome: FlightOutcome,
    residual_rms: BTreeMap<String, Rms>,
    initial: BTreeMap<String, Estimate>,
) -> FlightReport {
    FlightReport {
        file: observations.file.clone(),
        role: observations.role,
        outcome,
        samples: observations.samples,
        residual_rms,
        outliers: observations.outliers(),
        cut: observations.truncation.clone(),
        notes: { observations.notes.iter().cloned() }
            .chain(undetermined(problem, observations, &initial))
            .collect(),
        initial,
        is_summary: observations.is_summary,
        seen: Vec::new(),
    }
}

/// Values of a summary beside what the model predicts; empty for a track.
pub fn seen(
    problem: &FitProblem,
    observations: &Observations,
    residuals: &Residuals,
    noise: &NoiseModel,
) -> Vec<SeenValue> {
    let channels = problem.channels.iter().zip(residuals).enumerate();
    let each = channels.filter_map(|(index, (own, series))| {
        let measures = own.summary()?;
        let measured = observations.value(0, index)?[0];
        let residual = series[0]?[0] / own.scale;
        Some(SeenValue {
            name: own.name.clone(),
            measures: measures.to_owned(),
            unit: own.unit.to_owned(),
            measured,
            predicted: measured + residual,
            sigma: noise.of(index).sigma[0] / own.scale,
        })
    });
    each.collect()
}

/// Share of the standard deviation of its prior from which the standard error of an unknown quantity tells that the
/// flight does not determine it.
const UNDETERMINED: f64 = 0.5;

/// Note on the unknown quantities of a flight that it does not determine.
fn undetermined(
    problem: &FitProblem,
    observations: &Observations,
    initial: &BTreeMap<String, Estimate>,
) -> Option<String> {
    let states = &problem.body.layout().states;
    let priors = observations.state_priors.iter();
    let open = priors.filter_map(|prior| {
        let name = &states[prior.state.index()];
        let found = initial.get(name)?;
        let is_open = !prior.is_measured && found.std_error > UNDETERMINED * prior.sigma;
        is_open.then_some(name.as_str())
    });
    let open: Vec<&str> = open.collect();
    (!open.is_empty()).then(|| format!("{}: not determined by this flight", open.join(", ")))
}

/// Initial state of a flight with standard errors, by name. `covariance` is that of steps along its free directions.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::fit;
    use crate::fit::tests::balls;
    use crate::options::FitOptions;

    #[test]
    fn a_flight_that_the_model_follows_far_worse_than_others_is_noted() {
        let (model, dataset) = balls(5, 0.4);
        let mut flights = fit(&model, &dataset, &FitOptions::default())
            .unwrap()
            .report
            .flights;
        let is_noted = |flight: &FlightReport| {
            flight
                .notes
                .iter()
                .any(|note| note.contains("times the usual"))
        };
        assert!(!flights.iter().any(is_noted));
        flights[2]
            .residual_rms
            .values_mut()
            .for_each(|rms| rms.value *= 10.0);
        note_misfits(&mut flights);
        let noted: Vec<bool> = flights.iter().map(is_noted).collect();
        assert_eq!(noted, [false, false, true, false, false]);
    }
}
