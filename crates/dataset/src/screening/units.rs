//! Units of the readings of gyroscopes, accelerometers and speeds: those that are stated, and those that the mechanics of the
//! body or the measured path show.

use model_spec::compose::Instrument;
use nalgebra::Vector3;

use super::readings::series;
use crate::sensor::with_channels;
use crate::statistics::median_of;
use crate::{ACCELERATIONS, ANGULAR_RATES, Dataset, Flight, SPEEDS, Sensor, SensorKind};

/// Maximum relative difference of the apparent from a known unit: motions of the axis turn at another rate than the
/// spin.
const UNIT_ERROR: f64 = 0.5;
/// The same of speeds: their units are nearer to one another, and wind may halve a speed.
const SPEED_UNIT_ERROR: f64 = 0.08;
/// Maximum angle by which a direction may turn in the body from sample to sample, rad: nearly half a turn.
const MAX_TURN: f64 = 2.5;
/// Minimum share of what turns in the mean square of the angular velocity across its mean direction; the rest is noise.
const MIN_TURNING: f64 = 0.4;
/// Least rotation over which forces on the body average out in it, rad, and least centripetal acceleration that tells the
/// unit of an accelerometer, m/s².
const MIN_TURNED: f64 = 20.0;
const MIN_CENTRIPETAL: f64 = 10.0;

/// Units in which an instrument may record; the first is that of a dataset.
pub fn units(instrument: Instrument) -> &'static [(&'static str, f64)] {
    match instrument {
        Instrument::Gyroscope => &ANGULAR_RATES,
        Instrument::Accelerometer => &ACCELERATIONS,
        Instrument::Speed => &SPEEDS,
    }
}

/// Why readings are in another unit than the stated one.
pub fn why(instrument: Instrument) -> &'static str {
    match instrument {
        Instrument::Accelerometer => {
            "only in this unit do the readings show the centripetal acceleration that the measured rates give at its place"
        }
        Instrument::Gyroscope => "the readings follow the motion of the body only in this unit",
        Instrument::Speed => "only in this unit are the readings those of the measured path",
    }
}

/// A unit of the readings that a fit is given: one of [`units`], or what one of these is if the values are SI, but were
/// converted from it.
#[derive(Clone, Copy, Default)]
pub struct UnitOfReadings {
    pub index: usize,
    pub is_converted_twice: bool,
}

impl UnitOfReadings {
    /// All units, that of a dataset first.
    pub fn all(instrument: Instrument) -> impl Iterator<Item = Self> {
        let of = |is_converted_twice: bool| {
            let first = usize::from(is_converted_twice);
            (first..units(instrument).len()).map(move |index| Self {
                index,
                is_converted_twice,
            })
        };
        of(false).chain(of(true))
    }

    /// Its value in SI units.
    pub fn value(self, instrument: Instrument) -> f64 {
        let (_, unit) = units(instrument)[self.index];
        if self.is_converted_twice {
            1.0 / unit
        } else {
            unit
        }
    }
}

/// The unit that is nearest to the median of what the flights show; `None` if none is near, or the
/// mechanics of the body do not tell it.
pub fn unit(
    dataset: &Dataset,
    instrument: Instrument,
    (sensor, channel): (&Sensor, usize),
) -> Option<UnitOfReadings> {
    let flights = dataset.flights.iter();
    let found = match instrument {
        Instrument::Speed => {
            let apparent = |own| super::path_speed::apparent_unit(dataset, own, channel);
            median_of(flights.filter_map(apparent))
        }
        Instrument::Gyroscope => median_of(flights.filter_map(|own| apparent_unit(own, channel))),
        Instrument::Accelerometer => {
            let (gyroscope, rates) = gyroscope(dataset)?;
            let of_rates = unit(dataset, Instrument::Gyroscope, (gyroscope, rates));
            if sensor.position_is_unknown || of_rates.is_some_and(|unit| unit.index > 0) {
                return None;
            }
            let place = Vector3::from(sensor.position);
            let apparent = |own| Centripetal::of(own, [channel, rates], place)?.unit();
            median_of(flights.filter_map(apparent))
        }
    }?;
    let error = |unit: UnitOfReadings| (found / unit.value(instrument) - 1.0).abs();
    let known = UnitOfReadings::all(instrument).map(|unit| (unit, error(unit)));
    let nearest = known.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let limit = match instrument {
        Instrument::Speed => SPEED_UNIT_ERROR,
        _ => UNIT_ERROR,
    };
    (nearest.1 < limit).then_some(nearest.0)
}

/// The first gyroscope and its channel.
pub fn gyroscope(dataset: &Dataset) -> Option<(&Sensor, usize)> {
    let gyroscope = SensorKind::Instrument(Instrument::Gyroscope);
    with_channels(&dataset.sensors).find(|(sensor, _)| sensor.kind == gyroscope)
}

/// What an accelerometer off the axis reads across the mean spin in one flight: forces on the body turn with it there, and
/// have no mean.
pub struct Centripetal {
    /// Mean angular velocity, rad/s.
    rate: Vector3<f64>,
    /// Mean reading, in the unit of the recording.
    pub read: Vector3<f64>,
    /// Mean centripetal acceleration across the mean spin, m/s².
    pub expected: Vector3<f64>,
}

impl Centripetal {
    /// From the channels of an accelerometer at `place`, m, and a gyroscope; `None` if the body turns too little.
    pub fn of(flight: &Flight, channels: [usize; 2], place: Vector3<f64>) -> Option<Self> {
        let rows = flight.times.iter().zip(&flight.readings);
        let samples = rows.filter_map(|(time, row)| {
            let [force, rate] = channels.map(|own| row.get(own).copied().flatten());
            let ([x, y, z, _], [p, q, r, _]) = (force?, rate?);
            Some((*time, Vector3::new(x, y, z), Vector3::new(p, q, r)))
        });
        let samples: Vec<(f64, Vector3<f64>, Vector3<f64>)> = samples.collect();
        let count = samples.len() as f64;
        let rate = samples.iter().map(|own| own.2).sum::<Vector3<f64>>() / count;
        let read = samples.iter().map(|own| own.1).sum::<Vector3<f64>>() / count;
        let centripetal = samples.iter().map(|own| own.2.cross(&own.2.cross(&place)));
        let turned = rate.norm() * (samples.last()?.0 - samples[0].0);
        let mut found = Self {
            rate,
            read,
            expected: centripetal.sum::<Vector3<f64>>() / count,
        };
        found.expected = found.across(found.expected);
        (turned > MIN_TURNED).then_some(found)
    }

    /// Part of a vector across the mean spin.
    pub fn across(&self, vector: Vector3<f64>) -> Vector3<f64> {
        vector - self.rate * (self.rate.dot(&vector) / self.rate.norm_squared())
    }

    /// Unit of the readings, m/s²; `None` if the centripetal acceleration is too small to tell.
    fn unit(&self) -> Option<f64> {
        let is_determined = self.expected.norm() > MIN_CENTRIPETAL;
        is_determined
            .then(|| self.expected.norm_squared() / self.expected.dot(&self.across(self.read)))
    }
}

/// Unit of the recorded rates, rad/s: the rate at which their part across the mean turns, over their magnitude; `None`
/// if noise or the interval hide it.
fn apparent_unit(flight: &Flight, channel: usize) -> Option<f64> {
    let rates: Vec<(f64, Vector3<f64>)> = series(flight, channel)
        .map(|(time, [x, y, z, _])| (time, Vector3::new(x, y, z)))
        .collect();
    let mean = rates.iter().map(|(_, rate)| rate).sum::<Vector3<f64>>() / rates.len() as f64;
    let axis = mean.normalize();
    let across = rates.iter().map(|(_, rate)| rate - axis * axis.dot(rate));
    let across: Vec<Vector3<f64>> = across.collect();
    let product = |lag: usize| {
        let pairs = across.iter().zip(across.iter().skip(lag));
        pairs.map(|(a, b)| a.dot(b)).sum::<f64>() / across.len().saturating_sub(lag) as f64
    };
    // A part that turns by φ per sample has the mean products P cos φ and P cos 2φ with the next samples, free of
    // noise: cos φ = x with 2x² − 1 = (cos 2φ/cos φ) x.
    let next = product(1);
    let ratio = product(2) / next;
    let cosine = (ratio + next.signum() * (ratio * ratio + 8.0).sqrt()) / 4.0;
    let turned = cosine.clamp(-1.0, 1.0).acos();
    let is_turning = next / cosine > MIN_TURNING * product(0);
    if !is_turning || turned > MAX_TURN {
        return None;
    }
    let interval = (rates.last()?.0 - rates[0].0) / (rates.len() - 1) as f64;
    Some(turned / interval / mean.norm())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::tests::jitter;
    use crate::screening::tests::calm_disc;

    /// The axis of a body that spins steadily turns with it, also by far more than a right angle from sample to sample.
    #[test]
    fn the_unit_of_rates_is_that_in_which_their_direction_turns() {
        let (_, dataset) = calm_disc(1);
        let mut flight = dataset.flights[0].clone();
        for spin in [20.0, 60.0, 115.0] {
            for unit in [1.0, 1.0_f64.to_radians()] {
                flight.times = (0..100).map(|sample| 0.02 * f64::from(sample)).collect();
                let rates = flight.times.iter().map(|time| {
                    let (sin, cos) = (spin * time).sin_cos();
                    vec![Some(
                        [0.1 * spin * cos, 0.1 * spin * sin, spin, 0.0].map(|own| own / unit),
                    )]
                });
                flight.readings = rates.collect();
                let found = apparent_unit(&flight, 0).expect("it turns");
                assert!((found / unit - 1.0).abs() < 0.02, "{spin} {unit}: {found}");
            }
        }
        // Noise does not turn.
        for (sample, row) in flight.readings.iter_mut().enumerate() {
            row[0] = Some([jitter(2 * sample), jitter(2 * sample + 1), 20.0, 0.0]);
        }
        assert_eq!(apparent_unit(&flight, 0), None);
    }
}
