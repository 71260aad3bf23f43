//! Agreement between the lift directions of flights and their stated spins, tested against permuted spins.

use nalgebra::{Quaternion, UnitQuaternion};
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};
use serde::Serialize;

use super::lift::Lift;

/// Number of random permutations, among the flights, of the spins that the data state; used by the permutation test.
const PERMUTATIONS: usize = 10_000;

/// Number of random rotations that are tried, each on all stated spins in common, to find the best agreement between
/// the flights' lift directions and ω × v.
const ROTATIONS: usize = 2_000;

/// Number of random permutations of the spins among the flights. For each permutation, random rotations of all spins
/// are tried, to find the best agreement between lift directions and ω × v.
const ROTATED_PERMUTATIONS: usize = 20;

/// Agreement between the lift directions of ball flights and the spins that the data state, with a permutation test.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Agreement {
    /// Number of flights to which the permutation test is applied.
    pub flights: usize,
    /// Mean over the flights of the cosine of the angle between the lift and ω × v, for the velocity v and the spin ω
    /// that the data state.
    pub cosine: f64,
    /// Mean, over random permutations of the spins among the flights, of the flights' mean cosine between lift and ω ×
    /// v.
    pub permuted: f64,
    /// Standard deviation, over random permutations of the spins among the flights, of the flights' mean cosine between
    /// lift and ω × v.
    pub permuted_deviation: f64,
    /// p-value of the permutation test: fraction of the random permutations of the spins for which the mean cosine
    /// between lift and ω × v (spin × velocity) is at least as large as for the stated spins.
    pub p_value: f64,
    /// Maximum of the flights' mean cosine between lift and ω × v over random rotations, with and without reflection,
    /// that are applied to all spins in common.
    pub rotated: f64,
    /// Mean, over random permutations of the spins among the flights, of the maximum mean cosine between lift and ω × v
    /// over random rotations of all spins.
    pub rotated_permuted: f64,
}

/// Tests whether the flights' lifts point along ω × v for the spins ω that the data state. The permutations of the
/// spins and the rotations are drawn from `seed`.
pub(super) fn agreement(lifts: &[&Lift], seed: u64) -> Agreement {
    let identity: Vec<usize> = (0..lifts.len()).collect();
    let no_rotation = UnitQuaternion::identity();
    let cosine = mean_cosine(lifts, &identity, &no_rotation);
    let mut order = identity.clone();
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let permuted = (0..PERMUTATIONS).map(|_| {
        order.shuffle(&mut random);
        mean_cosine(lifts, &order, &no_rotation)
    });
    let permuted: Vec<f64> = permuted.collect();
    let count = permuted.len() as f64;
    let mean = permuted.iter().sum::<f64>() / count;
    let squares: f64 = permuted.iter().map(|m| (m - mean).powi(2)).sum();
    let rotations = (0..ROTATIONS).map(|_| {
        let normal = [0; 4].map(|_| StandardNormal.sample(&mut random));
        UnitQuaternion::from_quaternion(Quaternion::from(normal))
    });
    let rotations: Vec<UnitQuaternion<f64>> = rotations.collect();
    let rotated_permuted = (0..ROTATED_PERMUTATIONS).map(|_| {
        order.shuffle(&mut random);
        greatest_rotated(lifts, &order, &rotations)
    });
    Agreement {
        rotated: greatest_rotated(lifts, &identity, &rotations),
        rotated_permuted: rotated_permuted.sum::<f64>() / ROTATED_PERMUTATIONS as f64,
        flights: lifts.len(),
        cosine,
        permuted: mean,
        permuted_deviation: (squares / count).sqrt(),
        p_value: permuted.iter().filter(|m| **m >= cosine).count() as f64 / count,
    }
}

/// Mean cosine between lift and ω × v if flight `k` has the spin of flight `order[k]`, and all spins are rotated by
/// `rotation`.
fn mean_cosine(lifts: &[&Lift], order: &[usize], rotation: &UnitQuaternion<f64>) -> f64 {
    let each = lifts.iter().zip(order);
    let sum: f64 = each
        .map(|(lift, &k)| lift.cosine_with(rotation * lifts[k].spin))
        .sum();
    sum / lifts.len().max(1) as f64
}

/// Maximum, over `rotations` of all spins, of the flights' mean cosine between lift and ω × v if flight `k` has the
/// spin of flight `order[k]`. Each rotation is tried with and without a reflection through the origin, which changes
/// the sign of every cosine.
fn greatest_rotated(lifts: &[&Lift], order: &[usize], rotations: &[UnitQuaternion<f64>]) -> f64 {
    let means = rotations
        .iter()
        .map(|rotation| mean_cosine(lifts, order, rotation).abs());
    means.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::super::lift::tests::lift;
    use super::*;

    #[test]
    fn spins_in_other_axes_agree_once_they_are_rotated() {
        // Right spins, all stated in axes rotated by a right angle about y.
        let rotated: Vec<Lift> = (0..24)
            .map(|k| f64::from(k) * 0.7)
            .map(|a| lift([a.cos(), 0.0, a.sin()], [a.sin(), 0.1, -a.cos()]))
            .collect();
        let found = agreement(&rotated.iter().collect::<Vec<_>>(), 1);
        assert!(
            found.cosine.abs() < 1e-9 && found.rotated > 0.95,
            "{found:?}"
        );
        assert!(found.rotated_permuted < 0.6, "{found:?}");
    }
}
