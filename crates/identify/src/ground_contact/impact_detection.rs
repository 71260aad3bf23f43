//! Detects the first impact on a path that interrupts the descent.
//!
//! An impact is a velocity jump within one sampling interval between two segments of smooth motion. At each interval,
//! one parabola before it and one after it are compared with a single smooth polynomial through both segments.
//! Aerodynamic loads, however large, also change the velocity along the segments; an impact does not.

use nalgebra::{SMatrix, SVector, Vector3};

use super::PathPoint;
use crate::path_noise::path_noise;
use dataset::statistics::median_of;

/// Maximum number of points (measured positions) that are used on each side of an interval between two successive
/// points that is tested for an impact.
const SIDE: usize = 7;
/// Minimum numbers of points (measured positions) before and after an interval that is tested for an impact.
const MIN_SIDES: (usize, usize) = (6, 3);
/// Minimum number of points (measured positions) on one side of an interval tested for an impact, at which a parabola
/// is fitted to them. With fewer points after the interval, only position and velocity are fitted there, and the
/// acceleration before the interval is used.
const PARABOLA: usize = 5;
/// Number of coefficients (degree plus one) of the single polynomial that represents motion without an impact. It is
/// fitted to the points before and after the interval that is tested for an impact.
const SMOOTH: usize = 5;
/// Minimum velocity jump of an impact, m/s.
const MIN_JUMP: f64 = 0.5;
/// Minimum velocity jump of an impact, in units of its standard error.
const MIN_SIGNIFICANCE: f64 = 8.0;
/// Minimum velocity jump of an impact, in units of the median of the jumps that are fitted at other intervals of the
/// flight.
const MIN_RATIO: f64 = 3.5;
/// Minimum velocity jump of an impact, in units of the velocity change that acceleration alone causes within the tested
/// interval (the larger of the accelerations before and after the interval is used).
const MIN_IMPULSE: f64 = 3.0;
/// Minimum ratios of the upward component of the velocity jump at an impact: to the magnitude of the jump, and to the
/// descent speed before it.
const MIN_VERTICAL_PART: (f64, f64) = (0.3, 0.3);
/// Minimum ratio of the residual variance of a single polynomial (motion without an impact) to that of two parabolas
/// (motion before and after an impact).
const MIN_SQUARES_RATIO: f64 = 1.5;
/// Maximum number of points (measured positions) around an interval tested for an impact that are excluded as outliers.
const MAX_OUTLIERS: usize = 2;
/// Maximum number of intervals, distributed over the flight, at which velocity jumps are fitted; the jump of an impact
/// is compared with their median (see `MIN_RATIO`).
const REFERENCE_INTERVALS: usize = 24;

/// An impact on the measured path of a body: a velocity jump between two points of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// Index, in the path, of the first measured position after the impact.
    pub index: usize,
    /// Jump of the velocity of the body at the impact, m/s.
    pub jump: Vector3<f64>,
}

/// Finds the first impact on the measured path of a body; `None` if there is none or the path is too short.
pub fn impact(path: &[PathPoint]) -> Option<Impact> {
    if path.len() < MIN_SIDES.0 + MIN_SIDES.1 {
        return None;
    }
    let noise = path_noise(path.iter().map(|point| (point.time, point.position))).max(1e-9);
    let candidates = MIN_SIDES.0..=path.len() - MIN_SIDES.1;
    let mut usual = None;
    let mut found: Option<(usize, Kink)> = None;
    for index in candidates.clone() {
        if found.is_some_and(|(first, _)| index > first + 2) {
            break;
        }
        if !may_be_impact(path, index) {
            continue;
        }
        let Some(kink) = kink(path, index, noise).filter(Kink::is_impact) else {
            continue;
        };
        let usual = *usual.get_or_insert_with(|| usual_jump(path, candidates.clone(), noise));
        if kink.jump.norm() < MIN_RATIO * usual {
            continue;
        }
        // Intervals adjacent to the impact also show part of it; the correct interval has the smallest residuals.
        let (first, best) = found.get_or_insert((index, kink));
        if kink.squares < best.squares {
            (*first, *best) = ((*first).min(index), kink);
        }
    }
    found.map(|(_, kink)| Impact {
        index: kink.index,
        jump: kink.jump,
    })
}

/// Median magnitude, m/s, of the velocity jumps that are fitted at intervals spread evenly over the path, most of which
/// contain no impact. `candidates` is the range of point indices from which the intervals are chosen; the index is that
/// of the point after the interval. `noise` is the standard deviation of one coordinate, m.
fn usual_jump(path: &[PathPoint], candidates: std::ops::RangeInclusive<usize>, noise: f64) -> f64 {
    let step = candidates.clone().count().div_ceil(REFERENCE_INTERVALS);
    let kinks = candidates
        .step_by(step)
        .filter_map(|index| kink(path, index, noise));
    median_of(kinks.map(|kink| kink.jump.norm())).unwrap_or(0.0)
}

/// Whether an impact in the interval before point `index` is possible. A cheap test: the body descends before the
/// interval, and the vertical mean velocity over a few points rises across it by more than `MIN_JUMP` / 2.
fn may_be_impact(path: &[PathPoint], index: usize) -> bool {
    let velocity = |from: usize, to: usize| {
        (path[to].position - path[from].position) / (path[to].time - path[from].time)
    };
    let (before, after) = (velocity(index - 4, index - 1), velocity(index, index + 2));
    before.z < 0.0 && after.z - before.z > 0.5 * MIN_JUMP
}

/// Test of one interval for an impact: parabolas in time fitted to the motion before and after the interval.
#[derive(Clone, Copy)]
struct Kink {
    /// Index, in the measured path, of the first point after the interval that is tested for an impact.
    index: usize,
    /// Velocity before the impact, extrapolated to the middle of the interval that is tested for an impact, m/s.
    before: Vector3<f64>,
    /// Jump of the velocity in the interval that is tested for an impact, m/s.
    jump: Vector3<f64>,
    /// Standard error of each component of the velocity jump `jump`, m/s.
    error: f64,
    /// Velocity change that acceleration alone would cause within the interval that is tested for an impact, m/s. The
    /// larger one of the accelerations before and after the interval is used.
    impulse: f64,
    /// Residual variance of the two parabolas, or the noise variance if that is greater, m².
    squares: f64,
    /// Residual variance of a single polynomial fitted to the points of both parabolas, m².
    smooth: f64,
}

impl Kink {
    fn is_impact(&self) -> bool {
        let size = self.jump.norm();
        let least = MIN_JUMP
            .max(MIN_SIGNIFICANCE * self.error)
            .max(MIN_IMPULSE * self.impulse);
        let (of_jump, of_descent) = MIN_VERTICAL_PART;
        size > least
            && self.before.z < 0.0
            && self.jump.z > of_jump * size
            && self.jump.z > -of_descent * self.before.z
            && self.smooth > MIN_SQUARES_RATIO * self.squares
    }
}

/// Tests the interval before point `index` of a measured path for an impact: fits one parabola in time to the points
/// before it and one to the points after it, and a single polynomial to all of these points. `noise` is the standard
/// deviation of one coordinate, m. `None` if there are too few points.
fn kink(path: &[PathPoint], index: usize, noise: f64) -> Option<Kink> {
    let (from, to) = (index.saturating_sub(SIDE), (index + SIDE).min(path.len()));
    let time = 0.5 * (path[index - 1].time + path[index].time);
    let half = 0.5 * (path[to - 1].time - path[from].time);
    let origin = path[index].position;
    let mut sides = [Vec::new(), Vec::new()];
    for (offset, point) in path[from..to].iter().enumerate() {
        let side = usize::from(from + offset >= index);
        sides[side].push(((point.time - time) / half, point.position - origin));
    }
    leave_out_outliers(&mut sides, noise);
    let [before, after] = &sides;
    if before.len() < PARABOLA || after.len() < MIN_SIDES.1 {
        return None;
    }
    let all: Vec<_> = before.iter().chain(after).copied().collect();
    let first = polynomial::<3>(before, None)?;
    let known = Vector3::from(first.coefficients.fixed_rows::<1>(2).transpose());
    let second = match after.len() >= PARABOLA {
        true => polynomial::<3>(after, None)?,
        false => polynomial::<3>(after, Some(known))?,
    };
    // A polynomial with as many coefficients as points would pass through all of them.
    let smooth = polynomial::<SMOOTH>(&all, None)?;
    let velocity =
        |side: &Fitted<3>| Vector3::from(side.coefficients.fixed_rows::<1>(1).transpose()) / half;
    let acceleration =
        |side: &Fitted<3>| 2.0 * side.coefficients.fixed_rows::<1>(2).norm() / (half * half);
    let freedom =
        |points: usize, unknowns: usize| (3 * points.saturating_sub(unknowns)).max(3) as f64;
    let squares = (first.squares + second.squares) / freedom(all.len(), 6);
    let deviation = squares.sqrt().max(noise);
    let variance = first.slope_variance + second.slope_variance;
    Some(Kink {
        index,
        before: velocity(&first),
        jump: velocity(&second) - velocity(&first),
        error: deviation * variance.sqrt() / half,
        impulse: acceleration(&first).max(acceleration(&second))
            * (path[index].time - path[index - 1].time),
        squares: squares.max(noise * noise),
        smooth: smooth.squares / freedom(all.len(), SMOOTH),
    })
}

/// Removes up to `MAX_OUTLIERS` outliers from the points (time, position) on the two sides of an interval that is
/// tested for an impact. A point is an outlier if a single polynomial fits the points of both sides far better without
/// it. After an impact, the removal of a single point does not improve the fit in this way. `noise` is the standard
/// deviation of one coordinate, m.
fn leave_out_outliers(sides: &mut [Vec<(f64, Vector3<f64>)>; 2], noise: f64) {
    for _ in 0..MAX_OUTLIERS {
        let all: Vec<_> = sides.iter().flatten().copied().collect();
        if all.len() <= SMOOTH + 2 {
            return;
        }
        let Some(whole) = polynomial::<SMOOTH>(&all, None) else {
            return;
        };
        let without = |left_out: usize| {
            let mut others = all.clone();
            others.remove(left_out);
            polynomial::<SMOOTH>(&others, None).map_or(f64::INFINITY, |fitted| fitted.squares)
        };
        let squares: Vec<f64> = (0..all.len()).map(without).collect();
        let Some(best) = (0..all.len()).min_by(|&a, &b| squares[a].total_cmp(&squares[b])) else {
            return;
        };
        let expected = 9.0 * (3 * (all.len() - SMOOTH)) as f64 * noise * noise;
        if squares[best] > 0.2 * whole.squares.max(expected) || whole.squares < expected {
            return;
        }
        let before = sides[0].len();
        match best < before {
            true => sides[0].remove(best),
            false => sides[1].remove(best - before),
        };
    }
}

/// Least-squares polynomial in the normalised (dimensionless) time, fitted to the three coordinates of a path.
struct Fitted<const N: usize> {
    /// Coefficients of the powers of the normalised time, m; one column per axis.
    coefficients: SMatrix<f64, N, 3>,
    /// Sum of squared residuals, m².
    squares: f64,
    /// Variance of the coefficient of the first power of the normalised time, for residuals of variance 1.
    slope_variance: f64,
}

/// Fits a polynomial in time with `N` coefficients through points (normalised time, position in m). The coefficient of
/// the second power is fixed at `quadratic`, m, and fitted if that is `None`. `None` if the normal matrix is singular.
fn polynomial<const N: usize>(
    points: &[(f64, Vector3<f64>)],
    quadratic: Option<Vector3<f64>>,
) -> Option<Fitted<N>> {
    let mut normal = SMatrix::<f64, N, N>::zeros();
    let mut right = SMatrix::<f64, N, 3>::zeros();
    let powers = |time: f64| SVector::<f64, N>::from_fn(|power, _| time.powi(power as i32));
    for (time, position) in points {
        let row = powers(*time);
        normal += row * row.transpose();
        right += row * position.transpose();
    }
    if let Some(quadratic) = quadratic {
        // The weight is far above that of the points.
        let weight = 1e6 * points.len() as f64;
        normal[(2, 2)] += weight;
        for axis in 0..3 {
            right[(2, axis)] += weight * quadratic[axis];
        }
    }
    let inverse = normal.try_inverse()?;
    let coefficients = inverse * right;
    let squares = points.iter().map(|(time, position)| {
        let fitted = coefficients.tr_mul(&powers(*time));
        (fitted - position).norm_squared()
    });
    Some(Fitted {
        squares: squares.sum(),
        slope_variance: inverse[(1, 1)].max(0.0),
        coefficients,
    })
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
            let found = impact(&path).unwrap_or_else(|| panic!("bounce {seed} is missed"));
            assert!(found.index.abs_diff(at) <= 2, "{} for {at}", found.index);
            assert!(found.jump.z > 0.5);
        }
    }

    #[test]
    fn a_strong_lift_that_fades_is_no_impact() {
        for seed in 0..60 {
            let lift = 10.0 + seed as f64;
            let fading = 0.03 + 0.01 * (seed % 10) as f64;
            let path = path(25.0, (lift, fading), None, seed);
            assert_eq!(impact(&path), None, "lift {lift}, fading in {fading} s");
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
            assert_eq!(impact(&path), None, "seed {seed}");
        }
    }

    #[test]
    fn a_bounce_in_the_last_samples_is_found() {
        let path = path(6.0, (0.0, 1.0), Some((60, 0.7)), 3);
        let found = impact(&path[..64]).expect("a bounce");
        assert!(found.index.abs_diff(60) <= 2);
    }
}
