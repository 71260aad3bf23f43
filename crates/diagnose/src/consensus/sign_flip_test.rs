//! Sign-flip score test: whether the scores of the single flights have a common sign.
//!
//! If each flight deviates from the model in a different way, the sum of squares rejects every law that is common to
//! all flights. A common sign of the flights' scores is still evidence for an effect. Under the null hypothesis, the
//! sign of each flight's score is positive or negative with equal probability.

use identify::{NormalBlock, pseudo_inverse};
use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::context::{CandidateId, ColumnId, Partition, ScoreTestModel, select};
use crate::error::DiagnosisError;
use crate::score_test::{MIN_TOLERANCE, eliminate_locals, keep_directions};

/// Number of random sign vectors, with one sign for each flight, drawn for the null distribution of the sign-flip test.
const DRAWS: usize = 10_000;

/// Seed of the random sign vectors that simulate the null distribution of the sign-flip test.
const SEED: u64 = 1;

/// Effective scores and information of the single flights, the input of the sign-flip test.
#[derive(Clone, Debug)]
pub(crate) struct SignFlipTest {
    /// Effective score by flight (row) and column of the normal equations; positive if the sum of squares decreases
    /// as the unknown increases. Zero if the column is not tested.
    pub(super) scores: DMatrix<f64>,
    /// Effective information by flight (row) and column of the normal equations. Zero if the column is not tested.
    pub(super) information: DMatrix<f64>,
    /// For each flight: weighted sum of squares of its residuals, and the expectation of this sum for pure noise.
    pub(super) fits: Vec<FlightSquares>,
}

/// Weighted sum of squares of the residuals of one flight, and its expectation.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlightSquares {
    /// Weighted sum of squares of the residuals.
    pub squares: f64,
    /// Expected weighted sum of squares if the residuals are pure noise.
    pub expected: f64,
}

impl SignFlipTest {
    /// Computes the effective scores of all flights from their normal equations. Nuisance parameters are those of the
    /// model under test and of the candidates in `conditioned_on`.
    ///
    /// # Errors
    /// [`DiagnosisError::UndeterminedInitialState`] if the samples of a flight do not determine its initial state;
    /// [`DiagnosisError::SingularInformation`] if the information matrix of the nuisance parameters cannot be
    /// inverted.
    pub fn new(
        model: &ScoreTestModel<'_>,
        blocks: &[NormalBlock],
        conditioned_on: &[CandidateId],
    ) -> Result<Self, DiagnosisError> {
        let size = blocks.first().map_or(0, |block| block.global.nrows());
        let partition = Partition::new(model.nuisance_columns(conditioned_on), size);
        let reduced = |flight: usize| {
            let (_, free) = model.local_partition(flight, conditioned_on);
            eliminate_locals(model, flight, &keep_directions(&blocks[flight], &free))
        };
        // Each flight is reduced twice, so that only one flight's matrix is in memory at a time.
        let mut total = DMatrix::zeros(size, size);
        for flight in 0..blocks.len() {
            total += reduced(flight)?.matrix;
        }
        let nuisance = &partition.nuisance;
        let inverse = pseudo_inverse(&select(&total, nuisance, nuisance));
        let inverse = inverse.ok_or(DiagnosisError::SingularInformation)?;
        let all: Vec<ColumnId> = (0..size).map(ColumnId::new).collect();
        let projection = inverse * select(&total, nuisance, &all);
        let fit = |block: &NormalBlock| FlightSquares {
            squares: block.squares,
            expected: block.count as f64,
        };
        let mut test = Self {
            scores: DMatrix::zeros(blocks.len(), size),
            information: DMatrix::zeros(blocks.len(), size),
            fits: blocks.iter().map(fit).collect(),
        };
        for flight in 0..blocks.len() {
            let equations = reduced(flight)?;
            let (h, g) = (&equations.matrix, &equations.gradient);
            test.set_flight(flight, (h, g), &partition, &projection);
        }
        Ok(test)
    }

    /// Computes the scores of one flight from its normal equations, matrix `h` and gradient `g`. The nuisance columns
    /// are projected out of the tested columns by `projection`, the projection coefficients common to all flights.
    fn set_flight(
        &mut self,
        flight: usize,
        (h, g): (&DMatrix<f64>, &DVector<f64>),
        partition: &Partition,
        projection: &DMatrix<f64>,
    ) {
        let nuisance = &partition.nuisance;
        let projected = select(h, nuisance, nuisance) * projection;
        for column in partition.tested.iter().map(|column| column.index()) {
            let total = h[(column, column)];
            let (mut score, mut information) = (-g[column], total);
            for (row, i) in nuisance.iter().map(|column| column.index()).enumerate() {
                let coefficient = projection[(row, column)];
                score += coefficient * g[i];
                information += coefficient * (projected[(row, column)] - 2.0 * h[(i, column)]);
            }
            if information > MIN_TOLERANCE * total {
                self.scores[(flight, column)] = score;
                self.information[(flight, column)] = information;
            }
        }
    }

    /// Number of flights whose scores are tested.
    pub fn flights(&self) -> usize {
        self.scores.nrows()
    }

    /// Excess χ² of the flights with the given indices: weighted sum of squares minus its expectation for pure noise.
    pub fn excess_chi2(&self, flights: impl Iterator<Item = usize>) -> f64 {
        let each = flights.map(|f| self.fits[f].squares - self.fits[f].expected);
        each.sum()
    }

    /// Cosine of the angle between a flight's whitened residuals and the Jacobian column of an unknown, after the
    /// nuisance columns are projected out of this column. Positive if the sum of squares decreases as the unknown
    /// increases; 0 if the flight has no information about the unknown.
    pub(super) fn cosine(&self, flight: usize, column: ColumnId) -> f64 {
        let at = (flight, column.index());
        let norms = (self.information[at] * self.fits[flight].squares).sqrt();
        match norms > 0.0 {
            true => (self.scores[at] / norms).clamp(-1.0, 1.0),
            false => 0.0,
        }
    }

    /// Familywise p-value of the sign-flip test of each group of columns of the normal equations, by the maximum
    /// statistic: the fraction of random sign vectors for which the agreement of the flights on any group is at least
    /// the observed agreement on this group.
    pub fn p_values(&self, groups: &[Vec<ColumnId>]) -> Vec<f64> {
        let groups: Vec<Vec<Vec<f64>>> = groups
            .iter()
            .map(|group| group.iter().map(|&c| self.unit_cosines(c)).collect())
            .collect();
        let mut signs = vec![1.0; self.flights()];
        let observed: Vec<f64> = groups.iter().map(|g| agreement(&signs, g)).collect();
        let mut random = ChaCha12Rng::seed_from_u64(SEED);
        let mut greatest = Vec::with_capacity(DRAWS);
        for _ in 0..DRAWS {
            signs.fill_with(|| if random.random::<bool>() { 1.0 } else { -1.0 });
            let each = groups.iter().map(|group| agreement(&signs, group));
            greatest.push(each.fold(0.0, f64::max));
        }
        greatest.sort_by(f64::total_cmp);
        let p_value = |observed: f64| {
            let reached = DRAWS - greatest.partition_point(|drawn| *drawn < observed);
            (1 + reached) as f64 / (1 + DRAWS) as f64
        };
        observed.into_iter().map(p_value).collect()
    }

    /// For every flight: cosine of the angle between its whitened residuals and the Jacobian column of the unknown of
    /// `column`. The vector of these cosines is scaled to unit length.
    fn unit_cosines(&self, column: ColumnId) -> Vec<f64> {
        let cosines: Vec<f64> = (0..self.flights())
            .map(|f| self.cosine(f, column))
            .collect();
        let norm = cosines.iter().map(|c| c * c).sum::<f64>().sqrt();
        let scale = if norm > 0.0 { 1.0 / norm } else { 0.0 };
        cosines.iter().map(|c| c * scale).collect()
    }
}

/// Agreement of the flights on a group of unknowns. `group` contains one vector for each unknown: for each flight, the
/// cosine of the angle between its residuals and the unknown's Jacobian column. The agreement is the maximum over the
/// unknowns of the absolute sum of the cosines, each multiplied by its flight's entry in `signs`.
fn agreement(signs: &[f64], group: &[Vec<f64>]) -> f64 {
    let sum = |cosines: &Vec<f64>| -> f64 {
        let each = cosines.iter().zip(signs);
        each.map(|(cosine, sign)| cosine * sign).sum()
    };
    group.iter().map(|c| sum(c).abs()).fold(0.0, f64::max)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use rand_distr::{Distribution, StandardNormal};

    /// Sign-flip test of `count` simulated flights with two unknowns. The value of the first unknown is about 1, but −1
    /// in the last `opposite` flights; the second unknown is random.
    pub(in crate::consensus) fn flights(count: usize, opposite: usize) -> SignFlipTest {
        let mut random = ChaCha12Rng::seed_from_u64(4);
        let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
        let mut scores = DMatrix::zeros(count, 2);
        for flight in 0..count {
            let side = if flight + opposite < count { 1.0 } else { -1.0 };
            scores[(flight, 0)] = 1000.0 * (side + 0.3 * normal());
            scores[(flight, 1)] = 1000.0 * normal();
        }
        let fit = FlightSquares {
            squares: 2500.0,
            expected: 100.0,
        };
        SignFlipTest {
            scores,
            information: DMatrix::from_element(count, 2, 1000.0),
            fits: vec![fit; count],
        }
    }

    fn groups() -> Vec<Vec<ColumnId>> {
        vec![vec![ColumnId::new(0)], vec![ColumnId::new(1)], vec![]]
    }

    #[test]
    fn only_a_common_sign_is_significant() {
        let p = flights(24, 0).p_values(&groups());
        assert!(p[0] < 0.001 && p[1] > 0.05, "{p:?}");
        assert_eq!(p[2], 1.0);
        // If half of the flights have the opposite sign, there is no agreement.
        let p = flights(24, 12).p_values(&groups());
        assert!(p[0] > 0.05, "{p:?}");
    }

    #[test]
    fn the_familywise_error_rate_is_the_level() {
        let mut below = 0;
        let mut random = ChaCha12Rng::seed_from_u64(9);
        for _ in 0..300 {
            let mut none = flights(20, 0);
            for score in none.scores.iter_mut() {
                *score = StandardNormal.sample(&mut random);
            }
            let p = none.p_values(&groups()[..2]);
            below += usize::from(p.iter().any(|p| *p < 0.1));
        }
        // Expected value 30, standard deviation 5.
        assert!((12..=48).contains(&below), "{below}");
    }
}
