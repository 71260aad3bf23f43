//! Readings of one channel of the sensors, and faults of all flights that have any.

use crate::fault::{DataFault, FaultKind};
use crate::{Dataset, Flight, Reading};

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
