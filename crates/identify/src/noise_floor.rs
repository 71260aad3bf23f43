//! Noise of measured coordinates without a model: the position of the body's origin is compared with the cubic through
//! its neighbours in time. The origin of a rigid body is computed from poses, so that spin has no effect; that of a
//! point mass is the mean over its markers.
//!
//! The cubic partly follows correlated noise: AR(1) noise of coefficient 0.6 is underestimated by a factor of about
//! 0.6, of 0.9 by 0.3. Errors of marker positions on a spinning body count as noise, and a path far from a cubic over
//! nine samples raises the estimate.

use nalgebra::{Matrix4, Vector3, Vector4};

use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::levels::{MAX_GAP, NEIGHBOURS as SIDE, OUTLIER_VARIANCE};
use dataset::pose::Pose;
use dataset::seen_path;
use dataset::statistics::{median_of, median_vector, robust_sigma};

/// Maximum and minimum number of samples of one flight that are compared; longer flights are subsampled.
const COMPARED: (usize, usize) = (60, 8);

/// Measured position of the body's origin in one sample.
struct TrackPoint {
    time: f64,
    position: Vector3<f64>,
    /// Number of measured markers from which the position was computed.
    markers: f64,
}

/// Standard deviation of the noise of a coordinate along each axis, m; `None` for too few samples. `poses` are those of
/// [`Observations::poses`].
pub fn noise_floor(
    problem: &FitProblem,
    observations: &Observations,
    poses: &[Option<Pose>],
) -> Option<[f64; 3]> {
    let track = track(problem, observations, poses);
    let interval = observations.interval()?;
    let windows = track.len().checked_sub(2 * SIDE)?;
    let stride = windows.div_ceil(COMPARED.0).max(1);
    let mut line = Interpolation::default();
    let mut sizes: [Vec<f64>; 3] = Default::default();
    for window in track.windows(2 * SIDE + 1).step_by(stride) {
        let span = window[2 * SIDE].time - window[0].time;
        if span > MAX_GAP * interval * (2 * SIDE) as f64 {
            continue;
        }
        let Some(residual) = line.residual(window) else {
            continue;
        };
        for (sizes, residual) in sizes.iter_mut().zip(residual.iter()) {
            sizes.push(residual.abs());
        }
    }
    (sizes[0].len() >= COMPARED.1).then(|| sizes.map(|mut sizes| robust_sigma(&mut sizes)))
}

pub fn median_noise_floor(flights: &[[f64; 3]]) -> Option<[f64; 3]> {
    let sigmas: Vec<Vector3<f64>> = flights.iter().map(|sigma| (*sigma).into()).collect();
    median_vector(&sigmas).map(Into::into)
}

fn track(
    problem: &FitProblem,
    observations: &Observations,
    poses: &[Option<Pose>],
) -> Vec<TrackPoint> {
    // A sample whose marker distances differ much from the rigid body contains an outlier.
    let usual = median_of(poses.iter().flatten().map(Pose::variance));
    let limit = OUTLIER_VARIANCE * usual.unwrap_or(0.0);
    let points = |sample: usize| observations.points(sample);
    let seen = seen_path(&problem.points, &observations.times, points, |k| {
        *poses.get(k)?
    });
    let rigid = seen.filter(|own| own.variance() <= limit);
    let each = rigid.map(|own| TrackPoint {
        time: own.time,
        position: own.position,
        markers: match own.pose {
            Some(pose) => pose.markers as f64,
            None => points(own.sample).iter().flatten().count() as f64,
        },
    });
    each.collect()
}

/// Weights of the neighbours' positions whose sum is the cubic in time at the sample.
#[derive(Default)]
struct Interpolation {
    offsets: [f64; 2 * SIDE],
    weights: [f64; 2 * SIDE],
}

/// Relative difference of equal times, for which weights are reused.
const SAME_TIME: f64 = 1e-6;

impl Interpolation {
    /// Middle position less the cubic through the others, m, scaled to the noise of one marker coordinate.
    fn residual(&mut self, window: &[TrackPoint]) -> Option<Vector3<f64>> {
        let middle = &window[SIDE];
        let neighbours = || window[..SIDE].iter().chain(&window[SIDE + 1..]);
        let offsets = neighbours().map(|point| point.time - middle.time);
        self.prepare(offsets)?;
        let mut residual = middle.position;
        let mut variance = 1.0 / middle.markers;
        for (weight, point) in self.weights.iter().zip(neighbours()) {
            residual -= *weight * point.position;
            variance += weight * weight / point.markers;
        }
        Some(residual / variance.sqrt())
    }

    fn prepare(&mut self, offsets: impl Iterator<Item = f64> + Clone) -> Option<()> {
        let near = |(now, before): (f64, &f64)| (now - before).abs() <= SAME_TIME * before.abs();
        if offsets.clone().zip(&self.offsets).all(near) {
            return Some(());
        }
        for (to, offset) in self.offsets.iter_mut().zip(offsets) {
            *to = offset;
        }
        let scale = self.offsets.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        let row = |offset: f64| {
            let t = offset / scale;
            Vector4::new(1.0, t, t * t, t * t * t)
        };
        let mut normal = Matrix4::zeros();
        for &offset in &self.offsets {
            normal += row(offset) * row(offset).transpose();
        }
        let coefficients = normal.cholesky()?.solve(&Vector4::x());
        for (weight, &offset) in self.weights.iter_mut().zip(&self.offsets) {
            *weight = row(offset).dot(&coefficients);
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::FitOptions;
    use dataset::synthesize::{Corruption, Plan, flights};
    use flight::release::{Vocabulary, built_in, read};

    fn floor(name: &str, noise: Corruption) -> [f64; 3] {
        let text = built_in(name).unwrap();
        let mut model = None;
        let release = read(name, text, |named| {
            let loaded = model_spec::load::load(named, &[])?;
            let vocabulary = Vocabulary::of(&loaded);
            model = Some(loaded);
            Ok(vocabulary)
        });
        let model = model.unwrap();
        let plan = Plan {
            noise,
            ..Plan::default()
        };
        let dataset = flights(&model, &[release.unwrap()], &plan).unwrap().dataset;
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let each = dataset.flights.iter().map(|flight| {
            let observations = Observations::new(&problem, flight).unwrap();
            noise_floor(&problem, &observations, &observations.poses(&problem)).unwrap()
        });
        median_noise_floor(&each.collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn the_noise_of_a_spinning_body_and_of_a_point_mass_is_found() {
        for name in ["backhand", "serve"] {
            for outliers in [0.0, 0.02] {
                let noise = Corruption {
                    sigma: 0.002,
                    outliers,
                    dropouts: 0.1,
                    ..Corruption::default()
                };
                let sigma = floor(name, noise);
                assert!(
                    sigma.iter().all(|sigma| (0.0014..0.0028).contains(sigma)),
                    "{name}: {sigma:?}"
                );
            }
        }
    }

    #[test]
    fn correlated_noise_is_underestimated_as_documented() {
        let noise = Corruption {
            sigma: 0.002,
            ar1: 0.6,
            ..Corruption::default()
        };
        let sigma = floor("backhand", noise);
        assert!(
            sigma.iter().all(|sigma| (0.0008..0.0019).contains(sigma)),
            "{sigma:?}"
        );
    }
}
