//! Score tests of all candidates and terms at one linearization point.

use identify::{NormalBlock, pseudo_inverse};
use model_spec::index::{Idx, IndexVec};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::local_elimination::{GlobalEquations, LocalElimination, PerFlightCandidate};
use super::null_distribution::{chi2_ln_sf, minp_thresholds};
use super::schur::{EffectiveScore, inverse_sqrt};
use crate::context::{
    CandidateId, ColumnId, Partition, ScoreTestModel, TermId, select, select_vector,
};
use crate::error::DiagnosisError;

/// Tolerance below which a direction is not tested; integration errors dominate there.
pub(crate) const MIN_TOLERANCE: f64 = 1e-8;

/// Seed of the simulated null distribution.
const THRESHOLD_SEED: u64 = 1;

/// Score tests given that the model under test and the candidates conditioned on are estimated.
#[derive(Clone, Debug)]
pub(crate) struct ScoreTests {
    /// Test of each candidate; none for those conditioned on.
    pub candidates: IndexVec<CandidateId, Option<ScoreTest>>,
    /// Test of each term, if the normal equations have their columns.
    pub terms: IndexVec<TermId, ScoreTest>,
    /// Nuisance and tested columns.
    pub partition: Partition,
    /// Information of the tested columns, each scaled to unit diagonal before the nuisance parameters are eliminated.
    pub information: DMatrix<f64>,
    /// Effective scores of the tested columns, scaled like `information`.
    pub score: DVector<f64>,
    /// Scale factor of each tested column.
    pub scale: Vec<f64>,
    /// Projection coefficients of the tested columns on the nuisance columns.
    pub nuisance_projection: DMatrix<f64>,
    /// Information of the nuisance columns.
    pub nuisance_information: DMatrix<f64>,
    /// Squared norms of each tested column.
    pub norms: Vec<ColumnNorms>,
    pub(super) nuisance_step: DVector<f64>,
    /// Whitening matrix of each test, by tested columns.
    whitenings: Vec<DMatrix<f64>>,
    /// Number of tests of states, which share no column.
    state_tests: usize,
}

/// Squared norms of a column of the whitened Jacobian.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ColumnNorms {
    /// Squared norm of the column.
    pub total: f64,
    /// Squared norm of the column after projection orthogonal to the local columns.
    pub locals_eliminated: f64,
}

/// Score test of one candidate or term.
#[derive(Clone, Debug)]
pub(crate) struct ScoreTest {
    /// Score statistic: the decrease of the weighted sum of squares by a refit, to second order. χ² of `dof` under the null
    /// hypothesis.
    pub statistic: f64,
    /// Degrees of freedom: directions with a tolerance above [`MIN_TOLERANCE`].
    pub dof: usize,
    /// Natural logarithm of the p-value.
    pub ln_p: f64,
    /// One-step estimates of the coefficients, other candidates at their null value.
    pub one_step: Vec<OneStepEstimate>,
    /// Tolerance 1 − R² of the best determined direction: the share of its squared effect that no nuisance parameter
    /// explains.
    pub tolerance: f64,
}

/// One-step estimate of a coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OneStepEstimate {
    /// Column of the coefficient.
    pub column: ColumnId,
    /// Value, SI.
    pub value: f64,
    /// Standard error, SI; infinite if the flights do not determine the value.
    pub std_error: f64,
}

impl ScoreTest {
    /// Test of a candidate without tested columns.
    const EMPTY: ScoreTest = ScoreTest {
        statistic: 0.0,
        dof: 0,
        ln_p: 0.0,
        one_step: Vec::new(),
        tolerance: 0.0,
    };
}

impl ScoreTests {
    /// Tests at the linearization point of `blocks`, where the global parameters have the values `global`.
    ///
    /// # Errors
    /// [`DiagnosisError::UndeterminedInitialState`], [`DiagnosisError::SingularInformation`].
    pub fn new(
        model: &ScoreTestModel,
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

    /// Joint test of some columns, at these values of the unknowns.
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
        let one_step = at.iter().enumerate().map(|(i, &column)| {
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
        let (statistic, dof) = (normal.norm_squared(), kept.len());
        let test = ScoreTest {
            statistic,
            dof,
            ln_p: chi2_ln_sf(statistic, dof),
            one_step: one_step.collect(),
            tolerance: eigen.eigenvalues.iter().copied().fold(0.0, f64::max),
        };
        if dof > 0 {
            self.whitenings.push(whitening);
        }
        test
    }

    /// Familywise thresholds: log p-values below which the least of all tests falls with probabilities `levels` under
    /// the null hypothesis.
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

    /// The term with the least p-value.
    pub fn strongest_term(&self) -> Option<(TermId, &ScoreTest)> {
        least_p(self.terms.iter_enumerated())
    }

    /// The candidate with the least p-value.
    pub fn strongest_candidate(&self) -> Option<(CandidateId, &ScoreTest)> {
        let each = self.candidates.iter_enumerated();
        least_p(each.filter_map(|(id, test)| Some((id, test.as_ref()?))))
    }

    /// Decrease of the weighted sum of squares by all tested columns for which `wanted` holds, to second order.
    pub fn joint_statistic(&self, wanted: impl Fn(ColumnId) -> bool) -> f64 {
        let tested = self.partition.tested.iter().enumerate();
        let at = tested.filter(|(_, column)| wanted(**column));
        let at: Vec<ColumnId> = at.map(|(i, _)| ColumnId::new(i)).collect();
        let score = select_vector(&self.score, &at);
        let inverse = pseudo_inverse(&select(&self.information, &at, &at));
        inverse.map_or(0.0, |inverse| score.dot(&(inverse * &score)))
    }

    /// Correlations of the effective scores of the tested columns, −1 … 1.
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

    /// Standard errors of nuisance columns, those of the unknowns of a hypothesis among them.
    pub fn nuisance_std_errors(&self) -> impl Fn(ColumnId) -> f64 {
        let covariance = pseudo_inverse(&self.nuisance_information);
        move |column| {
            let mut nuisance = self.partition.nuisance.iter();
            let at = nuisance.position(|own| *own == column);
            let variance = at.zip(covariance.as_ref()).map(|(at, c)| c[(at, at)]);
            variance.unwrap_or(0.0).max(0.0).sqrt()
        }
    }
}

impl PerFlightCandidate {
    /// The test of a candidate's states, where the nuisance parameters decrease the sum of squares by `nuisance_decrease` more
    /// than under the null hypothesis.
    fn test(&self, nuisance_decrease: f64) -> ScoreTest {
        let statistic = (self.decrease + nuisance_decrease).max(0.0);
        ScoreTest {
            statistic,
            dof: self.dof,
            ln_p: chi2_ln_sf(statistic, self.dof),
            one_step: Vec::new(),
            tolerance: f64::from(u8::from(self.dof > 0)),
        }
    }
}

/// Decrease of the sum of squares by fitting some columns, to second order.
fn decrease(equations: &GlobalEquations, columns: &[ColumnId]) -> f64 {
    let gradient = select_vector(&equations.gradient, columns);
    let matrix = select(&equations.matrix, columns, columns);
    pseudo_inverse(&matrix).map_or(0.0, |inverse| gradient.dot(&(inverse * &gradient)))
}

/// The test with the least p-value among those with at least one degree of freedom.
fn least_p<'s, I: Idx>(
    tests: impl Iterator<Item = (I, &'s ScoreTest)>,
) -> Option<(I, &'s ScoreTest)> {
    tests
        .filter(|(_, test)| test.dof > 0)
        .min_by(|a, b| a.1.ln_p.total_cmp(&b.1.ln_p))
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
        assert!(test.ln_p < tests.thresholds([0.004])[0]);
        assert!(test.tolerance > MIN_TOLERANCE && test.tolerance <= 1.0);
        // The statistic predicts the decrease of the sum of squares by the refit.
        let Refitted {
            iterate: refitted,
            squares,
            ..
        } = model.refit(&[stall], &fixture.iterate, noise).unwrap();
        let before = model.normal_equations(&model.problem, &fixture.iterate, noise);
        let before: f64 = before.unwrap().iter().map(|block| block.squares).sum();
        let relative = (before - squares) / test.statistic;
        assert!((0.5..1.5).contains(&relative), "{relative}");
        let [column] = model.columns_of(stall)[..] else {
            panic!("one coefficient");
        };
        let estimate = test.one_step[0];
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
        assert!(strongest.ln_p > threshold, "{strongest:?}");
    }
}
