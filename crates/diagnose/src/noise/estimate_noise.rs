//! Noise estimate from the residuals after removing all significant effects, to first order.

use flight::parallel;
use identify::{FitError, NoiseModel, NormalBlock, PointResidual, Residuals, eliminate, outliers};
use nalgebra::DVector;

use crate::context::{CandidateId, LinearizationPoint, ScoreTestModel};
use crate::error::DiagnosisError;
use crate::score_test::{ScoreTests, keep_directions};

/// Minimum score, in standard deviations, of a direction whose contribution is removed; removing more would bias the
/// variance low and distort the autocorrelation.
const MIN_SCORE: f64 = 4.0;

/// Maximum log p-value of a candidate whose states are estimated before the noise.
const MAX_LN_P_OF_STATES: f64 = -14.0;

/// Relative damping of the elimination of local parameters.
pub(crate) const DAMPING: f64 = 1e-12;

impl ScoreTestModel<'_> {
    /// Estimates the noise and marks outliers after one linearized step: nuisance parameters, with those of
    /// `conditioned_on`, are re-estimated, and significant candidates and terms removed. `noise` weights the residuals.
    pub fn estimate_noise(
        &mut self,
        at: LinearizationPoint<'_>,
        conditioned_on: &[CandidateId],
        noise: &NoiseModel,
    ) -> Result<NoiseModel, DiagnosisError> {
        let blocks = self.normal_equations_with_terms(at, noise)?;
        let global = &at.iterate.global;
        let mut tests = ScoreTests::new(self, &blocks, conditioned_on, global)?;
        let with = self.with_significant_states(&tests, conditioned_on);
        if with.len() > conditioned_on.len() {
            tests = ScoreTests::new(self, &blocks, &with, global)?;
        }
        let (global_step, directions) = tests.one_step_along_significant(MIN_SCORE);
        let local_steps: Vec<DVector<f64>> = blocks
            .iter()
            .enumerate()
            .map(|(flight, block)| self.local_step(flight, block, &with, &global_step))
            .collect::<Result<_, _>>()?;
        let remaining = parallel::each_on(self.threads(), self.flights.len(), |flight| {
            self.residuals_after_step(at, flight, (&global_step, &local_steps[flight]))
        });
        let remaining: Vec<Residuals> = remaining.into_iter().collect::<Result<_, FitError>>()?;
        let locals: usize = local_steps.iter().map(DVector::len).sum();
        let unknowns = directions + tests.partition.nuisance.len() + locals;
        let residuals: Vec<_> = remaining.iter().map(|flight| &flight[..]).collect();
        let (after, threads) = ((unknowns, noise.interval), self.threads());
        let (problem, flights) = (&self.problem, &mut self.flights);
        let (noise, _) = outliers::estimate_noise(problem, flights, &residuals, after, threads);
        Ok(noise)
    }

    /// The candidates in `conditioned_on`, followed by significant ones with one value for each flight.
    fn with_significant_states(
        &self,
        tests: &ScoreTests,
        conditioned_on: &[CandidateId],
    ) -> Vec<CandidateId> {
        let mut with = conditioned_on.to_vec();
        for (id, candidate) in self.candidates() {
            let test = tests.candidates[id].as_ref();
            let is_significant = test.is_some_and(|test| test.ln_p_value < MAX_LN_P_OF_STATES);
            if candidate.is_per_flight() && is_significant {
                with.push(id);
            }
        }
        with
    }

    /// Step of a flight's local parameters for a step of the global ones; 0 for states of candidates outside `with`.
    fn local_step(
        &self,
        flight: usize,
        block: &NormalBlock,
        with: &[CandidateId],
        global_step: &DVector<f64>,
    ) -> Result<DVector<f64>, DiagnosisError> {
        let (_, free) = self.local_partition(flight, with);
        let blocks = [keep_directions(block, &free)];
        let file = || self.flights[flight].file.clone();
        let system = eliminate(&blocks, DAMPING)
            .map_err(|_| DiagnosisError::UndeterminedInitialState { file: file() })?;
        let mut step = DVector::zeros(self.flights[flight].manifold.dimension());
        for (direction, value) in free
            .iter()
            .zip(system.back_substitute(global_step)[0].iter())
        {
            step[direction.index()] = *value;
        }
        Ok(step)
    }

    /// Residuals, m, of a flight after the steps of global and local parameters, by linearization.
    fn residuals_after_step(
        &self,
        at: LinearizationPoint<'_>,
        flight: usize,
        (global_step, local_step): (&DVector<f64>, &DVector<f64>),
    ) -> Result<Residuals, FitError> {
        let observations = &self.flights[flight];
        let step: Vec<f64> = local_step
            .iter()
            .chain(global_step.iter())
            .copied()
            .collect();
        let mut remaining: Residuals =
            vec![vec![None; observations.times.len()]; observations.channels];
        self.each_residual(at, flight, &mut |point: PointResidual<'_>| {
            let change = |axis: usize| -> f64 {
                let row = &point.rows[axis];
                row.iter().zip(&step).map(|(a, b)| a * b).sum()
            };
            let after = [0, 1, 2].map(|axis| point.residual[axis] + change(axis));
            remaining[point.channel][point.sample] = Some(after);
        })?;
        Ok(remaining)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context::TrajectoryCache;
    use crate::test_support::fixture;

    #[test]
    fn the_noise_is_that_of_the_dataset_given_the_missing_effect_and_smaller_than_the_misfit_without()
     {
        let mut fixture = fixture();
        let misfit = fixture.fit.noise().clone();
        let stall = [fixture.candidate("stall")];
        let mut noise = misfit.clone();
        // The first fit is weighted by the noise estimate with misfit, the second by the noise estimate without it.
        for _ in 0..2 {
            let from = &fixture.iterate;
            let hypothesis = fixture.model.fit_hypothesis(&stall, from, &noise).unwrap();
            let at = hypothesis.linearization_point();
            noise = fixture.model.estimate_noise(at, &stall, &noise).unwrap();
        }
        // The dataset was made with noise of 1.5 mm.
        assert!((noise.overall() / 0.0015 - 1.0).abs() < 0.1, "{noise:?}");
        assert!(misfit.overall() > 1.5 * noise.overall(), "{misfit:?}");
        // What the noise was estimated beside, and nothing that has one value for all flights.
        let at = LinearizationPoint {
            problem: &fixture.model.problem,
            iterate: &fixture.iterate,
            cache: &TrajectoryCache::DISABLED,
        };
        let blocks = fixture.model.normal_equations_with_terms(at, &misfit);
        let global = &fixture.iterate.global;
        let tests = ScoreTests::new(&fixture.model, &blocks.unwrap(), &[], global).unwrap();
        let is_significant = |id| tests.candidates[id].as_ref().unwrap().ln_p_value < -20.0;
        assert!(is_significant(stall[0]));
        let with = fixture.model.with_significant_states(&tests, &[]);
        assert!(
            with.iter()
                .all(|id| fixture.model.candidate(*id).is_per_flight())
        );
        assert!(with.iter().all(|id| is_significant(*id)));
    }
}
