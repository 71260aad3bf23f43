//! Tracks and starts of the flights, each on its own: which can be fitted, and from where.

use flight::batch;
use nalgebra::DVector;

use super::settle::own_only;
use super::{FitError, State};
use crate::cut;
use crate::dataset::{Dataset, Flight};
use crate::noise::median;
use crate::options::Options;
use crate::pose::Pose;
use crate::setting::Setting;
use crate::start::{self, Start};
use crate::track::Track;

/// The first part of a flight that its start is judged on, s and samples.
pub const FIRST: (f64, usize) = (0.15, 12);

/// The least that is believed of noise, m: as much as a table of rounded numbers has.
const LEAST_FLOOR: f64 = 1e-7;

/// What the flights begin with.
pub struct Begun {
    /// The flights that can be fitted, with their starts.
    pub state: State,
    /// Their indices in the dataset.
    pub flights: Vec<usize>,
    /// Every start of each: more than one where the samples are too far apart to tell its spin.
    pub alternatives: Vec<Vec<Start>>,
    /// Flights that cannot, and why.
    pub left_out: Vec<(usize, String)>,
}

/// Tracks of flights by index, and the flights that have none, with why.
pub type Tracks = (Vec<(usize, Track)>, Vec<(usize, String)>);

/// Makes tracks of these flights, and a first estimate of their noise, m.
pub fn tracks(
    setting: &Setting,
    dataset: &Dataset,
    flights: &[usize],
    options: &Options<'_>,
) -> (Tracks, f64) {
    let made = batch::each_on(options.threads(), flights.len(), |index| {
        let (track, poses) = track_and_poses(setting, &dataset.flights[flights[index]])?;
        let floor = start::floor(setting, &track, &poses);
        Ok((track, floor))
    });
    let (mut tracks, mut left_out) = (Vec::with_capacity(flights.len()), Vec::new());
    let mut floors = Vec::with_capacity(flights.len());
    for (&flight, made) in flights.iter().zip(made) {
        match made {
            Ok((track, floor)) => {
                tracks.push((flight, track));
                floors.extend(floor);
            }
            Err(reason) => left_out.push((flight, reason)),
        }
    }
    let floor = match floors.is_empty() {
        true => setting.floor,
        false => median(&mut floors).max(LEAST_FLOOR),
    };
    ((tracks, left_out), floor)
}

/// Finds starts of these flights.
///
/// # Errors
/// Where none of them can be fitted.
pub fn begin(
    setting: &Setting,
    dataset: &Dataset,
    (tracks, mut left_out): Tracks,
    options: &Options<'_>,
) -> Result<Begun, FitError> {
    options.begins("starts", tracks.len());
    let mut intervals: Vec<f64> = tracks
        .iter()
        .filter_map(|(_, track)| track.interval())
        .collect();
    let shared = DVector::from_iterator(
        setting.shared.len(),
        setting.shared.iter().map(|shared| shared.model_value),
    );
    let found = batch::each_on(options.threads(), tracks.len(), |index| {
        if options.is_stopped() {
            return Err("interrupted".to_owned());
        }
        let found = fitted_starts(setting, &tracks[index].1, &shared, options);
        options.part_done();
        found
    });
    if options.is_stopped() {
        return Err(FitError::Interrupted);
    }
    let mut state = State {
        tracks: Vec::with_capacity(tracks.len()),
        shared,
        own: Vec::with_capacity(tracks.len()),
        interval: if intervals.is_empty() {
            1.0
        } else {
            median(&mut intervals)
        },
        steps: 0,
        rounds: 0,
    };
    let mut usable = Vec::with_capacity(tracks.len());
    let mut alternatives = Vec::with_capacity(tracks.len());
    for ((flight, track), found) in tracks.into_iter().zip(found) {
        match found {
            Ok(starts) => {
                let starts: Vec<Start> = starts.into_iter().map(|(_, start)| start).collect();
                usable.push(flight);
                state.own.push(starts[0].state.clone());
                state.tracks.push(track);
                alternatives.push(starts);
            }
            Err(reason) => left_out.push((flight, reason)),
        }
    }
    if usable.is_empty() {
        left_out.sort_unstable();
        let each = left_out.iter().take(10);
        let reasons: Vec<String> = each
            .map(|(flight, reason)| format!("  {}: {reason}", dataset.flights[*flight].file))
            .collect();
        return Err(FitError::NoFlight(reasons.join("\n")));
    }
    Ok(Begun {
        state,
        alternatives,
        flights: usable,
        left_out,
    })
}

/// What is said of a flight whose spin was not the least that its samples allow.
pub fn spin_note(turns: i32) -> String {
    format!(
        "between samples it makes whole turns ({turns:+}) beside what neighbouring samples show"
    )
}

/// A track of a flight, cut at the ground.
pub fn track(setting: &Setting, flight: &Flight) -> Result<Track, String> {
    Ok(track_and_poses(setting, flight)?.0)
}

/// The same with the poses in its samples, of a body that turns.
fn track_and_poses(
    setting: &Setting,
    flight: &Flight,
) -> Result<(Track, Vec<Option<Pose>>), String> {
    let mut track = Track::new(setting, flight)?;
    let poses = cut::at_the_ground(setting, &mut track);
    let points = track.seen.iter().flatten().count();
    let unknowns = track.chart.dimension();
    if 3 * points < unknowns {
        let measured = 3 * points;
        return Err(format!(
            "{measured} measured coordinates do not determine the {unknowns} unknowns of its initial state"
        ));
    }
    Ok((track, poses))
}

/// Starts whose first samples were fitted with the shared unknowns held, the one of least spin first; and how well each
/// met them.
pub fn fitted_starts(
    setting: &Setting,
    track: &Track,
    shared: &DVector<f64>,
    options: &Options<'_>,
) -> Result<Vec<(f64, Start)>, String> {
    let samples = track.until(FIRST.0).max(FIRST.1).min(track.times.len());
    let mut fitted = Vec::new();
    let mut refused = String::new();
    for Start { state, turns } in start::starts(setting, track)? {
        match own_only(setting, track, samples, shared, state, options) {
            Ok((squares, state)) => fitted.push((squares, Start { state, turns })),
            Err(reason) => refused = reason,
        }
    }
    if fitted.is_empty() {
        Err(refused)
    } else {
        Ok(fitted)
    }
}
