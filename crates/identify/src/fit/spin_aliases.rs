//! Spins of flights whose samples are too far apart to tell the number of turns between them: fits with other numbers.

use flight::parallel;
use flight::throw::ThrownModel;
use model_spec::sort_by_number;
use nalgebra::{DVector, Vector3};

use super::FitError;
use super::horizon_continuation::{anneal_scale, continue_horizon};
use super::initial_guess::spin_note;
use super::residual_cache::ResidualCache;
use super::starts::{ANOTHER, Arrivals, are_same};
use super::state::State;
use crate::problem::FitProblem;
use dataset::levels::ROUGHLY_NOISE;
use dataset::statistics::median_of;

/// Numbers of turns per sampling interval that are added to the slowest spin, the most probable first.
const ALIASES: [i32; 3] = [0, -1, 1];

/// Maximum ratio of the median residual scale to that of the best fit so far, for another spin to be preferred.
const ACCEPTED_RATIO: f64 = 0.9;

/// Decrease of the deviance, −2 ln of the likelihood, at which another spin is preferred where the residuals of both are
/// noise: odds of 150 to 1.
const MIN_DEVIANCE: f64 = 10.0;

/// Decrease of the deviance at which a faster spin is certain: with a term that the model lacks, wrong spins gained up to 25
/// in simulated flights, and right ones at least 39.
const DECISIVE: f64 = 30.0;

/// Maximum number of times that single flights are moved to another spin.
const ROUNDS: usize = 3;

/// Fits all flights once for each alias of the spin, and returns the best fit.
pub fn resolve(mut state: State<'_>) -> Result<(State<'_>, ResidualCache), FitError> {
    let all = state.guesses.iter().flatten();
    let aliases = ALIASES.into_iter();
    let aliases = aliases.filter(|alias| all.clone().any(|guess| guess.turns == *alias));
    let aliases: Vec<i32> = aliases.collect();
    if aliases.iter().all(|alias| *alias == 0) {
        let cache = continue_horizon(&mut state)?;
        return Ok((state, cache));
    }
    let mut arrivals = Arrivals::default();
    let scale_of = |(fit, cache): &(State<'_>, ResidualCache)| {
        median_scale(cache, fit.excluded.len() - state.excluded.len())
    };
    let common: Vec<Vec<i32>> = { aliases.iter() }
        .map(|alias| vec![*alias; state.guesses.len()])
        .collect();
    for turns in &common {
        arrivals.add(with_turns(&state, turns), converged);
    }
    let mut arrived = arrivals.fits.iter();
    if !arrived.any(|fit| is_noise_of(scale_of(fit), &state)) {
        for turns in further_choices(&state, &common) {
            arrivals.add(with_turns(&state, &turns), converged);
        }
    }
    if arrivals.fits.is_empty() {
        return arrivals.take(0, None);
    }
    let fits = &arrivals.fits;
    let scale = |place: usize| scale_of(&fits[place]);
    let is_noise = |scale: f64| is_noise_of(scale, &state);
    let (mut best, mut is_doubtful) = (0, false);
    for place in 1..fits.len() {
        let ((tried, new), (other, before)) = (&fits[place], &fits[best]);
        let [scale, least] = [place, best].map(scale);
        let [gain, alone] = gain_of((tried, new), (other, before), scale.min(least));
        let are_noise = is_noise(scale.min(least));
        let is_better = match are_noise {
            true => gain > MIN_DEVIANCE,
            false => scale < ACCEPTED_RATIO * least,
        };
        // Neither spin is better both with the priors and without them.
        let is_open = gain.abs().min(alone.abs()) <= MIN_DEVIANCE || gain * alone < 0.0;
        let is_as_good = are_noise && is_open && is_another(tried, other);
        is_doubtful = is_as_good || is_doubtful && !is_better;
        if is_better {
            best = place;
        }
    }
    let is_decisive = || {
        let ((tried, new), (slowest, before)) = (&fits[best], &fits[0]);
        let gains = gain_of((tried, new), (slowest, before), scale(best).min(scale(0)));
        let is_clear = gains.into_iter().all(|gain| gain > DECISIVE);
        is_clear || !is_another(tried, slowest)
    };
    let how = match is_doubtful {
        true => Some("as well"),
        false if best > 0 && !is_decisive() => {
            Some("almost as well, as where the model lacks a term")
        }
        false => None,
    };
    let doubt = how.map(|how| {
        format!(
            "the spin is not determined: with a turn more or less per sampling interval the flights fit {how}"
        )
    });
    let least = scale(best);
    let (mut state, mut cache) = arrivals.take(best, doubt)?;
    if is_noise_of(least, &state) {
        cache = with_own_turns(&mut state, cache)?;
    }
    Ok((state, cache))
}

/// Moves each flight that does not fit to the noise to another number of turns with which it alone fits better, and adds a
/// doubt of those that fit as well with another.
fn with_own_turns(
    state: &mut State<'_>,
    mut cache: ResidualCache,
) -> Result<ResidualCache, FitError> {
    let mut open = Vec::new();
    for _ in 0..ROUNDS {
        let found = gains_of_turns(state, &cache);
        let each = found.into_iter().enumerate();
        let (better, others): (Vec<_>, Vec<_>) = each
            .filter_map(|(flight, found)| Some((flight, found?)))
            .partition(|(_, (gain, _))| *gain > MIN_DEVIANCE);
        open = others;
        if better.is_empty() || state.options.is_past_deadline() {
            break;
        }
        for (flight, (_, local)) in better {
            state.local[flight] = local;
        }
        cache = anneal_scale(state)?;
    }
    let open = open
        .into_iter()
        .filter(|(_, (gain, _))| *gain > -MIN_DEVIANCE);
    let open: Vec<&str> = open
        .map(|(flight, _)| &*state.flights[flight].file)
        .collect();
    if !open.is_empty() && state.doubts.is_empty() {
        let doubt = format!(
            "the spin of {} is not determined: with a turn more or less per sampling interval it fits as well",
            open.join(", ")
        );
        state.doubts.push(doubt);
    }
    Ok(cache)
}

/// For each flight that does not fit to the noise the initial state of another spin with the least deviance at the present
/// parameters, and by how much it is less than that of the present one.
fn gains_of_turns(state: &State<'_>, cache: &ResidualCache) -> Vec<Option<(f64, DVector<f64>)>> {
    let sigma0 = state.problem.sigma0;
    let (spin, scales) = (spins(state.problem), cache.scales());
    parallel::each_on(state.options.threads(), state.flights.len(), |flight| {
        if scales[flight].is_some_and(|scale| is_noise_of(scale, state)) {
            return None;
        }
        let fitted = |local: &DVector<f64>| state.alone(flight).fit(local.clone()).ok();
        let (present, local) = fitted(&state.local[flight])?;
        let (own, guesses) = (spin(&local)?, state.guesses[flight].iter());
        let others = guesses.filter_map(|guess| {
            let (squares, local) = fitted(&guess.state)?;
            let is_another = (spin(&local)? - own).norm() > ANOTHER * own.norm();
            is_another.then_some(((present - squares) / (sigma0 * sigma0), local))
        });
        others.max_by(|a, b| a.0.total_cmp(&b.0))
    })
}

fn is_noise_of(scale: f64, state: &State<'_>) -> bool {
    scale < ROUGHLY_NOISE * state.problem.sigma0
}

/// Continues the horizon, and from residuals at the noise on to the minimum: likelihoods are compared at minima.
fn converged(state: &mut State<'_>) -> Result<ResidualCache, FitError> {
    let cache = continue_horizon(state)?;
    if cache.median_scale() < ROUGHLY_NOISE * state.problem.sigma0 {
        return anneal_scale(state);
    }
    Ok(cache)
}

/// Whether a flight starts with another angular velocity in another fit: with a gyroscope both may arrive at the same
/// one, by other angles for the same attitude.
fn is_another(one: &State<'_>, other: &State<'_>) -> bool {
    let (spin, model) = (spins(one.problem), &one.problem.model);
    let is_same = |(one, other): (&DVector<f64>, &DVector<f64>)| match (spin(one), spin(other)) {
        (Some(one), Some(other)) => (one - other).norm() < ANOTHER * other.norm(),
        _ => are_same(model, (one, other)),
    };
    let mut pairs = one.local.iter().zip(&other.local);
    one.local.len() == other.local.len() && pairs.any(|pair| !is_same(pair))
}

/// Decrease of the deviance from the fit `before` to the fit `new`, for noise of unknown size: with weak priors of the
/// parameters, since moments that no such body has may make up for another spin, and without. `scale` is that of the
/// residuals, m.
fn gain_of(
    (new, new_cache): (&State<'_>, &ResidualCache),
    (before, before_cache): (&State<'_>, &ResidualCache),
    scale: f64,
) -> [f64; 2] {
    let [(is, count), (was, count_before)] =
        [new_cache, before_cache].map(|cache| cache.clipped_squares(scale));
    if count < count_before {
        return [f64::NEG_INFINITY; 2];
    }
    let prior = |state: &State<'_>| {
        let globals = state.problem.globals.iter().zip(state.global.iter());
        let each = globals.map(|(own, value)| ((value - own.model_value) / own.x_scale).powi(2));
        each.sum::<f64>()
    };
    let alone = count as f64 * (was / is).ln();
    [alone + prior(before) - prior(new), alone]
}

/// A fit in progress in which each flight starts at its guess with its number of additional turns, if it has one.
fn with_turns<'a>(state: &State<'a>, turns: &[i32]) -> State<'a> {
    let mut state = state.clone();
    for (index, turns) in turns.iter().enumerate() {
        let mut guesses = state.guesses[index].iter();
        let guess = guesses.find(|guess| guess.turns == *turns && *turns != 0);
        if let Some(guess) = guess {
            state.local[index].clone_from(&guess.state);
            state.flights[index].notes.push(spin_note(*turns));
        }
    }
    state
}

/// Numbers of additional turns, by flight, that are tried beside the `common` ones of all flights: those that suit the
/// model's values, and those with which all flights spin most alike, as some may spin below and others above half a turn
/// per interval.
fn further_choices(state: &State<'_>, common: &[Vec<i32>]) -> Vec<Vec<i32>> {
    let mut choices: Vec<Vec<i32>> = Vec::new();
    let of_model = nearest_to_model(state);
    if !common.contains(&of_model) {
        choices.push(of_model);
    }
    let spin = spins(state.problem);
    let spins = state.guesses.iter().map(|guesses| {
        let each = guesses.iter();
        let each = each.filter_map(|guess| Some((guess.turns, spin(&guess.state)?)));
        each.collect()
    });
    let spins: Vec<Vec<(i32, Vector3<f64>)>> = spins.collect();
    let like = |(_, wanted): &(i32, Vector3<f64>)| {
        let (mut turns, mut squares) = (Vec::new(), 0.0);
        for spins in &spins {
            let off = |own: &(i32, Vector3<f64>)| (own.1 - wanted).norm_squared();
            let nearest = spins.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
            turns.push(nearest.map_or(0, |own| own.0));
            squares += nearest.map_or(0.0, off);
        }
        (squares, turns)
    };
    let mut alike: Vec<(f64, Vec<i32>)> = spins.iter().flatten().map(like).collect();
    sort_by_number(&mut alike, |(squares, _)| *squares);
    for (_, turns) in alike {
        let is_known = common.contains(&turns) || choices.contains(&turns);
        if choices.len() < ALIASES.len() && !is_known {
            choices.push(turns);
        }
    }
    choices
}

/// Number of additional turns with which each flight is nearest to what the model flies with its own values.
fn nearest_to_model(state: &State<'_>) -> Vec<i32> {
    parallel::each_on(state.options.threads(), state.flights.len(), |flight| {
        let fitted = state.guesses[flight].iter().filter_map(|guess| {
            let found = state.alone(flight).fit(guess.state.clone());
            Some((found.ok()?.0, guess.turns))
        });
        let best = fitted.min_by(|a, b| a.0.total_cmp(&b.0));
        best.map_or(0, |(_, turns)| turns)
    })
}

/// Angular velocity at a state of a body, in axes that are fixed in it, rad/s; `None` of a point mass.
fn spins(problem: &FitProblem) -> impl Fn(&DVector<f64>) -> Option<Vector3<f64>> {
    let thrown = ThrownModel::new(&problem.model).ok();
    move |local| {
        let state = &local.as_slice()[..problem.body.layout().states.len()];
        let turning = thrown
            .as_ref()?
            .motion(state, &problem.parameters)
            .turning?;
        Some(turning.axes.tr_mul(&turning.rates))
    }
}

/// Median of the flights' residual scales, m; flights that cannot be integrated or were `excluded` count as infinite.
fn median_scale(cache: &ResidualCache, excluded: usize) -> f64 {
    let scales = cache.scales().into_iter();
    let flown = scales.map(|scale| scale.unwrap_or(f64::INFINITY));
    let without = std::iter::repeat_n(f64::INFINITY, excluded);
    median_of(flown.chain(without)).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::simulated;
    use crate::fit::{flights_of, initial_guess};
    use crate::options::FitOptions;
    use crate::problem::whitened_tolerance;
    use dataset::Role;
    use dataset::synthesize::Plan;

    #[test]
    fn each_flight_has_its_own_number_of_turns() {
        const RATE: f64 = 18.0;
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 4,
            duration: Some(0.8),
            rate: RATE,
            ..Plan::default()
        };
        let dataset = simulated(&model, "backhand", &plan);
        let options = FitOptions::default();
        let mut problem = FitProblem::new(&model, &dataset, &options).unwrap();
        let fitted = flights_of(&dataset, Role::Fit);
        let observed = initial_guess::observe(&problem, &dataset, &fitted, &[], &options);
        problem.sigma0 = observed.sigma0.unwrap();
        problem.tolerance = whitened_tolerance(&model, fitted.len());
        let guesses = initial_guess::from_guesses(&problem, &dataset, observed, &options);
        let guesses = guesses.unwrap();
        let slowest = guesses.guesses.iter().map(|all| all[0].clone());
        let slowest: Vec<_> = slowest.collect();
        let (state, _) = resolve(guesses).unwrap();
        let spin = spins(&problem);
        let along = |state| spin(state).unwrap().z;
        // Some flights seem to spin the other way, as they spin by more than half a turn per interval.
        let seem: Vec<f64> = slowest
            .iter()
            .map(|own| along(&own.state).signum())
            .collect();
        assert!(seem.contains(&1.0) && seem.contains(&-1.0), "{seem:?}");
        let found: Vec<f64> = state.local.iter().map(along).collect();
        assert!(
            found.iter().all(|spin| (-80.0..-35.0).contains(spin)),
            "{found:?}"
        );
        assert_eq!(state.doubts, Vec::<String>::new());
    }
}
