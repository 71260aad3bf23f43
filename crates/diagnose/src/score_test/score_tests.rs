//! Score tests of all candidate effects and library terms at one linearization point.

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

/// Minimum tolerance 1 − R² of a tested direction, where R² is the fraction of its squared sensitivity that the
/// nuisance parameters explain. Below this tolerance, integration errors dominate and the direction is not tested.
pub(crate) const MIN_TOLERANCE: f64 = 1e-8;

/// Seed of the simulated null distribution from which the familywise significance thresholds are computed.
const THRESHOLD_SEED: u64 = 1;

/// Score tests of candidate effects and library terms. The parameters of the model under test, and of candidates that
/// are included in the null hypothesis, are nuisance parameters.
#[derive(Clone, Debug)]
pub(crate) struct ScoreTests {
    /// Test of each candidate effect; `None` if the parameters of the candidate are nuisance parameters.
    pub candidates: IndexVec<CandidateId, Option<ScoreTest>>,
    /// Test of each library term; empty if the normal equations have no columns for library terms.
    pub terms: IndexVec<TermId, ScoreTest>,
    /// Partition of the columns of the normal equations into nuisance and tested columns.
    pub partition: Partition,
    /// Effective information of the tested unknowns, with rows and columns multiplied by the factors in `scale`.
    /// Without the projection of the nuisance parameters, the diagonal would be 1.
    pub information: DMatrix<f64>,
    /// Effective scores of the tested unknowns, each multiplied by its entry in `scale`.
    pub score: DVector<f64>,
    /// Factor by which the Jacobian column of each tested unknown is multiplied, so that its norm is 1 after
    /// eliminating the local parameters.
    pub scale: Vec<f64>,
    /// Coefficients of the projection of the Jacobian columns of the tested unknowns on those of the nuisance
    /// parameters: one row for each nuisance parameter, one column for each tested unknown, in the order of
    /// `partition`. Each column is multiplied by the unknown's entry in `scale`.
    pub nuisance_projection: DMatrix<f64>,
    /// Information matrix of the nuisance parameters, in the order of `partition`, after eliminating the local
    /// parameters. Includes the priors; `scale` is not applied.
    pub nuisance_information: DMatrix<f64>,
    /// For each tested unknown: squared norm of its Jacobian column before and after elimination of the local
    /// parameters.
    pub norms: Vec<ColumnNorms>,
    pub(super) nuisance_step: DVector<f64>,
    /// For each test with at least one degree of freedom: matrix that maps the effective scores of all tested columns
    /// to independent standard normal variables; one matrix column for each tested column.
    whitenings: Vec<DMatrix<f64>>,
    /// Number of tests of candidate effects that are represented by states with one value for each flight. These states
    /// have no column in the normal equations of the global parameters.
    state_tests: usize,
}

/// Squared norms of one column of the whitened Jacobian, before and after elimination of the flights' initial states.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ColumnNorms {
    /// Squared norm of the column before the elimination, over all flights.
    pub total: f64,
    /// Squared norm of the column of the whitened Jacobian after projection orthogonal to the derivatives with respect
    /// to each flight's initial state, plus the precision 1/σ² of the parameter's prior if it has one.
    pub locals_eliminated: f64,
}

/// Score test of one candidate effect or library term.
#[derive(Clone, Debug)]
pub(crate) struct ScoreTest {
    /// Score statistic: the decrease of the weighted sum of squares that a refit would give, to second order.
    /// Distributed as χ² with `degrees_of_freedom` degrees of freedom under the null hypothesis.
    pub score_chi2: f64,
    /// Degrees of freedom: number of principal directions of the tested columns whose tolerance 1 − R² exceeds
    /// [`MIN_TOLERANCE`]. R² is the fraction of a direction's squared sensitivity that the nuisance parameters explain.
    pub degrees_of_freedom: usize,
    /// Natural logarithm of the p-value.
    pub ln_p_value: f64,
    /// One-step estimates of the coefficients, with all other candidate effects at their null value; empty for a
    /// candidate that is represented by states.
    pub one_step_estimates: Vec<OneStepEstimate>,
    /// Tolerance 1 − R² of the best determined direction: the fraction of its squared sensitivity that the nuisance
    /// parameters do not explain.
    pub tolerance: f64,
}

/// One-step estimate of a coefficient, without a refit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OneStepEstimate {
    /// Column of the coefficient in the normal equations.
    pub column: ColumnId,
    /// Estimated value of the coefficient, SI.
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
    /// Computes the score tests at the linearization point of the normal equations `blocks`, one block for each flight.
    /// `global` are the values of the global parameters at this point. The parameters of the candidate effects in
    /// `conditioned_on` are nuisance parameters and not tested.
    ///
    /// # Errors
    /// [`DiagnosisError::UndeterminedInitialState`] if the samples of a flight do not determine its initial state;
    /// [`DiagnosisError::SingularInformation`] if the information of the nuisance parameters cannot be inverted.
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

    /// Joint score test of the coefficients with the columns `own` of the normal equations. `values` are the values of
    /// all global parameters and term coefficients at the linearization point.
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

    /// Familywise thresholds: for each of `levels`, the log p-value below which the smallest p-value of all tests falls
    /// with a probability of that level under the null hypothesis.
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

    /// Decrease of the weighted sum of squares, to second order, by jointly fitting the coefficients of all tested
    /// columns for which `wanted` returns true, together with the nuisance parameters.
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

    /// Returns a function that maps a column of the normal equations to the standard error, SI, of the nuisance
    /// parameter to which the column belongs; 0 for columns of tested parameters. Unknowns of effects that are included
    /// in the null hypothesis are nuisance parameters.
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
    /// Test of the candidate effect's states, one value for each flight. `nuisance_decrease` is the decrease of the sum
    /// of squares by the nuisance parameters with the states estimated, minus the decrease with the states at their
    /// null values.
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

/// Decrease of the weighted sum of squares, to second order, by fitting the unknowns that belong to `columns` of the
/// normal equations; all other unknowns remain fixed.
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
}
