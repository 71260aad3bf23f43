//! Multiple shooting, a method that converges from poor initial values: the global parameters are fitted to short arcs
//! of all flights, each with its own initial state, and the arcs are joined until they are whole flights.
//!
//! Over a short arc, the motion depends on the parameters almost as its accelerations do, which is nearly linear. Arcs
//! from all parts of the flights cover all flow regimes, and a flight that cannot be integrated as a whole at the
//! present parameters can still be integrated in arcs.

use flight::parallel;
use nalgebra::DVector;

use super::FitError;
use super::horizon_continuation::{anneal_scale, fit_horizon};
use super::residual_cache::ResidualCache;
use super::state::State;
use super::wrong_minimum::{is_better, is_suspect};
use crate::initial_state;
use crate::least_squares::Unknowns;
use crate::observations::Observations;
use crate::predict::{Loss, linearise};
use crate::problem::FitProblem;

/// Duration of the first and shortest arcs, which are parts of a flight with separate initial states, s.
const ARC: f64 = 0.14;

/// Minimum number of samples of an arc, a part of a flight with its own initial state.
const MIN_ARC_SAMPLES: usize = 12;

/// Number of consecutive arcs of a flight that are joined into one longer arc.
const JOINED: usize = 3;

/// Minimum distance between the initial value of a parameter and its bounds, in units of the parameter's typical
/// magnitude. An initial value nearer to a bound is moved inwards.
const OFF_BOUND: f64 = 0.1;

/// Change of the sum of squares, if a parameter changes by its typical magnitude, below which the parameter is
/// considered to have no effect on the residuals.
const HIDDEN: f64 = 1e-6;

/// Maximum number of parameters for which other initial values are tried because the parameters do not change the
/// residuals.
const MAX_HIDDEN: usize = 2;

/// Fits all flights again by multiple shooting if the present fit may have ended in a wrong minimum: its residuals are
/// above the noise, a flight cannot be integrated, or a parameter is at a bound. `cache` contains the residuals for the
/// present values of the unknowns in `state`, which are replaced if the new fit is better. Returns the residuals for
/// the final values.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn shoot_again(state: &mut State<'_>, cache: ResidualCache) -> Result<ResidualCache, FitError> {
    let options = state.options;
    if options.is_past_deadline() || !is_suspect(state, &cache) {
        return Ok(cache);
    }
    options.stage_started("multiple shooting", state.flights.len());
    let mut cache = shoot_from(state, cache, &[])?;
    for start in without_effect(state) {
        if options.is_past_deadline() || !is_suspect(state, &cache) {
            break;
        }
        cache = shoot_from(state, cache, &[start])?;
    }
    Ok(cache)
}

/// Fits by multiple shooting from the model's values of the global parameters, except for those in `changed`, given as
/// (index of the global parameter, value). Replaces the values of the unknowns in `state` if the new fit is better, and
/// returns the residuals for the final values.
fn shoot_from(
    state: &mut State<'_>,
    cache: ResidualCache,
    changed: &[(usize, f64)],
) -> Result<ResidualCache, FitError> {
    let mut tried = state.clone();
    tried.limits.fill(f64::INFINITY);
    let Some(found) = shoot(&mut tried, changed)? else {
        return Ok(cache);
    };
    if is_better(&found, &cache) {
        *state = tried;
        return Ok(found);
    }
    state.steps = tried.steps;
    Ok(cache)
}

/// Finds global parameters that do not change the residuals at the present values of the other parameters, such as an
/// angle that appears only multiplied by a coefficient equal to 0. Returns two entries (index, initial value) for each
/// of them, with initial values between its bounds; empty if every parameter changes the residuals.
fn without_effect(state: &State<'_>) -> Vec<(usize, f64)> {
    let problem = state.problem;
    let loss = Loss::Huber(problem.sigma0);
    let mut effect = vec![0.0; problem.globals.len()];
    for (flight, local) in state.flights.iter().zip(&state.local) {
        let unknowns = (&state.global, local);
        let samples = flight.times.len();
        if let Ok(block) = linearise(problem, flight, unknowns, samples, Unknowns::All, loss) {
            for (index, effect) in effect.iter_mut().enumerate() {
                *effect += block.global[(index, index)];
            }
        }
    }
    let hidden = problem.globals.iter().zip(effect).enumerate();
    let hidden = hidden.filter_map(|(index, (global, effect))| {
        let (low, high) = global.constraint.bounds;
        let is_hidden = effect * global.x_scale.powi(2) < HIDDEN && (high - low).is_finite();
        let at = |part: f64| low + part * (high - low);
        is_hidden.then(|| [(index, at(0.25)), (index, at(0.75))])
    });
    hidden.take(MAX_HIDDEN).flatten().collect()
}

/// Fits arcs of increasing length (parts of flights with separate initial states) and then whole flights. `changed`
/// contains initial values that replace those of the model, as (index of the global parameter, value). Returns the
/// residuals after the fit of the whole flights; `None` if too few arcs can be fitted.
fn shoot(
    state: &mut State<'_>,
    changed: &[(usize, f64)],
) -> Result<Option<ResidualCache>, FitError> {
    let problem = state.problem;
    let starts = problem.globals.iter().map(|global| {
        let (low, high) = global.constraint.bounds;
        let inside = (OFF_BOUND * global.x_scale).min(0.5 * (high - low));
        global.model_value.clamp(low + inside, high - inside)
    });
    state.global = DVector::from_iterator(problem.globals.len(), starts);
    for &(parameter, value) in changed {
        state.global[parameter] = value;
    }
    let Some(mut arcs) = arcs(state)? else {
        return Ok(None);
    };
    loop {
        // Only few arcs may cover a flow regime; a loss with the median scale would treat them as outliers.
        let spread = ResidualCache::rms_scale;
        if let Err(error) = fit_horizon(&mut arcs, f64::INFINITY, spread) {
            return match error {
                FitError::NoUsableFlight(_) => Ok(None),
                error => Err(error),
            };
        }
        state.global.clone_from(&arcs.global);
        state.steps += std::mem::take(&mut arcs.steps);
        for (id, local) in state.ids.iter().zip(&mut state.local) {
            let mut found = arcs.ids.iter().zip(&arcs.flights).zip(&arcs.local);
            let first = found.find(|((arc, flight), _)| *arc == id && flight.times[0] == 0.0);
            if let Some((_, found)) = first {
                local.clone_from(found);
            }
        }
        if state.options.is_past_deadline() || !join(state, &mut arcs) {
            break;
        }
    }
    anneal_scale(state).map(Some)
}

/// Divides all flights into arcs, each with its initial guess; `None` if no arc has an initial guess.
fn arcs<'a>(state: &State<'a>) -> Result<Option<State<'a>>, FitError> {
    let (problem, options) = (state.problem, state.options);
    let mut cut = Vec::new();
    for (&id, flight) in state.ids.iter().zip(&state.flights) {
        let mut first = 0;
        while first < flight.times.len() {
            let end = flight.samples_until(flight.times[first] + ARC);
            let mut end = end.max(first + MIN_ARC_SAMPLES);
            if end + MIN_ARC_SAMPLES > flight.times.len() {
                end = flight.times.len();
            }
            cut.push((id, flight.arc(problem, first..end)));
            first = end;
        }
    }
    let guesses = parallel::each_on(options.threads(), cut.len(), |index| {
        match options.is_cancelled() {
            true => None,
            false => guess(problem, &cut[index].1),
        }
    });
    if options.is_cancelled() {
        return Err(FitError::Interrupted);
    }
    let mut arcs = state.without_flights();
    for ((id, arc), guess) in cut.into_iter().zip(guesses) {
        if let Some(guess) = guess {
            arcs.push(id, arc, guess);
        }
    }
    Ok((!arcs.flights.is_empty()).then_some(arcs))
}

fn guess(problem: &FitProblem, arc: &Observations) -> Option<DVector<f64>> {
    let guesses = initial_state::initial_guesses(problem, arc).ok()?;
    Some(guesses.into_iter().next()?.state)
}

/// Joins each group of `JOINED` consecutive arcs of a flight into one arc, with the initial state of the first arc;
/// returns `false` if all arcs are whole flights already.
fn join<'a>(state: &State<'a>, arcs: &mut State<'a>) -> bool {
    let joined = arcs.without_flights();
    let before = std::mem::replace(arcs, joined);
    let mut has_joined = false;
    for (id, flight) in state.ids.iter().zip(&state.flights) {
        let of_flight = (0..before.ids.len()).filter(|&arc| before.ids[arc] == *id);
        let of_flight: Vec<usize> = of_flight.collect();
        for group in of_flight.chunks(JOINED) {
            let (first, last) = (&before.flights[group[0]], group[group.len() - 1]);
            let end = before.flights[last].times.last().copied();
            let start = flight.times.partition_point(|time| *time < first.times[0]);
            let end = flight.samples_until(end.unwrap_or(first.times[0]));
            has_joined |= group.len() > 1;
            let arc = first.longer(flight, start..end);
            arcs.push(*id, arc, before.local[group[0]].clone());
        }
    }
    has_joined
}

#[cfg(test)]
mod tests {

    use super::*;
    use crate::fit::tests::simulated;
    use crate::options::FitOptions;
    use dataset::synthesize::Plan;

    #[test]
    fn an_angle_of_a_coefficient_that_vanishes_is_hidden() {
        let model = model_spec::load::load("disc", &["zero_lift_drag_angle"]).unwrap();
        let plan = Plan {
            flights: 2,
            duration: Some(0.3),
            ..Plan::default()
        };
        let dataset = simulated(&model, "backhand", &plan);
        let options = FitOptions::default();
        let problem = FitProblem::new(&model, &dataset, &options).unwrap();
        let place = |name: &str| {
            let mut globals = problem.globals.iter();
            globals.position(|global| global.name == name).expect(name)
        };
        let hidden_at = |drag: f64| {
            let mut global = problem.model_values();
            global[place("C_Da")] = drag;
            let mut state = State::new(&problem, &options, global, 1.0 / 120.0);
            for (index, flight) in dataset.flights.iter().enumerate() {
                let observations = Observations::new(&problem, flight).unwrap();
                let guesses = initial_state::initial_guesses(&problem, &observations).unwrap();
                state.push(
                    crate::ids::FlightId::new(index),
                    observations,
                    guesses[0].state.clone(),
                );
            }
            without_effect(&state)
        };
        let (low, high) = problem.globals[place("alpha_0")].constraint.bounds;
        let quarter = 0.25 * (high - low);
        let expected = [
            (place("alpha_0"), low + quarter),
            (place("alpha_0"), high - quarter),
        ];
        let found = hidden_at(0.0);
        assert_eq!(found.len(), 2);
        for ((index, value), (parameter, start)) in found.iter().zip(&expected) {
            assert_eq!(index, parameter);
            assert!((value - start).abs() < 1e-12, "{value} {start}");
        }
        assert!(hidden_at(1.0).is_empty());
    }
}
