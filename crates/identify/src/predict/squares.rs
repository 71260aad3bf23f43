//! Sum of squares of a flight, without derivatives.

use nalgebra::DVector;

use super::trajectory_pass::states_within;
use super::weighted_rows::{WeightedRows, add_priors};
use super::{Loss, linearise, tolerance_of};
use crate::error::FlightError;
use crate::least_squares::{GramAccumulator, Unknowns};
use crate::observations::Observations;
use crate::observers::ChannelConditions;
use crate::problem::FitProblem;

/// Sum of squares of the first `samples` samples of a flight, that of [`linearise`], without derivatives, which take most
/// of the time.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub fn squares(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
    loss: Loss<'_>,
) -> Result<f64, FlightError> {
    let unknowns = (global, local);
    if observations.is_summary {
        let by = Unknowns::Local;
        let block = linearise(problem, observations, unknowns, samples, by, loss)?;
        return Ok(block.squares);
    }
    let tolerance = tolerance_of(problem, loss) * observations.tolerance_factor;
    let states = states_within(problem, observations, unknowns, samples, tolerance)?;
    let none = GramAccumulator::new(Vec::new(), Vec::new());
    let mut rows = WeightedRows::new(none, &problem.channels, loss);
    let mut row = [0; 3].map(|_| vec![0.0; GramAccumulator::width(0)]);
    let values = observations.parameters(problem, global);
    let conditions = ChannelConditions::new(problem, &values);
    let mut observers = conditions.observers();
    let with_outliers = matches!(loss, Loss::Huber(_));
    for (sample, state) in states.chunks(observations.manifold.states()).enumerate() {
        let time = observations.times[sample];
        for channel in 0..observations.channels {
            let measured = match with_outliers {
                true => observations.value(sample, channel),
                false => observations.inlier(sample, channel),
            };
            if let Some(measured) = measured {
                let residual = observers.residual(time, state, channel, measured);
                rows.add(channel, time, &mut row, residual);
            }
        }
    }
    let mut block = rows.accumulator.block();
    add_priors(problem, observations, local, &mut block);
    Ok(block.squares)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::balls;
    use crate::initial_state::initial_guesses;
    use crate::noise::{AxesNoise, NoiseModel};
    use crate::options::FitOptions;

    #[test]
    fn they_are_those_of_the_normal_equations() {
        let (model, dataset) = balls(1, 0.4);
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let mut observations = Observations::new(&problem, &dataset.flights[0]).unwrap();
        observations.outlier[3] = true;
        let guess = initial_guesses(&problem, &observations).unwrap();
        let (global, samples) = (problem.model_values(), observations.times.len());
        let at = (&global, &guess[0].state);
        let noise: NoiseModel = AxesNoise {
            ar1: [0.5, 0.0, -0.2],
            ..AxesNoise::white(1e-3, 1.0 / 120.0)
        }
        .into();
        for loss in [Loss::Huber(1e-3), Loss::Whitened(&noise)] {
            let alone = squares(&problem, &observations, at, samples, loss).unwrap();
            let by = Unknowns::Local;
            let block = linearise(&problem, &observations, at, samples, by, loss).unwrap();
            let ratio = alone / block.squares;
            assert!((ratio - 1.0).abs() < 1e-3, "{loss:?}: {ratio}");
        }
    }
}
