//! Other starts of a fit that may have ended in a wrong minimum.

use flight::parallel;
use nalgebra::DVector;

use super::FitError;
use super::horizon_continuation::{anneal_scale, continue_horizon, fit_horizon};
use super::initial_guess::{MIN_SEGMENT_SAMPLES, first_segment};
use super::output_error::{FixedGlobal, FlightAlone};
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::error::FlightError;
use crate::initial_state::{self, InitialGuess};
use crate::least_squares::Unknowns;
use crate::observations::Observations;
use crate::observers::ChannelConditions;
use crate::predict::{FlightAt, Loss};
use crate::problem::FitProblem;
use dataset::levels::FAR_ABOVE;

/// Maximum ratio of the rms residual scale of a new fit to that of the present one, for it to be accepted.
const ACCEPTED_RATIO: f64 = 0.98;

/// Maximum number of restarts from corrected samples, each with a better estimate of the distortion.
const MAX_STARTS: usize = 3;

/// Maximum number of corrections of samples, each with the distortion at the initial state of the one before.
const PASSES: usize = 4;

/// Duration of the shortest arcs, parts of a flight with separate initial states, s, and number of consecutive arcs that
/// are joined into a longer one.
const ARCS: (f64, usize) = (0.14, 3);

/// Minimum distance of an initial value from its bounds, in typical magnitudes.
const OFF_BOUND: f64 = 0.1;

/// Change of the sum of squares by a change of a typical magnitude, below which a parameter has no effect, and maximum
/// number of such parameters for which other initial values are tried.
const WITHOUT_EFFECT: (f64, usize) = (1e-6, 2);

/// Fit in progress that arrives from another start, and its residuals.
type Arrival<'a> = (State<'a>, ResidualCache);

/// Tries other starts as long as the fit may have ended in a wrong minimum: samples corrected for the distortion that
/// the present parameters predict; multiple shooting from the model's values; and other values of parameters that have
/// no effect, from the present ones and by multiple shooting. A better fit replaces the present one; its residuals are returned.
pub fn restart(state: &mut State<'_>, mut cache: ResidualCache) -> Result<ResidualCache, FitError> {
    for _ in 0..MAX_STARTS {
        if !take_better(state, &mut cache, from_undistorted)? {
            break;
        }
    }
    take_better(state, &mut cache, |state| shoot(state, None))?;
    if is_suspect(state, &cache) {
        for start in without_effect(state) {
            take_better(state, &mut cache, |state| moved(state, start))?;
            take_better(state, &mut cache, |state| shoot(state, Some(start)))?;
        }
    }
    Ok(cache)
}

/// Replaces the fit by the proposed one if it may have ended in a wrong minimum and the proposed one is better. Returns
/// whether it is.
fn take_better<'a>(
    state: &mut State<'a>,
    cache: &mut ResidualCache,
    propose: impl FnOnce(&State<'a>) -> Result<Option<Arrival<'a>>, FitError>,
) -> Result<bool, FitError> {
    if state.options.is_past_deadline() || !is_suspect(state, cache) {
        return Ok(false);
    }
    let Some((tried, found)) = propose(state)? else {
        return Ok(false);
    };
    let is_better = is_better(&found, cache);
    if is_better {
        (*state, *cache) = (tried, found);
    } else {
        state.steps = tried.steps;
    }
    Ok(is_better)
}

/// Whether a fit may have ended in a wrong minimum: residuals above the noise, a failed flight, or a parameter at a
/// bound.
fn is_suspect(state: &State<'_>, cache: &ResidualCache) -> bool {
    let problem = state.problem;
    let mut globals = problem.globals.iter().zip(state.global.iter());
    let is_driven_to_bound = globals.any(|(global, &value)| {
        let (low, high) = global.constraint.bounds;
        (value <= low && global.model_value > low) || (value >= high && global.model_value < high)
    });
    is_driven_to_bound || !cache.failures().is_empty() || problem.is_misfit(cache.median_scale())
}

/// Whether `found` is better than `before`: fewer trajectories fail, or as many and the residuals are clearly smaller.
fn is_better(found: &ResidualCache, before: &ResidualCache) -> bool {
    let (failed, failed_before) = (found.failures().len(), before.failures().len());
    failed < failed_before
        || failed == failed_before && found.rms_scale() < ACCEPTED_RATIO * before.rms_scale()
}

// Corrected samples. Estimated parameters of the measurement may distort the samples: late recording, a scale,
// misplaced markers. Their poses then show another motion than that of the body.

/// Initial guesses from the samples; if the parameters predict a distortion, one from corrected samples follows.
pub fn initial_guesses(flight: FlightAlone<'_>) -> Result<Vec<InitialGuess>, FlightError> {
    let mut guesses = initial_state::initial_guesses(flight.at.problem, flight.observations)?;
    let found = undistorted_guess(flight, &guesses[0].state);
    guesses.extend(found.map(|state| InitialGuess {
        state,
        turns: 0,
        speed: 0,
    }));
    Ok(guesses)
}

/// Guess from samples that are corrected for the distortion by the parameters, from the initial state `local`.
fn undistorted_guess(flight: FlightAlone<'_>, local: &DVector<f64>) -> Option<DVector<f64>> {
    let (at, observations) = (flight.at, flight.observations);
    let first = observations.first_samples(first_segment(observations));
    let mut found: Option<DVector<f64>> = None;
    for _ in 0..PASSES {
        let local = found.as_ref().unwrap_or(local);
        let undistorted = without_distortion(FlightAt::new(at.problem, &first, (at.global, local)));
        let Some(next) = undistorted.and_then(|undistorted| guess(at.problem, &undistorted)) else {
            break;
        };
        found = Some(next);
    }
    found
}

fn guess(problem: &FitProblem, observations: &Observations) -> Option<DVector<f64>> {
    let guesses = initial_state::initial_guesses(problem, observations).ok()?;
    Some(guesses.into_iter().next()?.state)
}

/// Fits from the present parameters of the measurement, the model's values of the others, and initial states by
/// corrected samples; `None` if no parameter distorts the samples noticeably.
fn from_undistorted<'a>(state: &State<'a>) -> Result<Option<Arrival<'a>>, FitError> {
    let (problem, options) = (state.problem, state.options);
    let mut global = problem.model_values();
    let (observations, local) = (&state.flights[0], &state.local[0]);
    let first = observations.first_samples(first_segment(observations));
    let of_measurement = (0..global.len()).filter(|&index| {
        let mut changed = global.clone();
        changed[index] = state.global[index];
        without_distortion(FlightAt::new(problem, &first, (&changed, local))).is_some()
    });
    let of_measurement: Vec<usize> = of_measurement.collect();
    if of_measurement.is_empty() {
        return Ok(None);
    }
    for index in of_measurement {
        global[index] = state.global[index];
    }
    let at = FixedGlobal {
        global: &global,
        ..state.fixed_global()
    };
    let found = parallel::each_on(options.threads(), state.flights.len(), |flight| {
        let flight = at.flight(&state.flights[flight]);
        let as_seen = guess(problem, flight.observations)?;
        let guess = undistorted_guess(flight, &as_seen)?;
        let first = flight.first(first_segment(flight.observations));
        Some(first.fit(guess).ok()?.1)
    });
    options.stage_started("undistorted samples", state.flights.len());
    let mut started = state.clone();
    started.limits.fill(f64::INFINITY);
    started.move_to(found);
    started.global = global;
    let cache = continue_horizon(&mut started)?;
    Ok(Some((started, cache)))
}

/// Samples less the distortion: the predicted marker positions with the global parameters less those with the model's
/// values on the same trajectory. `None` if it is negligible, or the pose is not that of markers alone.
fn without_distortion(at: FlightAt<'_>) -> Option<Observations> {
    let (problem, observations) = (at.problem, at.observations);
    if !problem.points.are_markers {
        return None;
    }
    let trajectory = at.states().ok()?;
    let bound = [at.global, &problem.model_values()]
        .map(|global| ChannelConditions::new(problem, &observations.parameters(problem, global)));
    let [mut distorted, mut plain] = bound.each_ref().map(ChannelConditions::observers);
    let mut found = observations.clone();
    let mut greatest: f64 = 0.0;
    for (sample, time, state) in observations.along(&trajectory) {
        for marker in 0..observations.markers {
            let Some(point) = &mut found.measured[sample * observations.channels + marker] else {
                continue;
            };
            let seen = distorted.residual(time, state, marker, [0.0; 3]);
            let shift = plain.residual(time, state, marker, seen);
            for (coordinate, shift) in point.iter_mut().zip(shift) {
                *coordinate += shift;
                greatest = greatest.max(shift.abs());
            }
        }
    }
    let is_distorted = greatest.is_finite() && greatest > FAR_ABOVE * problem.sigma0;
    is_distorted.then_some(found)
}

// Multiple shooting converges from poor initial values: the global parameters are fitted to short arcs of all flights,
// each with its own initial state, and the arcs are joined until they are whole flights. Over an arc, the motion depends
// on the parameters almost linearly, arcs cover all flow regimes, and they can be integrated where a flight cannot.

/// Parameters that change no residuals at the present values, such as an angle of a coefficient equal to 0: two entries
/// (index, initial value) for each.
fn without_effect(state: &State<'_>) -> Vec<(usize, f64)> {
    let problem = state.problem;
    let loss = Loss::Huber(problem.sigma0);
    let mut effect = vec![0.0; problem.globals.len()];
    for flight in 0..state.flights.len() {
        if let Ok(block) = state.at(flight).linearise(Unknowns::All, loss) {
            for (index, effect) in effect.iter_mut().enumerate() {
                *effect += block.global[(index, index)];
            }
        }
    }
    let hidden = problem.globals.iter().zip(effect).enumerate();
    let hidden = hidden.filter_map(|(index, (global, effect))| {
        let (low, high) = global.constraint.bounds;
        let is_hidden =
            effect * global.x_scale.powi(2) < WITHOUT_EFFECT.0 && (high - low).is_finite();
        let at = |part: f64| low + part * (high - low);
        is_hidden.then(|| [(index, at(0.25)), (index, at(0.75))])
    });
    hidden.take(WITHOUT_EFFECT.1).flatten().collect()
}

/// Fits whole flights from the present values but for the parameter `changed` (index, value): where it vanishes, so do
/// the derivatives by what it multiplies, such as an unknown spin.
fn moved<'a>(
    state: &State<'a>,
    (parameter, value): (usize, f64),
) -> Result<Option<Arrival<'a>>, FitError> {
    let mut state = state.clone();
    state.limits.fill(f64::INFINITY);
    state.global[parameter] = value;
    let cache = anneal_scale(&mut state)?;
    Ok(Some((state, cache)))
}

/// Fits arcs of increasing length, then whole flights, from the model's values but for the parameter `changed` (index,
/// value); `None` if too few arcs can be fitted.
fn shoot<'a>(
    state: &State<'a>,
    changed: Option<(usize, f64)>,
) -> Result<Option<Arrival<'a>>, FitError> {
    let options = state.options;
    options.stage_started("multiple shooting", state.flights.len());
    let mut state = state.clone();
    state.limits.fill(f64::INFINITY);
    for (value, global) in state.global.iter_mut().zip(&state.problem.globals) {
        let (low, high) = global.constraint.bounds;
        let inside = (OFF_BOUND * global.x_scale).min(0.5 * (high - low));
        *value = global.model_value.clamp(low + inside, high - inside);
    }
    if let Some((parameter, value)) = changed {
        state.global[parameter] = value;
    }
    let Some(mut arcs) = arcs(&state) else {
        return Ok(None);
    };
    loop {
        // Only few arcs may cover a flow regime; a loss with the median scale would treat them as outliers.
        match fit_horizon(&mut arcs, f64::INFINITY, ResidualCache::rms_scale) {
            Err(FitError::NoUsableFlight(_)) => return Ok(None),
            fitted => fitted?,
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
        if options.is_past_deadline() || !join(&state, &mut arcs) {
            break;
        }
    }
    let cache = anneal_scale(&mut state)?;
    Ok(Some((state, cache)))
}

/// Divides all flights into arcs, each with its initial guess; `None` if no arc has an initial guess.
fn arcs<'a>(state: &State<'a>) -> Option<State<'a>> {
    let (problem, options) = (state.problem, state.options);
    let mut cut = Vec::new();
    for (&id, flight) in state.ids.iter().zip(&state.flights) {
        let mut first = 0;
        while first < flight.times.len() {
            let end = flight.samples_until(flight.times[first] + ARCS.0);
            let mut end = end.max(first + MIN_SEGMENT_SAMPLES);
            if end + MIN_SEGMENT_SAMPLES > flight.times.len() {
                end = flight.times.len();
            }
            cut.push((id, flight.arc(problem, first..end)));
            first = end;
        }
    }
    let guesses = parallel::each_on(options.threads(), cut.len(), |index| {
        guess(problem, &cut[index].1)
    });
    let mut arcs = state.without_flights();
    for ((id, arc), guess) in cut.into_iter().zip(guesses) {
        if let Some(guess) = guess {
            arcs.push(id, arc, guess);
        }
    }
    (!arcs.flights.is_empty()).then_some(arcs)
}

/// Joins each group of `ARCS.1` consecutive arcs, with the initial state of the first; `false` if all are whole flights
/// already.
fn join<'a>(state: &State<'a>, arcs: &mut State<'a>) -> bool {
    let joined = arcs.without_flights();
    let before = std::mem::replace(arcs, joined);
    let mut has_joined = false;
    for (id, flight) in state.ids.iter().zip(&state.flights) {
        let of_flight = (0..before.ids.len()).filter(|&arc| before.ids[arc] == *id);
        let of_flight: Vec<usize> = of_flight.collect();
        for group in of_flight.chunks(ARCS.1) {
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
