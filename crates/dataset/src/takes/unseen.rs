//! Positions that are no measurements: programs write one number in place of all coordinates of a point that is not seen,
//! such as 0 or -9999.

use std::collections::BTreeMap;

use crate::takes::Take;

/// Minimum number of positions with one number for all coordinates, at which it stands for a point that is not seen.
const REPEATED: usize = 2;

/// Takes positions whose coordinates are all one number, the same in several samples, as not seen. Returns a note on
/// them; `None` if there are none.
pub(crate) fn leave_out(take: &mut Take) -> Option<String> {
    let word = |position: &[f64; 3]| {
        let [x, y, z] = *position;
        (x == y && y == z).then_some((x + 0.0).to_bits())
    };
    let mut counts: BTreeMap<u64, usize> = BTreeMap::new();
    let points = take.points.iter().flat_map(|point| &point.positions);
    let poses = take.bodies.iter().flat_map(|body| &body.poses).flatten();
    let positions = points.flatten().chain(poses.map(|pose| &pose.position));
    for own in positions.filter_map(word) {
        *counts.entry(own).or_default() += 1;
    }
    counts.retain(|_, count| *count >= REPEATED);
    let (&most, _) = counts.iter().max_by_key(|(_, count)| **count)?;
    let is_unseen =
        |position: &[f64; 3]| word(position).is_some_and(|own| counts.contains_key(&own));
    for point in &mut take.points {
        for position in &mut point.positions {
            *position = position.filter(|own| !is_unseen(own));
        }
    }
    for body in &mut take.bodies {
        for pose in &mut body.poses {
            *pose = pose.take().filter(|own| !is_unseen(&own.position));
        }
    }
    let count: usize = counts.values().sum();
    let value = f64::from_bits(most) / take.length.metres();
    Some(format!(
        "{count} positions whose coordinates are one number, such as {value} {}, were read as not seen",
        take.length
    ))
}
