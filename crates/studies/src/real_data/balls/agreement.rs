//! Agreement between the lifts of flights and their stated spins, compared with permuted spins.

use nalgebra::{Quaternion, UnitQuaternion};
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};

use super::lift::Lift;

/// Number of permutations of the spins among the flights.
const PERMUTATIONS: usize = 10_000;

/// Number of random rotations applied to all spins.
const ROTATIONS: usize = 2_000;

/// Number of permutations for which the rotations are tried.
const ROTATED_PERMUTATIONS: usize = 20;

/// Agreement between the lifts of flights and their stated spins; permutation test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Number of flights.
    pub flights: usize,
    /// Mean cosine between the lift and ω × v.
    pub cosine: f64,
    /// Mean of that mean over permutations.
    pub permuted: f64,
    /// Standard deviation of the mean cosine over permutations.
    pub permuted_deviation: f64,
    /// Fraction of the permutations whose mean cosine is at least as great.
    pub p_value: f64,
    /// Greatest mean cosine that a common rotation or reflection of all spins gives.
    pub rotated: f64,
    /// Mean of that greatest mean cosine over permutations.
    pub rotated_permuted: f64,
}

/// Tests the agreement of some flights with permutations and rotations drawn from a seed.
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

/// Mean cosine if each flight has the spin of flight `order[k]`, rotated.
fn mean_cosine(lifts: &[&Lift], order: &[usize], rotation: &UnitQuaternion<f64>) -> f64 {
    let each = lifts.iter().zip(order);
    let sum: f64 = each
        .map(|(lift, &k)| lift.cosine_with(rotation * lifts[k].spin))
        .sum();
    sum / lifts.len().max(1) as f64
}

/// Greatest mean cosine over rotations and the same with a reflection through the origin, which changes every sign.
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
        // Right spins, all given in axes rotated by a right angle about y.
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
