//! The noise first: what is left of the residuals once every candidate at once has taken what it can is far nearer to the
//! noise than what the base leaves.

use flight::batch;
use identify::fit::FitError;
use identify::levenberg::Point;
use identify::noise::{Moments, Noise};
use identify::normal::eliminate;
use identify::outlier;
use identify::predict::{Residual, Residuals};
use nalgebra::{DMatrix, DVector};

use crate::bench::Bench;

/// Directions that carry less than this of a column's information are not followed.
const RIDGE: f64 = 1e-6;

impl Bench {
    /// Estimates the noise from what all candidates together leave, and marks outliers by it. `noise` is a first guess of it.
    ///
    /// # Errors
    /// Where a flight is impossible.
    pub fn leftover(&mut self, point: &Point, noise: &Noise) -> Result<Noise, FitError> {
        let blocks = self.look_further(point, noise)?;
        let system = eliminate(&blocks, 1e-12)
            .map_err(|flight| self.impossible(flight.0, flight.to_string()))?;
        let mut matrix = system.reduced.clone();
        for i in 0..matrix.nrows() {
            matrix[(i, i)] += RIDGE * system.reduced[(i, i)].abs() + f64::MIN_POSITIVE;
        }
        let shared = crate::scores::inverse(&matrix).map_or_else(
            || DVector::zeros(matrix.nrows()),
            |inverse| -(inverse * &system.gradient),
        );
        let own = system.own_steps(&shared);
        let left = batch::each_on(self.threads, self.tracks.len(), |flight| {
            self.left_by(flight, point, &shared, &own[flight])
                .map_err(|reason| self.impossible(flight, reason))
        });
        let left: Vec<Residuals> = left.into_iter().collect::<Result<_, FitError>>()?;
        let unknowns = shared.len() + own.iter().map(DVector::len).sum::<usize>();
        Ok(self.noise_of(&left, unknowns, noise.interval))
    }

    /// What a step of all unknowns leaves of a flight's residuals, to the first order.
    fn left_by(
        &self,
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
        self.each_residual_further(track, unknowns, take)?;
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

/// The correlation matrix of an information matrix.
pub fn alike(information: &DMatrix<f64>) -> DMatrix<f64> {
    let root = information.diagonal().map(|value| value.max(0.0).sqrt());
    DMatrix::from_fn(information.nrows(), information.ncols(), |i, j| {
        let product = root[i] * root[j];
        if product > 0.0 {
            (information[(i, j)] / product).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    })
}
