//! Faults of the recorded values themselves: tracks that repeat the same coordinates, dropouts written as zeros, a
//! body that does not move, and a flight that is a copy of another.

use crate::data_fault::{DataFault, FaultKind};
use dataset::Dataset;
use dataset::pose::distance;
use dataset::statistics::median_of;

/// Minimum number of consecutive identical positions of a marker at which its track counts as frozen: the body moves,
/// but the recorded coordinates do not change.
const FROZEN_SAMPLES: usize = 4;
/// Minimum motion, m, for reporting a run of identical positions as frozen: the distance that the marker typically
/// moves in the same time elsewhere in the flight. A slower marker may plausibly repeat its position.
const FROZEN_DISTANCE: f64 = 0.005;
/// Minimum motion for reporting repeated positions of a marker, in units of the resolution of the recorded coordinates.
/// The motion is the distance that the marker typically moves in the same time elsewhere in the flight.
const FROZEN_STEPS: f64 = 10.0;
/// Minimum fraction of the sampling intervals in which the position of a marker does not change, at which the flight is
/// reported as having repeated values, for example after resampling at a higher rate.
const REPEATED_FRACTION: f64 = 0.3;
/// Minimum number of samples at which a flight is checked for being a copy of an earlier flight.
const COPY_SAMPLES: usize = 8;

/// First fault in the recorded values of the flight with the index `flight`: a copy of an earlier flight, or
/// coordinates that are repeated or exactly 0. `None` if there is none.
pub fn check(dataset: &Dataset, flight: usize) -> Option<DataFault> {
    copy(dataset, flight)
        .or_else(|| (0..dataset.markers.len()).find_map(|marker| frozen(dataset, flight, marker)))
}

/// Fault of a flight whose samples equal those of an earlier flight in the dataset; `None` if there is no such flight.
/// Only flights with noise are compared: simulations without noise may be equal, but noise does not repeat.
fn copy(dataset: &Dataset, flight: usize) -> Option<DataFault> {
    let this = &dataset.flights[flight];
    let count = this.positions.len();
    if count < COPY_SAMPLES || !is_noisy(dataset, flight) {
        return None;
    }
    let mut earlier = dataset.flights[..flight].iter();
    let original = earlier.find(|other| other.positions == this.positions)?;
    Some(DataFault::new(
        this,
        FaultKind::Other,
        format!("its samples are a copy of those of {}", original.file),
        format!("remove one of {} and {}", original.file, this.file),
    ))
}

/// Whether the median third difference of the first marker's coordinates exceeds 0.1 mm, as a result of noise; the
/// third differences of a smooth path without noise are smaller at the sampling rates of cameras.
fn is_noisy(dataset: &Dataset, flight: usize) -> bool {
    let rows = &dataset.flights[flight].positions;
    let third = |w: &[Vec<Option<[f64; 3]>>]| {
        let [a, b, c, d] = [w[0][0]?, w[1][0]?, w[2][0]?, w[3][0]?];
        let axis = |k: usize| (d[k] - 3.0 * c[k] + 3.0 * b[k] - a[k]).abs();
        Some(axis(0).max(axis(1)).max(axis(2)))
    };
    median_of(rows.windows(4).filter_map(third)).is_some_and(|size| size > 1e-4)
}

/// Run of consecutive identical positions of a marker.
struct Run {
    start: usize,
    samples: usize,
}

fn frozen(dataset: &Dataset, flight: usize, marker: usize) -> Option<DataFault> {
    let this = &dataset.flights[flight];
    let track: Vec<(usize, [f64; 3])> = (this.positions.iter().enumerate())
        .filter_map(|(sample, row)| Some((sample, row[marker]?)))
        .collect();
    if track.len() < FROZEN_SAMPLES {
        return None;
    }
    let name = &dataset.markers[marker].name;
    let fault = |detail: String, correction: &str| {
        Some(DataFault::new(this, FaultKind::Frozen, detail, correction))
    };
    let zeros = track.iter().filter(|(_, point)| *point == [0.0; 3]).count();
    let far = |point: &[f64; 3]| point.iter().any(|axis| axis.abs() > 0.05);
    if zeros >= 2 && 2 * zeros < track.len() && track.iter().filter(|(_, p)| far(p)).count() > zeros
    {
        return fault(
            format!(
                "marker {name} is at exactly (0, 0, 0) in {zeros} samples, as where dropouts are written as zeros"
            ),
            "leave the cells of a marker that was not seen empty",
        );
    }
    let (runs, still) = runs(&track);
    let pairs = track.len() - 1;
    if let Some(whole) = runs.iter().find(|run| run.samples == track.len()) {
        return fault(
            format!(
                "marker {name} has the same coordinates in all {} samples",
                whole.samples
            ),
            "export the recording again, or remove the flight",
        );
    }
    if still as f64 > REPEATED_FRACTION * pairs as f64
        && moves_by(&track, 1) > resolution(&track) * FROZEN_STEPS
    {
        return fault(
            format!("marker {name} repeats its coordinates in {still} of {pairs} intervals"),
            "keep only the samples at which the cameras recorded, or leave repeated cells empty",
        );
    }
    let longest = runs.into_iter().max_by_key(|run| run.samples)?;
    if longest.samples < FROZEN_SAMPLES {
        return None;
    }
    let usual = moves_by(&track, longest.samples - 1);
    if usual < FROZEN_DISTANCE.max(FROZEN_STEPS * resolution(&track)) {
        return None;
    }
    let (first, last) = (longest.start, longest.start + longest.samples - 1);
    fault(
        format!(
            "marker {name} stays at the same coordinates from t = {:.3} s to {:.3} s, where it moves by {usual:.2} m otherwise",
            this.times[track[first].0], this.times[track[last].0]
        ),
        &format!("leave the cells of {name} empty there"),
    )
}

/// Runs of at least two consecutive identical positions of one marker, and the number of sampling intervals within all
/// of these runs. `track` contains (index of the sample, position in m) for each sample in which the marker was
/// measured.
fn runs(track: &[(usize, [f64; 3])]) -> (Vec<Run>, usize) {
    let (mut runs, mut still, mut start) = (Vec::new(), 0, 0);
    for end in 1..=track.len() {
        if end < track.len() && track[end].1 == track[start].1 {
            continue;
        }
        let samples = end - start;
        if samples > 1 {
            still += samples - 1;
            runs.push(Run { start, samples });
        }
        start = end;
    }
    (runs, still)
}

/// Median distance, m, between two positions in the track of one marker that are `intervals` entries apart; pairs of
/// identical positions are ignored.
fn moves_by(track: &[(usize, [f64; 3])], intervals: usize) -> f64 {
    let pairs = track.iter().zip(&track[intervals.min(track.len())..]);
    let moved = pairs.map(|((_, a), (_, b))| distance(*a, *b));
    median_of(moved.filter(|distance| *distance > 0.0)).unwrap_or(0.0)
}

/// Resolution of a marker's track, m: the smallest nonzero change of a coordinate between successive entries; 0 if
/// there is none.
fn resolution(track: &[(usize, [f64; 3])]) -> f64 {
    let pairs = track.windows(2);
    let steps = pairs.flat_map(|pair| [0, 1, 2].map(|k| (pair[1].1[k] - pair[0].1[k]).abs()));
    // Differences below 0.1 µm are rounding errors of the values.
    let least = steps.filter(|step| *step > 1e-7).min_by(f64::total_cmp);
    least.unwrap_or(0.0)
}
