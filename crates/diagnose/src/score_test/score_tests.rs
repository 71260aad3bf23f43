//! Score tests of all candidate effects and library terms at one linearization point.

use identify::{NormalBlock, pseudo_inverse};
use model_spec::index::{Idx, IndexVec};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::effective_score::{EffectiveScore, inverse_sqrt};
use super::local_elimination::{GlobalEquations, LocalElimination, PerFlightCandidate};
use super::null_distribution::{chi2_ln_sf, minp_thresholds};
use crate::context::{
    CandidateId, ColumnId, Partition, ScoreTestModel, TermId, select, select_vector,
};
use crate::error::DiagnosisError;

/// Minimum tolerance 1 − R² of a tested direction; below, integration errors dominate.
pub(crate) const MIN_TOLERANCE: f64 = 1e-8;

/// Seed of the simulated null distribution from which the familywise significance thresholds are computed.
const THRESHOLD_SEED: u64 = 1;

/// Score tests of candidates and library terms, given the nuisance parameters of the null hypothesis.
#[derive(Clone, Debug)]
pub(crate) struct ScoreTests {
    /// Test of each candidate effect; `None` if the parameters of the candidate are nuisance parameters.
    pub candidates: IndexVec<CandidateId, Option<ScoreTest>>,
    /// Test of each library term; empty if the normal equations have no columns for library terms.
    pub terms: IndexVec<TermId, ScoreTest>,
    /// Partition of the columns of the normal equations into nuisance and tested columns.
    pub partition: Partition,
    /// Effective information of the tested unknowns, scaled: its diagonal would be 1 without nuisance.
    pub information: DMatrix<f64>,
    /// Effective scores of the tested unknowns, each multiplied by its entry in `scale`.
    pub score: DVector<f64>,
    /// Factor of each tested unknown's column, to norm 1 after eliminating the local parameters.
    pub scale: Vec<f64>,
    /// Coefficients of the projection of tested columns, scaled, on nuisance columns (rows).
    pub nuisance_projection: DMatrix<f64>,
    /// Information of the nuisance parameters with the priors, not scaled.
    pub nuisance_information: DMatrix<f64>,
    /// Squared norm of each tested column before and after elimination of the local parameters.
    pub norms: Vec<ColumnNorms>,
    pub(super) nuisance_step: DVector<f64>,
    /// For each test: matrix that maps the scores of all tested columns to independent normal variables.
    whitenings: Vec<DMatrix<f64>>,
    /// Number of tests of candidates with states, which have no global column.
    state_tests: usize,
}

/// Squared norms of one column of the whitened Jacobian, before and after elimination of the flights' initial states.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ColumnNorms {
    /// Squared norm of the column before the elimination, over all flights.
    pub total: f64,
    /// Squared norm beyond the initial states, plus the precision 1/σ² of a prior.
    pub locals_eliminated: f64,
}

/// Score test of one candidate effect or library term.
#[derive(Clone, Debug)]
pub(crate) struct ScoreTest {
    /// Decrease of χ² that a refit would give, to second order.
    pub score_chi2: f64,
    /// Number of principal directions whose tolerance exceeds [`MIN_TOLERANCE`].
    pub degrees_of_freedom: usize,
    pub ln_p_value: f64,
    /// One-step estimates with all other candidates at their null value; empty for states.
    pub one_step_estimates: Vec<OneStepEstimate>,
    pub tolerance: f64,
}

/// One-step estimate of a coefficient, without a refit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OneStepEstimate {
    pub column: ColumnId,
    pub value: f64,
    /// Standard error of the value, SI; infinite if the flights do not determine the value.
    pub std_error: f64,
}

impl ScoreTest {
    /// Result of a score test without tested columns, which has no degrees of freedom.
    const EMPTY: ScoreTest = ScoreTest {
        score_chi2: 0.0,
        degrees_of_freedom: 0,
        ln_p_value: 0.0,
        one_step_estimates: Vec::new(),
        tolerance: 0.0,
    };
}

impl ScoreTests {
    /// Score tests at the linearization point `global` of the normal equations, given the candidates in
    /// `conditioned_on`.
    pub fn new(
        model: &ScoreTestModel<'_>,
        blocks: &[NormalBlock],
        conditioned_on: &[CandidateId],
        global: &DVector<f64>,
    ) -> Result<Self, DiagnosisError> {
        let columns = blocks.first().map_or(0, |block| block.global.nrows());
        // Terms are at their null value, 0.
        let values = DVector::from_fn(columns, |i, _| global.get(i).copied().unwrap_or(0.0));
        let eliminated = LocalElimination::new(model, blocks, conditioned_on)?;
        let partition = Partition::new(model.nuisance_columns(conditioned_on), columns);
        let equations = eliminated.null.with_priors(model, &values);
        let mut tests = Self::without_tests(&equations, partition, blocks)?;
        let null_decrease = decrease(&equations, &tests.partition.nuisance);
        for (id, candidate) in model.candidates() {
            let test = if conditioned_on.contains(&id) {
                None
            } else if candidate.is_per_flight() {
                tests.state_tests += 1;
                let with = eliminated.candidates[id].as_ref();
                with.map(|with| {
                    let equations = with.equations.with_priors(model, &values);
                    let decrease = decrease(&equations, &tests.partition.nuisance);
                    with.test(decrease - null_decrease)
                })
            } else {
                Some(tests.test_columns(model.columns_of(id), &values))
            };
            tests.candidates.push(test);
        }
        for column in (global.len()..columns).map(ColumnId::new) {
            let test = tests.test_columns(&[column], &values);
            tests.terms.push(test);
        }
        Ok(tests)
    }

    fn without_tests(
        equations: &GlobalEquations,
        partition: Partition,
        blocks: &[NormalBlock],
    ) -> Result<Self, DiagnosisError> {
        let norm = |column: &ColumnId| equations.matrix[(column.index(), column.index())];
        let scale: Vec<f64> = partition
            .tested
            .iter()
            .map(|c| inverse_sqrt(norm(c)))
            .collect();
        let system = (&equations.matrix, &equations.gradient);
        let effective = EffectiveScore::new(system, &partition, &scale)
            .ok_or(DiagnosisError::SingularInformation)?;
        let norms = partition.tested.iter().map(|column| {
            let at = (column.index(), column.index());
            ColumnNorms {
                total: blocks.iter().map(|block| block.global[at]).sum(),
                locals_eliminated: norm(column),
            }
        });
        Ok(Self {
            candidates: IndexVec::new(),
            terms: IndexVec::new(),
            norms: norms.collect(),
            nuisance_information: select(
                &equations.matrix,
                &partition.nuisance,
                &partition.nuisance,
            ),
            partition,
            information: effective.information,
            score: effective.score,
            scale,
            nuisance_projection: effective.nuisance_projection,
            nuisance_step: effective.nuisance_step,
            whitenings: Vec::new(),
            state_tests: 0,
        })
    }

    /// Joint score test of the columns `own`; `values` are those of all global columns.
    fn test_columns(&mut self, own: &[ColumnId], values: &DVector<f64>) -> ScoreTest {
        let tested = self.partition.tested.iter().enumerate();
        let at: Vec<usize> = tested
            .filter(|(_, c)| own.contains(c))
            .map(|(i, _)| i)
            .collect();
        if at.is_empty() {
            return ScoreTest::EMPTY;
        }
        let block = DMatrix::from_fn(at.len(), at.len(), |i, j| self.information[(at[i], at[j])]);
        let eigen = SymmetricEigen::new(block);
        let kept: Vec<usize> = (0..at.len())
            .filter(|&k| eigen.eigenvalues[k] > MIN_TOLERANCE)
            .collect();
        // A principal direction, scaled so that its score is standard normal.
        let direction =
            |i: usize, k: usize| eigen.eigenvectors[(i, k)] / eigen.eigenvalues[k].sqrt();
        let mut whitening = DMatrix::zeros(kept.len(), self.partition.tested.len());
        for (row, &k) in kept.iter().enumerate() {
            for (i, &column) in at.iter().enumerate() {
                whitening[(row, column)] = direction(i, k);
            }
        }
        let normal = &whitening * &self.score;
        let one_step_estimates = at.iter().enumerate().map(|(i, &column)| {
            let directions = kept.iter().map(|&k| direction(i, k));
            let step: f64 = directions
                .clone()
                .zip(normal.iter())
                .map(|(d, n)| d * n)
                .sum();
            let variance: f64 = directions.map(|d| d * d).sum();
            let is_determined = variance > 0.0 && kept.len() == at.len();
            let id = self.partition.tested[column];
            OneStepEstimate {
                column: id,
                value: values[id.index()] + step * self.scale[column],
                std_error: match is_determined {
                    true => variance.sqrt() * self.scale[column],
                    false => f64::INFINITY,
                },
            }
        });
        let (statistic, degrees_of_freedom) = (normal.norm_squared(), kept.len());
        let test = ScoreTest {
            score_chi2: statistic,
            degrees_of_freedom,
            ln_p_value: chi2_ln_sf(statistic, degrees_of_freedom),
            one_step_estimates: one_step_estimates.collect(),
            tolerance: eigen.eigenvalues.iter().copied().fold(0.0, f64::max),
        };
        if degrees_of_freedom > 0 {
            self.whitenings.push(whitening);
        }
        test
    }

    /// Familywise thresholds of the log p-value at `levels`.
    pub fn thresholds<const N: usize>(&self, levels: [f64; N]) -> [f64; N] {
        let (whitenings, others) = (&self.whitenings, self.state_tests);
        let found = minp_thresholds(
            &self.information,
            whitenings,
            others,
            &levels,
            THRESHOLD_SEED,
        );
        std::array::from_fn(|index| found[index])
    }

    /// The library term with the smallest p-value, and its test; `None` if no term can be tested.
    pub fn strongest_term(&self) -> Option<(TermId, &ScoreTest)> {
        least_p(self.terms.iter_enumerated())
    }

    /// The candidate effect with the smallest p-value, and its test; `None` if no candidate can be tested.
    pub fn strongest_candidate(&self) -> Option<(CandidateId, &ScoreTest)> {
        let each = self.candidates.iter_enumerated();
        least_p(each.filter_map(|(id, test)| Some((id, test.as_ref()?))))
    }

    /// Decrease of χ², to second order, by the tested columns for which `wanted` holds.
    pub fn joint_statistic(&self, wanted: impl Fn(ColumnId) -> bool) -> f64 {
        let tested = self.partition.tested.iter().enumerate();
        let at = tested.filter(|(_, column)| wanted(**column));
        let at: Vec<ColumnId> = at.map(|(i, _)| ColumnId::new(i)).collect();
        let score = select_vector(&self.score, &at);
        let inverse = pseudo_inverse(&select(&self.information, &at, &at));
        inverse.map_or(0.0, |inverse| score.dot(&(inverse * &score)))
    }

    /// Correlation matrix of the effective scores of the tested columns, with entries −1 … 1.
    pub fn score_correlations(&self) -> DMatrix<f64> {
        let root = self
            .information
            .diagonal()
            .map(|value| value.max(0.0).sqrt());
        let (rows, columns) = self.information.shape();
        DMatrix::from_fn(rows, columns, |i, j| {
            let product = root[i] * root[j];
            match product > 0.0 {
                true => (self.information[(i, j)] / product).clamp(-1.0, 1.0),
                false => 0.0,
            }
        })
    }

    /// Standard error, SI, of the nuisance parameter of a column; 0 for tested ones.
    pub fn nuisance_std_errors(&self) -> impl Fn(ColumnId) -> f64 {
        let covariance = pseudo_inverse(&self.nuisance_information);
        move |column| {
            let mut nuisance = self.partition.nuisance.iter();
            let at = nuisance.position(|own| *own == column);
            let variance = at.zip(covariance.as_ref()).map(|(at, c)| c[(at, at)]);
            variance.unwrap_or(0.0).max(0.0).sqrt()
        }
    }

    /// Gauss–Newton step along the eigenvectors of the effective information whose score exceeds `limit` standard
    /// deviations, with nuisance parameters re-estimated, and the number of these eigenvectors.
    pub fn one_step_along_significant(&self, limit: f64) -> (DVector<f64>, usize) {
        let tested = &self.partition.tested;
        let mut along = DVector::zeros(tested.len());
        let mut directions = 0;
        if !tested.is_empty() {
            let eigen = SymmetricEigen::new(self.information.clone());
            let vectors = eigen.eigenvectors.column_iter();
            for (value, vector) in eigen.eigenvalues.iter().zip(vectors) {
                if *value > MIN_TOLERANCE {
                    let score = vector.dot(&self.score) / value.sqrt();
                    if score.abs() > limit {
                        along.axpy(score / value.sqrt(), &vector, 1.0);
                        directions += 1;
                    }
                }
            }
        }
        let nuisance = &self.nuisance_step - &self.nuisance_projection * &along;
        let mut step = DVector::zeros(tested.len() + nuisance.len());
        for (column, value) in self.partition.nuisance.iter().zip(nuisance.iter()) {
            step[column.index()] = *value;
        }
        for ((column, value), scale) in tested.iter().zip(along.iter()).zip(&self.scale) {
            step[column.index()] = value * scale;
        }
        (step, directions)
    }
}

impl PerFlightCandidate {
    /// Test of a candidate's states; `nuisance_decrease` is the further decrease by nuisance parameters.
    fn test(&self, nuisance_decrease: f64) -> ScoreTest {
        let statistic = (self.decrease + nuisance_decrease).max(0.0);
        ScoreTest {
            score_chi2: statistic,
            degrees_of_freedom: self.degrees_of_freedom,
            ln_p_value: chi2_ln_sf(statistic, self.degrees_of_freedom),
            one_step_estimates: Vec::new(),
            tolerance: f64::from(u8::from(self.degrees_of_freedom > 0)),
        }
    }
}

/// Decrease of χ², to second order, by the unknowns of `columns`.
fn decrease(equations: &GlobalEquations, columns: &[ColumnId]) -> f64 {
    let gradient = select_vector(&equations.gradient, columns);
    let matrix = select(&equations.matrix, columns, columns);
    pseudo_inverse(&matrix).map_or(0.0, |inverse| gradient.dot(&(inverse * &gradient)))
}

/// The test with the smallest p-value among those with at least one degree of freedom; `None` if there is none.
fn least_p<'s, I: Idx>(
    tests: impl Iterator<Item = (I, &'s ScoreTest)>,
) -> Option<(I, &'s ScoreTest)> {
    tests
        .filter(|(_, test)| test.degrees_of_freedom > 0)
        .min_by(|a, b| a.1.ln_p_value.total_cmp(&b.1.ln_p_value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context::Refitted;
    use crate::test_support::fixture;

    #[test]
    fn the_seeded_effect_has_the_least_p_and_a_refit_confirms_its_one_step_estimate() {
        let fixture = fixture();
        let model = &fixture.model;
        let noise = fixture.fit.noise();
        let blocks = model.normal_equations(&model.problem, &fixture.iterate, noise);
        let tests = ScoreTests::new(model, &blocks.unwrap(), &[], &fixture.iterate.global).unwrap();
        let stall = fixture.candidate("stall");
        let (strongest, test) = tests.strongest_candidate().unwrap();
        assert_eq!(strongest, stall);
        assert!(test.ln_p_value < tests.thresholds([0.004])[0]);
        assert!(test.tolerance > MIN_TOLERANCE && test.tolerance <= 1.0);
        // The statistic predicts the decrease of the sum of squares by the refit.
        let Refitted {
            iterate: refitted,
            squares,
            ..
        } = model.refit(&[stall], &fixture.iterate, noise).unwrap();
        let before = model.normal_equations(&model.problem, &fixture.iterate, noise);
        let before: f64 = before.unwrap().iter().map(|block| block.squares).sum();
        let relative = (before - squares) / test.score_chi2;
        assert!((0.5..1.5).contains(&relative), "{relative}");
        let [column] = model.columns_of(stall)[..] else {
            panic!("one coefficient");
        };
        let estimate = test.one_step_estimates[0];
        assert_eq!(estimate.column, column);
        let fitted = refitted.global[column.index()];
        assert!(
            (estimate.value / fitted - 1.0).abs() < 0.5,
            "{estimate:?}, {fitted}"
        );
    }

    #[test]
    fn conditioning_on_the_seeded_effect_leaves_nothing_significant() {
        let fixture = fixture();
        let model = &fixture.model;
        let noise = fixture.fit.noise();
        let stall = fixture.candidate("stall");
        let problem = model.problem_with(&[stall]);
        let Refitted { iterate, .. } = model.refit(&[stall], &fixture.iterate, noise).unwrap();
        let blocks = model.normal_equations(&problem, &iterate, noise).unwrap();
        let tests = ScoreTests::new(model, &blocks, &[stall], &iterate.global).unwrap();
        assert!(tests.candidates[stall].is_none());
        let [threshold] = tests.thresholds([0.002]);
        let (_, strongest) = tests.strongest_candidate().unwrap();
        assert!(strongest.ln_p_value > threshold, "{strongest:?}");
    }

    #[test]
    fn only_significant_directions_are_stepped_along() {
        let fixture = fixture();
        let model = &fixture.model;
        let noise = fixture.fit.noise();
        let blocks = model.normal_equations(&model.problem, &fixture.iterate, noise);
        let blocks = blocks.unwrap();
        let tests = ScoreTests::new(model, &blocks, &[], &fixture.iterate.global).unwrap();
        let (_, none) = tests.one_step_along_significant(f64::INFINITY);
        let (step, few) = tests.one_step_along_significant(4.0);
        let (_, all) = tests.one_step_along_significant(0.0);
        assert!(none == 0 && 0 < few && few < all, "{few} of {all}");
        assert_eq!(step.len(), model.global_columns());
    }
}
