//! Observations, scales and initial guesses of single flights, and exclusion of unusable flights.

use flight::parallel;
use model_spec::sort_by_number;
use nalgebra::{UnitQuaternion, Vector3};

use super::output_error::FlightAlone;
use super::state::State;
use super::{FitError, marker_noise};
use crate::channel::{Channel, ChannelKind};
use crate::error::{ExcludedFlight, FlightError};
use crate::ids::FlightId;
use crate::initial_state::InitialGuess;
use crate::noise::overall;
use crate::noise_floor::{median_noise_floor, noise_floor};
use crate::observations::{Observations, median_interval};
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::{initial_state, summary, vertical};
use dataset::contact::{self, Contact, ContactSearch};
use dataset::path_noise;
use dataset::pose::Pose;
use dataset::statistics::{median_of, robust_sigma};
use dataset::{Dataset, Flight};

/// Duration of the first segment of a flight, to which the guess of its initial state is fitted, s.
const FIRST_SEGMENT: f64 = 0.15;

/// Minimum number of samples of a segment of a flight; one with fewer is fitted as a whole.
pub const MIN_SEGMENT_SAMPLES: usize = 12;

/// Least noise that is assumed: of a coordinate, m, about the rounding error of recorded ones; and of another channel,
/// relative to the median magnitude of its values.
const LEAST_NOISE: (f64, f64) = (1e-7, 1e-6);

/// Ratio of the noise floor to the noise by rigidity below which the former is used: deviations from a rigid body are
/// then due to wrong marker positions or times. Correlated noise lowers the ratio less.
const MAX_FLOOR_RATIO: f64 = 0.2;

/// Number of initial guesses of each speed that are kept for a flight.
const KEPT: usize = 5;

/// Relative difference of sums of squares, and of states, below which two guesses are refined to the same one.
const SAME_GUESS: f64 = 1e-3;

/// Observations of the flights that can be fitted, excluded flights, and noise estimates.
pub struct ObservedFlights {
    pub usable: Vec<(FlightId, Observations)>,
    pub excluded: Vec<ExcludedFlight>,
    /// Initial noise of a coordinate, m, from deviations of the markers from a rigid body.
    pub sigma0: Option<f64>,
    /// Noise floor along each axis, m; `None` if the samples do not determine it.
    pub noise_floor: Option<[f64; 3]>,
}

/// Number of samples in the first segment of a flight, to which the guess of its initial state is fitted.
pub fn first_segment(observations: &Observations) -> usize {
    let samples = observations.samples_until(FIRST_SEGMENT);
    samples
        .max(MIN_SEGMENT_SAMPLES)
        .min(observations.times.len())
}

/// Observations of `flights`, with estimates of their noise. `contacts` contains earlier searches for contacts by index
/// of the flight, or is empty.
pub fn observe(
    problem: &FitProblem,
    dataset: &Dataset,
    flights: &[FlightId],
    contacts: &[Option<ContactSearch>],
    options: &FitOptions<'_>,
) -> ObservedFlights {
    let each = parallel::each_on(options.threads(), flights.len(), |index| {
        let flight = flights[index].index();
        let search = contacts.get(flight).and_then(Option::as_ref);
        let flight = &dataset.flights[flight];
        let (observations, poses) = observations_and_poses(problem, flight, search)?;
        let sigma0 = initial_state::sigma0(problem, &observations, &poses);
        let floor = noise_floor(problem, &observations, &poses);
        Ok((observations, sigma0, floor))
    });
    let (mut usable, mut excluded) = (Vec::with_capacity(flights.len()), Vec::new());
    let (mut estimates, mut floors) = (Vec::with_capacity(flights.len()), Vec::new());
    for (&flight, found) in flights.iter().zip(each) {
        match found {
            Ok((observations, sigma0, floor)) => {
                usable.push((flight, observations));
                estimates.extend(sigma0);
                floors.extend(floor);
            }
            Err(reason) => excluded.push(exclude(dataset, flight, reason)),
        }
    }
    let positions = problem.channels.iter().filter(|own| own.is_position());
    let rounding = positions.map(Channel::overall_rounding);
    let least = rounding.fold(LEAST_NOISE.0, f64::max);
    let mut sigma0 = median_of(estimates).map(|sigma0| sigma0.max(least));
    let noise_floor = median_noise_floor(&floors);
    if let (Some(sigma0), Some(floor)) = (&mut sigma0, noise_floor) {
        let floor = overall(floor);
        if floor < MAX_FLOOR_RATIO * *sigma0 {
            *sigma0 = floor.max(least);
        }
    }
    ObservedFlights {
        usable,
        excluded,
        sigma0,
        noise_floor,
    }
}

fn exclude(dataset: &Dataset, flight: FlightId, reason: FlightError) -> ExcludedFlight {
    ExcludedFlight {
        flight,
        file: dataset.flights[flight.index()].file.clone(),
        reason,
    }
}

/// A fit in progress of the flights that can be fitted, from their initial guesses.
pub fn from_guesses<'a>(
    problem: &'a FitProblem,
    dataset: &Dataset,
    observed: ObservedFlights,
    options: &'a FitOptions<'a>,
) -> Result<State<'a>, FitError> {
    let ObservedFlights {
        usable,
        mut excluded,
        ..
    } = observed;
    let interval = median_interval(usable.iter().map(|(_, observations)| observations));
    let mut state = State::new(problem, options, problem.model_values(), interval);
    let at = state.fixed_global();
    let found = options.each_flight("starts", usable.len(), |index| {
        refined_guesses(at.flight(&usable[index].1))
    });
    for ((flight, observations), found) in usable.into_iter().zip(found) {
        match found {
            Ok(guesses) => {
                let guesses = guesses.into_iter().map(|(_, guess)| guess);
                let guesses: Vec<InitialGuess> = guesses.collect();
                state.push(flight, observations, guesses[0].state.clone());
                state.guesses[state.ids.len() - 1] = guesses;
            }
            Err(reason) => excluded.push(exclude(dataset, flight, reason)),
        }
    }
    state.excluded = excluded;
    state.exclude(Vec::new())?;
    Ok(state)
}

/// Note for a flight that makes `turns` additional turns between successive samples.
pub fn spin_note(turns: i32) -> String {
    format!(
        "between samples it makes whole turns ({turns:+}) beyond what neighbouring samples show"
    )
}

/// Observations of a flight up to its first contact, with the poses if the body has an attitude. The contact is
/// searched for unless `search` contains an earlier search; if the vertical is unknown, none is.
pub fn observations_and_poses(
    problem: &FitProblem,
    flight: &Flight,
    search: Option<&ContactSearch>,
) -> Result<(Observations, Vec<Option<Pose>>), FlightError> {
    let mut observations = Observations::new(problem, flight)?;
    let unseen = flight
        .times
        .partition_point(|time| *time < observations.origin);
    let search = match search {
        Some(search) => Some(search.of_part(unseen, observations.times.len())),
        // The effect of a contact with the ground is not known if the vertical is not known.
        None => vertical::is_in(&problem.model).then(ContactSearch::default),
    };
    let poses = truncate_at_contact(problem, &mut observations, search);
    let measured = 3 * observations.measured.iter().flatten().count();
    let unknowns = observations.manifold.dimension();
    if measured < unknowns {
        return Err(FlightError::TooFewCoordinates { measured, unknowns });
    }
    Ok((observations, poses))
}

/// Truncates a flight before its first contact, which is searched for unless `search` contains it. Returns the poses in
/// the remaining samples; empty for a point mass.
fn truncate_at_contact(
    problem: &FitProblem,
    observations: &mut Observations,
    search: Option<ContactSearch>,
) -> Vec<Option<Pose>> {
    let (sought, known) = match search {
        Some(ContactSearch { contact, poses }) => (Some(contact), poses),
        None => (None, Vec::new()),
    };
    let mut poses = match known.is_empty() {
        true => observations.poses(problem),
        false => known,
    };
    let found = sought.unwrap_or_else(|| {
        let points = |sample: usize| observations.points(sample);
        contact::first_change(&contact::path(
            &problem.points,
            &observations.times,
            &poses,
            points,
        ))
    });
    let Some(Contact { sample, why }) = found else {
        return poses;
    };
    let time = observations.origin + observations.times[sample];
    observations.truncate(
        sample,
        format!("{why} at t = {time:.3} s, as at a touch of the ground"),
    );
    poses.truncate(sample);
    poses
}

/// Guesses of the initial state, refined by a fit to the first segment, each with its sum of squares; the slowest spin
/// first, or without measured positions the smallest sum of squares. Past the deadline, they are not refined.
pub fn refined_guesses(flight: FlightAlone<'_>) -> Result<Vec<(f64, InitialGuess)>, FlightError> {
    let (problem, observations) = (flight.at.problem, flight.observations);
    let segment = flight.first(first_segment(observations));
    let mut refined = Vec::new();
    let mut failure = FlightError::NoMatchingState;
    for guess in initial_state::initial_guesses(problem, observations)? {
        if flight.at.options.is_past_deadline() {
            refined.push((f64::INFINITY, guess));
            continue;
        }
        match segment.fit(guess.state.clone()) {
            Ok((squares, state)) => refined.push((squares, InitialGuess { state, ..guess })),
            Err(reason) => failure = reason,
        }
    }
    if !problem.sees_positions() {
        keep_best(&mut refined);
    }
    match refined.is_empty() {
        true => Err(failure),
        false => Ok(refined),
    }
}

/// Keeps the best guesses of each speed, the smallest sum of squares first: short segments look alike at different
/// speeds.
fn keep_best(guesses: &mut Vec<(f64, InitialGuess)>) {
    sort_by_number(guesses, |(squares, _)| *squares);
    let mut kept: Vec<(f64, InitialGuess)> = Vec::new();
    for (squares, guess) in guesses.drain(..) {
        let of_speed = kept.iter().filter(|(_, other)| other.speed == guess.speed);
        let is_known = of_speed.clone().any(|(least, other)| {
            squares - least <= SAME_GUESS * least
                && (&guess.state - &other.state).norm() < SAME_GUESS * other.state.norm()
        });
        if !is_known && of_speed.count() < KEPT {
            kept.push((squares, guess));
        }
    }
    *guesses = kept;
}

/// Sets the noise, the noise groups and the scales of `problem` from the flights that are fitted and the summaries.
pub fn set_noise<'o>(
    problem: &mut FitProblem,
    observed: &'o ObservedFlights,
    summaries: impl Iterator<Item = &'o Observations> + Clone,
) {
    problem.sigma0 = observed.sigma0.unwrap_or(problem.sigma0);
    let flights = observed.usable.iter().map(|(_, observations)| observations);
    marker_noise::set_groups(problem, flights.clone());
    set_scales(problem, flights.chain(summaries));
}

// Scales of channels other than markers, from the noise of their samples.

/// Sets the scale of each sensor channel so that its noise × scale is `problem.sigma0`, the noise of a position
/// coordinate, m, of markers or, without them, of pose sensors.
fn set_scales<'o>(
    problem: &mut FitProblem,
    flights: impl Iterator<Item = &'o Observations> + Clone,
) {
    for channel in 0..problem.channels.len() {
        let own = &problem.channels[channel];
        // Without markers, `sigma0` is the noise of the positions of the pose sensors.
        if problem.is_scored(channel) && own.is_position() {
            continue;
        }
        if summary::event(own.kind).is_some() {
            let sigma = own
                .sigma
                .or_else(|| rough_deviation(flights.clone(), channel));
            let scale = sigma.map_or(1.0, |sigma| problem.sigma0 / sigma);
            problem.channels[channel].scale = scale;
            continue;
        }
        let is_attitude = own.kind == ChannelKind::Attitude;
        let noise = own.sigma.or_else(|| {
            let each = flights.clone();
            let found = median_of(each.filter_map(|flight| noise(flight, channel, is_attitude)));
            found.map(|found| found.max(own.overall_rounding()))
        });
        if let Some(noise) = noise.filter(|noise| *noise > 0.0) {
            problem.channels[channel].scale = problem.sigma0 / noise;
        }
    }
}

/// Part of the typical size of the values of a summary that their noise is taken to be at first.
const ROUGH_PART: f64 = 0.02;

/// Rough standard deviation of the values of a channel of summaries, in its unit.
fn rough_deviation<'o>(
    flights: impl Iterator<Item = &'o Observations>,
    channel: usize,
) -> Option<f64> {
    let values = flights.filter_map(|flight| flight.value(0, channel));
    let size = median_of(values.map(|value| value[0].abs()))?;
    Some((ROUGH_PART * size).max(LEAST_NOISE.1))
}

/// Standard deviation of the noise of a channel in one flight, from the deviations of its values from smooth curves, in
/// the unit of the channel; `None` for fewer than four values.
fn noise(flight: &Observations, channel: usize, is_attitude: bool) -> Option<f64> {
    let samples = flight.times.iter().enumerate();
    let values = samples.filter_map(|(sample, time)| {
        let value = flight.value(sample, channel)?;
        Some((*time, Vector3::from(value)))
    });
    let values: Vec<(f64, Vector3<f64>)> = values.collect();
    if values.len() < 4 {
        return None;
    }
    let least = LEAST_NOISE.1 * median_of(values.iter().map(|(_, value)| value.norm()))?;
    let noise = match is_attitude {
        true => attitude_noise(&values),
        false => path_noise(values.into_iter()),
    };
    Some(noise.max(least))
}

/// Noise of an attitude about one axis, rad, from the rotation between each attitude and the interpolation of its
/// neighbours. `values` contains times, s, and rotation vectors, rad.
fn attitude_noise(values: &[(f64, Vector3<f64>)]) -> f64 {
    let turn = |value: &Vector3<f64>| UnitQuaternion::from_scaled_axis(*value);
    let mut sizes = Vec::new();
    for three in values.windows(3) {
        let [(before, a), (time, b), (after, c)] = [three[0], three[1], three[2]];
        let part = (time - before) / (after - before);
        let between = (turn(&a).inverse() * turn(&c)).scaled_axis();
        let middle = turn(&a) * UnitQuaternion::from_scaled_axis(between * part);
        let off = (middle.inverse() * turn(&b)).scaled_axis();
        let spread = (1.0 + part * part + (1.0 - part).powi(2)).sqrt();
        sizes.extend(off.iter().map(|part| part.abs() / spread));
    }
    robust_sigma(&mut sizes)
}
