//! Noise of the columns of summaries: the sum of squared residuals over their redundancy, the number of values less the
//! leverages of the unknowns on them (Förstner 1979, estimation of variance components).

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ChiSquared, ContinuousCDF};

use super::state::State;
use super::summaries::assumed;
use crate::error::FlightError;
use crate::least_squares::{NormalBlock, ScaledCholesky, pseudo_inverse};
use crate::noise::NoiseModel;
use crate::numbers::{probability, significant};
use crate::observations::Observations;
use crate::predict::{FlightAt, add_state_priors};
use crate::problem::FitProblem;
use dataset::levels::ROUNDING;

/// Maximum number of iterations, and relative change of the standard deviations at their end.
const ITERATIONS: (usize, f64) = (50, 1e-4);

/// Least redundancy of a column whose noise is estimated.
const LEAST_REDUNDANCY: f64 = 0.5;

/// p-value below which rows do not agree with their stated standard deviations.
const LEVEL: f64 = 0.01;

/// Number of standard errors by which an estimate may move if what is assumed of releases is off by its standard deviation
/// in all of them.
const MOST_BY_ASSUMPTION: f64 = 1.0;

/// A value of a summary with the derivatives of its residual by the local and the global parameters, m.
struct Row {
    channel: usize,
    residual: f64,
    by_local: DVector<f64>,
    by_global: DVector<f64>,
}

/// Replaces the estimates of the noise of columns of summaries in `noise`.
///
/// # Errors
/// [`FlightError`] if a flight cannot be integrated.
pub fn estimate(state: &State<'_>, noise: &mut NoiseModel) -> Result<(), FlightError> {
    let problem = state.problem;
    let estimated = estimated(problem);
    if estimated.is_empty() {
        return Ok(());
    }
    let flights = flights(state)?;
    for _ in 0..ITERATIONS.0 {
        let sums = redundancy(&flights, noise, None)?;
        let mut change: f64 = 0.0;
        for &channel in &estimated {
            let Some(Sums {
                squares,
                redundancy,
                ..
            }) = sums.get(&channel)
            else {
                continue;
            };
            let sigma = (squares / redundancy.max(LEAST_REDUNDANCY)).sqrt();
            let sigma = sigma.max(ROUNDING * problem.sigma0);
            let own = noise.of_mut(channel);
            change = change.max((sigma / own.sigma[0] - 1.0).abs());
            own.sigma = [sigma; 3];
            own.ar1 = [0.0; 3];
        }
        if change < ITERATIONS.1 {
            break;
        }
    }
    Ok(())
}

/// Rows of a flight, with its observations and initial state.
type FlightRows<'a> = (Vec<Row>, &'a Observations, &'a DVector<f64>);

fn flights<'a>(state: &'a State<'_>) -> Result<Vec<FlightRows<'a>>, FlightError> {
    let flights = (0..state.flights.len()).map(|flight| state.at(flight));
    let summaries = flights.filter(|at| at.observations.is_summary);
    let with_rows = summaries.map(|at| Ok((rows(at)?, at.observations, at.local)));
    with_rows.collect()
}

/// Sums over the rows of a channel.
struct Sums {
    squares: f64,
    redundancy: f64,
    /// Change of the global parameters if all values of the channel change by 1 m.
    shift: DVector<f64>,
}

/// Sums of each channel. `covariance` is that of the global parameters; `None` if the rows alone determine them.
fn redundancy(
    flights: &[FlightRows<'_>],
    noise: &NoiseModel,
    covariance: Option<&DMatrix<f64>>,
) -> Result<BTreeMap<usize, Sums>, FlightError> {
    let all = flights.iter().flat_map(|(rows, ..)| rows);
    let globals = { all }.map(|row| row.by_global.len()).next().unwrap_or(0);
    let (mut factors, mut reduced) = (Vec::new(), DMatrix::zeros(globals, globals));
    for (rows, flight, local) in flights {
        let mut block = NormalBlock::zero(flight.manifold.dimension(), globals);
        for row in rows {
            let weight = 1.0 / noise.of(row.channel).sigma[0];
            let (by_local, by_global) = (&row.by_local * weight, &row.by_global * weight);
            block.add(weight * row.residual, &by_local, &by_global);
        }
        add_state_priors(flight, local, &mut block);
        let factor = ScaledCholesky::independent(&block.local, 0.0);
        let factor = factor.ok_or(FlightError::SingularInitialState)?;
        let through = factor.solve_matrix(&block.cross);
        reduced += &block.global - block.cross.tr_mul(&through);
        factors.push((factor, through));
    }
    let own = || pseudo_inverse(&reduced).unwrap_or_else(|| DMatrix::zeros(globals, globals));
    let covariance = covariance.cloned().unwrap_or_else(own);
    let mut sums = BTreeMap::new();
    for ((rows, ..), (factor, through)) in flights.iter().zip(&factors) {
        for row in rows {
            let beyond = &row.by_global - through.tr_mul(&row.by_local);
            let variance = row.by_local.dot(&factor.solve(&row.by_local))
                + beyond.dot(&(&covariance * &beyond));
            let weight = noise.of(row.channel).sigma[0].powi(-2);
            let own = sums.entry(row.channel).or_insert_with(|| Sums {
                squares: 0.0,
                redundancy: 0.0,
                shift: DVector::zeros(globals),
            });
            own.squares += row.residual * row.residual;
            own.redundancy += 1.0 - (variance * weight).min(1.0);
            own.shift += &covariance * &beyond * weight;
        }
    }
    Ok(sums)
}

/// Channels of outcomes whose noise is not stated.
fn estimated(problem: &FitProblem) -> Vec<usize> {
    let channels = problem.channels.iter().enumerate();
    let unstated = channels
        .filter(|(_, own)| crate::summary::event(own.kind).is_some() && own.sigma.is_none());
    unstated.map(|(channel, _)| channel).collect()
}

/// Why rows of summaries leave a doubt whether the model fits them: no test is possible, or they fail it; `None` if
/// there are no rows, or they pass. `covariance` is that of the global parameters.
///
/// # Errors
/// [`FlightError`] if a flight cannot be integrated.
pub fn doubt(
    state: &State<'_>,
    noise: &NoiseModel,
    covariance: &DMatrix<f64>,
) -> Result<Option<String>, FlightError> {
    let problem = state.problem;
    if !state.flights.iter().any(|flight| flight.is_summary) {
        return Ok(None);
    }
    let estimated = estimated(problem);
    if !estimated.is_empty() {
        let names = estimated.iter().map(|k| problem.channels[*k].name.clone());
        let names = names.collect::<Vec<_>>().join(", ");
        return Ok(Some(format!(
            "the noise of {names} is estimated from the rows themselves, so that nothing tests whether the model fits \
             them: state each `sigma`, and compare held-out rows"
        )));
    }
    let sums = redundancy(&flights(state)?, noise, Some(covariance))?;
    let weighted =
        |(channel, own): (&usize, &Sums)| own.squares / noise.of(*channel).sigma[0].powi(2);
    let squares: f64 = sums.iter().map(weighted).sum();
    let freedom: f64 = sums.values().map(|own| own.redundancy).sum();
    let Ok(distribution) = ChiSquared::new(freedom.max(1.0)) else {
        return Ok(None);
    };
    let p_value = distribution.sf(squares);
    if p_value >= LEVEL {
        return Ok(doubt_of_assumptions(state, &sums, covariance));
    }
    Ok(Some(format!(
        "the residuals of the rows are {} times their stated standard deviations (chi-squared test, p = {}): \
         `hyzer diagnose` searches for the cause",
        significant((squares / freedom.max(1.0)).sqrt(), 2),
        probability(p_value)
    )))
}

/// Why estimates follow from what is assumed of releases: the rows may all differ from it in the same way.
fn doubt_of_assumptions(
    state: &State<'_>,
    sums: &BTreeMap<usize, Sums>,
    covariance: &DMatrix<f64>,
) -> Option<String> {
    let problem = state.problem;
    let worst = sums.iter().flat_map(|(channel, own)| {
        let of = &problem.channels[*channel];
        let sigma = of.sigma.filter(|_| of.assumed.is_some()).unwrap_or(0.0);
        own.shift.iter().enumerate().map(move |(index, shift)| {
            let error = covariance[(index, index)].max(f64::MIN_POSITIVE).sqrt();
            (*channel, index, (shift * sigma / error).abs())
        })
    });
    let (channel, index, moved) = worst.max_by(|a, b| a.2.total_cmp(&b.2))?;
    let rows = state.flights.iter().filter(|flight| flight.is_summary);
    let assumed = assumed(&problem.channels[channel], channel, rows)?;
    (moved > MOST_BY_ASSUMPTION).then(|| {
        format!(
            "{assumed}: if all had {} more, {} would be {} standard errors off",
            assumed.more,
            problem.globals[index].name,
            significant(moved, 2)
        )
    })
}

fn rows(at: FlightAt<'_>) -> Result<Vec<Row>, FlightError> {
    let directions = at.observations.manifold.dimension();
    let mut rows = Vec::new();
    at.each_residual(&at.problem.global_parameters(), &mut |point| {
        let (by_local, by_global) = point.rows[0].split_at(directions);
        rows.push(Row {
            channel: point.channel,
            residual: point.residual[0],
            by_local: DVector::from_column_slice(by_local),
            by_global: DVector::from_column_slice(by_global),
        });
    })?;
    Ok(rows)
}
