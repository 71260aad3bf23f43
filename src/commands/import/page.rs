//! Data of the report page of an import: curves of a recording and its flights.

use dataset::takes::{Cut, Motion, Take, Throw};
use dataset::{Flight, Marker};
use report::import::{Curve, Distance, Edge, ImportedFlight};

use super::template::Followed;

/// Minimum duration, s, of the parts of the recording before and after a flight that the figures of the flight show
/// too.
const AROUND: f64 = 0.5;
/// Maximum number of pairs of markers whose distances the figures of a flight show; further pairs are omitted.
const MAX_PAIRS: usize = 45;

/// Data from which the figures of flights are made: a recording with z up, and the points or the body in it whose
/// motion is imported.
pub struct Shown<'a> {
    pub take: &'a Take,
    pub followed: &'a Followed,
    pub markers: &'a [Marker],
    pub motion: Option<&'a Motion>,
}

impl Shown<'_> {
    /// Data for the report page on one flight: curves of the body's motion and measured distances between markers,
    /// during the flight and shortly before and after it. Also lists gaps and missing markers.
    pub fn flight(&self, throw: &Throw, flight: &Flight) -> ImportedFlight {
        let times = &self.take.times;
        let span = (times[throw.release.sample], times[throw.end.sample]);
        let around = AROUND.max(0.5 * (span.1 - span.0));
        let window = self.seen((span.0 - around, span.1 + around));
        ImportedFlight {
            file: flight.file.clone(),
            samples: flight.times.len(),
            release: edge(&throw.release),
            end: edge(&throw.end),
            span,
            gaps: gaps(flight),
            missing: self.missing(flight),
            curves: self.curves(window),
            distances: self.distances(window),
        }
    }

    /// Shrinks a time window (s): its start becomes the time of the first sample in the window at which the motion of
    /// the body is known, and its end the time of the last. A window without such a sample is returned unchanged; with
    /// only one such sample, the end is unchanged.
    fn seen(&self, (from, to): (f64, f64)) -> (f64, f64) {
        let times = self.motion.map_or(&[][..], |motion| &motion.times);
        let mut inside = times.iter().filter(|time| from <= **time && **time <= to);
        let first = inside.next().copied().unwrap_or(from);
        (first, inside.next_back().copied().unwrap_or(to))
    }

    fn curves(&self, window: (f64, f64)) -> Vec<Curve> {
        let Some(motion) = self.motion else {
            return Vec::new();
        };
        let curve = |title: &str, values: &[f64]| Curve {
            title: title.to_owned(),
            points: within(
                motion.times.iter().copied().zip(values.iter().copied()),
                window,
            ),
        };
        let mut curves = vec![
            curve("Height, m", &motion.heights),
            curve("Speed, m/s", &motion.speeds),
        ];
        if let Some(rates) = &motion.rotation {
            curves.push(curve("Rate of rotation, rad/s", rates));
        }
        curves
    }

    /// Measured distances of pairs of markers, at most [`MAX_PAIRS`], over a time window (s); empty if the marker
    /// positions are computed from the pose of a body, because their distances are then constant.
    fn distances(&self, window: (f64, f64)) -> Vec<Distance> {
        if self.followed.is_pose() {
            return Vec::new();
        }
        let samples = 0..self.take.times.len();
        let samples =
            samples.filter(|&i| window.0 <= self.take.times[i] && self.take.times[i] <= window.1);
        let rows: Vec<(f64, Vec<Option<[f64; 3]>>)> = samples
            .map(|i| (self.take.times[i], self.followed.positions(self.take, i)))
            .collect();
        let mut distances = Vec::new();
        for (i, a) in self.markers.iter().enumerate() {
            for (j, b) in self.markers.iter().enumerate().skip(i + 1) {
                if distances.len() == MAX_PAIRS {
                    return distances;
                }
                let points = rows.iter().map(|(time, row)| match (row[i], row[j]) {
                    (Some(a), Some(b)) => (*time, distance(a, b)),
                    _ => (*time, f64::NAN),
                });
                distances.push(Distance {
                    name: format!("{}–{}", a.name, b.name),
                    template: distance(a.position, b.position),
                    points: points.collect(),
                });
            }
        }
        distances
    }

    /// Names of the markers that are missing in some samples of a flight, with the number of these samples.
    fn missing(&self, flight: &Flight) -> Vec<(String, usize)> {
        let count = |i: usize| {
            flight
                .positions
                .iter()
                .filter(|row| row[i].is_none())
                .count()
        };
        let markers = self.markers.iter().enumerate();
        let each = markers.map(|(i, marker)| (marker.name.clone(), count(i)));
        each.filter(|(_, count)| *count > 0).collect()
    }
}

/// Height of the centroid of the tracked points over the whole recording, as pairs of time (s) and height (m); empty if
/// the motion is unknown.
pub fn heights(motion: Option<&Motion>) -> Vec<(f64, f64)> {
    motion.map_or_else(Vec::new, |motion| {
        motion
            .times
            .iter()
            .copied()
            .zip(motion.heights.iter().copied())
            .collect()
    })
}

fn edge(cut: &Cut) -> Edge {
    Edge {
        time: cut.time,
        reason: cut.cause.to_string(),
    }
}

/// Time intervals of a flight, s, in which no marker was seen: from the last sample before to the first sample after.
fn gaps(flight: &Flight) -> Vec<(f64, f64)> {
    let is_seen = |row: &Vec<Option<[f64; 3]>>| row.iter().any(Option::is_some);
    let seen = flight.times.iter().zip(&flight.positions).enumerate();
    let seen: Vec<(usize, f64)> = seen
        .filter(|(_, (_, row))| is_seen(row))
        .map(|(i, (&time, _))| (i, time))
        .collect();
    let pairs = seen.windows(2).filter(|pair| pair[1].0 > pair[0].0 + 1);
    pairs.map(|pair| (pair[0].1, pair[1].1)).collect()
}

fn within(points: impl Iterator<Item = (f64, f64)>, window: (f64, f64)) -> Vec<(f64, f64)> {
    points
        .filter(|(time, _)| window.0 <= *time && *time <= window.1)
        .collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}
