//! Local quadratic fits of a track: residual, velocity and acceleration at each sample.

use std::ops::Range;

use nalgebra::{SMatrix, SVector, Vector3};

use super::track::Track;
use super::{FINEST, GRAVITY};
use crate::statistics::median_vector;

/// Half of the time span of the samples to which a quadratic in time is fitted around one sample, s.
const HALF: f64 = 0.042;
/// Minimum number of samples on each side of the central sample of a local fit of a quadratic in time.
const MIN_HALF: usize = 4;
/// Speed below which a body that is not in free fall counts as carried or at rest, m/s.
pub(super) const SLOW: f64 = 1.0;
/// Constants a and b of the maximum aerodynamic acceleration a + b V² of a body in free flight at the speed V: a in
/// m/s², b in 1/m. For comparison, a shuttlecock, with a terminal speed of 6.8 m/s, has b = 0.21 1/m.
const AERODYNAMIC: (f64, f64) = (3.0, 0.3);
/// Maximum aerodynamic acceleration along the velocity, m/s²: wind may accelerate a body forwards, but slightly.
const PUSH: f64 = 2.5;
/// Maximum ratio of a local fit's residuals to the deviation of a measured position for the motion to be smooth.
const SMOOTH: f64 = 2.5;
/// Prior standard deviation of each coordinate of [`Window::offset`], m.
const OFFSET: f64 = 0.1;
/// Standard deviation of a measured position, m, assumed for the weight of that prior.
const TYPICAL: f64 = 1e-3;

/// Quadratic in time fitted to the motion of a body in the samples around one sample.
#[derive(Clone, Debug)]
pub(super) struct Window {
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    /// Position of the body point that moves smoothly (in free flight the centre of mass) relative to the centroid of
    /// the tracked points of the body, in the body-fixed axes of these points, m.
    offset: Vector3<f64>,
    /// Standard deviation of the residuals of the quadratic fit, per coordinate, m.
    residual: f64,
    /// Standard error of the fitted acceleration per unit standard deviation of a measured position, 1/s².
    spread: f64,
}

impl Window {
    /// Whether the motion around the central sample is free flight; `noise` is the deviation of a position, m.
    pub fn is_free(&self, noise: f64) -> bool {
        let air = self.acceleration + Vector3::z() * GRAVITY;
        let slack = 3.0 * noise * self.spread;
        let is_moving = self.velocity.norm() > SLOW || air.norm() < 0.5 * GRAVITY;
        self.residual <= SMOOTH * noise && is_moving && allowed(self.velocity, air, slack)
    }
}

/// Whether aerodynamic forces and wind can cause the acceleration `air` (without gravity, m/s²) of a body in free
/// flight at a velocity (m/s); `slack` is the uncertainty of the acceleration, m/s².
pub(super) fn allowed(velocity: Vector3<f64>, air: Vector3<f64>, slack: f64) -> bool {
    let speed = velocity.norm();
    let push = air.dot(&velocity) / speed.max(1e-9);
    air.norm() <= AERODYNAMIC.0 + AERODYNAMIC.1 * speed * speed + slack
        && (push <= PUSH + slack || speed <= SLOW)
}

/// Number of samples on each side of the central sample to which a local quadratic in time is fitted.
pub(super) fn half(track: &Track) -> usize {
    ((HALF / track.step).round() as usize).max(MIN_HALF)
}

/// Fit of a quadratic in time around each sample of the track.
pub(super) fn windows(track: &Track) -> Vec<Option<Window>> {
    let half = half(track);
    (0..track.times.len())
        .map(|i| window(track, i, half))
        .collect()
}

fn window(track: &Track, i: usize, half: usize) -> Option<Window> {
    flight::cancellation::stop_if_cancelled();
    let range = i.checked_sub(half)?..i + half + 1;
    if range.end > track.times.len() {
        return None;
    }
    let t0 = track.times[i];
    let span = track.times[range.end - 1] - track.times[range.start];
    // A gap widens the window; its samples are then too far apart for a quadratic.
    if span > 3.0 * (2 * half) as f64 * track.step {
        return None;
    }
    let scale = 0.5 * span;
    let mut normal = SMatrix::<f64, 12, 12>::zeros();
    let mut right = SVector::<f64, 12>::zeros();
    let mut squares = 0.0;
    for k in range.clone() {
        let s = (track.times[k] - t0) / scale;
        let powers = [1.0, s, s * s];
        for axis in 0..3 {
            let mut row = SVector::<f64, 12>::zeros();
            for (power, value) in powers.iter().enumerate() {
                row[3 * power + axis] = *value;
            }
            for column in 0..3 {
                row[9 + column] = -track.rotation(k)[(axis, column)];
            }
            let value = track.centres[k][axis] - track.centres[i][axis];
            normal += row * row.transpose();
            right += row * value;
            squares += value * value;
        }
    }
    let prior = (TYPICAL / OFFSET).powi(2);
    for k in 9..12 {
        normal[(k, k)] += prior;
    }
    let factor = normal.cholesky()?;
    let solution = factor.solve(&right);
    let inverse = factor.inverse();
    let misfit = (squares - solution.dot(&right)).max(0.0);
    let vector = |first: usize| Vector3::from(solution.fixed_rows::<3>(first));
    Some(Window {
        velocity: vector(3) / scale,
        acceleration: vector(6) / (0.5 * scale * scale),
        offset: vector(9),
        residual: (misfit / (3 * range.len() - 9) as f64).sqrt(),
        spread: inverse[(6, 6)].max(0.0).sqrt() / (0.5 * scale * scale),
    })
}

/// Standard deviation of a position, m: lower tercile of the local fits' residuals, least in flight or at rest.
pub(super) fn noise(windows: &[Option<Window>]) -> f64 {
    let mut residuals: Vec<f64> = windows.iter().flatten().map(|w| w.residual).collect();
    residuals.sort_by(f64::total_cmp);
    let quiet = residuals.get(residuals.len() / 3).copied().unwrap_or(0.0);
    quiet.max(FINEST)
}

/// Median of [`Window::offset`] over the local quadratic fits around the samples in `run`.
pub(super) fn offset(windows: &[Option<Window>], run: &Range<usize>) -> Vector3<f64> {
    let offsets = windows[run.clone()]
        .iter()
        .flatten()
        .map(|window| window.offset);
    median_vector(&offsets.collect::<Vec<_>>()).unwrap_or_default()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::takes::{Body, Format, LengthUnit, Pose, Take};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha12Rng;
    use rand_distr::StandardNormal;

    /// Track of a falling body that turns about the vertical at `rate`, rad/s; the positions have the deviation that
    /// `noise` gives for each sample.
    pub fn track(rate: f64, noise: impl Fn(usize) -> f64) -> Track {
        let mut random = ChaCha12Rng::seed_from_u64(7);
        let times: Vec<f64> = (0..2000).map(|k| f64::from(k) / 200.0).collect();
        let poses = times.iter().enumerate().map(|(k, t)| {
            let centre = [5.0 * t, 0.0, -0.5 * GRAVITY * t * t];
            let position =
                centre.map(|own| own + noise(k) * random.sample::<f64, _>(StandardNormal));
            let (sin, cos) = (0.5 * rate * t).sin_cos();
            let quaternion = [cos, 0.0, 0.0, sin];
            Some(Pose {
                position,
                quaternion,
            })
        });
        let body = Body {
            label: "body".to_owned(),
            poses: poses.collect(),
        };
        let take = Take {
            format: Format::Vicon,
            times,
            points: Vec::new(),
            bodies: vec![body],
            length: LengthUnit::Metre,
            up: None,
            left_handed: None,
            notes: Vec::new(),
        };
        Track::new(&take, &[], &mut Vec::new()).expect("seen")
    }

    #[test]
    fn the_spread_is_the_standard_error_of_the_acceleration() {
        let noise = 1e-3;
        let windows = windows(&track(0.0, |_| noise));
        let windows: Vec<&Window> = windows.iter().flatten().collect();
        let squares = windows
            .iter()
            .map(|own| (own.acceleration.z + GRAVITY).powi(2));
        let found = (squares.sum::<f64>() / windows.len() as f64).sqrt();
        let expected = noise * windows[0].spread;
        assert!((found / expected - 1.0).abs() < 0.1, "{found} {expected}");
    }

    #[test]
    fn the_point_that_moves_smoothly_is_on_a_body_that_hardly_turns() {
        for window in windows(&track(4.0, |_| 1e-3)).iter().flatten() {
            assert!(window.offset.norm() < OFFSET, "{}", window.offset);
        }
    }

    #[test]
    fn a_body_at_rest_is_not_in_flight_however_uncertain_its_acceleration() {
        let rests = Window {
            velocity: Vector3::zeros(),
            acceleration: Vector3::zeros(),
            offset: Vector3::zeros(),
            residual: 0.0,
            spread: 1e4,
        };
        assert!(!rests.is_free(0.01));
        let falls = Window {
            acceleration: -Vector3::z() * GRAVITY,
            ..rests
        };
        assert!(falls.is_free(0.01));
    }
}
