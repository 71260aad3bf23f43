//! The noise first: what is left of the residuals once the candidates have taken what is certainly theirs is far nearer to
//! the noise than what the base leaves.

use flight::batch;
use identify::fit::FitError;
use identify::levenberg::Point;
use identify::noise::{Moments, Noise};
use identify::normal::eliminate;
use identify::outlier;
use identify::predict::{Residual, Residuals};
use identify::setting::Setting;
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
        noise: &Noise,
    ) -> Result<Noise, FitError> {
        let Vantage { setting, point, .. } = from;
        let blocks = self.look_further(from, noise)?;
        let scored = |allowed: &[usize]| {
            Scores::new(self, &blocks, (allowed, &[]), &point.shared).map_err(FitError::Mismatch)
        };
        let mut scores = scored(allowed)?;
        let mut with = allowed.to_vec();
        for (index, score) in scores.each.iter().enumerate() {
            let own = !self.candidates[index].states.is_empty();
            if own && score.as_ref().is_some_and(|score| score.ln_p < ALARMING) {
                with.push(index);
            }
        }
        if with.len() > allowed.len() {
            scores = scored(&with)?;
        }
        let (shared, kept) = scores.step(BEYOND);
        let mut own = Vec::with_capacity(blocks.len());
        for (flight, block) in blocks.iter().enumerate() {
            let (block, directions) = self.own_of(flight, block, &with);
            let blocks = [block];
            let system = eliminate(&blocks, 1e-12)
                .map_err(|fault| self.impossible(flight, fault.to_string()))?;
            let mut step = DVector::zeros(self.tracks[flight].chart.dimension());
            for (&direction, value) in directions.iter().zip(system.own_steps(&shared)[0].iter()) {
                step[direction] = *value;
            }
            own.push(step);
        }
        let left = batch::each_on(self.threads, self.tracks.len(), |flight| {
            self.left_by(setting, flight, point, &shared, &own[flight])
                .map_err(|reason| self.impossible(flight, reason))
        });
        let left: Vec<Residuals> = left.into_iter().collect::<Result<_, FitError>>()?;
        let unknowns = kept + scores.base.0.len() + own.iter().map(DVector::len).sum::<usize>();
        Ok(self.noise_of(&left, unknowns, noise.interval))
    }

    /// What a step of all unknowns leaves of a flight's residuals, to the first order.
    fn left_by(
        &self,
        setting: &Setting,
        flight: usize,
        point: &Point,
        shared: &DVector<f64>,
        own: &DVector<f64>,
    ) -> Result<Residuals, String> {
        let track = &self.tracks[flight];
        let unknowns = (&point.shared, &point.own[flight]);
        let step: Vec<f64> = own.iter().chain(shared.iter()).copied().collect();
        let mut left: Residuals = vec![vec![None; track.times.len()]; track.markers];
        let take = |seen: Residual<'_>| {
            let along = |axis: usize| -> f64 {
                let row = &seen.rows[axis];
                row.iter().zip(&step).map(|(a, b)| a * b).sum()
            };
            left[seen.marker][seen.sample] =
                Some([0, 1, 2].map(|axis| seen.residual[axis] + along(axis)));
        };
        self.each_residual_further(setting, track, unknowns, take)?;
        Ok(left)
    }

    fn noise_of(&mut self, left: &[Residuals], unknowns: usize, interval: f64) -> Noise {
        let departures: Vec<_> = self
            .tracks
            .iter()
            .zip(left)
            .map(|(track, left)| outlier::departures(&track.times, left))
            .collect();
        let scales: Vec<[f64; 3]> = departures.iter().map(|d| outlier::scale(d)).collect();
        let usual = outlier::usual(&scales);
        let mut sum = Moments::default();
        for (index, (track, left)) in self.tracks.iter_mut().zip(left).enumerate() {
            let scale = [0, 1, 2].map(|axis| usual[axis].max(scales[index][axis]));
            track.outlier = outlier::marks(&departures[index], scale);
            for (marker, series) in left.iter().enumerate() {
                let good = series.iter().enumerate().map(|(sample, residual)| {
                    residual.filter(|_| !track.outlier[sample * track.markers + marker])
                });
                let good: Vec<Option<[f64; 3]>> = good.collect();
                sum.add(&track.times, &good, interval);
            }
        }
        sum.noise(unknowns, interval, self.setting.sigma)
    }
}
