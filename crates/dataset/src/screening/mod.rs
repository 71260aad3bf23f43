//! Screening of a dataset for mistakes that a fit cannot recover from, by distances between markers, poses and free
//! fall, without the aerodynamic model.

mod body;
mod copies;
mod distances;
mod free_axes;
mod free_fall;
mod handling;
mod instrument_axes;
mod loads;
mod meaning;
mod mirror;
mod momentum;
mod motion;
mod other_meaning;
mod path_speed;
mod pose_axes;
mod pose_frames;
mod readings;
mod records;
mod sensors;
mod signed_axes;
mod template;
#[cfg(test)]
mod tests;
mod track;
mod units;

use flight::parallel;

pub use self::body::Body;
pub use self::distances::marker_pairs;
pub use self::free_axes::mirrored;
use self::free_fall::FreeFall;
pub use self::mirror::{MEND, is_upside_down};
pub use self::other_meaning::{OtherMeaning, undetermined};
pub use self::pose_frames::Poses;
pub use self::signed_axes::SignedAxes;
use self::track::Track;
use crate::Dataset;
use crate::contact::ContactSearch;
use crate::fault::{DataFault, FaultKind};
use crate::statistics::median_of;

/// Noise of a track that is none of a body: ratio to the median over the flights, and to its own extent.
const ROUGH: (f64, f64) = (30.0, 0.1);

/// Faults in the data of the flights, at most one per flight, and the search for the first contact in each, `None` after
/// a fault; no searches if the tracks of markers do not show the body.
type Screening = (Vec<DataFault>, Vec<Option<ContactSearch>>);

/// The same, and the tracks of flights without faults.
type TrackScreening = (
    Vec<DataFault>,
    Vec<Option<ContactSearch>>,
    Vec<Option<Track>>,
);

/// Screens all flights: the tracks of markers, if they show the body, and the readings of sensors.
pub fn screen(body: &dyn Body, dataset: &Dataset, threads: usize) -> Screening {
    let is_tracked = !body.points().markers.is_empty() && body.sees_positions();
    let of_poses = pose_axes::check(body, dataset);
    let (mut faults, contacts, tracks) = match is_tracked {
        true => screen_tracks(body, dataset, &of_poses, threads),
        false => (of_poses, Vec::new(), Vec::new()),
    };
    for fault in sensors::check(body, dataset, &tracks) {
        if !faults.iter().any(|own| own.file == fault.file) {
            faults.push(fault);
        }
    }
    (faults, contacts)
}

/// Screens the tracks of flights whose poses have no faults, `of_poses`.
fn screen_tracks(
    body: &dyn Body,
    dataset: &Dataset,
    of_poses: &[DataFault],
    threads: usize,
) -> TrackScreening {
    let by_markers = body.points().are_markers;
    let mirror_is_decided =
        by_markers && body.points().has_attitude && mirror::is_decided_by(&body.points().markers);
    let rigid = match by_markers {
        true => body.rigid_pairs(),
        false => Vec::new(),
    };
    let is_rigid = rigid.iter().all(|is_rigid| *is_rigid);
    let each = parallel::each_on(threads, dataset.flights.len(), |index| {
        let flight = &dataset.flights[index];
        let mut of_poses = of_poses.iter();
        let of_pose = of_poses.find(|fault| fault.file == flight.file);
        let fault = of_pose
            .cloned()
            .or_else(|| records::check(body, dataset, index))
            .or_else(|| by_markers.then(|| template::check(dataset, index, &rigid))?)
            .or_else(|| {
                mirror_is_decided.then(|| mirror::check(&body.points().markers, flight))?
            });
        match fault {
            Some(fault) => ((Some(fault), None), None),
            None => {
                let (track, search) = Track::until_contact(body, flight);
                let fault = records::jumps(&track, flight);
                let track = fault.is_none().then_some(track);
                ((fault, track), Some(search))
            }
        }
    });
    let (of_flights, contacts): (Vec<_>, Vec<Option<ContactSearch>>) = each.into_iter().unzip();
    let (mut faults, mut tracks): (Vec<_>, Vec<_>) = of_flights.into_iter().unzip();
    reject_noisy_tracks(dataset, &mut faults, &mut tracks);
    copies::reject(dataset, &mut faults, &mut tracks, threads);
    let faults = compare_flights((body, dataset), is_rigid, (faults, &tracks), threads);
    for (track, flight) in tracks.iter_mut().zip(&dataset.flights) {
        let is_faulty = faults.iter().any(|fault| fault.file == flight.file);
        *track = track.take().filter(|_| !is_faulty);
    }
    (faults, contacts, tracks)
}

/// Adds faults that a comparison of the flights with each other and with gravity reveals.
fn compare_flights(
    (body, dataset): (&dyn Body, &Dataset),
    is_rigid: bool,
    (faults, tracks): (Vec<Option<DataFault>>, &[Option<Track>]),
    threads: usize,
) -> Vec<DataFault> {
    // What is recorded of motors or controls acts beside gravity.
    let flights = tracks.iter().zip(&dataset.flights);
    let tracks = flights.map(|(track, flight)| track.clone().filter(|_| flight.inputs.is_empty()));
    let tracks: Vec<Option<Track>> = tracks.collect();
    let Some(gravity) = loads::gravity(body) else {
        return faults.into_iter().flatten().collect();
    };
    let mut of_fall = FreeFall::new((body, dataset), gravity, &tracks, threads).check();
    if of_fall.is_empty() {
        of_fall = mirror::check_all(body, dataset, &tracks);
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

/// Adds a fault for each path that is far noisier than the others, whose track becomes `None`.
fn reject_noisy_tracks(
    dataset: &Dataset,
    faults: &mut [Option<DataFault>],
    tracks: &mut [Option<Track>],
) {
    let all = tracks.iter().flatten().map(|track| track.noise);
    let usual = median_of(all).unwrap_or(0.0);
    let is_rough = |track: &&Track| track.noise > (ROUGH.1 * track.extent()).max(ROUGH.0 * usual);
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
