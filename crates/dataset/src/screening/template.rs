//! Faults that distances between markers reveal: a unit of length, exchanged labels, a misplaced marker.

use super::distances::{Distances, MAX_MARKERS, confused, correction, unit};
use crate::fault::{DataFault, FaultKind};
use crate::statistics::median_of;
use crate::{Dataset, Flight, Marker};

/// Minimum magnitude of the log ratio of measured to declared distances for a wrong unit: about 20 %.
const MIN_LOG_RATIO: f64 = 0.18;
/// Maximum fraction of a marker's samples with gross distances that are outliers.
const GROSS_FRACTION: f64 = 0.15;

/// First fault of the flight that the distances reveal; `rigid` is that of [`rigid_pairs`](super::distances::rigid_pairs).
pub fn check(dataset: &Dataset, flight: usize, rigid: &[bool]) -> Option<DataFault> {
    let (flight, markers) = (&dataset.flights[flight], &dataset.markers[..]);
    let distances = Distances::of(flight, markers, rigid)?;
    let labels = || labels(&distances, flight, markers);
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
            correction(&format!("the positions in {}", flight.file), length),
        ),
        (None, Some((length, name))) => (
            format!(
                "distances between markers are {ratio:.4} times those of the template, as if the template were in {name}"
            ),
            format!("multiply the markers' positions in dataset.toml by {length}"),
        ),
        (None, None) => {
            let read = confused(ratio);
            let as_if = read.map(|(own, read)| format!(", as if {own} had been read as {read}"));
            (
                format!(
                    "distances between markers are {ratio:.3} times those of the template{}",
                    as_if.unwrap_or_default()
                ),
                match read {
                    Some((own, _)) => format!("state that the recording of {} is in {own}", flight.file),
                    None => "check the markers' positions in the template and the calibration of the cameras".into(),
                },
            )
        }
    };
    Some(DataFault::new(flight, FaultKind::Units, detail, correction))
}

/// Fault of a marker whose distances to the others are gross in many samples.
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

// Exchanged labels: distances that match the template only after a permutation of the markers' names.

/// Maximum number of markers for which all permutations are tried; else exchanges of two.
const ALL_PERMUTATIONS: usize = 4;
/// Standard deviation of the declared position of a marker, m, and factor of the noise of distances, which correlated
/// noise makes too small.
const ASSUMED_ERROR: (f64, f64) = (1e-3, 2.0);

/// Log-likelihood ratio of exchanged to declared labels: at most that of one sample, at least that of consecutive samples
/// together.
const EVIDENCE: (f64, f64) = (25.0, 100.0);

/// Maximum ratio of the squared errors with exchanged labels to those with declared labels, without noise.
const ERROR_RATIO: f64 = 0.2;
/// Minimum fraction of exchanged samples for a fault of the whole flight.
const WHOLE: f64 = 0.9;

/// Consecutive samples that match better after a permutation, and the log-likelihood ratio in them.
struct SampleRange {
    first: usize,
    last: usize,
    evidence: f64,
}

fn labels(distances: &Distances, flight: &Flight, markers: &[Marker]) -> Option<DataFault> {
    let count = markers.len().min(MAX_MARKERS);
    let mut best: Option<(Vec<usize>, SampleRange)> = None;
    for permutation in permutations(count) {
        let permuted = permuted(distances, &permutation);
        let Some(stretch) = exchanged_range(distances, &permuted) else {
            continue;
        };
        let least = best.as_ref().map_or(EVIDENCE.1, |(_, best)| best.evidence);
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

/// Permutations other than the identity, those that move fewer labels first.
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

/// Distances that the template declares, m, if the track labelled `marker` is that of `permutation[marker]`.
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

/// Range of samples with the greatest log-likelihood ratio for the distances `permuted`, m; `None` if it is too small,
/// or the permutation does not remove most of the deviation.
fn exchanged_range(distances: &Distances, permuted: &[f64]) -> Option<SampleRange> {
    let variance = (ASSUMED_ERROR.1 * distances.noise).powi(2) + ASSUMED_ERROR.0.powi(2);
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
        sum += ratio.clamp(-EVIDENCE.0, EVIDENCE.0);
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
    let best = best.filter(|best| best.evidence > EVIDENCE.1)?;
    let within = &squares[best.first..=best.last];
    let named = median_of(within.iter().map(|(named, _)| *named))?;
    let exchanged = median_of(within.iter().map(|(_, exchanged)| *exchanged))?;
    // Noise contributes to both errors; the error in excess of noise must vanish.
    let noise = distances.pairs.len() as f64 * distances.noise.powi(2);
    (exchanged - noise < ERROR_RATIO * (named - noise).max(0.0)).then_some(best)
}
