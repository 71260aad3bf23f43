//! Impact detection: a flight is truncated before its first upward jump of velocity.

use nalgebra::Vector3;

use crate::observations::Observations;
use crate::pose::{Pose, point_position, pose};
use crate::problem::FitProblem;
use crate::statistics::median;

/// Number of samples on either side of a velocity jump from which velocities are estimated.
const SIDE: usize = 5;

/// Least jump of velocity of an impact, m/s.
const MIN_JUMP: f64 = 1.0;

/// Least ratio of an impact's velocity jump to the median velocity change between samples.
const MIN_RATIO: f64 = 10.0;

/// Least ratio of the vertical component to the magnitude of an impact's velocity jump.
const MIN_VERTICAL_PART: f64 = 0.3;

/// Truncates a flight before its first upward jump of velocity, which only an impact on the ground causes. Returns
/// the poses in the remaining samples of a body with an attitude.
pub fn truncate_at_impact(
    problem: &FitProblem,
    observations: &mut Observations,
) -> Vec<Option<Pose>> {
    let samples = 0..observations.times.len();
    let mut poses: Vec<Option<Pose>> = match problem.has_attitude {
        true => samples
            .clone()
            .map(|sample| pose(&problem.markers, observations.points(sample)))
            .collect(),
        false => Vec::new(),
    };
    let position = |sample: usize| match problem.has_attitude {
        true => poses[sample].map(|pose| pose.position),
        false => point_position(&problem.markers, observations.points(sample)),
    };
    let path: Vec<(usize, f64, Vector3<f64>)> = samples
        .filter_map(|sample| Some((sample, observations.times[sample], position(sample)?)))
        .collect();
    if let Some((index, jump)) = jump(&path) {
        let (sample, time, _) = path[index];
        let why = format!(
            "the velocity jumps by ({:.1}, {:.1}, {:.1}) m/s at t = {:.3} s, as at a touch of the ground",
            jump.x,
            jump.y,
            jump.z,
            observations.origin + time
        );
        observations.truncate(sample, why);
        poses.truncate(sample);
    }
    poses
}

/// Index of the first sample after an impact and the velocity jump there, m/s; `None` without an impact.
fn jump(path: &[(usize, f64, Vector3<f64>)]) -> Option<(usize, Vector3<f64>)> {
    if path.len() < 2 * SIDE + 1 {
        return None;
    }
    let velocities: Vec<Vector3<f64>> = path.windows(SIDE).map(velocity).collect();
    let pairs = velocities[SIDE..].iter().zip(&velocities);
    let jumps: Vec<Vector3<f64>> = pairs.map(|(after, before)| after - before).collect();
    // Gravity and drag change the velocity too, but almost evenly.
    let usual = [0, 1, 2].map(|axis| {
        let mut values: Vec<f64> = jumps.iter().map(|jump| jump[axis]).collect();
        median(&mut values)
    });
    let usual = Vector3::from(usual);
    let mut sizes: Vec<f64> = jumps.iter().map(|jump| (jump - usual).norm()).collect();
    let limit = MIN_JUMP.max(MIN_RATIO * median(&mut sizes));
    let beyond = |jump: &Vector3<f64>| {
        let extra = jump - usual;
        extra.z > MIN_JUMP.max(MIN_VERTICAL_PART * extra.norm()) && extra.norm() > limit
    };
    let first = jumps.iter().position(beyond)?;
    // Windows that only overlap the impact contain a part of the jump; the full jump is the greatest.
    let around = &jumps[first..(first + SIDE).min(jumps.len())];
    let size = |jump: &Vector3<f64>| (jump - usual).norm();
    let (offset, jump) = around
        .iter()
        .enumerate()
        .max_by(|a, b| size(a.1).total_cmp(&size(b.1)))?;
    Some((first + offset + SIDE, *jump))
}

/// Velocity, m/s, by the median slope of all pairs among `SIDE` samples, which one outlier does not change.
fn velocity(path: &[(usize, f64, Vector3<f64>)]) -> Vector3<f64> {
    let slope = |axis: usize| {
        let mut slopes = [0.0; SIDE * (SIDE - 1) / 2];
        let mut count = 0;
        for (i, (_, earlier, from)) in path.iter().enumerate() {
            for (_, later, to) in &path[i + 1..] {
                slopes[count] = (to[axis] - from[axis]) / (later - earlier);
                count += 1;
            }
        }
        median(&mut slopes[..count])
    };
    Vector3::new(slope(0), slope(1), slope(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Path of a thrown stone that bounces at sample `bounce`, or not at all if `None`.
    fn stone(bounce: Option<usize>) -> Vec<(usize, f64, Vector3<f64>)> {
        let (mut position, mut velocity) =
            (Vector3::new(0.0, 0.0, 1.0), Vector3::new(5.0, 0.0, 1.0));
        let dt = 1.0 / 120.0;
        (0..60)
            .map(|i| {
                if Some(i) == bounce {
                    velocity.z *= -0.7;
                }
                let jitter = 0.001 * ((i * 7919) as f64).sin();
                let now = (i, i as f64 * dt, position + Vector3::repeat(jitter));
                velocity.z -= 9.81 * dt;
                position += velocity * dt;
                now
            })
            .collect()
    }

    #[test]
    fn a_bounce_is_found_and_a_fall_is_none() {
        let (at, jump) = jump(&stone(Some(45))).unwrap();
        assert!((44..=46).contains(&at), "at {at}");
        assert!(jump.z > 3.0);
        assert_eq!(super::jump(&stone(None)), None);
    }

    #[test]
    fn an_outlier_is_no_bounce() {
        let mut path = stone(None);
        path[30].2.z += 0.1;
        assert_eq!(jump(&path), None);
    }
}
