//! Detects the first contact of a body as a change of its smooth motion: smooth motion through the points around an
//! interval is compared with motion whose velocity and acceleration jump in it. Aerodynamic loads, however large,
//! change the velocity on both sides; a contact does not.

use std::ops::Range;

use nalgebra::Vector3;

use super::smooth_motion::{Changed, Smooth};
use super::{Contact, PathPoint};
use crate::seen_path::path_noise;
use crate::statistics::median_of;

/// Maximum numbers of points before and after an interval: over more, lift varies too much, and another contact may
/// follow.
const SIDES: (usize, usize) = (20, 8);
/// Minimum numbers of points before and after an interval, for four coefficients before it and two more after it.
const MIN_SIDES: (usize, usize) = (8, 3);
/// Maximum number of outliers around an interval, as more may be the points after a contact, and decrease of the sum of
/// squares, in noise variances, above which a point is one; noise exceeds it with 10⁻⁸.
const OUTLIERS: (usize, f64) = (2, 40.0);

/// Minimum gain of a contact, in units of the usual gain, and least usual gain. The former is exceeded in 2 of 2,500
/// simulated flights that touch nothing, with outliers, gaps and correlated noise; white noise alone gives a gain of 6,
/// the number of coefficients of the two jumps, and correlated noise more.
const GAIN: (f64, f64) = (7.0, 10.0);

/// Minimum number of earlier intervals whose median gain is the usual one; else it is the lower quartile of the flight.
const EARLIER: usize = 8;
/// Minimum upward velocity jump, m/s; lift that changes at the start of a fast throw feigns 0.2 to 0.4 m/s.
const MIN_JUMP: f64 = 0.5;
/// Minimum upward part of a velocity jump at the ground: limited friction limits the horizontal part.
pub const MIN_UPWARD_PART: f64 = 0.3;
/// Numbers of points before and after the interval of a contact among which it is dated.
const DATED: (usize, usize) = (4, SIDES.1);
/// Least noise of a coordinate that is assumed, m.
const MIN_NOISE: f64 = 1e-9;

/// Comparison of smooth motion with motion that changes in the interval before one point.
#[derive(Clone, Copy, Debug)]
struct Change {
    index: usize,
    interval: f64,
    /// Decrease of the sum of squared residuals if the motion changes, m².
    squares: f64,
    /// Residual variance if the motion changes, m².
    variance: f64,
    velocity: Vector3<f64>,
    jump: Vector3<f64>,
}

impl Change {
    /// Decrease of the sum of squares in units of the variance `noise`, m², or of the residual variance if that is
    /// greater.
    fn gain(&self, noise: f64) -> f64 {
        self.squares / noise.max(self.variance)
    }

    /// Whether the jump is one at the ground: upward, of a body that descends, and not of its position, as where frames
    /// are missing.
    fn is_impact(&self) -> bool {
        let least = MIN_JUMP.max(MIN_UPWARD_PART * self.jump.norm());
        let moved = self.velocity.norm() * self.interval;
        self.velocity.z < 0.0 && self.jump.z > least && self.variance < moved * moved
    }
}

/// Finds the first contact on a measured path; `None` if there is none, a hand catches the body, or the path is too
/// short.
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
        change.is_impact() && **gain > GAIN.0 * usual.max(GAIN.1)
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
        let changed = Changed::through(&kept, self.noise, about)?;
        Some(Change {
            index,
            interval: self.points[index].time - self.points[index - 1].time,
            squares: smooth.squares - changed.squares,
            variance: changed.squares / changed.freedom,
            velocity: changed.velocity(),
            jump: changed.jump(),
        })
    }

    /// Points of a range without outliers, and smooth motion through them. Smooth motion fits far better without an
    /// outlier; a contact affects all later points.
    fn inliers(&self, range: Range<usize>) -> Option<(Vec<&PathPoint>, Smooth)> {
        let mut kept: Vec<&PathPoint> = self.points[range].iter().collect();
        let about = kept.last()?.time;
        let mut fitted = Smooth::through(&kept, self.noise, about)?;
        for _ in 0..OUTLIERS.0 {
            let removals = fitted.removals(&kept).enumerate();
            let (worst, removal) = removals.max_by(|a, b| a.1.total_cmp(&b.1))?;
            if removal <= OUTLIERS.1 * self.noise.powi(2) {
                break;
            }
            kept.remove(worst);
            fitted = Smooth::through(&kept, self.noise, about)?;
        }
        Some((kept, fitted))
    }

    /// First sample after the change in the interval before point `index`: motion that changes just before it fits
    /// best.
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
            Some((Changed::through(&kept, self.noise, about)?.squares, sample))
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

// Detects whether a body is stopped, as by a hand; the ground leaves a flying body most of its speed.

/// Number of points within which a hand stops a body, as a disc that slides takes longer, and maximum ratio of its final
/// speed to that before, which allows for noise and an early end.
const STOPPED: (usize, f64) = (24, 0.2);

/// Number of last points from which the final speed is computed.
const LAST: usize = 3;
/// Whether a body with the velocity `velocity`, m/s, before point `index` comes to rest soon, as in a hand.
pub fn is_stopped(points: &[PathPoint], index: usize, velocity: &Vector3<f64>) -> bool {
    let end = index.saturating_add(STOPPED.0).min(points.len());
    let soon = points.get(index..end).unwrap_or_default();
    let Some([first, .., last]) = soon.last_chunk::<LAST>() else {
        return false;
    };
    let moved = (last.position - first.position).norm();
    moved < STOPPED.1 * velocity.norm() * (last.time - first.time)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::tests::jitter;

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
    fn a_bounce_while_the_body_is_not_seen_is_dated_within_the_gap() {
        for seed in 0..10 {
            let mut path = path(6.0, (0.0, 1.0), Some((44, 0.5)), seed);
            path.retain(|point| !(40..45).contains(&point.sample));
            let found = first_change(&path).expect("a bounce").sample;
            assert!(found.abs_diff(44) <= 1, "{found}");
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

    /// Interval between samples, s.
    const INTERVAL: f64 = 1.0 / 120.0;

    /// Simulated points of a body that flies at 9 m/s and, from point 40 on, loses the fraction `lost` of its speed
    /// over `braked` sampling intervals.
    fn points(count: usize, braked: usize, lost: f64) -> Vec<PathPoint> {
        let mut position = Vector3::new(0.0, 0.0, 1.0);
        let each = (0..count).map(|sample| {
            let part = (sample.saturating_sub(40) as f64 / braked as f64).min(1.0);
            position += VELOCITY * (1.0 - lost * part) * INTERVAL;
            PathPoint {
                sample,
                time: sample as f64 * INTERVAL,
                position,
                attitude: None,
            }
        });
        each.collect()
    }

    const VELOCITY: Vector3<f64> = Vector3::new(8.0, 0.0, -4.0);

    #[test]
    fn a_body_that_is_caught_is_stopped() {
        for braked in [1, 8, 15] {
            assert!(is_stopped(&points(80, braked, 1.0), 38, &VELOCITY));
        }
        assert!(is_stopped(&points(50, 9, 1.0), 38, &VELOCITY), "to its end");
    }

    #[test]
    fn a_body_that_slides_on_is_not_stopped() {
        for lost in [0.0, 0.3, 0.6] {
            assert!(!is_stopped(&points(80, 2, lost), 38, &VELOCITY));
        }
    }

    #[test]
    fn too_few_points_show_no_rest() {
        let points = points(40, 1, 0.0);
        for index in [38, 39, 40, 100] {
            assert!(!is_stopped(&points, index, &VELOCITY));
        }
    }
}
