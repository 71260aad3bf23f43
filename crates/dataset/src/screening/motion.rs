//! Motion that measured attitudes show, beside the readings of an instrument.

use model_spec::compose::Instrument;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::meaning::Meaning;
use super::track::Track;
use crate::contact::PathPoint;
use crate::{Reading, Sensor};

/// What an instrument should read over some time, in inertial components, and what it reads: its mean.
pub struct Comparison {
    /// Angular velocity, rad/s, or specific force, m/s².
    pub expected: Vector3<f64>,
    gravity: Vector3<f64>,
    /// Reading along each axis of the instrument (second index) if that is an axis of the body (first index), in inertial
    /// components.
    along: [[Vector3<f64>; 3]; 3],
    reading: Vector3<f64>,
}

impl Comparison {
    /// What the readings are in inertial components, if this leads from the axes of the instrument to those of the body.
    pub fn turned(&self, turn: &Matrix3<f64>) -> Vector3<f64> {
        let each = self.along.iter().enumerate().flat_map(|(body, along)| {
            let each = along.iter().enumerate();
            each.map(move |(own, reading)| turn[(body, own)] * reading)
        });
        each.sum()
    }

    /// Squared difference of the readings from what is expected, if they are meant so, in a unit of this value.
    pub fn misfit(&self, meaning: &Meaning, unit: f64) -> f64 {
        let read = match meaning.in_room {
            true => meaning.axes.turned(self.reading),
            false => {
                let each = (0..3).map(|body| {
                    let (own, sign) = meaning.axes.along(body);
                    sign * self.along[body][own]
                });
                each.sum()
            }
        };
        let missing = f64::from(meaning.gravity_missing);
        (unit * read - self.expected - missing * self.gravity).norm_squared()
    }
}

/// Sum over the readings of a time span; `lever` is the acceleration of the place of the instrument about the body's origin.
#[derive(Default)]
struct Sum {
    count: f64,
    along: [[Vector3<f64>; 3]; 3],
    reading: Vector3<f64>,
    lever: Vector3<f64>,
}

impl Sum {
    fn add(&mut self, attitude: UnitQuaternion<f64>, reading: Vector3<f64>) {
        let axes = attitude.to_rotation_matrix();
        for (body, along) in self.along.iter_mut().enumerate() {
            for (own, sum) in along.iter_mut().enumerate() {
                *sum += axes.matrix().column(body) * reading[own];
            }
        }
        self.reading += reading;
        self.count += 1.0;
    }

    fn compared(self, expected: Vector3<f64>, gravity: Vector3<f64>) -> Option<Comparison> {
        let mean = |sum: Vector3<f64>| sum / self.count;
        (self.count > 0.0).then(|| Comparison {
            expected: expected + mean(self.lever),
            gravity,
            along: self.along.map(|sums| sums.map(mean)),
            reading: mean(self.reading),
        })
    }
}

/// Compares the readings of one flight with its track: a gyroscope between successive attitudes, an accelerometer in the
/// windows of the track, in which forces are steady.
pub fn comparisons(
    track: &Track,
    readings: impl Iterator<Item = (f64, Reading)>,
    sensor: &Sensor,
    instrument: Instrument,
    gravity: Option<Vector3<f64>>,
) -> Vec<Comparison> {
    let spans: Vec<Span<'_>> = track.points.windows(2).filter_map(Span::of).collect();
    let readings: Vec<(f64, Vector3<f64>)> = readings
        .map(|(time, [x, y, z, _])| (time, Vector3::new(x, y, z)))
        .collect();
    match (instrument, gravity) {
        (Instrument::Gyroscope, _) => {
            let each = spans.iter().filter_map(|span| {
                let mut sum = Sum::default();
                for (time, reading) in within(&readings, span.from.time, span.to.time) {
                    sum.add(span.attitude(*time), *reading);
                }
                sum.compared(span.rate, Vector3::zeros())
            });
            each.collect()
        }
        (Instrument::Accelerometer, Some(gravity)) => {
            let place = Vector3::from(sensor.position);
            let each = track.windows().into_iter().filter_map(|(range, motion)| {
                let mut sum = Sum::default();
                let ends = [range.start, range.end - 1].map(|k| track.points[k].time);
                for span in spans.iter().filter(|span| span.is_within(ends)) {
                    for (time, reading) in within(&readings, span.from.time, span.to.time) {
                        let attitude = span.attitude(*time);
                        sum.add(attitude, *reading);
                        sum.lever += span.rate.cross(&span.rate.cross(&(attitude * place)));
                    }
                }
                sum.compared(motion.acceleration - gravity, gravity)
            });
            each.collect()
        }
        _ => Vec::new(),
    }
}

/// The readings from one time to another, both included.
fn within(readings: &[(f64, Vector3<f64>)], from: f64, to: f64) -> &[(f64, Vector3<f64>)] {
    let first = readings.partition_point(|(time, _)| *time < from);
    let last = readings.partition_point(|(time, _)| *time <= to);
    &readings[first..last]
}

/// Two successive points of a track, and the angular velocity between them, rad/s, inertial.
struct Span<'p> {
    from: &'p PathPoint,
    to: &'p PathPoint,
    start: UnitQuaternion<f64>,
    rate: Vector3<f64>,
}

impl<'p> Span<'p> {
    fn of(pair: &'p [PathPoint]) -> Option<Self> {
        let [from, to] = pair else {
            return None;
        };
        let start = from.attitude?;
        let turn = to.attitude? * start.inverse();
        Some(Self {
            from,
            to,
            start,
            rate: turn.scaled_axis() / (to.time - from.time),
        })
    }

    fn attitude(&self, time: f64) -> UnitQuaternion<f64> {
        UnitQuaternion::from_scaled_axis(self.rate * (time - self.from.time)) * self.start
    }

    fn is_within(&self, [first, last]: [f64; 2]) -> bool {
        self.from.time >= first && self.to.time <= last
    }
}
