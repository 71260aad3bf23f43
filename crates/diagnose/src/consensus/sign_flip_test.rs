//! Sign-flip score test: whether the scores of the flights have a common sign. Where each flight deviates in its own
//! way, the sum of squares rejects every common law, but a common sign is still evidence. Under the null hypothesis,
//! both signs are equally likely.

use identify::{NormalBlock, pseudo_inverse};
use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::context::{CandidateId, ColumnId, Partition, ScoreTestModel, select};
use crate::error::DiagnosisError;
use crate::score_test::{MIN_TOLERANCE, eliminate_locals, keep_directions};

/// Number of random sign vectors, with one sign for each flight, of the null distribution, and their seed.
const DRAWN: (usize, u64) = (10_000, 1);

/// Effective scores and information of the single flights, the input of the sign-flip test.
#[derive(Clone, Debug)]
pub(crate) struct SignFlipTest {
    /// Effective score by flight (row) and column; positive if χ² decreases as the unknown increases. 0 if not tested.
    pub(super) scores: DMatrix<f64>,
    /// Effective information by flight (row) and column of the normal equations. Zero if the column is not tested.
    pub(super) information: DMatrix<f64>,
    /// For each flight: weighted sum of squares of its residuals, and the expectation of this sum for pure noise.
    pub(super) fits: Vec<FlightSquares>,
}

/// Weighted sum of squares of the residuals of one flight, and its expectation.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlightSquares {
    pub squares: f64,
    /// Expected weighted sum of squares if the residuals are pure noise.
    pub expected: f64,
}

impl SignFlipTest {
    /// Effective scores of all flights. Nuisance parameters are those of the model under test and of `conditioned_on`.
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

    /// Scores of one flight from its matrix `h` and gradient `g`; `projection` is common to all flights.
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

    pub fn flights(&self) -> usize {
        self.scores.nrows()
    }

    /// Excess χ² of the flights with the given indices: weighted sum of squares minus its expectation for pure noise.
    pub fn excess_chi2(&self, flights: impl Iterator<Item = usize>) -> f64 {
        let each = flights.map(|f| self.fits[f].squares - self.fits[f].expected);
        each.sum()
    }

    /// Cosine of the angle between a flight's whitened residuals and the effective Jacobian column; positive if χ²
    /// decreases as the unknown increases, 0 without information.
    pub(super) fn cosine(&self, flight: usize, column: ColumnId) -> f64 {
        let at = (flight, column.index());
        let norms = (self.information[at] * self.fits[flight].squares).sqrt();
        match norms > 0.0 {
            true => (self.scores[at] / norms).clamp(-1.0, 1.0),
            false => 0.0,
        }
    }

    /// Familywise p-value of each group of columns, by the maximum statistic: the fraction of random sign vectors for
    /// which the agreement on any group is at least the observed one.
    pub fn p_values(&self, groups: &[Vec<ColumnId>]) -> Vec<f64> {
        let groups: Vec<Vec<Vec<f64>>> = groups
            .iter()
            .map(|group| group.iter().map(|&c| self.unit_cosines(c)).collect())
            .collect();
        let mut signs = vec![1.0; self.flights()];
        let observed: Vec<f64> = groups.iter().map(|g| agreement(&signs, g)).collect();
        let mut random = ChaCha12Rng::seed_from_u64(DRAWN.1);
        let mut greatest = Vec::with_capacity(DRAWN.0);
        for _ in 0..DRAWN.0 {
            signs.fill_with(|| if random.random::<bool>() { 1.0 } else { -1.0 });
            let each = groups.iter().map(|group| agreement(&signs, group));
            greatest.push(each.fold(0.0, f64::max));
        }
        greatest.sort_by(f64::total_cmp);
        let p_value = |observed: f64| {
            let reached = DRAWN.0 - greatest.partition_point(|drawn| *drawn < observed);
            (1 + reached) as f64 / (1 + DRAWN.0) as f64
        };
        observed.into_iter().map(p_value).collect()
    }

    fn unit_cosines(&self, column: ColumnId) -> Vec<f64> {
        let cosines: Vec<f64> = (0..self.flights())
            .map(|f| self.cosine(f, column))
            .collect();
        let norm = cosines.iter().map(|c| c * c).sum::<f64>().sqrt();
        let scale = if norm > 0.0 { 1.0 / norm } else { 0.0 };
        cosines.iter().map(|c| c * scale).collect()
    }
}

/// Maximum over the unknowns of a group of the absolute sum of the flights' cosines, each with its sign.
fn agreement(signs: &[f64], group: &[Vec<f64>]) -> f64 {
    let sum = |cosines: &Vec<f64>| -> f64 {
        let each = cosines.iter().zip(signs);
        each.map(|(cosine, sign)| cosine * sign).sum()
    };
    group.iter().map(|c| sum(c).abs()).fold(0.0, f64::max)
}

// Discordant flights, in which an effect has the opposite sign or a much smaller size than in most.

/// Maximum number of iterations: the common value by the concordant flights, then these by the value.
const MAX_ITERATIONS: usize = 20;

/// A flight is discordant if the common estimate is expected to change its χ² by at least this much, and its own estimate
/// is below this part of the common one.
const DISCORDANT: (f64, f64) = (10.0, 0.25);

/// Division of the flights into those that agree with a common value of one unknown and those that contradict it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Concordance {
    /// Indices of the flights that contradict the value of the unknown on which all other flights agree.
    pub discordant: Vec<usize>,
    /// Decrease of the χ² of the concordant flights by the value on which they agree.
    pub chi2_decrease: f64,
}

impl SignFlipTest {
    /// Finds the value of an unknown on which most flights agree, and informative flights that contradict it.
    pub fn concordance(&self, column: ColumnId) -> Concordance {
        let flights = 0..self.flights();
        let score = |flight: usize| self.scores[(flight, column.index())];
        let information = |flight: usize| self.information[(flight, column.index())];
        // The sign of the effect in most flights, each flight weighted by its cosine.
        let sum: f64 = flights.clone().map(|f| self.cosine(f, column)).sum();
        let sign = sum.signum();
        let mut concordant: Vec<usize> =
            flights.clone().filter(|&f| sign * score(f) > 0.0).collect();
        let mut value = 0.0;
        for _ in 0..MAX_ITERATIONS {
            let total: f64 = concordant.iter().map(|&f| information(f)).sum();
            if total <= 0.0 {
                break;
            }
            value = concordant.iter().map(|&f| score(f)).sum::<f64>() / total;
            let is_concordant = |flight: &usize| {
                let expected = value * value * information(*flight);
                expected < DISCORDANT.0 || value * score(*flight) > DISCORDANT.1 * expected
            };
            let next: Vec<usize> = flights.clone().filter(is_concordant).collect();
            if next == concordant {
                break;
            }
            concordant = next;
        }
        let decrease = |&f: &usize| value * (2.0 * score(f) - value * information(f));
        Concordance {
            chi2_decrease: concordant.iter().map(decrease).sum(),
            discordant: flights.filter(|f| !concordant.contains(f)).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context::ColumnId;
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

    #[test]
    fn flights_of_opposite_sign_are_discordant() {
        let found = flights(24, 7).concordance(ColumnId::new(0));
        assert_eq!(found.discordant, (17..24).collect::<Vec<_>>());
        // The weighted sum of squares of each of the 17 concordant flights falls by about 1000.
        let relative = found.chi2_decrease / 17_000.0;
        assert!((relative - 1.0).abs() < 0.3, "{relative}");
        let none = flights(24, 0).concordance(ColumnId::new(0));
        assert!(none.discordant.is_empty());
    }
}
