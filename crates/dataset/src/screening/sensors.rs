//! Faults of the readings of gyroscopes, accelerometers, speeds and poses: saturated and repeated ones, and those of
//! other units, axes and conventions.

use super::Body;
use super::meaning::Meaning;
use super::other_meaning::OtherMeaning;
use super::readings::{of_flights, series};
use super::records::{self, Repeated};
use super::track::Track;
use super::units::{unit, why};
use super::{free_axes, instrument_axes, loads};
use crate::fault::{DataFault, FaultKind};
use crate::sensor::with_channels;
use crate::{Dataset, Flight, Sensor, SensorKind};

/// Minimum number of samples at the limit, beyond the second number of times the longest run of another value: coarsely
/// rounded readings repeat all their values, and as many samples of one of them show that they do.
const SATURATED: (usize, usize) = (5, 3);

/// Faults of the readings of all sensors; `tracks` are those of the flights that show attitudes and positions.
pub fn check(body: &dyn Body, dataset: &Dataset, tracks: &[Option<Track>]) -> Vec<DataFault> {
    let mut faults = Vec::new();
    let is_instrument = |sensor: &Sensor| matches!(sensor.kind, SensorKind::Instrument(_));
    let has_instruments = dataset.sensors.iter().any(is_instrument);
    let gravity = has_instruments.then(|| loads::gravity(body)).flatten();
    for (sensor, channel) in with_channels(&dataset.sensors) {
        if !matches!(sensor.kind, SensorKind::Summary(_)) {
            let each = dataset.flights.iter();
            faults.extend(each.filter_map(|flight| repeated(flight, (sensor, channel))));
        }
        let found = match sensor.kind {
            SensorKind::Summary(_) | SensorKind::Pose => None,
            SensorKind::Instrument(instrument) => {
                faults.extend(saturated(dataset, (sensor, channel)));
                let own = (sensor, channel, instrument);
                let unit = unit(dataset, instrument, (sensor, channel));
                let unit = unit.filter(|unit| unit.index > 0);
                let unit = unit.map(|unit| OtherMeaning::new(&[own], Meaning::of_unit(unit)));
                let unit = unit.map(|other| other.fault(why(instrument), true));
                unit.or_else(|| instrument_axes::check(dataset, own, (tracks, gravity)))
            }
        };
        faults.extend(
            found
                .into_iter()
                .flat_map(|found| of_flights(dataset, channel, found)),
        );
    }
    if faults.is_empty() {
        faults = free_axes::check(body, dataset, gravity.is_some());
    }
    faults
}

/// Longest run of the same reading along one axis in a flight, in samples: at a limit, and of any other reading.
#[derive(Clone, Copy, Debug, Default)]
struct Runs {
    at_limit: usize,
    elsewhere: usize,
}

fn runs(flight: &Flight, channel: usize, axis: usize, limit: f64) -> Runs {
    let (mut runs, mut run, mut last) = (Runs::default(), 0, f64::NAN);
    for (_, reading) in series(flight, channel) {
        run = if reading[axis] == last { run + 1 } else { 1 };
        last = reading[axis];
        match last.abs() == limit {
            true => runs.at_limit = runs.at_limit.max(run),
            false => runs.elsewhere = runs.elsewhere.max(run),
        }
    }
    runs
}

/// Faults of the flights in which a component of the sensor stays at its greatest magnitude in all flights, and nowhere
/// else as long: readings on a coarse grid repeat whatever they are.
fn saturated(dataset: &Dataset, (sensor, channel): (&Sensor, usize)) -> Vec<DataFault> {
    let mut faults: Vec<DataFault> = Vec::new();
    for (axis, name) in crate::AXES.iter().enumerate() {
        let of_flight = |flight| series(flight, channel).map(|(_, reading)| reading[axis].abs());
        let limit = dataset.flights.iter().flat_map(of_flight);
        let limit = limit.fold(0.0, f64::max);
        let flights = dataset.flights.iter();
        let runs = flights.map(|flight| (flight, runs(flight, channel, axis, limit)));
        let runs: Vec<(&Flight, Runs)> = runs.collect();
        let elsewhere = runs.iter().map(|(_, own)| own.elsewhere).max();
        let elsewhere = elsewhere.unwrap_or(0);
        let least = SATURATED.0 + SATURATED.1 * elsewhere;
        let stays = runs.iter().filter(|(_, own)| own.at_limit >= least);
        // Of readings that repeat elsewhere, too, or are nowhere else, a single long run may be what the body does.
        let is_clear = (1..SATURATED.0).contains(&elsewhere) || stays.clone().count() > 1;
        let is_limit = limit > 0.0 && is_clear;
        for (flight, own) in stays.filter(|_| is_limit) {
            if !faults.iter().any(|fault| fault.file == flight.file) {
                faults.push(saturation((sensor, name), (limit, own.at_limit), flight));
            }
        }
    }
    faults
}

fn saturation(
    (sensor, axis): (&Sensor, &str),
    (limit, samples): (f64, usize),
    flight: &Flight,
) -> DataFault {
    DataFault::new(
        flight,
        FaultKind::Other,
        format!(
            "{}_{axis} is saturated: it stays at {limit} {} in {samples} samples",
            sensor.name,
            sensor.kind.unit()
        ),
        "leave the cells of saturated readings empty, or record with a wider range",
    )
}

/// Fault of a flight in which a sensor repeats its readings, or shows zeros in between.
fn repeated(flight: &Flight, (sensor, channel): (&Sensor, usize)) -> Option<DataFault> {
    let rows = flight.readings.iter().enumerate();
    let track = rows.filter_map(|(sample, row)| {
        let [x, y, z, _] = (*row.get(channel)?)?;
        Some((sample, [x, y, z]))
    });
    let track: Vec<(usize, [f64; 3])> = track.collect();
    // A body at rest before its start and after its end shows the same, as it should.
    let same = |a: &(usize, [f64; 3]), b: &(usize, [f64; 3])| a.1 == b.1;
    let rest = track
        .first()
        .map_or(0, |at| track.iter().take_while(|own| same(own, at)).count());
    let track = &track[rest.saturating_sub(1)..];
    let rest = track.last().map_or(0, |at| {
        track.iter().rev().take_while(|own| same(own, at)).count()
    });
    let track = &track[..track.len() - rest.saturating_sub(1)];
    let name = &sensor.name;
    let zeros = track.iter().filter(|(_, reading)| *reading == [0.0; 3]);
    let zeros = zeros.count();
    let is_dropout = zeros >= 2 && 2 * zeros < track.len();
    let (detail, correction) = match records::repeated(track, 0.0) {
        _ if is_dropout => (
            format!(
                "{name} is exactly zero in {zeros} samples, as where dropouts are written as zeros"
            ),
            "leave the cells of readings that are missing empty",
        ),
        Some(Repeated::Often { still, pairs }) => (
            format!("{name} repeats its readings in {still} of {pairs} intervals"),
            "keep only the samples at which the sensor recorded, or leave repeated cells empty",
        ),
        Some(Repeated::Once { first, last, .. }) => (
            format!(
                "{name} stays at the same reading from t = {:.3} s to {:.3} s, and changes otherwise",
                flight.times[first], flight.times[last]
            ),
            "leave these cells empty",
        ),
        None => return None,
    };
    Some(DataFault::new(
        flight,
        FaultKind::Frozen,
        detail,
        correction,
    ))
}
