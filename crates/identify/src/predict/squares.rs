//! Sum of squares of a flight, without derivatives.

use super::weighted_rows::{WeightedRows, add_priors};
use super::{FlightAt, Loss, tolerance_of};
use crate::error::FlightError;
use crate::least_squares::{GramAccumulator, Unknowns};
use crate::observers::ChannelConditions;

impl FlightAt<'_> {
    /// Sum of squares, that of [`linearise`](Self::linearise), without derivatives, which take most of the time.
    ///
    /// # Errors
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn squares(self, loss: Loss<'_>) -> Result<f64, FlightError> {
        let (problem, observations) = (self.problem, self.observations);
        if observations.is_summary {
            return Ok(self.linearise(Unknowns::Local, loss)?.squares);
        }
        let tolerance = tolerance_of(problem, loss) * observations.tolerance_factor;
        let states = self.states_within(tolerance)?;
        let none = GramAccumulator::new(Vec::new(), Vec::new());
        let mut rows = WeightedRows::new(none, &problem.channels, loss);
        let mut row = [0; 3].map(|_| vec![0.0; GramAccumulator::width(0)]);
        let values = observations.parameters(problem, self.global);
        let conditions = ChannelConditions::new(problem, &values);
        let mut observers = conditions.observers();
        let with_outliers = matches!(loss, Loss::Huber(_));
        for (sample, time, state) in observations.along(&states) {
            for channel in 0..observations.channels {
                let measured = observations.seen(sample, channel, with_outliers);
                if let Some(measured) = measured {
                    let residual = observers.residual(time, state, channel, measured);
                    rows.add(channel, time, &mut row, residual);
                }
            }
        }
        let mut block = rows.accumulator.block();
        add_priors(self, &mut block);
        Ok(block.squares)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FitProblem;
    use crate::fit::tests::balls;
    use crate::initial_state::initial_guesses;
    use crate::noise::{AxesNoise, NoiseModel};
    use crate::observations::Observations;
    use crate::options::FitOptions;

    #[test]
    fn they_are_those_of_the_normal_equations() {
        let (model, dataset) = balls(1, 0.4);
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let mut observations = Observations::new(&problem, &dataset.flights[0]).unwrap();
        observations.outlier[3] = true;
        let guess = initial_guesses(&problem, &observations).unwrap();
        let global = problem.model_values();
        let at = FlightAt::new(&problem, &observations, (&global, &guess[0].state));
        let noise: NoiseModel = AxesNoise {
            ar1: [0.5, 0.0, -0.2],
            ..AxesNoise::white(1e-3, 1.0 / 120.0)
        }
        .into();
        for loss in [Loss::Huber(1e-3), Loss::Whitened(&noise)] {
            let alone = at.squares(loss).unwrap();
            let block = at.linearise(Unknowns::Local, loss).unwrap();
            let ratio = alone / block.squares;
            assert!((ratio - 1.0).abs() < 1e-3, "{loss:?}: {ratio}");
        }
    }
}
