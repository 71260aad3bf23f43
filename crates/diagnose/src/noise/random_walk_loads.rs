//! Unexplained loads over time: a random walk for each flight and load channel, piecewise linear between knots. The
//! variances of its first value and of its increments are estimated by expectation maximization from all flights; a
//! channel without evidence remains at 0.

use flight::{BasisLoads, parallel};
use identify::{Iterate, Loss, NoiseModel, pseudo_inverse};
use model_spec::layout::ParamId;
use nalgebra::{DMatrix, DVector};
use ode::DifferentiableRhs;
use serde::{Deserialize, Serialize};

use crate::context::{LibraryTerms, ScoreTestModel};
use crate::score_test::{eliminate_locals, keep_directions};

/// Maximum time between the knots of a time history, s, exceeded only beyond the maximum number of knots.
const KNOTS: (f64, usize) = (0.2, 9);

/// Maximum number of flights for which time histories of missing loads are estimated; further flights are ignored.
const MAX_FLIGHTS: usize = 12;

const INITIAL_SIGMA: f64 = 0.03;

const EM_ITERATIONS: usize = 40;

/// Minimum standard deviation, which prevents division by 0.
const MIN_SIGMA: f64 = 1e-7;

/// Time history, in one flight, of the coefficient of a load that the model lacks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoadHistory {
    /// File name of the flight.
    pub file: String,
    /// Times of the knots at which the load coefficient is estimated, s after the first sample.
    pub t: Vec<f64>,
    /// Dimensionless coefficient at each knot; near 0 where the loads of the model are complete.
    pub value: Vec<f64>,
    /// Standard errors of `value`, one for each knot.
    pub std_error: Vec<f64>,
}

/// Time histories of missing loads by channel of the term library, for at most [`MAX_FLIGHTS`] flights each; empty
/// without a library.
pub(crate) fn random_walk_loads(
    model: &ScoreTestModel<'_>,
    at: &Iterate,
    noise: &NoiseModel,
) -> Vec<Vec<LoadHistory>> {
    let Some(terms) = &model.terms else {
        return Vec::new();
    };
    let count = model.flights.len().min(MAX_FLIGHTS);
    let flights = parallel::each_on(model.threads(), count, |flight| {
        FlightLoads::new(model, terms, flight, at, noise)
    });
    let flights: Vec<FlightLoads> = flights.into_iter().flatten().collect();
    let mut sigmas = vec![WalkSigma::INITIAL; terms.loads.len()];
    for _ in 0..EM_ITERATIONS {
        maximise(&mut sigmas, &flights);
    }
    let mut histories = vec![Vec::new(); terms.loads.len()];
    for flight in &flights {
        let Some((mean, covariance)) = flight.posterior(&sigmas) else {
            continue;
        };
        let knots = flight.knots.len();
        for (channel, histories) in histories.iter_mut().enumerate() {
            let rows = channel * knots..(channel + 1) * knots;
            let std_error = |k: usize| covariance[(k, k)].max(0.0).sqrt();
            histories.push(LoadHistory {
                file: model.flights[flight.flight].file.clone(),
                t: flight.knots.clone(),
                value: rows.clone().map(|k| mean[k]).collect(),
                std_error: rows.map(std_error).collect(),
            });
        }
    }
    histories
}

/// Standard deviations of a channel's random walk.
#[derive(Clone, Copy, Debug)]
struct WalkSigma {
    first: f64,
    increment: f64,
}

impl WalkSigma {
    const INITIAL: Self = Self {
        first: INITIAL_SIGMA,
        increment: INITIAL_SIGMA,
    };
}

/// Sum of expected squares, and their number.
#[derive(Clone, Copy, Debug, Default)]
struct SquareSum {
    squares: f64,
    count: f64,
}

impl SquareSum {
    fn add(&mut self, square: f64) {
        self.squares += square;
        self.count += 1.0;
    }

    fn update(&self, sigma: &mut f64) {
        if self.count > 0.0 {
            *sigma = (self.squares / self.count).sqrt().max(MIN_SIGMA);
        }
    }
}

/// Updates the random walks' standard deviations by one iteration of expectation maximization.
fn maximise(sigmas: &mut [WalkSigma], flights: &[FlightLoads]) {
    let mut sums = vec![[SquareSum::default(); 2]; sigmas.len()];
    for flight in flights {
        if let Some((mean, covariance)) = flight.posterior(sigmas) {
            flight.add_expected_squares((&mean, &covariance), &mut sums);
        }
    }
    for (sigma, [first, increment]) in sigmas.iter_mut().zip(&sums) {
        first.update(&mut sigma.first);
        increment.update(&mut sigma.increment);
    }
}

/// Normal equations of one flight for the load coefficients at the knots, ordered by load channel and then by knot.
struct FlightLoads {
    flight: usize,
    knots: Vec<f64>,
    information: DMatrix<f64>,
    gradient: DVector<f64>,
}

impl FlightLoads {
    fn new(
        model: &ScoreTestModel<'_>,
        terms: &LibraryTerms,
        flight: usize,
        at: &Iterate,
        noise: &NoiseModel,
    ) -> Option<Self> {
        let at = model.flight_at(&model.problem, at, flight);
        let knots = knots(*at.observations.times.last()?);
        let count = knots.len();
        let conditions = at.bound();
        let first = model.problem.body.layout().parameters.len();
        let loads = terms.loads.iter().flat_map(|&load| vec![load; count]);
        let loads: Vec<(ParamId, usize)> = loads.zip(first..).collect();
        let mut motion = BasisLoads::new(&conditions, &loads, |t, _, values: &mut [f64]| {
            for (index, value) in values.iter_mut().enumerate() {
                *value = hat(&knots, index % count, t);
            }
        });
        let parameters = first..first + loads.len();
        let parameters: Vec<ParamId> = parameters.map(ParamId::new).collect();
        let by = (&mut motion as &mut dyn DifferentiableRhs, &*parameters);
        let block = at.linearise_with(Loss::Whitened(noise), by, None).ok()?;
        let (_, free) = model.local_partition(flight, &[]);
        let block = keep_directions(&block, &free);
        let equations = eliminate_locals(model, flight, &block).ok()?;
        Some(Self {
            flight,
            knots,
            information: equations.matrix,
            gradient: equations.gradient,
        })
    }

    fn posterior(&self, sigmas: &[WalkSigma]) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let mut matrix = self.information.clone();
        let knots = self.knots.len();
        for (channel, sigma) in sigmas.iter().enumerate() {
            let at = channel * knots;
            matrix[(at, at)] += sigma.first.powi(-2);
            for k in at + 1..at + knots {
                let weight = sigma.increment.powi(-2);
                matrix[(k, k)] += weight;
                matrix[(k - 1, k - 1)] += weight;
                matrix[(k, k - 1)] -= weight;
                matrix[(k - 1, k)] -= weight;
            }
        }
        let covariance = pseudo_inverse(&matrix)?;
        Some((-(&covariance * &self.gradient), covariance))
    }

    fn add_expected_squares(
        &self,
        (mean, covariance): (&DVector<f64>, &DMatrix<f64>),
        sums: &mut [[SquareSum; 2]],
    ) {
        let knots = self.knots.len();
        for (channel, [first, increment]) in sums.iter_mut().enumerate() {
            let at = channel * knots;
            first.add(mean[at].powi(2) + covariance[(at, at)]);
            for k in at + 1..at + knots {
                let variance =
                    covariance[(k, k)] + covariance[(k - 1, k - 1)] - 2.0 * covariance[(k, k - 1)];
                increment.add((mean[k] - mean[k - 1]).powi(2) + variance);
            }
        }
    }
}

/// Evenly spaced knot times, from 0 to `end`, s, of the time history of a missing load; at least 2.
fn knots(end: f64) -> Vec<f64> {
    let count = ((end / KNOTS.0).ceil() as usize + 1).clamp(2, KNOTS.1);
    let knot = |k: usize| end * k as f64 / (count - 1) as f64;
    (0..count).map(knot).collect()
}

/// Hat function: the piecewise linear function of time that is 1 at the knot with index `knot` and 0 at all others.
fn hat(knots: &[f64], knot: usize, t: f64) -> f64 {
    let width = knots[1] - knots[0];
    (1.0 - ((t - knots[knot]) / width).abs()).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hat_functions_sum_to_one_and_interpolate_at_knots() {
        let knots = knots(0.6);
        assert_eq!(knots.len(), 4);
        for t in [0.0, 0.05, 0.2, 0.31, 0.6] {
            let sum: f64 = (0..4).map(|k| hat(&knots, k, t)).sum();
            assert!((sum - 1.0).abs() < 1e-12);
        }
        assert!((hat(&knots, 2, 0.4) - 1.0).abs() < 1e-12);
        assert_eq!(hat(&knots, 0, 0.25), 0.0);
    }

    /// A random walk: the variance grows from knot to knot, and nothing in it says otherwise.
    #[test]
    fn without_any_evidence_a_load_is_what_was_assumed() {
        let flight = FlightLoads {
            flight: 0,
            knots: knots(0.6),
            gradient: DVector::zeros(8),
            information: DMatrix::zeros(8, 8),
        };
        let assumed = WalkSigma {
            first: 0.3,
            increment: 0.1,
        };
        let mut sigmas = [assumed, WalkSigma::INITIAL];
        let (mean, covariance) = flight.posterior(&sigmas).unwrap();
        assert_eq!(mean.amax(), 0.0);
        for knot in 0..4 {
            let expected = 0.09 + 0.01 * knot as f64;
            assert!((covariance[(knot, knot)] - expected).abs() < 1e-9);
        }
        maximise(&mut sigmas, &[flight]);
        let [found, _] = sigmas;
        assert!((found.first - 0.3).abs() < 1e-6 && (found.increment - 0.1).abs() < 1e-6);
    }

    #[test]
    fn a_channel_without_evidence_stays_at_zero_and_one_with_it_is_followed() {
        // Two channels at three knots: a rising load is measured in the first channel, a zero load in the second.
        let mut information = DMatrix::identity(6, 6) * 1e6;
        information[(5, 5)] = 1e5;
        let truth = DVector::from_column_slice(&[0.1, 0.2, 0.3, 0.0, 0.0, 0.0]);
        let flight = FlightLoads {
            flight: 0,
            knots: knots(0.4),
            gradient: -(&information * &truth),
            information,
        };
        let mut sigmas = vec![WalkSigma::INITIAL; 2];
        for _ in 0..EM_ITERATIONS {
            maximise(&mut sigmas, std::slice::from_ref(&flight));
        }
        let (mean, _) = flight.posterior(&sigmas).unwrap();
        assert!((mean[2] - 0.3).abs() < 1e-3, "{mean}");
        assert!(mean[5].abs() < 1e-6 && sigmas[1].increment < 1e-2 * sigmas[0].increment);
    }
}
