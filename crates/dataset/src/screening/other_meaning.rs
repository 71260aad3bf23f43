//! Readings of an instrument that are meant otherwise than stated: what to correct, and the readings converted.

use model_spec::compose::Instrument;
use nalgebra::Vector3;

use super::meaning::Meaning;
use super::readings::{of_flights, series};
use super::units::{UnitOfReadings, unit, units};
use crate::fault::{DataFault, FaultKind};
use crate::levels::CLEARLY_SMALLER;
use crate::sensor::with_channels;
use crate::statistics::median_of;
use crate::{Dataset, Flight, Sensor, SensorKind};

/// Another meaning than the stated one of the readings of an instrument, or of two that are turned alike.
pub struct OtherMeaning {
    /// Name, channel and kind of each instrument.
    instruments: Vec<(String, usize, Instrument)>,
    meaning: Meaning,
}

impl OtherMeaning {
    /// Another meaning of the readings of some instruments, each with its channel and kind.
    pub(super) fn new(of: &[(&Sensor, usize, Instrument)], meaning: Meaning) -> Self {
        let each = of.iter();
        let each = each.map(|(sensor, channel, kind)| (sensor.name.clone(), *channel, *kind));
        Self {
            instruments: each.collect(),
            meaning,
        }
    }

    /// The flight with readings along the axes of the body, converted from this unit.
    pub fn converted(&self, mut flight: Flight) -> Flight {
        for (_, channel, instrument) in &self.instruments {
            let unit = self.meaning.unit.value(*instrument);
            let readings = flight.readings.iter_mut();
            for reading in readings.filter_map(|row| row.get_mut(*channel)?.as_mut()) {
                let [x, y, z, last] = *reading;
                let turned = unit * self.meaning.axes.turned(Vector3::new(x, y, z));
                *reading = [turned.x, turned.y, turned.z, last];
            }
        }
        flight
    }

    /// Whether a fit of the converted readings follows them, given the root mean square residual that it leaves of a sensor,
    /// by name: noise that is as large as the readings fits in any unit.
    pub fn is_followed(&self, dataset: &Dataset, left: impl Fn(&str) -> Option<f64>) -> bool {
        self.instruments.iter().all(|(name, channel, instrument)| {
            let usual = dataset.flights.iter();
            let usual = median_of(usual.filter_map(|own| root_mean_square(own, *channel)));
            let unit = self.meaning.unit.value(*instrument);
            let axis = usual.map(|usual| usual * unit / f64::sqrt(3.0));
            let left = axis.zip(left(name));
            left.is_some_and(|(axis, left)| left < CLEARLY_SMALLER * axis)
        })
    }

    /// Faults of the flights with readings of this meaning, given how it was found and whether no other is as good.
    pub fn faults(&self, dataset: &Dataset, why: &str, is_alone: bool) -> Vec<DataFault> {
        of_flights(dataset, self.instruments[0].1, self.fault(why, is_alone))
    }

    /// Message and correction, given how the meaning was found and whether no other is as good.
    pub fn fault(&self, why: &str, is_alone: bool) -> (FaultKind, (String, String)) {
        let (name, _, instrument) = &self.instruments[0];
        if !self.meaning.axes.is_identity() {
            return self.of_axes(why, is_alone);
        }
        if self.meaning.in_room {
            return (
                FaultKind::AttitudeConvention,
                (
                    format!("{name} seems to be along the axes of the room: {why}"),
                    "write the readings along the axes of the body".to_owned(),
                ),
            );
        }
        let found = match self.meaning.gravity_missing {
            0 => None,
            1 => Some("read accelerations, without gravity"),
            _ => Some("read gravity with the wrong sign"),
        };
        if let Some(found) = found {
            return (
                FaultKind::Other,
                (
                    format!("{name} seems to {found}: {why}"),
                    "write specific forces: at rest an accelerometer reads 9.8 m/s² upwards"
                        .to_owned(),
                ),
            );
        }
        let unit = (name.as_str(), *instrument);
        (FaultKind::SensorUnit, self.of_unit(unit, why))
    }

    fn of_axes(&self, why: &str, is_alone: bool) -> (FaultKind, (String, String)) {
        let axes = self.meaning.axes;
        let (example, seems) = match (is_alone, self.instruments.len()) {
            (true, 1) => ("", "seems"),
            (false, 1) => (", for example", "seems"),
            (true, _) => ("", "seem"),
            (false, _) => (", for example", "seem"),
        };
        let names = self.instruments.iter().map(|(name, ..)| name.as_str());
        let names: Vec<&str> = names.collect();
        let stated = self.instruments.iter().map(|(.., kind)| match kind {
            Instrument::Accelerometer => format!("`accelerometer_axes = {}`", axes.toml()),
            _ => format!("`gyroscope_axes = {}`", axes.toml()),
        });
        let stated: Vec<String> = stated.collect();
        let names = names.join(" and ");
        (
            FaultKind::AttitudeConvention,
            (
                format!(
                    "{names} {seems} to have other axes than the body{example} {axes} for x, y, z: {why}"
                ),
                format!(
                    "state {} in [recording], or turn the readings",
                    stated.join(" and ")
                ),
            ),
        )
    }

    fn of_unit(&self, (sensor, instrument): (&str, Instrument), why: &str) -> (String, String) {
        let own = self.meaning.unit;
        let (unit, _) = units(instrument)[own.index];
        let (key, si) = match instrument {
            Instrument::Accelerometer => ("acceleration", "m/s²"),
            Instrument::Gyroscope => ("angular_rate", "rad/s"),
            Instrument::Speed => ("speed", "m/s"),
        };
        match own.is_converted_twice {
            true => (
                format!(
                    "{sensor} seems to be in {si}, and converted from {unit} nevertheless: {why}"
                ),
                format!(
                    "remove `{key} = \"{unit}\"` from [recording] if it stands there, or write {si}"
                ),
            ),
            false => (
                format!("{sensor} seems to be in {unit}: {why}"),
                format!("state `{key} = \"{unit}\"` in [recording], or write {si}"),
            ),
        }
    }
}

/// Root mean squares of the readings of bodies in flight: a unit by which they are outside is not tried.
fn in_flight(instrument: Instrument) -> std::ops::Range<f64> {
    match instrument {
        Instrument::Gyroscope => 0.3..3000.0,
        Instrument::Accelerometer | Instrument::Speed => 1.0..500.0,
    }
}

/// The other units of the instruments whose unit the mechanics of the body do not determine.
pub fn undetermined(dataset: &Dataset) -> Vec<OtherMeaning> {
    let mut found = Vec::new();
    for (sensor, channel) in with_channels(&dataset.sensors) {
        // A speed alone determines too little for a trial.
        if let SensorKind::Instrument(instrument) = sensor.kind
            && instrument != Instrument::Speed
            && unit(dataset, instrument, (sensor, channel)).is_none()
        {
            let flights = dataset.flights.iter();
            let usual = median_of(flights.filter_map(|own| root_mean_square(own, channel)));
            let is_in_flight = |unit: &UnitOfReadings| {
                let converted = usual.map(|usual| usual * unit.value(instrument));
                converted.is_some_and(|own| in_flight(instrument).contains(&own))
            };
            // Each trial is a fit, and the motion itself tells the unit of most gyroscopes.
            let is_tried = |unit: &UnitOfReadings| {
                (instrument == Instrument::Accelerometer || !unit.is_converted_twice)
                    && is_in_flight(unit)
            };
            let others = UnitOfReadings::all(instrument).skip(1).filter(is_tried);
            let own = (sensor, channel, instrument);
            found.extend(others.map(|unit| OtherMeaning::new(&[own], Meaning::of_unit(unit))));
        }
    }
    found
}

/// Root mean square of the readings of a channel; `None` without any.
pub fn root_mean_square(flight: &Flight, channel: usize) -> Option<f64> {
    let squares = series(flight, channel).map(|(_, [x, y, z, _])| x * x + y * y + z * z);
    let (count, sum) = squares.fold((0.0, 0.0), |(count, sum), own| (count + 1.0, sum + own));
    (count > 0.0).then(|| f64::sqrt(sum / count))
}
