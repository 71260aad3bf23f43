//! Missing terms: score tests of whether the residuals fit better if a coefficient, or the rate of a state, has a further
//! term that follows a quantity of the flight. A force or moment that the model lacks is one that its coefficients, as
//! constants, absorb.
//!
//! The fit takes whatever constants absorb best, so that residuals alone may pass as noise while estimates are far off.

use std::f64::consts::PI;

use flight::parallel;
use model_spec::model::Shape;
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, StudentsT};
use statrs::statistics::Statistics;

use super::FittedFlight;
use crate::error::FitError;
use crate::fit::{Fit, flight_error};
use crate::least_squares::{
    NormalBlock, SchurComplement, TestedParameters, add_priors, pseudo_inverse,
};
use crate::predict::{Target, linearise_with_terms, targets};
use crate::problem::RESIDUAL_TOLERANCE;
use crate::report::MissingTerm;

/// Largest deviation of a quantity from its mean, in its standard deviations, that counts: a ratio may have poles.
const MAX_DEVIATION: f64 = 3.0;

/// Correlation over all samples above which two quantities are one.
const SAME: f64 = 0.98;

/// Maximum number of quantities.
const MAX_QUANTITIES: usize = 20;

/// Part of a term's information beyond that of the constants, below which it is not tested: rounding would decide.
const MIN_TOLERANCE: f64 = 1e-6;

/// Least and greatest p-value that is combined with others: one of 0 or 1 alone would decide.
const P_VALUES: (f64, f64) = (1e-150, 0.99);

/// A flight without its local parameters.
struct Reduced {
    constants: DMatrix<f64>,
    gradient: DVector<f64>,
    tested: TestedParameters,
    /// Number of residuals.
    count: usize,
}

/// A quantity that a term may follow: its name, and its values by flight and sample, of mean 0 and deviation 1.
struct Quantity {
    name: String,
    values: Vec<Vec<f64>>,
}

impl MissingTerm {
    /// The most significant missing term of `fit`; `None` if none can be tested.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a trajectory cannot be integrated.
    pub(super) fn of_fit(
        fit: &Fit,
        flights: &[FittedFlight<'_>],
        threads: usize,
    ) -> Result<Option<Self>, FitError> {
        let problem = fit.problem();
        let Some(first) = flights.first() else {
            return Ok(None);
        };
        let quantities = quantities(fit, flights);
        let targets = targets(problem, first.observed, fit.global());
        let reduced = parallel::each_on(threads, flights.len(), |index| {
            reduce(fit, &flights[index], &targets, (&quantities, index))
        });
        let reduced: Vec<Option<Reduced>> = reduced.into_iter().collect::<Result<_, _>>()?;
        let reduced: Vec<Reduced> = reduced.into_iter().flatten().collect();
        let functions = 1 + quantities.len();
        let is_constant = |test: usize| {
            let target = targets[test / functions];
            test.is_multiple_of(functions) && matches!(target, Target::Coefficient(_))
        };
        let scores = scores(fit, &reduced, is_constant).unwrap_or_default();
        let largest = scores.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        Ok(largest.map(|&(test, _)| {
            let count: usize = reduced.iter().map(|flight| flight.count).sum();
            let by_integration = RESIDUAL_TOLERANCE * problem.sigma0 / fit.noise().overall();
            let by = StudentsT::new(0.0, 1.0, count as f64);
            let p_values = scores.iter().map(|(_, chi2)| {
                let score = chi2.sqrt() / by_integration.max(1.0);
                by.map_or(1.0, |by| 2.0 * by.sf(score))
            });
            let follows = (test % functions).checked_sub(1);
            Self {
                target: match targets[test / functions] {
                    Target::Coefficient(id) => problem.globals[id.index()].name.clone(),
                    Target::Rate(state) => {
                        format!("der({})", problem.model.states[state.index()].name)
                    }
                },
                changes_with: follows.map(|index| quantities[index].name.clone()),
                tests: scores.len(),
                p_value: combined_p_value(p_values),
            }
        }))
    }
}

/// Normal equations without its local parameters of a flight, whose values of the quantities have an index; `None` if its
/// initial state is not free.
fn reduce(
    fit: &Fit,
    flight: &FittedFlight<'_>,
    targets: &[Target],
    (quantities, index): (&[Quantity], usize),
) -> Result<Option<Reduced>, FitError> {
    let Some(at) = fit.at(flight.id) else {
        return Ok(None);
    };
    // Functions of time that are added, one per column: 1, then the quantities.
    let functions = 1 + quantities.len();
    let weights = DMatrix::from_fn(at.samples, functions, |sample, k| match k {
        0 => 1.0,
        k => quantities[k - 1].values[index][sample],
    });
    let found = linearise_with_terms(at, fit.noise(), (targets, &weights));
    let found = found.map_err(|reason| flight_error(at.observations, reason))?;
    Ok(found.and_then(|(block, tested): (NormalBlock, _)| {
        let without = SchurComplement::new(&block, 0.0)?;
        let tested = without.tested(&block, tested);
        let is_finite = tested.information.iter().all(|own| own.is_finite());
        is_finite.then_some(Reduced {
            constants: without.reduced,
            gradient: without.gradient,
            tested,
            count: block.count,
        })
    }))
}

/// The terms that can be tested, with χ² of the score test of each; `None` if the flights do not determine the constants.
fn scores(
    fit: &Fit,
    flights: &[Reduced],
    is_constant: impl Fn(usize) -> bool,
) -> Option<Vec<(usize, f64)>> {
    let (first, others) = flights.split_first()?;
    let (mut constants, mut gradient) = (first.constants.clone(), first.gradient.clone());
    let mut tested = first.tested.clone();
    for flight in others {
        constants += &flight.constants;
        gradient += &flight.gradient;
        tested.by_global += &flight.tested.by_global;
        tested.score += &flight.tested.score;
        tested.information += &flight.tested.information;
    }
    let constraints = fit.problem().globals.iter().map(|own| &own.constraint);
    add_priors((&mut constants, &mut gradient), fit.global(), constraints);
    let through = pseudo_inverse(&constants)? * &tested.by_global;
    let each = tested.information.iter().enumerate();
    let scores = each.filter_map(|(test, &information)| {
        let through = through.column(test);
        let left = information - through.dot(&tested.by_global.column(test));
        let is_tested = !is_constant(test) && left > MIN_TOLERANCE * information;
        let chi2 = (tested.score[test] - through.dot(&gradient)).powi(2) / left;
        is_tested.then_some((test, chi2))
    });
    Some(scores.collect())
}

/// p-value of all tests together, however they depend on each other: the mean of the Cauchy variates of their p-values has
/// nearly the distribution of one in its tail (Y. Liu and J. Xie, "Cauchy combination test", Journal of the American
/// Statistical Association 115, 2020). Equal tests count as one, where Bonferroni's correction would count each.
fn combined_p_value(p_values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = p_values.len() as f64;
    let variates = p_values.map(|p| 1.0 / (PI * p.clamp(P_VALUES.0, P_VALUES.1)).tan());
    (count / variates.sum::<f64>()).atan().rem_euclid(PI) / PI
}

/// The time, the model's scalar quantities and its states, as far as they vary and differ from each other.
fn quantities(fit: &Fit, flights: &[FittedFlight<'_>]) -> Vec<Quantity> {
    let model = &fit.problem().model;
    let scalars = model.aux_variables.iter();
    let scalars = scalars.filter(|own| own.value.shape == Shape::Scalar);
    let names = std::iter::once("time".to_owned()).chain(scalars.map(|own| own.name.clone()));
    let names: Vec<String> = names
        .chain(model.states.iter().map(|state| state.name.clone()))
        .collect();
    let series = flights.iter().map(|FittedFlight { evidence, .. }| {
        let of = |name: &String| -> Vec<f64> {
            let of = |names: &[String], values: &[Vec<f64>]| -> Option<Vec<f64>> {
                let place = names.iter().position(|own| own == name)?;
                values.iter().map(|row| row.get(place).copied()).collect()
            };
            of(&evidence.quantity_names, &evidence.quantities)
                .or_else(|| of(&evidence.state_names, &evidence.states))
                .unwrap_or_else(|| evidence.times.clone())
        };
        names.iter().map(of).collect()
    });
    let series: Vec<Vec<Vec<f64>>> = series.collect();
    let mut kept: Vec<Quantity> = Vec::new();
    for (index, name) in names.into_iter().enumerate() {
        let own = series.iter().map(|flight| flight[index].clone());
        let Some(values) = scaled(own.collect()) else {
            continue;
        };
        if kept.len() < MAX_QUANTITIES && !kept.iter().any(|other| is_same(other, &values)) {
            kept.push(Quantity { name, values });
        }
    }
    kept
}

/// Values less their mean, over their standard deviation; `None` if they do not vary.
fn scaled(mut values: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let (mean, deviation) = {
        let all = || values.iter().flatten();
        (all().mean(), all().std_dev())
    };
    if !(deviation.is_finite() && deviation > f64::EPSILON.sqrt() * mean.abs()) {
        return None;
    }
    for value in values.iter_mut().flatten() {
        *value = ((*value - mean) / deviation).clamp(-MAX_DEVIATION, MAX_DEVIATION);
    }
    Some(values)
}

fn is_same(one: &Quantity, other: &[Vec<f64>]) -> bool {
    let pairs = || one.values.iter().flatten().zip(other.iter().flatten());
    let sum = |of: fn(f64, f64) -> f64| pairs().map(|(a, b)| of(*a, *b)).sum::<f64>();
    sum(|a, b| a * b).abs() > SAME * (sum(|a, _| a * a) * sum(|_, b| b * b)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::combined_p_value;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha12Rng;
    use rand_distr::StandardNormal;
    use statrs::distribution::{ContinuousCDF, Normal};

    #[test]
    fn tests_together_have_their_level_however_they_depend_on_each_other() {
        let mut random = ChaCha12Rng::seed_from_u64(1);
        let by = Normal::standard();
        for common in [0.0f64, 0.5, 0.95] {
            let draws = 20_000;
            let is_significant = |_: &usize| {
                let shared: f64 = random.sample(StandardNormal);
                let p_values: Vec<f64> = (0..30)
                    .map(|_| {
                        let own: f64 = random.sample(StandardNormal);
                        let score = common.sqrt() * shared + (1.0 - common).sqrt() * own;
                        2.0 * by.sf(score.abs())
                    })
                    .collect();
                combined_p_value(p_values.into_iter()) < 0.01
            };
            let rate = (0..draws).filter(is_significant).count() as f64 / draws as f64;
            assert!(
                (0.007..0.016).contains(&rate),
                "correlation {common}: {rate}"
            );
        }
        assert!((combined_p_value([0.02; 7].into_iter()) - 0.02).abs() < 1e-12);
        assert!(combined_p_value([0.0, 1.0].into_iter()) < 1e-100);
    }
}
