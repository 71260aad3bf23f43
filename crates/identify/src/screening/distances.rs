//! Faults that the rigid distances between markers show: lengths in another unit, labels that are exchanged in a
//! flight or a part of it, a track that lies elsewhere.

use super::fault::{DataFault, FaultKind};
use super::labels;
use crate::dataset::{Dataset, Flight, Marker};
use crate::statistics::median;

/// Greatest number of markers whose distances are compared: further ones add little and cost much.
pub const MOST_MARKERS: usize = 8;
/// Least logarithm of the ratio of measured to declared distances that is a matter of units: 20 %.
const LEAST_LOG_RATIO: f64 = 0.18;
/// Greatest relative deviation of a pair's ratio from the ratio of all pairs.
const RATIO_SPREAD: f64 = 0.1;
/// Relative deviation of a ratio from a unit's below which the unit is named.
const UNIT_TOLERANCE: f64 = 0.05;
/// Least relative error of a distance that is grossly wrong.
const GROSS: f64 = 0.25;
/// Least error of a distance that is grossly wrong, m.
const GROSS_DISTANCE: f64 = 0.02;
/// Least error of a distance that is grossly wrong, in units of its noise.
const GROSS_NOISE: f64 = 8.0;
/// Fraction of a marker's samples with grossly wrong distances above which the track is faulty; fewer are outliers.
const GROSS_FRACTION: f64 = 0.15;

/// Lengths of units in metres, with their names.
pub const UNITS: [(f64, &str); 6] = [
    (1e-3, "millimetres"),
    (1e-2, "centimetres"),
    (0.0254, "inches"),
    (0.3048, "feet"),
    (0.9144, "yards"),
    (1e3, "kilometres"),
];

/// The unit of coordinates that are `ratio` times as large as in metres.
pub fn unit(ratio: f64) -> Option<(f64, &'static str)> {
    let near = |length: f64| (ratio * length - 1.0).abs() < UNIT_TOLERANCE;
    UNITS.iter().copied().find(|(length, _)| near(*length))
}

/// Measured distances of the pairs of markers in one flight.
pub struct Distances {
    /// The pairs, by marker index.
    pub pairs: Vec<(usize, usize)>,
    /// `samples[sample][pair]`, m; NaN where a marker is missing.
    pub samples: Vec<Vec<f64>>,
    /// Declared distances of the pairs, m.
    pub declared: Vec<f64>,
    /// Median measured distances, m; NaN for a pair that is never measured.
    pub medians: Vec<f64>,
    /// Standard deviation of a measured distance, m, by differences of neighbouring samples.
    pub noise: f64,
}

impl Distances {
    /// Distances of the first [`MOST_MARKERS`] markers of a flight; none if no pair is measured.
    pub fn of(flight: &Flight, markers: &[Marker]) -> Option<Self> {
        let count = markers.len().min(MOST_MARKERS);
        let pairs: Vec<(usize, usize)> = (0..count)
            .flat_map(|i| (i + 1..count).map(move |j| (i, j)))
            .collect();
        if pairs.is_empty() {
            return None;
        }
        let declared = pairs
            .iter()
            .map(|&(i, j)| distance(markers[i].position, markers[j].position));
        let row = |row: &Vec<Option<[f64; 3]>>| {
            let each = pairs.iter().map(|&(i, j)| match (row[i], row[j]) {
                (Some(a), Some(b)) => distance(a, b),
                _ => f64::NAN,
            });
            each.collect::<Vec<f64>>()
        };
        let samples: Vec<Vec<f64>> = flight.positions.iter().map(row).collect();
        let of_pair = |pair: usize| {
            samples
                .iter()
                .map(move |row| row[pair])
                .filter(|d| !d.is_nan())
        };
        let (mut medians, mut changes) = (Vec::with_capacity(pairs.len()), Vec::new());
        for pair in 0..pairs.len() {
            let mut measured: Vec<f64> = of_pair(pair).collect();
            changes.extend(measured.windows(2).map(|w| (w[1] - w[0]).abs()));
            medians.push(match measured.is_empty() {
                true => f64::NAN,
                false => median(&mut measured),
            });
        }
        if medians.iter().all(|median| median.is_nan()) {
            return None;
        }
        Some(Self {
            declared: declared.collect(),
            noise: 1.4826 * median(&mut changes) / std::f64::consts::SQRT_2,
            pairs,
            samples,
            medians,
        })
    }

    /// Median ratio of measured to declared distances, if all pairs agree on it.
    fn ratio(&self) -> Option<f64> {
        let pairs = self.medians.iter().zip(&self.declared);
        let ratios: Vec<f64> = pairs
            .filter(|(m, _)| !m.is_nan())
            .map(|(m, d)| m / d)
            .collect();
        let common = median(&mut ratios.clone());
        let agree = ratios
            .iter()
            .all(|ratio| (ratio / common - 1.0).abs() < RATIO_SPREAD);
        (agree && common > 0.0).then_some(common)
    }

    /// Whether the error of a pair's distance in a sample is gross.
    fn is_gross(&self, measured: f64, pair: usize) -> bool {
        let declared = self.declared[pair];
        let limit = (GROSS * declared)
            .max(GROSS_DISTANCE)
            .max(GROSS_NOISE * self.noise);
        (measured - declared).abs() > limit
    }
}

/// First fault of a flight that its distances show; none if they are those of the template.
pub fn check(dataset: &Dataset, flight: usize) -> Option<DataFault> {
    let (flight, markers) = (&dataset.flights[flight], &dataset.markers[..]);
    let distances = Distances::of(flight, markers)?;
    units(&distances, flight)
        .or_else(|| labels::check(&distances, flight, markers))
        .or_else(|| elsewhere(&distances, flight, markers))
}

fn units(distances: &Distances, flight: &Flight) -> Option<DataFault> {
    let ratio = distances.ratio()?;
    if ratio.ln().abs() < LEAST_LOG_RATIO {
        return None;
    }
    let of_template = unit(1.0 / ratio);
    let (detail, mend) = match (unit(ratio), of_template) {
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
    Some(DataFault {
        file: flight.file.clone(),
        fault: FaultKind::Units,
        detail,
        mend,
    })
}

/// A marker whose distances to the others are grossly wrong in many samples.
fn elsewhere(distances: &Distances, flight: &Flight, markers: &[Marker]) -> Option<DataFault> {
    let count = markers.len().min(MOST_MARKERS);
    let (mut measured, mut wrong) = (vec![0_usize; count], vec![0_usize; count]);
    for row in &distances.samples {
        let gross: Vec<bool> = (0..row.len())
            .map(|pair| !row[pair].is_nan() && distances.is_gross(row[pair], pair))
            .collect();
        // The marker in most of the wrong pairs is the one that is elsewhere.
        let mut in_pairs = vec![0_usize; count];
        let mut seen = vec![false; count];
        for (pair, &(i, j)) in distances.pairs.iter().enumerate() {
            if !row[pair].is_nan() {
                (seen[i], seen[j]) = (true, true);
            }
            if gross[pair] {
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
    Some(DataFault {
        file: flight.file.clone(),
        fault: FaultKind::Other,
        detail: format!(
            "marker {name} is not where the template has it in {wrong} of {measured} samples (median distance of {} and {}: {:.3} m, declared {:.3} m)",
            markers[i].name, markers[j].name, distances.medians[pair], distances.declared[pair]
        ),
        mend: format!(
            "check the track and the declared position of {name}, or leave its cells empty"
        ),
    })
}

pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}
