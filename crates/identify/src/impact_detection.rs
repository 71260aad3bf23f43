//! The first touch of the ground: where the velocity jumps.

use nalgebra::Vector3;

use crate::noise::median;
use crate::observations::Observations;
use crate::pose::{Pose, pose};
use crate::problem::FitProblem;

/// Samples on either side of a jump that its velocities are taken from.
const SIDE: usize = 5;

/// A jump below this is none, m/s.
const LEAST: f64 = 1.0;

/// How far a jump must stand out from the scatter of the velocities.
const CLEAR: f64 = 10.0;

/// Cuts a track before its first jump of velocity with a rise: nothing but the ground throws a body up at once. Gives the
/// poses in the samples that are left, of a body that turns.
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
    let place = |sample: usize| match problem.has_attitude {
        true => poses[sample].map(|pose| pose.position),
        false => observations
            .points(sample)
            .iter()
            .flatten()
            .next()
            .map(|&seen| seen.into()),
    };
    let path: Vec<(usize, f64, Vector3<f64>)> = samples
        .filter_map(|sample| Some((sample, observations.times[sample], place(sample)?)))
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

/// The first sample after a jump, and the jump, m/s.
fn jump(path: &[(usize, f64, Vector3<f64>)]) -> Option<(usize, Vector3<f64>)> {
    if path.len() < 2 * SIDE + 1 {
        return None;
    }
    let velocities: Vec<Vector3<f64>> = path.windows(SIDE).map(velocity).collect();
    let pairs = velocities[SIDE..].iter().zip(&velocities);
    let jumps: Vec<Vector3<f64>> = pairs.map(|(after, before)| after - before).collect();
    // Gravity and drag change the velocity too, but by much the same everywhere.
    let usual = [0, 1, 2].map(|axis| {
        let mut values: Vec<f64> = jumps.iter().map(|jump| jump[axis]).collect();
        median(&mut values)
    });
    let usual = Vector3::from(usual);
    let mut sizes: Vec<f64> = jumps.iter().map(|jump| (jump - usual).norm()).collect();
    let limit = LEAST.max(CLEAR * median(&mut sizes));
    let beyond = |jump: &Vector3<f64>| {
        let extra = jump - usual;
        extra.z > LEAST.max(0.3 * extra.norm()) && extra.norm() > limit
    };
    let first = jumps.iter().position(beyond)?;
    // Windows that only reach over the edge see a part of the jump: the whole of it is where it is greatest.
    let around = &jumps[first..(first + SIDE).min(jumps.len())];
    let size = |jump: &Vector3<f64>| (jump - usual).norm();
    let (offset, jump) = around
        .iter()
        .enumerate()
        .max_by(|a, b| size(a.1).total_cmp(&size(b.1)))?;
    Some((first + offset + SIDE, *jump))
}

/// Velocity by the median of the slopes between all pairs of samples, `SIDE` at most, which one outlier does not move.
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

    /// A thrown stone that bounces at a sample, or never.
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
