//! Fits of flights without measured positions. Their instruments do not determine the initial attitude and velocity, so
//! that the fit has many minima: it is started from several initial guesses of every flight, and the best minimum is used.

use flight::parallel;
use nalgebra::DVector;

use super::FitError;
use super::horizon_continuation::{anneal_scale, continue_horizon};
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::ids::FlightId;
use crate::initial_state::InitialGuess;

/// Number of fits of all flights that are started from each speed.
const STARTS: usize = 2;

/// Maximum number of times that all flights are fitted again after single flights moved to better initial states.
const EXCHANGES: usize = 3;

/// Decrease of the sum of squares of a flight, in units of the variance of the noise, at which another initial state is
/// preferred.
const MIN_DECREASE: f64 = 1.0;

/// Difference of the deviances of two fits below which they have arrived at the same minimum.
const SAME_MINIMUM: f64 = 1.0;

/// Number of flights with which the minimum is searched where several instruments observe each of them. The others start
/// at their best initial states for the parameters found: the time of the search does not grow with the number of
/// flights. Flights of one instrument determine the minimum only all together.
const SEARCHED: usize = 4;

/// Finds the best minimum of the longest flights, and fits all flights from there.
///
/// # Errors
/// The errors of [`continue_horizon`], if every fit fails.
pub fn best_of_several<'a>(
    start: State<'a>,
    alternatives: &[Vec<InitialGuess>],
) -> Result<(State<'a>, ResidualCache), FitError> {
    let guesses = &Guesses {
        ids: start.ids.clone(),
        of_flights: alternatives,
    };
    let mut longest: Vec<usize> = (0..start.flights.len()).collect();
    longest.sort_by_key(|&flight| std::cmp::Reverse(start.flights[flight].times.len()));
    longest.truncate(SEARCHED);
    if longest.len() == start.flights.len() || start.problem.channels.len() == 1 {
        return best_minimum(start, guesses);
    }
    let mut few = start.without_flights();
    for &flight in &longest {
        let (observations, local) = (&start.flights[flight], &start.local[flight]);
        few.push(start.ids[flight], observations.clone(), local.clone());
    }
    let (found, _) = best_minimum(few, guesses)?;
    let mut state = start;
    state.global.clone_from(&found.global);
    state.doubts.extend(found.doubts);
    exchange(&mut state, guesses);
    for (id, local) in found.ids.into_iter().zip(found.local) {
        let place = state.ids.iter().position(|own| *own == id);
        state.local[place.expect("one of the flights")] = local;
    }
    let cache = anneal_scale(&mut state)?;
    Ok((state, cache))
}

/// Fits the flights several times, from initial guesses of every speed, until two fits arrive at the least deviance. If
/// none do, single flights are tried from their other guesses. If still one fit alone arrives there, a better minimum may
/// have been missed, which becomes a doubt of the fit.
///
/// # Errors
/// The errors of [`continue_horizon`], if every fit fails.
fn best_minimum<'a>(
    start: State<'a>,
    guesses: &Guesses<'_>,
) -> Result<(State<'a>, ResidualCache), FitError> {
    let mut arrived: Vec<(State<'a>, ResidualCache)> = Vec::new();
    let mut failure = None;
    for rank in 0..STARTS {
        for speed in guesses.speeds() {
            if start.options.is_past_deadline() && !arrived.is_empty() {
                break;
            }
            let mut tried = guesses.start(&start, speed, rank);
            match continue_horizon(&mut tried).and_then(|_| anneal_scale(&mut tried)) {
                Ok(cache) => arrived.push((tried, cache)),
                Err(FitError::Interrupted) => return Err(FitError::Interrupted),
                Err(error) => {
                    failure.get_or_insert(error);
                }
            }
        }
        if arrivals(&arrived).1 > 1 {
            break;
        }
    }
    if arrivals(&arrived).1 < 2 {
        for (state, cache) in &mut arrived {
            exchange_initial_states(state, cache, guesses)?;
        }
    }
    let (best, number) = arrivals(&arrived);
    let starts = arrived.len();
    if starts == 0 {
        return Err(failure.unwrap_or(FitError::Interrupted));
    }
    let (mut state, cache) = arrived.swap_remove(best);
    state.doubts.extend((number < 2).then(|| {
        format!(
            "the instruments do not determine the initial states: of {starts} starts of the fit only one arrives at this minimum, and a better one may exist"
        )
    }));
    Ok((state, cache))
}

/// Index of the fit with the least deviance, and the number of fits that arrive at it.
fn arrivals(fits: &[(State<'_>, ResidualCache)]) -> (usize, usize) {
    let scales = fits.iter().map(|(_, cache)| cache.median_scale());
    let scale = scales.fold(f64::INFINITY, f64::min);
    let deviance = |(state, cache): &(State<'_>, ResidualCache)| {
        let (squares, count) = cache.clipped_squares(scale);
        let count = count as f64;
        // A fit that has lost flights is no better for it.
        let lost = state.excluded.len() as f64;
        (lost, count * (squares / count).ln())
    };
    let deviances: Vec<(f64, f64)> = fits.iter().map(deviance).collect();
    let order = |a: &(f64, f64), b: &(f64, f64)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1));
    let Some(least) = deviances.iter().copied().min_by(order) else {
        return (0, 0);
    };
    let is_same = |own: &&(f64, f64)| own.0 == least.0 && own.1 - least.1 < SAME_MINIMUM;
    let best = deviances.iter().position(|own| *own == least);
    let number = deviances.iter().filter(is_same).count();
    (best.unwrap_or(0), number)
}

/// Initial guesses of flights, which may be excluded one after the other.
struct Guesses<'g> {
    ids: Vec<FlightId>,
    of_flights: &'g [Vec<InitialGuess>],
}

impl Guesses<'_> {
    /// Indices of the speeds from which guesses were made.
    fn speeds(&self) -> std::ops::RangeInclusive<usize> {
        let speeds = self.of_flights.iter().flatten().map(|guess| guess.speed);
        0..=speeds.max().unwrap_or(0)
    }

    /// Guesses of one flight, the best one first.
    fn of(&self, flight: FlightId) -> &[InitialGuess] {
        let index = self.ids.iter().position(|id| *id == flight);
        index.map_or(&[], |index| &self.of_flights[index])
    }

    /// Copy of a fit in progress in which each flight starts at its guess number `rank` of the speed with the index
    /// `speed`, or at its last one of this speed.
    fn start<'a>(&self, start: &State<'a>, speed: usize, rank: usize) -> State<'a> {
        let mut state = start.clone();
        for (local, id) in state.local.iter_mut().zip(&state.ids) {
            let guesses = self.of(*id).iter();
            let of_speed: Vec<_> = guesses.filter(|guess| guess.speed == speed).collect();
            if let Some(guess) = of_speed.get(rank).or(of_speed.last()) {
                local.clone_from(&guess.state);
            }
        }
        state
    }
}

/// Moves flights to other initial states that are better at the parameters found, and fits all flights again.
fn exchange_initial_states(
    state: &mut State<'_>,
    cache: &mut ResidualCache,
    guesses: &Guesses<'_>,
) -> Result<(), FitError> {
    for _ in 0..EXCHANGES {
        if state.options.is_past_deadline() || !exchange(state, guesses) {
            break;
        }
        *cache = anneal_scale(state)?;
    }
    Ok(())
}

/// Moves each flight to the best of the initial states to which its guesses lead at the present parameters. Returns
/// whether a flight moved.
fn exchange(state: &mut State<'_>, guesses: &Guesses<'_>) -> bool {
    let (at, sigma0) = (state.fixed_global(), state.problem.sigma0);
    let found = parallel::each_on(state.options.threads(), state.flights.len(), |flight| {
        let observations = &state.flights[flight];
        let fitted = |local: &DVector<f64>| {
            at.fit_initial_state(observations, observations.times.len(), local.clone())
                .ok()
        };
        let present = fitted(&state.local[flight]).map_or(f64::INFINITY, |(squares, _)| squares);
        let others = guesses.of(state.ids[flight]).iter();
        let best = others
            .filter_map(|guess| fitted(&guess.state))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        (best.0 < present - MIN_DECREASE * sigma0 * sigma0).then_some(best.1)
    });
    let mut has_moved = false;
    for (local, better) in state.local.iter_mut().zip(found) {
        if let Some(better) = better {
            *local = better;
            has_moved = true;
        }
    }
    has_moved
}
