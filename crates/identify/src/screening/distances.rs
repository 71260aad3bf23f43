//! Distances between markers that are rigidly fixed to the body, as measured in a flight and as the template declares
//! them.

use dataset::pose::distance;
use dataset::statistics::{median, median_of, robust_sigma};
use dataset::{Flight, Marker};

/// Maximum number of markers whose mutual distances are compared; more would add little information and much
/// computation.
pub const MAX_MARKERS: usize = 8;
/// Limit at which a scale error counts as common to all pairs of markers. The ratio of measured to declared distance
/// between the markers of a pair may deviate from the median ratio of all pairs by less than this fraction.
const RATIO_SPREAD: f64 = 0.1;
/// Tolerance for recognising that coordinates are in a certain unit of length instead of metres: maximum relative
/// deviation of the ratio of measured to true lengths from the ratio that this unit would give.
const UNIT_TOLERANCE: f64 = 0.05;
/// Minimum deviation of the measured distance between two markers from their declared distance, relative to the latter,
/// at which the measured distance counts as grossly wrong. The limits [`GROSS_DISTANCE`] and [`GROSS_NOISE`] must be
/// exceeded too.
const GROSS: f64 = 0.25;
/// Minimum deviation, m, of the measured distance between two markers from their declared distance, at which the
/// measured distance counts as grossly wrong. The limits [`GROSS`] and [`GROSS_NOISE`] must be exceeded too.
const GROSS_DISTANCE: f64 = 0.02;
/// Minimum deviation of the measured distance between two markers from their declared distance, in units of the
/// standard deviation of the noise of measured distances, at which the measured distance counts as grossly wrong. The
/// limits [`GROSS`] and [`GROSS_DISTANCE`] must be exceeded too.
const GROSS_NOISE: f64 = 8.0;

/// Units of length that users mistake for metres: length of the unit in metres, and its name.
pub const UNITS: [(f64, &str); 6] = [
    (1e-3, "millimetres"),
    (1e-2, "centimetres"),
    (0.0254, "inches"),
    (0.3048, "feet"),
    (0.9144, "yards"),
    (1e3, "kilometres"),
];

/// Unit of length in which coordinates are `ratio` times as large as in metres: its length in metres and its name.
/// `None` if no unit in [`UNITS`] fits.
pub fn unit(ratio: f64) -> Option<(f64, &'static str)> {
    let near = |length: f64| (ratio * length - 1.0).abs() < UNIT_TOLERANCE;
    UNITS.iter().copied().find(|(length, _)| near(*length))
}

/// All pairs (i, j), i < j, of the marker indices below `markers`; at most the first [`MAX_MARKERS`] markers are
/// paired.
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
    /// Distance between the markers of each pair according to the template, m.
    pub declared: Vec<f64>,
    /// Median measured distance between the markers of each pair, m; NaN for a pair that is never measured.
    pub medians: Vec<f64>,
    /// Standard deviation of the noise of a measured distance, m, estimated from differences of successive samples.
    pub noise: f64,
}

impl Distances {
    /// Distances between the markers of those pairs whose distance the template fixes. `rigid` has an entry for each
    /// pair, in the order of [`marker_pairs`], which is true if the distance of the pair is fixed. `None` if no such
    /// pair is measured.
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

    /// Median over the pairs of the ratio of the median measured distance to the declared distance; `None` if the ratio
    /// of any pair deviates from this median by a relative amount of [`RATIO_SPREAD`] or more.
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

    /// Whether `measured`, the measured distance between the markers of pair number `pair`, m, is grossly wrong: its
    /// deviation from the declared distance exceeds all three limits [`GROSS`], [`GROSS_DISTANCE`] and [`GROSS_NOISE`].
    pub fn is_gross(&self, measured: f64, pair: usize) -> bool {
        let declared = self.declared[pair];
        let limit = (GROSS * declared)
            .max(GROSS_DISTANCE)
            .max(GROSS_NOISE * self.noise);
        (measured - declared).abs() > limit
    }
}
