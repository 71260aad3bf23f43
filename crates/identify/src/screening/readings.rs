//! Readings of one channel of the sensors, and faults of all flights that have any.

use crate::error::{DataFault, FaultKind};
use dataset::{Dataset, Flight, Reading, Sensor};

/// The sensors, each with its first channel.
pub fn sensors(dataset: &Dataset) -> impl Iterator<Item = (&Sensor, usize)> {
    dataset.sensors.iter().scan(0, |next, sensor| {
        let channel = *next;
        *next += sensor.kind.channels().len();
        Some((sensor, channel))
    })
}

/// Times, s, and readings of a channel, where it has any.
pub fn series(flight: &Flight, channel: usize) -> impl Iterator<Item = (f64, Reading)> {
    let samples = flight.times.iter().zip(&flight.readings);
    samples.filter_map(move |(time, row)| Some((*time, (*row.get(channel)?)?)))
}

/// A fault of every flight with readings in a channel.
pub fn of_flights(
    dataset: &Dataset,
    channel: usize,
    (kind, (detail, correction)): (FaultKind, (String, String)),
) -> Vec<DataFault> {
    let flights = dataset.flights.iter();
    let with = flights.filter(|flight| series(flight, channel).next().is_some());
    with.map(|flight| DataFault::new(flight, kind, &*detail, &*correction))
        .collect()
}
