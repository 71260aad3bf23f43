//! Detection of the points of a take that move as one rigid body.

use crate::pose::distance;
use crate::takes::take::Take;

/// Number of samples, equally spaced, in which the distance of two points is compared for a rigid body, about.
const COMPARED: usize = 300;
/// Maximum difference between the 90 % and the 10 % quantile of the distance of two points of a rigid body, m.
const RIGID: f64 = 0.012;
/// Speed that a point must reach to belong to a thrown body, m/s.
const FAST: f64 = 2.0;
/// Minimum compared samples in which two points are both seen for them to be of one rigid body.
const COMMON: usize = 5;

/// Indices, increasing, of the largest set of moving points whose mutual distances are constant.
pub(super) fn rigid_points(take: &Take) -> Vec<usize> {
    let stride = (take.times.len() / COMPARED).max(1);
    let count = take.points.len();
    let moving: Vec<usize> = (0..count).filter(|&i| moves(take, i)).collect();
    let mut best: Vec<usize> = Vec::new();
    for &seed in &moving {
        let mut members = vec![seed];
        for &other in &moving {
            let keeps = |&member: &usize| member != other && is_rigid(take, member, other, stride);
            if other != seed && members.iter().all(keeps) {
                members.push(other);
            }
        }
        if members.len() > best.len() {
            members.sort_unstable();
            best = members;
        }
    }
    best
}

/// Whether the speed of a point, over 5 sampling intervals, ever exceeds [`FAST`].
fn moves(take: &Take, point: usize) -> bool {
    let positions = &take.points[point].positions;
    let apart = 5.min(positions.len().saturating_sub(1)).max(1);
    (apart..positions.len()).any(|i| match (positions[i - apart], positions[i]) {
        (Some(a), Some(b)) => distance(a, b) > FAST * (take.times[i] - take.times[i - apart]),
        _ => false,
    })
}

fn is_rigid(take: &Take, a: usize, b: usize, stride: usize) -> bool {
    let (a, b) = (&take.points[a].positions, &take.points[b].positions);
    let pairs = a.iter().zip(b).step_by(stride);
    let mut distances: Vec<f64> = pairs
        .filter_map(|(a, b)| Some(distance((*a)?, (*b)?)))
        .collect();
    if distances.len() < COMMON {
        return false;
    }
    distances.sort_by(f64::total_cmp);
    let at = |fraction: f64| distances[((distances.len() - 1) as f64 * fraction) as usize];
    at(0.9) - at(0.1) <= RIGID
}
