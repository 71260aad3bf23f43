//! Trial of standard errors: whether the likelihood falls as they say.

use nalgebra::DVector;

use super::output_error::OutputError;
use super::reweighting::Reweighted;
use super::state::State;
use crate::least_squares::{
    Iterate, LeastSquaresProblem, ReducedSystem, Solution, StoppingCriteria, solve,
};
use crate::predict::Loss;
use crate::report::NonIdentifiable;
use crate::uncertainty::Covariance;

/// Number of standard errors at which the rise of the deviance is tried, and maximum number of coefficients.
const TRIED_ERRORS: (f64, usize) = (2.0, 2);

/// Rises of the deviance at [`TRIED_ERRORS`] standard errors with which a standard error holds within a factor of two.
const RISES: std::ops::Range<f64> = 1.0..16.0;

/// Criteria of the fit that gives a rise, which is reported to a tenth.
const RISE: StoppingCriteria = StoppingCriteria {
    ftol_abs: 0.1,
    ..StoppingCriteria::CONVERGED
};

/// Standard errors of the least identifiable directions that the likelihood contradicts: at [`TRIED_ERRORS`] standard errors,
/// with all else fitted again, the deviance does not rise by about the square of that number.
pub fn contradicted_errors(
    state: &State<'_>,
    fitted: &Reweighted,
    (system, covariance): (&ReducedSystem<'_>, &Covariance),
    directions: &[NonIdentifiable],
) -> Vec<String> {
    let (problem, options) = (state.problem, state.options);
    // The fits of a diagnosis, whose faults are known, compare models; none of them is reported.
    if directions.is_empty() || options.known_faults.is_some() {
        return Vec::new();
    }
    let loss = Loss::Whitened(&fitted.noise);
    let mut objective = OutputError::of_all(problem, &state.flights, loss, options);
    let names = directions.iter().filter_map(|d| d.combination.first());
    let mut found = Vec::new();
    for name in names.take(TRIED_ERRORS.1) {
        let Some(index) = problem.globals.iter().position(|own| own.name == *name) else {
            continue;
        };
        let best = &fitted.solution.iterate;
        let variance = covariance.model[(index, index)];
        let bounds = objective.constraints[index].bounds;
        for side in [-TRIED_ERRORS.0, TRIED_ERRORS.0] {
            let value = best.global[index] + side * variance.sqrt();
            if !(bounds.0..=bounds.1).contains(&value) || options.is_past_deadline() {
                continue;
            }
            objective.constraints[index].bounds = (value, value);
            // The other unknowns start where the normal equations put them.
            let step = covariance.model.column(index) * (side / variance.sqrt());
            let mut alone = best.clone();
            alone.global[index] = value;
            let starts = [moved(best, &objective, system, &step), alone];
            let Some(moved) = fit_from(&objective, starts) else {
                continue;
            };
            let rise = moved.squares - fitted.solution.squares;
            if !RISES.contains(&rise) {
                let why = format!(
                    "the standard error of {name} does not hold: at {side} standard errors the deviance changes by {rise:.1}, not by {}",
                    TRIED_ERRORS.0 * TRIED_ERRORS.0
                );
                found.push(why);
                break;
            }
        }
        objective.constraints[index].bounds = bounds;
    }
    found
}

/// Fit from the first of `starts` at which all flights can be predicted; `None` if there is none.
fn fit_from(objective: &OutputError<'_>, starts: [Iterate; 2]) -> Option<Solution> {
    let mut fits = starts
        .into_iter()
        .map(|start| solve(objective, start, RISE));
    fits.find_map(Result::ok)
}

/// The iterate `from` after a step of the global parameters, within their bounds; the local parameters follow by the
/// normal equations `system` at `from`.
fn moved(
    from: &Iterate,
    objective: &OutputError<'_>,
    system: &ReducedSystem<'_>,
    step: &DVector<f64>,
) -> Iterate {
    let constraints = objective.constraints.iter().zip(from.global.iter());
    let each = constraints.zip(step.iter()).map(|((own, value), step)| {
        let (low, high) = own.bounds;
        (value + step).clamp(low, high)
    });
    let global = DVector::from_iterator(step.len(), each);
    let steps = system.back_substitute(&(&global - &from.global));
    let steps = steps.iter().zip(&from.local).enumerate();
    let local = steps.map(|(flight, (step, local))| objective.plus(flight, local, step));
    Iterate {
        local: local.collect(),
        global,
    }
}
