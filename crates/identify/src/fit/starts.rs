//! Fits from several starts: from several guesses of every flight without measured positions, whose instruments do not
//! determine the initial attitude and velocity.

use std::f64::consts::TAU;

use flight::parallel;
use model_spec::model::Model;
use nalgebra::DVector;

use super::FitError;
use super::horizon_continuation::{anneal_scale, continue_horizon};
use super::output_error::FlightAlone;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::initial_state::InitialGuess;
use dataset::levels::ROUGHLY_NOISE;

/// Least relative difference of initial states, or of their angular velocities, of different fits: a turn per interval is
/// most of either.
pub(super) const ANOTHER: f64 = 0.1;

/// Decrease of the deviance by which a minimum, or another initial state of a flight, is better.
const SAME_MINIMUM: f64 = 1.0;

/// Number of fits of all flights that are started from each speed.
const STARTS: usize = 2;

/// Maximum number of times that all flights are fitted again after single flights moved to better initial states.
const EXCHANGES: usize = 3;

/// Number of fits, the best ones, of which single flights are tried from other guesses: where neither confirms the other, the
/// model or the readings are wrong rather than the initial states.
const EXCHANGED: usize = 3;

/// Number of flights with which the minimum is searched where several instruments observe each; the others start there
/// at their best initial states. Flights of one instrument determine the minimum only all together.
const SEARCHED: usize = 4;

/// Duration of the first part of a flight, s, over which all its guesses are fitted.
const FIRST_PART: f64 = 0.4;

/// Number of initial states that are followed to the end of a flight: most guesses lead to few motions.
const FOLLOWED: usize = 8;

/// Fits that arrived from several starts, with their residuals, and the first error of another start.
#[derive(Default)]
pub(super) struct Arrivals<'a> {
    pub fits: Vec<(State<'a>, ResidualCache)>,
    failure: Option<FitError>,
}

impl<'a> Arrivals<'a> {
    /// Fits from a start by `refine`.
    pub fn add(
        &mut self,
        mut start: State<'a>,
        refine: impl Fn(&mut State<'a>) -> Result<ResidualCache, FitError>,
    ) {
        match refine(&mut start) {
            Ok(cache) => self.fits.push((start, cache)),
            Err(error) => {
                self.failure.get_or_insert(error);
            }
        }
    }

    /// The fit with the index `best`, and `doubt` about it.
    pub fn take(
        mut self,
        best: usize,
        doubt: Option<String>,
    ) -> Result<(State<'a>, ResidualCache), FitError> {
        if self.fits.is_empty() {
            return Err(self.failure.unwrap_or(FitError::NothingToFit));
        }
        let (mut state, cache) = self.fits.swap_remove(best);
        state.doubts.extend(doubt);
        Ok((state, cache))
    }
}

/// Whether two initial states differ little, but for whole turns and the signs of quaternions.
pub(super) fn are_same(model: &Model, (one, other): (&DVector<f64>, &DVector<f64>)) -> bool {
    let mut difference = one - other;
    for angle in model.angle_states() {
        difference[angle] -= TAU * (difference[angle] / TAU).round();
    }
    for quaternion in model.quaternions() {
        let dot: f64 = quaternion.iter().map(|&k| one[k] * other[k]).sum();
        for k in quaternion {
            difference[k] = one[k] - dot.signum() * other[k];
        }
    }
    difference.norm() < ANOTHER * other.norm()
}

/// Finds the best minimum of the longest flights, and fits all flights from there.
pub fn best_of_several(mut start: State<'_>) -> Result<(State<'_>, ResidualCache), FitError> {
    let mut longest: Vec<usize> = (0..start.flights.len()).collect();
    longest.sort_by_key(|&flight| std::cmp::Reverse(start.flights[flight].times.len()));
    longest.truncate(SEARCHED);
    if longest.len() == start.flights.len() || start.problem.channels.len() == 1 {
        return best_minimum(start);
    }
    let mut few = start.without_flights();
    longest
        .iter()
        .for_each(|&flight| few.push_from(&start, flight));
    let (found, _) = best_minimum(few)?;
    start.global.clone_from(&found.global);
    start.doubts.extend(found.doubts);
    exchange(&mut start);
    for (id, local) in found.ids.into_iter().zip(found.local) {
        let place = start.place(id).expect("one of the flights");
        start.local[place] = local;
    }
    let cache = anneal_scale(&mut start)?;
    Ok((start, cache))
}

/// Fits the flights from guesses of every speed, until two fits arrive at the least deviance. If none do, single
/// flights are tried from their other guesses, those of the best fits first. If one fit alone arrives, this becomes a
/// doubt of the fit.
fn best_minimum(start: State<'_>) -> Result<(State<'_>, ResidualCache), FitError> {
    let mut arrivals = Arrivals::default();
    let speeds = start.guesses.iter().flatten().map(|guess| guess.speed);
    let fastest = speeds.max().unwrap_or(0);
    for rank in 0..STARTS {
        for speed in 0..=fastest {
            if start.options.is_past_deadline() && !arrivals.fits.is_empty() {
                break;
            }
            arrivals.add(at_guess(&start, speed, rank), |state| {
                continue_horizon(state)?;
                anneal_scale(state)
            });
        }
        if least_deviance(&arrivals.fits).1 > 1 {
            break;
        }
    }
    let deviances = deviances(&arrivals.fits);
    let mut order: Vec<usize> = (0..deviances.len()).collect();
    order.sort_by(|&a, &b| by_deviance(&deviances[a], &deviances[b]));
    for place in order.into_iter().take(EXCHANGED) {
        if least_deviance(&arrivals.fits).1 > 1 {
            break;
        }
        let (state, cache) = &mut arrivals.fits[place];
        exchange_initial_states(state, cache)?;
        // No initial states make up for wrong readings or a wrong model.
        if cache.median_scale() > ROUGHLY_NOISE * state.problem.sigma0 {
            break;
        }
    }
    let (best, number) = least_deviance(&arrivals.fits);
    let doubt = format!(
        "the instruments do not determine the initial states: of {} starts of the fit only one arrives at this minimum, and a better one may exist",
        arrivals.fits.len()
    );
    arrivals.take(best, (number < 2).then_some(doubt))
}

/// Number of flights lost and deviance of each fit: one that has lost flights is no better for it.
fn deviances(fits: &[(State<'_>, ResidualCache)]) -> Vec<(usize, f64)> {
    let scales = fits.iter().map(|(_, cache)| cache.median_scale());
    let scale = scales.fold(f64::INFINITY, f64::min);
    let of_fit = |(state, cache): &(State<'_>, ResidualCache)| {
        let (squares, count) = cache.clipped_squares(scale);
        let count = count as f64;
        (state.excluded.len(), count * (squares / count).ln())
    };
    fits.iter().map(of_fit).collect()
}

fn by_deviance(a: &(usize, f64), b: &(usize, f64)) -> std::cmp::Ordering {
    a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
}

/// Index of the fit with the least deviance, and the number of fits that arrive at it.
fn least_deviance(fits: &[(State<'_>, ResidualCache)]) -> (usize, usize) {
    let deviances = deviances(fits);
    let places = 0..deviances.len();
    let best = places.min_by(|&a, &b| by_deviance(&deviances[a], &deviances[b]));
    let Some(best) = best else {
        return (0, 0);
    };
    let least = deviances[best];
    let is_same = |own: &&(usize, f64)| own.0 == least.0 && own.1 - least.1 < SAME_MINIMUM;
    (best, deviances.iter().filter(is_same).count())
}

/// A fit in progress in which each flight starts at its guess number `rank` of a speed, or at the last one.
fn at_guess<'a>(start: &State<'a>, speed: usize, rank: usize) -> State<'a> {
    let mut state = start.clone();
    for (local, guesses) in state.local.iter_mut().zip(&state.guesses) {
        let of_speed = guesses.iter().filter(|guess| guess.speed == speed);
        let of_speed: Vec<&InitialGuess> = of_speed.collect();
        if let Some(guess) = of_speed.get(rank).or(of_speed.last()) {
            local.clone_from(&guess.state);
        }
    }
    state
}

/// Moves flights to other initial states that are better at the parameters found, and fits all flights again.
fn exchange_initial_states(
    state: &mut State<'_>,
    cache: &mut ResidualCache,
) -> Result<(), FitError> {
    for _ in 0..EXCHANGES {
        if state.options.is_past_deadline() || !exchange(state) {
            break;
        }
        *cache = anneal_scale(state)?;
    }
    Ok(())
}

/// Moves each flight to the best initial state to which its guesses lead; returns whether one moved.
fn exchange(state: &mut State<'_>) -> bool {
    let sigma0 = state.problem.sigma0;
    let found = parallel::each_on(state.options.threads(), state.flights.len(), |flight| {
        let alone = state.alone(flight);
        let fitted = |local: &DVector<f64>, below| alone.fit_below(local.clone(), below).ok();
        let present = fitted(&state.local[flight], f64::INFINITY);
        let present = present.map_or(f64::INFINITY, |(squares, _)| squares);
        let mut least = present - SAME_MINIMUM * sigma0 * sigma0;
        let mut best = None;
        for (of_part, other) in begun(alone, &state.guesses[flight], least) {
            // The sum of squares of a whole flight is at least that of its first part.
            if of_part >= least {
                break;
            }
            if let Some((squares, local)) = fitted(&other, least)
                && squares < least
            {
                (least, best) = (squares, Some(local));
            }
        }
        best
    });
    state.move_to(found)
}

/// Initial states to which guesses lead over the first part of a flight, with their sums of squares there: the distinct ones,
/// and none that gets no sum of squares below `below` soon.
fn begun(
    flight: FlightAlone<'_>,
    guesses: &[InitialGuess],
    below: f64,
) -> impl Iterator<Item = (f64, DVector<f64>)> {
    let observations = flight.observations;
    let samples = observations.samples_until(observations.times[0] + FIRST_PART);
    let begun = guesses.iter().filter_map(|guess| {
        let start = guess.state.clone();
        let (squares, local) = flight.first(samples).fit_below(start, below).ok()?;
        Some((squares, local, ()))
    });
    distinct(&flight.at.problem.model, begun.collect()).map(|(squares, local, ())| (squares, local))
}

/// Initial states with their sums of squares, each once, the least first: at most [`FOLLOWED`].
pub(super) fn distinct<T>(
    model: &Model,
    mut states: Vec<(f64, DVector<f64>, T)>,
) -> impl Iterator<Item = (f64, DVector<f64>, T)> + use<T> {
    states.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found: Vec<(f64, DVector<f64>, T)> = Vec::new();
    for own in states {
        let is_same = |other: &(f64, DVector<f64>, T)| are_same(model, (&own.1, &other.1));
        if found.len() < FOLLOWED && !found.iter().any(is_same) {
            found.push(own);
        }
    }
    found.into_iter()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_turns_and_negated_quaternions_are_the_same_state() {
        let disc = model_spec::load::load("disc", &[]).unwrap();
        let spun = disc.angle_states()[2];
        let state = DVector::from_fn(12, |k, _| 1.0 + k as f64);
        let turned = |angle: f64| {
            let mut state = state.clone();
            state[spun] += angle;
            state
        };
        let norm = state.norm();
        assert!(are_same(&disc, (&turned(-2.0 * TAU), &state)));
        assert!(!are_same(&disc, (&turned(2.0 * TAU + 0.1 * norm), &state)));
        let disc = model_spec::load::load("disc_quaternion", &[]).unwrap();
        let mut state = DVector::from_element(disc.states.len(), 0.0);
        let quaternion = disc.quaternions().next().unwrap();
        for (k, value) in quaternion.into_iter().zip([0.5, -0.5, 0.1, 0.7]) {
            state[k] = value;
        }
        assert!(are_same(&disc, (&-&state, &state)));
        let mut other = state.clone();
        other[quaternion[2]] = -0.1;
        assert!(!are_same(&disc, (&other, &state)));
    }
}
