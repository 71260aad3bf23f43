//! Loads that no law gives, in time: for each flight and channel the coefficient by which the flight differs from the model.
//!
//! A history is a broken line between knots. How far its beginning and its bends are believed is estimated from all flights
//! at once, so that a channel that asks for nothing stays at nothing.

use flight::batch;
use identify::{Iterate, Loss, NoiseModel, eliminate, linearise_with};
use nalgebra::{DMatrix, DVector};

use crate::bench::Bench;
use crate::report::{Channel, History};
use crate::terms::Grammar;
use crate::weighted::Weighted;

/// Time between knots, s, and most of them.
const KNOTS: (f64, usize) = (0.2, 9);

/// Flights whose histories are estimated.
const FLIGHTS: usize = 12;

/// What is first believed of a coefficient's beginning, and of its change from knot to knot.
const BELIEVED: f64 = 0.03;

/// Estimates of what is believed.
const ROUNDS: usize = 40;

/// The least that is believed.
const LEAST: f64 = 1e-7;

/// Puts histories into the channels.
pub fn fill(channels: &mut [Channel], bench: &Bench, at: &Iterate, noise: &NoiseModel) {
    let Some(grammar) = &bench.grammar else {
        return;
    };
    let count = bench.observation_sets.len().min(FLIGHTS);
    let flown = batch::each_on(bench.threads, count, |flight| {
        Flown::new(bench, grammar, flight, at, noise)
    });
    let flown: Vec<Flown> = flown.into_iter().flatten().collect();
    let mut believed = vec![[BELIEVED; 2]; channels.len()];
    for _ in 0..ROUNDS {
        let mut sums = vec![[(0.0, 0.0); 2]; channels.len()];
        for flown in &flown {
            let Some((mean, covariance)) = flown.posterior(&believed) else {
                continue;
            };
            flown.add(&mean, &covariance, &mut sums);
        }
        for (believed, sums) in believed.iter_mut().zip(&sums) {
            for (size, (squares, count)) in believed.iter_mut().zip(sums) {
                if *count > 0.0 {
                    *size = (squares / count).sqrt().max(LEAST);
                }
            }
        }
    }
    for flown in &flown {
        let Some((mean, covariance)) = flown.posterior(&believed) else {
            continue;
        };
        let knots = flown.knots.len();
        for (index, channel) in channels.iter_mut().enumerate() {
            let at = |k: usize| index * knots + k;
            channel.histories.push(History {
                file: bench.observation_sets[flown.flight].file.clone(),
                t: flown.knots.clone(),
                value: (0..knots).map(|k| mean[at(k)]).collect(),
                std_error: (0..knots)
                    .map(|k| covariance[(at(k), at(k))].max(0.0).sqrt())
                    .collect(),
            });
        }
    }
}

/// A flight with what it says of its histories.
struct Flown {
    flight: usize,
    knots: Vec<f64>,
    information: DMatrix<f64>,
    gradient: DVector<f64>,
}

impl Flown {
    fn new(
        bench: &Bench,
        grammar: &Grammar,
        flight: usize,
        at: &Iterate,
        noise: &NoiseModel,
    ) -> Option<Self> {
        let (problem, observations) = (&bench.problem, &bench.observation_sets[flight]);
        let end = *observations.times.last()?;
        let count = ((end / KNOTS.0).ceil() as usize + 1).clamp(2, KNOTS.1);
        let knots: Vec<f64> = (0..count)
            .map(|k| end * k as f64 / (count - 1) as f64)
            .collect();
        let parameters = observations.parameters(problem, &at.global);
        let conditions = problem.body.bind(parameters);
        let first = problem.body.layout().parameters.len();
        let each = grammar.places.iter();
        let loads: Vec<usize> = each.flat_map(|&place| vec![place; count]).collect();
        let motion = Weighted::new(&conditions, &loads, first, |t, _, weights| {
            for (index, weight) in weights.iter_mut().enumerate() {
                *weight = hat(&knots, index % count, t);
            }
        });
        let places: Vec<usize> = (first..first + count * grammar.places.len()).collect();
        let unknowns = (&at.global, &at.local[flight]);
        let samples = observations.times.len();
        let loss = Loss::Whitened(noise);
        let block = linearise_with(
            problem,
            observations,
            unknowns,
            samples,
            loss,
            (motion, &places),
            None,
        )
        .ok()?;
        let blocks = [bench.own_of(flight, &block, &[]).0];
        let system = eliminate(&blocks, 0.0).ok()?;
        Some(Self {
            flight,
            knots,
            information: system.reduced.clone(),
            gradient: system.gradient.clone(),
        })
    }

    /// Mean and covariance of the knots' values, where beginnings and changes are believed to be of these sizes.
    fn posterior(&self, believed: &[[f64; 2]]) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let mut matrix = self.information.clone();
        let knots = self.knots.len();
        for (channel, [first, change]) in believed.iter().enumerate() {
            let at = channel * knots;
            matrix[(at, at)] += first.powi(-2);
            for k in at + 1..at + knots {
                let weight = change.powi(-2);
                matrix[(k, k)] += weight;
                matrix[(k - 1, k - 1)] += weight;
                matrix[(k, k - 1)] -= weight;
                matrix[(k - 1, k)] -= weight;
            }
        }
        let covariance = crate::scores::inverse(&matrix)?;
        Some((-(&covariance * &self.gradient), covariance))
    }

    /// Adds the expected squares of beginnings and changes, with how many they are.
    fn add(&self, mean: &DVector<f64>, covariance: &DMatrix<f64>, sums: &mut [[(f64, f64); 2]]) {
        let knots = self.knots.len();
        for (channel, sums) in sums.iter_mut().enumerate() {
            let at = channel * knots;
            sums[0].0 += mean[at].powi(2) + covariance[(at, at)];
            sums[0].1 += 1.0;
            for k in at + 1..at + knots {
                let variance =
                    covariance[(k, k)] + covariance[(k - 1, k - 1)] - 2.0 * covariance[(k, k - 1)];
                sums[1].0 += (mean[k] - mean[k - 1]).powi(2) + variance;
                sums[1].1 += 1.0;
            }
        }
    }
}

/// How much a knot counts at a time.
fn hat(knots: &[f64], knot: usize, t: f64) -> f64 {
    let width = knots[1] - knots[0];
    (1.0 - ((t - knots[knot]) / width).abs()).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::hat;

    #[test]
    fn hats_add_up_to_one_and_are_one_at_their_own_knot() {
        let knots = [0.0, 0.2, 0.4, 0.6];
        for t in [0.0, 0.05, 0.2, 0.31, 0.6] {
            let sum: f64 = (0..4).map(|k| hat(&knots, k, t)).sum();
            assert!((sum - 1.0).abs() < 1e-12);
        }
        assert_eq!(hat(&knots, 2, 0.4), 1.0);
        assert_eq!(hat(&knots, 0, 0.25), 0.0);
    }
}
