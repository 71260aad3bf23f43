//! Detects the first contact of a body as a change of its smooth motion.
//!
//! A contact with the ground changes the velocity within one sampling interval. At each interval, smooth motion through
//! the points around it is compared with motion whose velocity and acceleration jump there. Aerodynamic loads, however
//! large, also change the velocity on both sides; a contact does not.

use std::ops::Range;

use nalgebra::Vector3;

use super::halt::is_stopped;
use super::smooth_motion::{Fitted, fit};
use super::{Contact, PathPoint};
use crate::path_noise::path_noise;
use dataset::statistics::median_of;

/// Maximum numbers of points before and after an interval between two successive points to which motion is fitted. Over
/// more points, lift varies more than the polynomial; later points may follow another contact.
const SIDES: (usize, usize) = (20, 8);
/// Minimum numbers of points before and after an interval that is tested for a contact: enough for four coefficients
/// before it and for two more after it.
const MIN_SIDES: (usize, usize) = (8, 3);
/// Maximum number of points around a tested interval that are left out as outliers. If more were, a contact near the end
/// of the points could be taken for outliers.
const MAX_OUTLIERS: usize = 2;
/// Decrease of the sum of squared residuals, in units of the noise variance, above which a point is an outlier: χ² of
/// three coordinates exceeds it with probability 10⁻⁸.
const OUTLIER: f64 = 40.0;
/// Level of the test: minimum gain of a contact, in units of the usual gain of intervals without a contact. It is
/// exceeded in 2 of 2,500 simulated flights of discs and balls that touch nothing, with outliers, gaps and correlated
/// noise.
const LEVEL: f64 = 7.0;
/// Minimum usual gain: white noise alone gives 6, the number of coefficients of the two jumps, and correlated noise more.
const MIN_USUAL: f64 = 10.0;
/// Minimum number of earlier intervals for the usual gain to be the median of their gains. With fewer, it is the lower
/// quartile over the whole flight.
const EARLIER: usize = 8;
/// Minimum upward velocity jump of a contact, m/s. At the start of a fast throw, lift that changes within a few samples
/// feigns jumps of 0.2 to 0.4 m/s.
const MIN_JUMP: f64 = 0.5;
/// Minimum ratio of the upward component of a velocity jump at the ground to its magnitude; limited friction limits the
/// horizontal component.
pub(crate) const MIN_UPWARD_PART: f64 = 0.3;
/// Numbers of points before and after the interval in which a contact was found, among which the contact is dated. The
/// test of an interval sees `SIDES.1` points after it.
const DATED: (usize, usize) = (4, SIDES.1);
/// Least noise of a coordinate that is assumed, m.
const MIN_NOISE: f64 = 1e-9;

/// Comparison of smooth motion with motion that changes in the interval before one point.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// Index of the point.
    index: usize,
    /// Duration of the interval, s.
    interval: f64,
    /// Decrease of the sum of squared residuals if the motion changes, m².
    squares: f64,
    /// Residual variance if the motion changes, m².
    variance: f64,
    /// Velocity before the change, m/s.
    velocity: Vector3<f64>,
    /// Jump of the velocity, m/s.
    jump: Vector3<f64>,
}

impl Change {
    /// Decrease of the sum of squared residuals in units of the variance `noise`, m², or of the residual variance if
    /// that is greater, as among outliers.
    fn gain(&self, noise: f64) -> f64 {
        self.squares / noise.max(self.variance)
    }

    /// Whether the jump is one at the ground: upward, of a body that descends, and not of its position, as where frames
    /// are missing. The residuals are then smaller than the distance that the body moves during the interval.
    fn is_impact(&self) -> bool {
        let least = MIN_JUMP.max(MIN_UPWARD_PART * self.jump.norm());
        let moved = self.velocity.norm() * self.interval;
        self.velocity.z < 0.0 && self.jump.z > least && self.variance < moved * moved
    }
}

/// Finds the first contact on a measured path; `None` if there is none, if a hand catches the body, or if the path is
/// too short.
pub fn first_change(path: &[PathPoint]) -> Option<Contact> {
    let has_attitude = path.iter().any(|point| point.attitude.is_some());
    let of_path = |point: &&PathPoint| point.attitude.is_some() == has_attitude;
    let points: Vec<PathPoint> = path.iter().filter(of_path).copied().collect();
    let noise = path_noise(points.iter().map(|point| (point.time, point.position)));
    let mut path = Path {
        points,
        noise: noise.max(MIN_NOISE),
    };
    // Noise from differences of samples does not include correlated noise.
    let variance = quartile(path.changes().map(|change| change.variance));
    path.noise = variance.sqrt().max(MIN_NOISE);
    let changes: Vec<Change> = path.changes().collect();
    let gains = changes.iter().map(|change| change.gain(variance));
    let gains: Vec<f64> = gains.collect();
    let whole = quartile(gains.iter().copied());
    let (found, _) = changes.iter().zip(&gains).find(|(change, gain)| {
        let earlier = changes.partition_point(|other| other.index + SIDES.1 <= change.index);
        let usual = match earlier < EARLIER {
            true => whole,
            false => median_of(gains[..earlier].iter().copied()).unwrap_or(whole),
        };
        change.is_impact() && **gain > LEVEL * usual.max(MIN_USUAL)
    })?;
    if is_stopped(&path.points, found.index, &found.velocity) {
        return None;
    }
    let jump = found.jump;
    Some(Contact {
        sample: path.date(found.index)?,
        why: format!(
            "the velocity jumps by ({:.1}, {:.1}, {:.1}) m/s",
            jump.x, jump.y, jump.z
        ),
    })
}

/// A measured path with its noise.
struct Path {
    points: Vec<PathPoint>,
    /// Standard deviation of the noise of a coordinate, m.
    noise: f64,
}

impl Path {
    /// Tests every interval that has enough points around it.
    fn changes(&self) -> impl Iterator<Item = Change> {
        let indices = MIN_SIDES.0..(self.points.len() + 1).saturating_sub(MIN_SIDES.1);
        indices.filter_map(|index| self.change(index))
    }

    /// Tests the interval before point `index`; `None` if too few points are near.
    fn change(&self, index: usize) -> Option<Change> {
        let about = 0.5 * (self.points[index - 1].time + self.points[index].time);
        let to = (index + SIDES.1).min(self.points.len());
        let (kept, smooth) = self.inliers(index.saturating_sub(SIDES.0)..to)?;
        let before = kept.partition_point(|point| point.time < about);
        if before < MIN_SIDES.0 || kept.len() - before < MIN_SIDES.1 {
            return None;
        }
        let changed = fit(&kept, self.noise, about, true)?;
        Some(Change {
            index,
            interval: self.points[index].time - self.points[index - 1].time,
            squares: smooth.squares - changed.squares,
            variance: changed.squares / changed.freedom,
            velocity: changed.velocity(),
            jump: changed.jump(),
        })
    }

    /// Points of a range without at most `MAX_OUTLIERS` outliers, and smooth motion through them. An outlier is a point
    /// without which smooth motion fits the others far better; a contact affects all later points.
    fn inliers(&self, range: Range<usize>) -> Option<(Vec<&PathPoint>, Fitted)> {
        let mut kept: Vec<&PathPoint> = self.points[range].iter().collect();
        let about = kept.last()?.time;
        let mut fitted = fit(&kept, self.noise, about, false)?;
        for _ in 0..MAX_OUTLIERS {
            let removals = kept.iter().map(|point| fitted.removal(point)).enumerate();
            let (worst, removal) = removals.max_by(|a, b| a.1.total_cmp(&b.1))?;
            if removal <= OUTLIER * self.noise.powi(2) {
                break;
            }
            kept.remove(worst);
            fitted = fit(&kept, self.noise, about, false)?;
        }
        Some((kept, fitted))
    }

    /// First sample after the change that was found in the interval before point `index`: motion that changes just
    /// before it fits the points around best.
    fn date(&self, index: usize) -> Option<usize> {
        let from = index.saturating_sub(DATED.0).max(1);
        let to = (index + DATED.1).min(self.points.len() - 1);
        let range = from.saturating_sub(SIDES.0)..(to + MIN_SIDES.1 - 1).min(self.points.len());
        let (kept, _) = self.inliers(range)?;
        let each = self.points[from - 1..=to].windows(2).flat_map(|pair| {
            let (last, next) = (&pair[0], &pair[1]);
            // The samples between two points have no pose.
            (last.sample + 1..=next.sample).map(|sample| {
                let part = (sample - last.sample) as f64 - 0.5;
                let part = part / (next.sample - last.sample) as f64;
                (sample, last.time + part * (next.time - last.time))
            })
        });
        let squares = each.filter_map(|(sample, about)| {
            Some((fit(&kept, self.noise, about, true)?.squares, sample))
        });
        let best = squares.min_by(|a, b| a.0.total_cmp(&b.0));
        best.map(|(_, sample)| sample)
    }
}

/// Lower quartile (25 % quantile) of the values; 0 if there are none.
fn quartile(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    let quarter = values.len() / 4;
    match values.is_empty() {
        true => 0.0,
        false => *values.select_nth_unstable_by(quarter, f64::total_cmp).1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ground_contact::tests::jitter;

    /// Simulated path of a body thrown at `speed`, m/s, with an upward acceleration `lift`, m/s², that decays with the
    /// time constant `fading`, s. `bounce` contains the index of the first sample after a bounce and the coefficient of
    /// restitution; `None` for no bounce. `seed` determines the pseudo-random noise.
    fn path(
        speed: f64,
        (lift, fading): (f64, f64),
        bounce: Option<(usize, f64)>,
        seed: usize,
    ) -> Vec<PathPoint> {
        let (mut position, mut velocity) =
            (Vector3::new(0.0, 0.0, 1.0), Vector3::new(speed, 0.0, -1.0));
        let (dt, fine) = (1.0 / 120.0, 50);
        (0..90)
            .map(|i| {
                let noise = [0, 1, 2].map(|axis| 0.002 * jitter(seed * 1000 + 3 * i + axis));
                let now = PathPoint {
                    sample: i,
                    time: i as f64 * dt,
                    position: position + Vector3::from(noise),
                    attitude: None,
                };
                for step in 0..fine {
                    let time = (i as f64 + f64::from(step) / f64::from(fine)) * dt;
                    velocity.z += (lift * (-time / fading).exp() - 9.81) * dt / f64::from(fine);
                    position += velocity * dt / f64::from(fine);
                    if let Some((sample, restitution)) = bounce
                        && i + 1 == sample
                        && step == fine / 2
                    {
                        velocity.z = restitution * velocity.z.abs();
                        velocity.x *= 0.8;
                    }
                }
                now
            })
            .collect()
    }

    #[test]
    fn bounces_are_found_within_two_samples() {
        for seed in 0..40 {
            let at = 20 + seed;
            let restitution = 0.2 + 0.015 * seed as f64;
            let path = path(6.0, (0.0, 1.0), Some((at, restitution)), seed);
            let found = first_change(&path).unwrap_or_else(|| panic!("bounce {seed} is missed"));
            assert!(found.sample.abs_diff(at) <= 2, "{} for {at}", found.sample);
        }
    }

    #[test]
    fn a_strong_lift_that_fades_is_no_impact() {
        for seed in 0..60 {
            let lift = 10.0 + seed as f64;
            let fading = 0.03 + 0.01 * (seed % 10) as f64;
            let path = path(25.0, (lift, fading), None, seed);
            assert_eq!(
                first_change(&path),
                None,
                "lift {lift}, fading in {fading} s"
            );
        }
    }

    #[test]
    fn a_fall_with_outliers_is_no_impact() {
        for seed in 0..200 {
            let mut path = path(6.0, (0.0, 1.0), None, seed);
            for (i, point) in path.iter_mut().enumerate() {
                if jitter(seed * 7919 + i) > 0.97 {
                    point.position.z += 0.1 * jitter(seed + 31 * i);
                    point.position.x += 0.1 * jitter(seed + 37 * i);
                }
            }
            assert_eq!(first_change(&path), None, "seed {seed}");
        }
    }

    #[test]
    fn a_bounce_in_the_last_samples_is_found() {
        let path = path(6.0, (0.0, 1.0), Some((60, 0.7)), 3);
        let found = first_change(&path[..64]).expect("a bounce");
        assert!(found.sample.abs_diff(60) <= 2);
    }
}
