//! Noise of measured coordinates, estimated without a model of the motion as the part of the data that no smooth path
//! can follow.
//!
//! The position of the body's origin is compared with the least-squares cubic through its neighbours in time. For a
//! rigid body, the origin is computed from the pose in each sample, so that spin has no effect; for a point mass, it is
//! the mean over its markers. The median over many samples is robust to outliers.
//!
//! Sources of bias: the cubic partly follows noise that is correlated between samples, so that an AR(1) noise of
//! coefficient 0.6 is underestimated by a factor of about 0.6, and one of coefficient 0.9 by 0.3. Errors of the marker
//! positions on a spinning body count as noise, as no smooth path follows them. A path that is far from a cubic over
//! nine samples raises the estimate.

use nalgebra::{Matrix4, Vector3, Vector4};

use crate::observations::Observations;
use crate::problem::FitProblem;
use dataset::pose::{Pose, point_position};
use dataset::statistics::{median_of, median_vector, robust_sigma};

/// Number of neighbours on each side of a sample to which a cubic in time is fitted; the noise floor is estimated from
/// the deviation of the sample from this cubic.
const SIDE: usize = 4;

/// Maximum time span of a window, relative to the span of a window without missing samples. Windows with a longer span
/// are skipped.
const MAX_GAP_RATIO: f64 = 1.5;

/// Maximum number of samples of one flight that are compared with a cubic through their neighbours; longer flights are
/// subsampled.
const MAX_SAMPLES: usize = 60;

/// Minimum number of samples that are compared with the cubic through their neighbours, for an estimate of the noise
/// floor.
const MIN_SAMPLES: usize = 8;

/// Ratio of the variance of a sample's marker positions about the fitted rigid body to the median of these variances,
/// above which the sample is skipped because it contains an outlier.
const MAX_VARIANCE_RATIO: f64 = 25.0;

/// Measured position of the body's origin in one sample.
struct TrackPoint {
    time: f64,
    position: Vector3<f64>,
    /// Number of measured markers from which the position was computed.
    markers: f64,
}

/// Standard deviation of the noise of one marker coordinate along each axis, m, estimated without a model from the
/// scatter of one flight's samples about smooth curves; `None` if the flight has too few samples. `poses` are those of
/// [`Observations::poses`].
pub fn noise_floor(
    problem: &FitProblem,
    observations: &Observations,
    poses: &[Option<Pose>],
) -> Option<[f64; 3]> {
    let track = track(problem, observations, poses);
    let interval = observations.interval()?;
    let windows = track.len().checked_sub(2 * SIDE)?;
    let stride = windows.div_ceil(MAX_SAMPLES).max(1);
    let mut line = Interpolation::default();
    let mut sizes: [Vec<f64>; 3] = Default::default();
    for window in track.windows(2 * SIDE + 1).step_by(stride) {
        let span = window[2 * SIDE].time - window[0].time;
        if span > MAX_GAP_RATIO * interval * (2 * SIDE) as f64 {
            continue;
        }
        let Some(residual) = line.residual(window) else {
            continue;
        };
        for (sizes, residual) in sizes.iter_mut().zip(residual.iter()) {
            sizes.push(residual.abs());
        }
    }
    (sizes[0].len() >= MIN_SAMPLES).then(|| sizes.map(|mut sizes| robust_sigma(&mut sizes)))
}

/// Median over flights of their noise floors (standard deviations of the noise, estimated without a model), along each
/// axis, m; `None` if `flights` is empty.
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
    let limit = MAX_VARIANCE_RATIO * usual.unwrap_or(0.0);
    let samples = observations.times.iter().enumerate();
    samples
        .filter_map(|(sample, &time)| match problem.has_attitude {
            true => {
                let pose = poses.get(sample)?.as_ref()?;
                if pose.variance() > limit {
                    return None;
                }
                Some(TrackPoint {
                    time,
                    position: pose.position,
                    markers: pose.markers as f64,
                })
            }
            false => {
                let points = observations.points(sample);
                Some(TrackPoint {
                    time,
                    position: point_position(&problem.markers, points)?,
                    markers: points.iter().flatten().count() as f64,
                })
            }
        })
        .collect()
}

/// Cubic in time, fitted by least squares to the neighbours of a sample. It is stored as the weights whose weighted sum
/// of the neighbours' positions is the value of the cubic at the time of the sample.
#[derive(Default)]
struct Interpolation {
    offsets: [f64; 2 * SIDE],
    weights: [f64; 2 * SIDE],
}

/// Relative difference up to which times are considered equal, so that the weights of an [`Interpolation`] are reused
/// for evenly spaced samples.
const SAME_TIME: f64 = 1e-6;

impl Interpolation {
    /// Difference between the middle position of `window` and the cubic in time through the other positions, m, scaled
    /// so that its standard deviation is that of one marker coordinate. `None` if the times do not determine the cubic.
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
