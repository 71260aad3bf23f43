//! Distances between markers that are fixed to the body: measured, and declared by the template.

use crate::pose::distance;
use crate::statistics::{median, median_of, robust_sigma};
use crate::{Flight, Marker};

/// Maximum number of markers whose distances are compared; more add little.
pub const MAX_MARKERS: usize = 8;
/// Maximum relative deviation of a pair's ratio from the median, for a scale error common to all pairs.
const RATIO_SPREAD: f64 = 0.1;
/// Maximum relative deviation of a ratio of lengths from that of a known unit.
const UNIT_TOLERANCE: f64 = 0.05;
/// Deviation of a measured distance that is gross: relative, in m, and in units of the noise of distances; the greatest
/// of them.
const GROSS_ERROR: (f64, f64, f64) = (0.25, 0.02, 8.0);

/// Units of length that users mistake for metres: length of the unit in metres, and its name.
pub const UNITS: [(f64, &str); 6] = [
    (1e-3, "millimetres"),
    (1e-2, "centimetres"),
    (0.0254, "inches"),
    (0.3048, "feet"),
    (0.9144, "yards"),
    (1e3, "kilometres"),
];

/// Unit in which coordinates are `ratio` times as large as in metres: its length in metres and its name.
pub fn unit(ratio: f64) -> Option<(f64, &'static str)> {
    let near = |length: f64| (ratio * length - 1.0).abs() < UNIT_TOLERANCE;
    UNITS.iter().copied().find(|(length, _)| near(*length))
}

/// Names of two units, where coordinates in the first that are read as if in the second come out `ratio` times too large.
pub fn confused(ratio: f64) -> Option<(&'static str, &'static str)> {
    let read_as = |own: f64, read: f64| (ratio * own / read - 1.0).abs() < UNIT_TOLERANCE;
    UNITS.iter().find_map(|&(own, name)| {
        let read = UNITS.iter().find(|(read, _)| read_as(own, *read));
        read.map(|(_, other)| (name, *other))
    })
}

/// Correction of positions, named by `which`, that are in a unit of `length` metres.
pub fn correction(which: &str, length: f64) -> String {
    let multiplied = format!("multiply {which} by {length}");
    if length > 1.0 {
        // Few record in kilometres.
        format!("{multiplied}, or remove `length` from [recording] if the tables are in metres")
    } else {
        multiplied
    }
}

/// All pairs (i, j), i < j, of at most the first eight markers.
pub fn marker_pairs(markers: usize) -> Vec<(usize, usize)> {
    let count = markers.min(MAX_MARKERS);
    (0..count)
        .flat_map(|i| (i + 1..count).map(move |j| (i, j)))
        .collect()
}

/// Distances between the markers of each pair in one flight: measured, and according to the declared marker positions.
pub struct Distances {
    /// Pairs of markers, by marker index. The entries of all other fields are in the order of these pairs.
    pub pairs: Vec<(usize, usize)>,
    /// Measured distances `samples[sample][pair]`, m; NaN if a marker of the pair is missing.
    pub samples: Vec<Vec<f64>>,
    pub declared: Vec<f64>,
    /// Median measured distance between the markers of each pair, m; NaN for a pair that is never measured.
    pub medians: Vec<f64>,
    /// Standard deviation of the noise of a measured distance, m, estimated from differences of successive samples.
    pub noise: f64,
}

impl Distances {
    /// Distances of the pairs that the template fixes: `rigid`, in the order of [`marker_pairs`]. `None` if none is
    /// measured.
    pub fn of(flight: &Flight, markers: &[Marker], rigid: &[bool]) -> Option<Self> {
        let pairs = marker_pairs(markers.len()).into_iter().zip(rigid);
        let pairs: Vec<(usize, usize)> =
            pairs.filter(|(_, rigid)| **rigid).map(|(p, _)| p).collect();
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
            let measured: Vec<f64> = of_pair(pair).collect();
            changes.extend(measured.windows(2).map(|w| (w[1] - w[0]).abs()));
            medians.push(median_of(measured).unwrap_or(f64::NAN));
        }
        if medians.iter().all(|median| median.is_nan()) {
            return None;
        }
        Some(Self {
            declared: declared.collect(),
            noise: robust_sigma(&mut changes) / std::f64::consts::SQRT_2,
            pairs,
            samples,
            medians,
        })
    }

    /// Median ratio of measured to declared distances; `None` if the pairs do not agree on it.
    pub fn ratio(&self) -> Option<f64> {
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

    /// Whether `measured`, m, deviates grossly from the declared distance of a pair.
    pub fn is_gross(&self, measured: f64, pair: usize) -> bool {
        let declared = self.declared[pair];
        let limit = (GROSS_ERROR.0 * declared)
            .max(GROSS_ERROR.1)
            .max(GROSS_ERROR.2 * self.noise);
        (measured - declared).abs() > limit
    }
}
