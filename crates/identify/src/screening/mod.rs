//! Screening of a dataset before a fit: finds laboratory mistakes that a fit cannot recover from, by the distances
//! between markers, by poses and by free fall, without the aerodynamic model.

mod distances;
mod free_fall;
mod gravity;
mod handling;
mod jumps;
mod labels;
mod loads;
mod mirror;
mod records;
mod rigid;
mod sensors;
mod template;
#[cfg(test)]
mod tests;
mod track;
mod turned;

use crate::data_fault::{DataFault, FaultKind};

use flight::parallel;

use self::free_fall::FreeFall;
use self::track::Track;
use crate::error::{ExcludedFlight, FlightError};
use crate::ground_contact::ContactSearch;
use crate::ids::FlightId;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use dataset::Dataset;
use dataset::statistics::median_of;

/// Minimum ratio of the noise of a flight's path to the median noise of all flights at which a fault is reported: the
/// data are then too noisy to be those of a flying body. The limit [`NOISE_PART`] must be exceeded too.
const NOISE_RATIO: f64 = 30.0;
/// Minimum ratio of the noise of a flight's path to the spatial extent of the path at which a fault is reported: the
/// data are then too noisy to be those of a flying body. The limit [`NOISE_RATIO`] must be exceeded too.
const NOISE_PART: f64 = 0.1;

/// Result of screening (checking) a dataset for recording mistakes, such as wrong units or exchanged markers.
#[derive(Debug, Default)]
pub(crate) struct Screening {
    /// Faults in the data of the flights, in the order of the dataset, at most one per flight.
    pub faults: Vec<DataFault>,
    /// Results of the search for the first ground contact, one for each flight, in the order of the dataset: `None` if
    /// a fault of the flight prevented the search. Empty if the faults come from an earlier screening.
    pub contacts: Vec<Option<ContactSearch>>,
}

/// Screens the flights of a dataset, both fitted and held out, for recording mistakes from which a fit cannot recover:
/// the tracks of markers, if they show the body, and the readings of sensors. Uses `threads` threads.
pub(crate) fn screen(problem: &FitProblem, dataset: &Dataset, threads: usize) -> Screening {
    let mut found = if problem.is_shown_by_markers() && !problem.markers.is_empty() {
        screen_tracks(problem, dataset, threads)
    } else {
        Screening::default()
    };
    for fault in sensors::check(problem, dataset) {
        if !found.faults.iter().any(|own| own.file == fault.file) {
            found.faults.push(fault);
        }
    }
    found
}

/// Screens the tracks of the markers of a dataset.
fn screen_tracks(problem: &FitProblem, dataset: &Dataset, threads: usize) -> Screening {
    let mirror_is_decided = problem.has_attitude && mirror::is_decided_by(&problem.markers);
    let rigid = rigid::rigid_pairs(problem);
    let is_rigid = rigid.iter().all(|is_rigid| *is_rigid);
    let each = parallel::each_on(threads, dataset.flights.len(), |index| {
        let flight = &dataset.flights[index];
        let fault = records::check(dataset, index)
            .or_else(|| template::check(dataset, index, &rigid))
            .or_else(|| mirror_is_decided.then(|| mirror::check(&problem.markers, flight))?);
        match fault {
            Some(fault) => ((Some(fault), None), None),
            None => {
                let (track, search) =
                    Track::until_contact(problem, &flight.times, &flight.positions);
                let fault = jumps::check(&track, flight);
                let track = fault.is_none().then_some(track);
                ((fault, track), Some(search))
            }
        }
    });
    let (of_flights, contacts): (Vec<_>, Vec<Option<ContactSearch>>) = each.into_iter().unzip();
    let (faults, tracks) = of_flights.into_iter().unzip();
    let faults = compare_flights((problem, dataset), is_rigid, (faults, tracks), threads);
    Screening { faults, contacts }
}

/// Compares the motion of the flights with each other and with gravity, and adds the faults that this reveals to
/// `faults`, which were found by checks of single flights. Returns all faults. `faults` and `tracks` (paths of the
/// bodies) have one entry per flight. Uses `threads` threads.
fn compare_flights(
    (problem, dataset): (&FitProblem, &Dataset),
    is_rigid: bool,
    (mut faults, mut tracks): (Vec<Option<DataFault>>, Vec<Option<Track>>),
    threads: usize,
) -> Vec<DataFault> {
    reject_noisy_tracks(dataset, &mut faults, &mut tracks);
    let Some(gravity) = gravity::gravity(problem) else {
        return faults.into_iter().flatten().collect();
    };
    let mut of_fall = FreeFall::new((problem, dataset), gravity, &tracks, threads).check();
    if of_fall.is_empty() {
        of_fall = turned::check(problem, dataset, &tracks);
    }
    let each = parallel::each_on(threads, dataset.flights.len(), |index| {
        let flight = &dataset.flights[index];
        let found = of_fall.iter().find(|fault| fault.file == flight.file);
        match (&faults[index], found, &tracks[index]) {
            (Some(fault), ..) | (None, Some(fault), _) => Some(fault.clone()),
            // Poses from misplaced markers wobble with the spin, as if the body were pushed.
            (None, None, Some(track)) if is_rigid => handling::check(track, gravity, flight),
            (None, None, _) => None,
        }
    });
    each.into_iter().flatten().collect()
}

/// Adds a data fault for each flight whose measured path is far noisier than the paths of the other flights and than
/// any measured flight can be. The entry of the flight in `tracks` is set to `None`.
fn reject_noisy_tracks(
    dataset: &Dataset,
    faults: &mut [Option<DataFault>],
    tracks: &mut [Option<Track>],
) {
    let all = tracks.iter().flatten().map(|track| track.noise);
    let usual = median_of(all).unwrap_or(0.0);
    let is_rough =
        |track: &&Track| track.noise > (NOISE_PART * track.extent()).max(NOISE_RATIO * usual);
    for (index, flight) in dataset.flights.iter().enumerate() {
        let Some(track) = tracks[index].as_ref().filter(is_rough) else {
            continue;
        };
        faults[index] = Some(DataFault::new(
            flight,
            FaultKind::Other,
            format!(
                "its positions scatter by {:.2} m from sample to sample, unlike those of the other flights",
                track.noise
            ),
            "check that the table is of a flight",
        ));
        tracks[index] = None;
    }
}

/// Flights that a fit excludes because of the faults in their data; empty if the option `trust_data` includes faulty
/// flights.
pub(crate) fn excluded(
    dataset: &Dataset,
    faults: &[DataFault],
    options: &FitOptions<'_>,
) -> Vec<ExcludedFlight> {
    let mut excluded = Vec::new();
    if options.trust_data {
        return excluded;
    }
    for (index, flight) in dataset.flights.iter().enumerate() {
        let fault = faults.iter().find(|fault| fault.file == flight.file);
        excluded.extend(fault.map(|fault| ExcludedFlight {
            flight: FlightId::new(index),
            file: flight.file.clone(),
            reason: FlightError::DataFault(fault.clone()),
        }));
    }
    excluded
}
