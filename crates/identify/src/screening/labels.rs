//! Exchanged labels: measured distances that match the template only after a permutation of the markers' names, in
//! the whole flight or in a part of it.

use super::distances::{Distances, MAX_MARKERS};
use crate::data_fault::{DataFault, FaultKind};
use dataset::statistics::median_of;
use dataset::{Flight, Marker};

/// Maximum number of markers for which all permutations of their labels are tried; with more markers only exchanges of
/// two labels are tried.
const ALL_PERMUTATIONS: usize = 4;
/// Assumed standard deviation of the declared position of a marker, m.
const TEMPLATE_ERROR: f64 = 1e-3;
/// Factor by which the noise of measured distances, estimated from differences of successive samples, is multiplied,
/// because correlated noise makes this estimate too small.
const CORRELATION: f64 = 2.0;
/// Maximum magnitude of one sample's contribution to the log-likelihood ratio of exchanged to declared marker labels;
/// it limits the influence of outliers.
const MAX_OF_SAMPLE: f64 = 25.0;
/// Minimum log-likelihood ratio of exchanged to declared marker labels, summed over consecutive samples, at which the
/// labels are reported as exchanged.
const MIN_EVIDENCE: f64 = 100.0;
/// Limit for reporting marker labels as exchanged: maximum ratio of the squared error of the distances between markers
/// with exchanged labels to that with the declared labels. The contribution of noise is subtracted from both errors.
const ERROR_RATIO: f64 = 0.2;
/// Minimum fraction of a flight's samples with exchanged marker labels at which the fault is reported for the whole
/// flight instead of for a range of times.
const WHOLE: f64 = 0.9;

/// Range of consecutive samples in which the measured distances between markers match the declared distances better
/// after a permutation of the labels, and the log-likelihood ratio of permuted to declared labels in this range.
struct SampleRange {
    first: usize,
    last: usize,
    evidence: f64,
}

/// Data fault of a flight in which labels of markers are exchanged; `None` if the measured distances between markers
/// match the template.
pub fn check(distances: &Distances, flight: &Flight, markers: &[Marker]) -> Option<DataFault> {
    let count = markers.len().min(MAX_MARKERS);
    let mut best: Option<(Vec<usize>, SampleRange)> = None;
    for permutation in permutations(count) {
        let permuted = permuted(distances, &permutation);
        let Some(stretch) = exchanged_range(distances, &permuted) else {
            continue;
        };
        let least = best
            .as_ref()
            .map_or(MIN_EVIDENCE, |(_, best)| best.evidence);
        // Of permutations that fit equally well, the one that moves the fewest labels is preferred.
        if stretch.evidence > 1.01 * least {
            best = Some((permutation, stretch));
        }
    }
    let (permutation, stretch) = best?;
    let names = |change: &dyn Fn(usize) -> String| {
        let moved = (0..count).filter(|&marker| permutation[marker] != marker);
        moved.map(change).collect::<Vec<String>>()
    };
    let moved = names(&|marker| markers[marker].name.clone());
    let listed = match &moved[..] {
        [one, other] => format!("labels {one} and {other} seem exchanged"),
        _ => {
            let each = names(&|marker| {
                format!(
                    "{} is labelled {}",
                    markers[permutation[marker]].name, markers[marker].name
                )
            });
            format!("labels seem exchanged: {}", each.join(", "))
        }
    };
    let samples = stretch.last - stretch.first + 1;
    let file = &flight.file;
    let (from, to) = (flight.times[stretch.first], flight.times[stretch.last]);
    let (part, rows) = match samples as f64 >= WHOLE * flight.times.len() as f64 {
        true => (String::new(), String::new()),
        false => (
            format!(" from t = {from:.3} s to {to:.3} s"),
            " of these rows".to_owned(),
        ),
    };
    Some(DataFault::new(
        flight,
        FaultKind::LabelsExchanged,
        format!(
            "{listed} in {file}{part}: the distances between markers fit the template only then"
        ),
        match moved.len() {
            2 => format!(
                "exchange the columns of {} and {}{rows}",
                moved[0], moved[1]
            ),
            _ => format!("rename the columns{rows}"),
        },
    ))
}

/// Permutations of the labels of `count` markers other than the identity, ordered by the number of labels that they
/// move. For more than [`ALL_PERMUTATIONS`] markers, only the exchanges of two labels are returned.
fn permutations(count: usize) -> Vec<Vec<usize>> {
    let identity: Vec<usize> = (0..count).collect();
    let mut found = Vec::new();
    for i in 0..count {
        for j in i + 1..count {
            let mut exchanged = identity.clone();
            exchanged.swap(i, j);
            found.push(exchanged);
        }
    }
    if count <= ALL_PERMUTATIONS {
        let mut all = vec![Vec::new()];
        for _ in 0..count {
            all = all
                .into_iter()
                .flat_map(|begun: Vec<usize>| {
                    let next = (0..count)
                        .filter(|marker| !begun.contains(marker))
                        .collect::<Vec<_>>();
                    next.into_iter()
                        .map(move |marker| [&begun[..], &[marker]].concat())
                })
                .collect();
        }
        let moved = |p: &Vec<usize>| p.iter().enumerate().filter(|(i, m)| i != *m).count();
        all.retain(|permutation| moved(permutation) > 2);
        all.sort_by_key(moved);
        found.extend(all);
    }
    found
}

/// Distance between the markers of each pair according to their declared positions, m, if the track labelled `marker`
/// is in truth that of marker `permutation[marker]`.
fn permuted(distances: &Distances, permutation: &[usize]) -> Vec<f64> {
    let declared = |a: usize, b: usize| {
        let pair = (a.min(b), a.max(b));
        let index = distances.pairs.iter().position(|known| *known == pair);
        index.map_or(f64::NAN, |index| distances.declared[index])
    };
    let pairs = distances.pairs.iter();
    pairs
        .map(|&(i, j)| declared(permutation[i], permutation[j]))
        .collect()
}

/// Tests one permutation of the marker labels; `permuted` is the distance of each pair of markers, m, that is expected
/// with the permuted labels. Returns the range of consecutive samples with the greatest log-likelihood ratio of
/// permuted to declared labels; `None` if this ratio is at most [`MIN_EVIDENCE`] or the permutation does not remove
/// most of the deviation of the measured from the declared distances (see [`ERROR_RATIO`]).
fn exchanged_range(distances: &Distances, permuted: &[f64]) -> Option<SampleRange> {
    let variance = (CORRELATION * distances.noise).powi(2) + TEMPLATE_ERROR.powi(2);
    let errors = |row: &[f64], declared: &[f64]| -> f64 {
        let pairs = row.iter().zip(declared).filter(|(d, _)| !d.is_nan());
        pairs.map(|(d, declared)| (d - declared).powi(2)).sum()
    };
    let each = distances.samples.iter();
    let squares: Vec<(f64, f64)> = each
        .map(|row| (errors(row, &distances.declared), errors(row, permuted)))
        .collect();
    let (mut start, mut sum, mut best) = (0, 0.0, None::<SampleRange>);
    for (sample, (named, exchanged)) in squares.iter().enumerate() {
        let ratio = (named - exchanged) / variance;
        sum += ratio.clamp(-MAX_OF_SAMPLE, MAX_OF_SAMPLE);
        if sum <= 0.0 {
            (start, sum) = (sample + 1, 0.0);
        } else if best.as_ref().is_none_or(|best| sum > best.evidence) {
            best = Some(SampleRange {
                first: start,
                last: sample,
                evidence: sum,
            });
        }
    }
    let best = best.filter(|best| best.evidence > MIN_EVIDENCE)?;
    let within = &squares[best.first..=best.last];
    let named = median_of(within.iter().map(|(named, _)| *named))?;
    let exchanged = median_of(within.iter().map(|(_, exchanged)| *exchanged))?;
    // Noise contributes to both errors; the error in excess of noise must vanish.
    let noise = distances.pairs.len() as f64 * distances.noise.powi(2);
    (exchanged - noise < ERROR_RATIO * (named - noise).max(0.0)).then_some(best)
}
