//! The noise first: what is left of the residuals once the candidates have taken what is certainly theirs is far nearer to
//! the noise than what the base leaves.

use flight::batch;
use identify::{
    FitError, FitProblem, Iterate, Moments, NoiseModel, PointResidual, Residuals, eliminate,
    outliers,
};
use nalgebra::DVector;

use crate::bench::Bench;
use crate::kept::Vantage;
use crate::scores::Scores;

/// Directions whose scores are smaller than this, in standard deviations, are noise's own: to take them from it would leave too
/// little, and of noise that is correlated the wrong part.
const BEYOND: f64 = 4.0;

/// States of each flight are followed where chance does as much with a probability of this logarithm.
const ALARMING: f64 = -14.0;

impl Bench {
    /// Estimates the noise from what is left once the candidates have taken what is certainly theirs, and marks outliers by it; `allowed` candidates are in at
    /// the point already. `noise` is a first guess.
    ///
    /// # Errors
    /// Where a flight is impossible.
    pub fn leftover(
        &mut self,
        from: Vantage<'_>,
        allowed: &[usize],
        noise: &NoiseModel,
    ) -> Result<NoiseModel, FitError> {
        let Vantage { problem, point, .. } = from;
        let blocks = self.look_further(from, noise)?;
        let scored = |allowed: &[usize]| {
            Scores::new(self, &blocks, (allowed, &[]), &point.global).map_err(FitError::Mismatch)
        };
        let mut scores = scored(allowed)?;
        let mut with = allowed.to_vec();
        for (index, score) in scores.each.iter().enumerate() {
            let local = !self.candidates[index].states.is_empty();
            if local && score.as_ref().is_some_and(|score| score.ln_p < ALARMING) {
                with.push(index);
            }
        }
        if with.len() > allowed.len() {
            scores = scored(&with)?;
        }
        let (global, kept) = scores.step(BEYOND);
        let mut local = Vec::with_capacity(blocks.len());
        for (flight, block) in blocks.iter().enumerate() {
            let (block, directions) = self.own_of(flight, block, &with);
            let blocks = [block];
            let system = eliminate(&blocks, 1e-12)
                .map_err(|fault| self.impossible(flight, fault.to_string()))?;
            let mut step = DVector::zeros(self.observation_sets[flight].manifold.dimension());
            for (&direction, value) in directions
                .iter()
                .zip(system.back_substitute(&global)[0].iter())
            {
                step[direction] = *value;
            }
            local.push(step);
        }
        let left = batch::each_on(self.threads, self.observation_sets.len(), |flight| {
            self.left_by(problem, flight, point, &global, &local[flight])
                .map_err(|reason| self.impossible(flight, reason))
        });
        let left: Vec<Residuals> = left.into_iter().collect::<Result<_, FitError>>()?;
        let unknowns = kept + scores.base.0.len() + local.iter().map(DVector::len).sum::<usize>();
        Ok(self.noise_of(&left, unknowns, noise.interval))
    }

    /// What a step of all unknowns leaves of a flight's residuals, to the first order.
    fn left_by(
        &self,
        problem: &FitProblem,
        flight: usize,
        point: &Iterate,
        global: &DVector<f64>,
        local: &DVector<f64>,
    ) -> Result<Residuals, String> {
        let observations = &self.observation_sets[flight];
        let unknowns = (&point.global, &point.local[flight]);
        let step: Vec<f64> = local.iter().chain(global.iter()).copied().collect();
        let mut left: Residuals = vec![vec![None; observations.times.len()]; observations.markers];
        let take = |seen: PointResidual<'_>| {
            let along = |axis: usize| -> f64 {
                let row = &seen.rows[axis];
                row.iter().zip(&step).map(|(a, b)| a * b).sum()
            };
            left[seen.marker][seen.sample] =
                Some([0, 1, 2].map(|axis| seen.residual[axis] + along(axis)));
        };
        self.each_residual_further(problem, observations, unknowns, take)?;
        Ok(left)
    }

    fn noise_of(&mut self, left: &[Residuals], unknowns: usize, interval: f64) -> NoiseModel {
        let departures: Vec<_> = self
            .observation_sets
            .iter()
            .zip(left)
            .map(|(observations, left)| outliers::local_residuals(&observations.times, left))
            .collect();
        let scales: Vec<[f64; 3]> = departures.iter().map(|d| outliers::scale(d)).collect();
        let usual = outliers::usual(&scales);
        let mut sum = Moments::default();
        for (index, (observations, left)) in self.observation_sets.iter_mut().zip(left).enumerate()
        {
            let scale = [0, 1, 2].map(|axis| usual[axis].max(scales[index][axis]));
            observations.outlier = outliers::outlier_mask(&departures[index], scale);
            for (marker, series) in left.iter().enumerate() {
                let good = series.iter().enumerate().map(|(sample, residual)| {
                    residual
                        .filter(|_| !observations.outlier[sample * observations.markers + marker])
                });
                let good: Vec<Option<[f64; 3]>> = good.collect();
                sum.add(&observations.times, &good, interval);
            }
        }
        sum.noise(unknowns, interval, self.problem.sigma)
    }
}
