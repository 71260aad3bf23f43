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
use crate::predict::{Added, Target, linearise_with_terms, targets};
use crate::problem::{FitProblem, RESIDUAL_TOLERANCE};
use crate::report::{FlightEvidence, MissingTerm};

/// Largest deviation of a quantity from its mean, in its standard deviations, that counts: a ratio may have poles.
const MAX_DEVIATION: f64 = 3.0;

/// Correlation over all samples above which two quantities are one.
const SAME: f64 = 0.98;

/// Maximum number of quantities.
const MAX_QUANTITIES: usize = 20;

/// Maximum number of samples of all flights by which quantities are compared: more would fill the memory.
pub(super) const MAX_COMPARED: usize = 50_000;

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

/// What a term may follow, with its name.
pub(super) struct Source {
    name: String,
    kind: SourceKind,
}

#[derive(Clone, Copy)]
enum SourceKind {
    Time,
    /// Scalar of the model, by its index among the quantities of the layout.
    Quantity(usize),
    State(usize),
}

impl Source {
    /// The time, the model's scalars and its states.
    pub fn all(problem: &FitProblem) -> Vec<Self> {
        let layout = problem.body.layout();
        let source = |name: &str, kind| Self {
            name: name.to_owned(),
            kind,
        };
        let scalars = problem.model.aux_variables.iter();
        let scalars = scalars.filter(|own| own.value.shape == Shape::Scalar);
        let scalars = scalars.filter_map(|own| {
            let mut quantities = layout.quantities.iter();
            let place = quantities.position(|name| *name == own.name)?;
            Some(source(&own.name, SourceKind::Quantity(place)))
        });
        let states = layout.states.iter().enumerate();
        let states = states.map(|(index, name)| source(name, SourceKind::State(index)));
        let time = source("time", SourceKind::Time);
        std::iter::once(time).chain(scalars).chain(states).collect()
    }

    fn value(&self, time: f64, quantities: &[f64], state: &[f64]) -> f64 {
        match self.kind {
            SourceKind::Time => time,
            SourceKind::Quantity(index) => quantities[index],
            SourceKind::State(index) => state[index],
        }
    }
}

/// Values of each source at each sample of a flight, or at one of `every`.
pub(super) fn compared(
    sources: &[Source],
    evidence: &FlightEvidence,
    every: usize,
) -> Vec<Vec<f64>> {
    let values = |source: &Source| {
        let samples = (0..evidence.times.len()).step_by(every);
        let value = |sample: usize| {
            let quantities = &evidence.quantities[sample];
            source.value(evidence.times[sample], quantities, &evidence.states[sample])
        };
        samples.map(value).collect()
    };
    sources.iter().map(values).collect()
}

/// A quantity that a term may follow, less its mean, over its standard deviation.
struct Quantity {
    source: Source,
    mean: f64,
    deviation: f64,
}

impl Quantity {
    /// The quantity of a source with values by flight; `None` if they do not vary.
    fn new(source: Source, values: &[&[f64]]) -> Option<Self> {
        let all = || values.iter().copied().flatten();
        let (mean, deviation) = (all().mean(), all().std_dev());
        let varies = deviation.is_finite() && deviation > f64::EPSILON.sqrt() * mean.abs();
        varies.then_some(Self {
            source,
            mean,
            deviation,
        })
    }

    /// The scaled value; 0 where the quantity has none.
    fn scaled(&self, value: f64) -> f64 {
        let scaled = (value - self.mean) / self.deviation;
        match scaled.is_nan() {
            true => 0.0,
            false => scaled.clamp(-MAX_DEVIATION, MAX_DEVIATION),
        }
    }
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
        let quantities = quantities(problem, flights);
        let targets = targets(problem, first.observed, fit.global());
        let reduced = parallel::each_on(threads, flights.len(), |index| {
            reduce(fit, &flights[index], &targets, &quantities)
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
                changes_with: follows.map(|index| quantities[index].source.name.clone()),
                tests: scores.len(),
                p_value: combined_p_value(p_values),
            }
        }))
    }
}

/// Normal equations of a flight without its local parameters; `None` if its initial state is not free.
fn reduce(
    fit: &Fit,
    flight: &FittedFlight<'_>,
    targets: &[Target],
    quantities: &[Quantity],
) -> Result<Option<Reduced>, FitError> {
    let Some(at) = fit.at(flight.id) else {
        return Ok(None);
    };
    let conditions = at.bound();
    let mut observer = conditions.observer();
    // Functions of time that are added: 1, then the quantities.
    let mut functions = |time: f64, state: &[f64]| {
        let values = observer.quantities(time, state);
        let each = quantities.iter();
        let each = each.map(|own| own.scaled(own.source.value(time, &values, state)));
        std::iter::once(1.0).chain(each).collect()
    };
    let added = Added {
        targets,
        functions: 1 + quantities.len(),
        at: &mut functions,
    };
    let found = linearise_with_terms(at, fit.noise(), added);
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

/// The sources as far as they vary and differ from each other.
fn quantities(problem: &FitProblem, flights: &[FittedFlight<'_>]) -> Vec<Quantity> {
    let mut kept: Vec<(Quantity, Vec<f64>)> = Vec::new();
    for (index, source) in Source::all(problem).into_iter().enumerate() {
        let values = flights.iter().map(|flight| &flight.compared[index][..]);
        let values: Vec<&[f64]> = values.collect();
        let Some(quantity) = Quantity::new(source, &values) else {
            continue;
        };
        let scaled = values.into_iter().flatten();
        let scaled: Vec<f64> = scaled.map(|value| quantity.scaled(*value)).collect();
        let is_known = kept.iter().any(|(_, other)| is_same(other, &scaled));
        if kept.len() < MAX_QUANTITIES && !is_known {
            kept.push((quantity, scaled));
        }
    }
    kept.into_iter().map(|(quantity, _)| quantity).collect()
}

fn is_same(one: &[f64], other: &[f64]) -> bool {
    let pairs = || one.iter().zip(other);
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
