//! Data of the page of an import: curves of a recording and its flights.

use dataset::Marker;
use dataset::pose::distance;
use dataset::takes::{Cut, ImportedTake as Take, Throw};

use super::{Distance, Edge, ImportedFlight, ImportedTake};
use crate::figures::Line;

/// Minimum time before and after a flight in its figures, s.
const AROUND: f64 = 0.5;
const MAX_PAIRS: usize = 45;

impl ImportedTake {
    /// Data on a recording, `file`, whose flights are written with the names `files`.
    pub fn new(file: String, take: &Take, markers: &[Marker], files: &[String]) -> ImportedTake {
        let flights = take.throws.iter().zip(files);
        let heights = take.motion.iter();
        let heights = heights.flat_map(|m| m.times.iter().copied().zip(m.heights.iter().copied()));
        let flights = flights.map(|(throw, file)| flight(take, throw, markers, file));
        ImportedTake {
            file,
            decisions: take.decisions.clone(),
            notes: take.notes.clone(),
            heights: heights.collect(),
            flights: flights.collect(),
        }
    }
}

fn flight(take: &Take, throw: &Throw, markers: &[Marker], file: &str) -> ImportedFlight {
    let times = &take.take.times;
    let span = (times[throw.release.sample], times[throw.end.sample]);
    let around = AROUND.max(0.5 * (span.1 - span.0));
    let window = seen(take, (span.0 - around, span.1 + around));
    let rows = throw.samples();
    let rows = rows.map(|sample| take.followed.positions(&take.take, sample));
    let rows: Vec<Vec<Option<[f64; 3]>>> = rows.collect();
    let missing = markers.iter().enumerate().map(|(i, marker)| {
        let missing = rows.iter().filter(|row| row[i].is_none());
        (marker.name.clone(), missing.count())
    });
    let edge = |cut: &Cut| Edge {
        time: cut.time,
        reason: cut.cause.to_string(),
    };
    ImportedFlight {
        file: file.to_owned(),
        samples: rows.len(),
        release: edge(&throw.release),
        end: edge(&throw.end),
        span,
        gaps: gaps(&times[throw.samples()], &rows),
        missing: missing.filter(|(_, count)| *count > 0).collect(),
        curves: curves(take, window),
        distances: distances(take, markers, window),
    }
}

/// Shrinks a time window to the samples at which the motion of the body is known, if there are any.
fn seen(take: &Take, (from, to): (f64, f64)) -> (f64, f64) {
    let times = take.motion.iter().flat_map(|motion| &motion.times);
    let mut inside = times.filter(|time| from <= **time && **time <= to);
    let first = inside.next().copied().unwrap_or(from);
    (first, inside.next_back().copied().unwrap_or(to))
}

fn curves(take: &Take, (from, to): (f64, f64)) -> Vec<Line> {
    let Some(motion) = &take.motion else {
        return Vec::new();
    };
    let curve = |title: &str, values: &[f64]| {
        let points = motion.times.iter().copied().zip(values.iter().copied());
        Line::new(title, points.filter(|(t, _)| from <= *t && *t <= to))
    };
    let mut curves = vec![
        curve("Height, m", &motion.heights),
        curve("Speed, m/s", &motion.speeds),
    ];
    let rates = motion.rotation.iter();
    curves.extend(rates.map(|rates| curve("Rate of rotation, rad/s", rates)));
    curves
}

/// Measured distances of pairs of markers over a time window; empty if the positions are computed from the pose of a body.
fn distances(take: &Take, markers: &[Marker], window: (f64, f64)) -> Vec<Distance> {
    if take.followed.is_pose() {
        return Vec::new();
    }
    let times = take.take.times.iter().enumerate();
    let times = times.filter(|(_, t)| window.0 <= **t && **t <= window.1);
    let rows = times.map(|(i, t)| (*t, take.followed.positions(&take.take, i)));
    let rows: Vec<(f64, Vec<Option<[f64; 3]>>)> = rows.collect();
    let pairs = (0..markers.len()).flat_map(|i| (i + 1..markers.len()).map(move |j| (i, j)));
    let distances = pairs.take(MAX_PAIRS).map(|(i, j)| {
        let points = rows.iter().map(|(t, row)| {
            let ends = row[i].zip(row[j]);
            (*t, ends.map_or(f64::NAN, |(a, b)| distance(a, b)))
        });
        let (a, b) = (&markers[i], &markers[j]);
        Distance {
            name: format!("{}–{}", a.name, b.name),
            template: distance(a.position, b.position),
            points: points.collect(),
        }
    });
    distances.collect()
}

/// Intervals in which no marker was seen: from the last sample before to the first sample after.
fn gaps(times: &[f64], rows: &[Vec<Option<[f64; 3]>>]) -> Vec<(f64, f64)> {
    let is_seen = |i: &usize| rows[*i].iter().any(Option::is_some);
    let seen: Vec<usize> = (0..rows.len()).filter(is_seen).collect();
    let pairs = seen.windows(2).filter(|pair| pair[1] > pair[0] + 1);
    pairs.map(|pair| (times[pair[0]], times[pair[1]])).collect()
}
