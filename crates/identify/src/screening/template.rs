//! Faults revealed by the rigid distances between markers: lengths in another unit, labels that are exchanged in a
//! flight or a part of it, a track that does not match the declared position of its marker.

use super::distances::{Distances, MAX_MARKERS, unit};
use super::labels;
use crate::data_fault::{DataFault, FaultKind};
use dataset::{Dataset, Flight, Marker};

/// Minimum magnitude of the natural logarithm of the ratio of measured to declared distances between markers at which a
/// wrong unit is reported; it corresponds to a deviation of about 20 %.
const MIN_LOG_RATIO: f64 = 0.18;
/// Maximum fraction of a marker's samples with grossly wrong distances to other markers at which these samples count as
/// outliers. If the fraction is greater, all positions of the marker are reported as faulty.
const GROSS_FRACTION: f64 = 0.15;

/// First data fault of the flight with the index `flight` that the measured distances between markers reveal; `None` if
/// the distances match the template. `rigid` states for each pair, in the order of
/// [`marker_pairs`](super::distances::marker_pairs), whether the template fixes its distance.
pub fn check(dataset: &Dataset, flight: usize, rigid: &[bool]) -> Option<DataFault> {
    let (flight, markers) = (&dataset.flights[flight], &dataset.markers[..]);
    let distances = Distances::of(flight, markers, rigid)?;
    let labels = || labels::check(&distances, flight, markers);
    // Permutations are judged only if all distances are rigid.
    let all = rigid.iter().all(|rigid| *rigid);
    units(&distances, flight)
        .or_else(|| all.then(labels)?)
        .or_else(|| misplaced_marker(&distances, flight, markers))
}

fn units(distances: &Distances, flight: &Flight) -> Option<DataFault> {
    let ratio = distances.ratio()?;
    if ratio.ln().abs() < MIN_LOG_RATIO {
        return None;
    }
    let of_template = unit(1.0 / ratio);
    let (detail, correction) = match (unit(ratio), of_template) {
        (Some((length, name)), _) => (
            format!(
                "distances between markers are {ratio:.4} times those of the template, as if positions were in {name}"
            ),
            format!("multiply the positions in {} by {length}", flight.file),
        ),
        (None, Some((length, name))) => (
            format!(
                "distances between markers are {ratio:.4} times those of the template, as if the template were in {name}"
            ),
            format!("multiply the markers' positions in dataset.toml by {length}"),
        ),
        (None, None) => (
            format!("distances between markers are {ratio:.3} times those of the template"),
            "check the markers' positions in dataset.toml and the calibration of the cameras"
                .into(),
        ),
    };
    Some(DataFault::new(flight, FaultKind::Units, detail, correction))
}

/// Data fault of a flight due to a marker whose measured distances to the other markers are grossly wrong in many
/// samples; `None` if there is no such marker.
fn misplaced_marker(
    distances: &Distances,
    flight: &Flight,
    markers: &[Marker],
) -> Option<DataFault> {
    let count = markers.len().min(MAX_MARKERS);
    let (mut measured, mut wrong) = (vec![0_usize; count], vec![0_usize; count]);
    let (mut in_pairs, mut seen) = (vec![0_usize; count], vec![false; count]);
    for row in &distances.samples {
        // The marker in most of the wrong pairs is taken to be the misplaced one.
        in_pairs.fill(0);
        seen.fill(false);
        for (pair, &(i, j)) in distances.pairs.iter().enumerate() {
            if row[pair].is_nan() {
                continue;
            }
            (seen[i], seen[j]) = (true, true);
            if distances.is_gross(row[pair], pair) {
                in_pairs[i] += 1;
                in_pairs[j] += 1;
            }
        }
        let most = in_pairs.iter().copied().max().unwrap_or(0);
        for marker in 0..count {
            measured[marker] += usize::from(seen[marker]);
            wrong[marker] += usize::from(most > 0 && in_pairs[marker] == most);
        }
    }
    let fraction = |marker: usize| wrong[marker] as f64 / measured[marker].max(1) as f64;
    let worst = (0..count).max_by(|&a, &b| fraction(a).total_cmp(&fraction(b)))?;
    if fraction(worst) <= GROSS_FRACTION {
        return None;
    }
    let name = &markers[worst].name;
    let (wrong, measured) = (wrong[worst], measured[worst]);
    let pairs = distances.pairs.iter().enumerate();
    let (pair, &(i, j)) = pairs
        .filter(|(pair, (i, j))| (*i == worst || *j == worst) && !distances.medians[*pair].is_nan())
        .max_by(|a, b| {
            let error = |pair: usize| (distances.medians[pair] - distances.declared[pair]).abs();
            error(a.0).total_cmp(&error(b.0))
        })?;
    Some(DataFault::new(
        flight,
        FaultKind::Other,
        format!(
            "marker {name} is not where the template has it in {wrong} of {measured} samples (median distance of {} and {}: {:.3} m, declared {:.3} m)",
            markers[i].name, markers[j].name, distances.medians[pair], distances.declared[pair]
        ),
        format!("check the track and the declared position of {name}, or leave its cells empty"),
    ))
}
