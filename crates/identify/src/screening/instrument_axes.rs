//! Axes, units and frames of gyroscopes and accelerometers, compared with the motion that measured attitudes show.

use model_spec::compose::Instrument;
use nalgebra::Vector3;

use super::momentum::is_clearly_better;
use super::motion::{Comparison, comparisons};
use super::readings::series;
use super::signed_axes::SignedAxes;
use super::track::Track;
use super::units::{OtherUnit, UnitOfReadings};
use crate::error::FaultKind;
use dataset::{Dataset, Sensor};

/// Ratio of the misfit to the least one up to which an interpretation of the readings is as good.
const AS_GOOD: f64 = 1.2;

/// How the readings of an instrument may be meant.
#[derive(Clone, Copy)]
pub struct Meaning {
    pub axes: SignedAxes,
    pub unit: UnitOfReadings,
    /// Along the axes of the room, instead of those of the body.
    pub in_room: bool,
    /// Acceleration, instead of the specific force.
    pub without_gravity: bool,
}

impl Meaning {
    /// All meanings of an instrument, that of a dataset first, and simple ones before others.
    fn all(instrument: Instrument) -> Vec<Self> {
        let is_accelerometer = instrument == Instrument::Accelerometer;
        let mut all = Vec::new();
        for axes in SignedAxes::all() {
            for unit in UnitOfReadings::all(instrument) {
                for in_room in [false, true] {
                    for without_gravity in [false, true] {
                        let is_possible = is_accelerometer || !without_gravity;
                        all.extend(is_possible.then_some(Self {
                            axes,
                            unit,
                            in_room,
                            without_gravity,
                        }));
                    }
                }
            }
        }
        all.sort_by_key(Self::changes);
        all
    }

    /// Number of changes from what the readings are in a dataset.
    fn changes(&self) -> usize {
        let others = [self.unit.index > 0, self.in_room, self.without_gravity];
        self.axes.changes() + others.into_iter().filter(|is_other| *is_other).count()
    }
}

/// Kind, message and correction of readings that follow the motion of the body only with another meaning.
pub fn check(
    dataset: &Dataset,
    (sensor, channel, instrument): (&Sensor, usize, Instrument),
    (tracks, gravity): (&[Option<Track>], Option<Vector3<f64>>),
) -> Option<(FaultKind, (String, String))> {
    let flights = || dataset.flights.iter().zip(tracks);
    let compared: Vec<Comparison> = flights()
        .filter_map(|(flight, track)| {
            let readings = series(flight, channel);
            Some(comparisons(
                track.as_ref()?,
                readings,
                sensor,
                instrument,
                gravity,
            ))
        })
        .flatten()
        .collect();
    let size: f64 = compared.iter().map(|own| own.expected.norm_squared()).sum();
    let misfit = |meaning: &Meaning| {
        let unit = meaning.unit.value(instrument);
        let squares = compared.iter().map(|own| own.misfit(meaning, unit));
        squares.sum::<f64>() / size
    };
    // Without attitudes the readings do not tell: aerodynamic moments turn the angular momentum as wrong axes do.
    (size > 0.0).then_some(())?;
    let (meaning, is_alone) = clearly_best(Meaning::all(instrument), misfit)?;
    Some(fault((sensor, channel, instrument), &meaning, is_alone))
}

/// The simplest of the best meanings, and whether no other is as simple, if it is clearly better than the first.
fn clearly_best(
    meanings: Vec<Meaning>,
    misfit: impl Fn(&Meaning) -> f64,
) -> Option<(Meaning, bool)> {
    let misfits: Vec<f64> = meanings.iter().map(misfit).collect();
    let least = misfits.iter().copied().fold(f64::INFINITY, f64::min);
    if !is_clearly_better(least, misfits[0]) {
        return None;
    }
    let each = meanings.iter().zip(&misfits);
    let good = each.filter(|(_, misfit)| **misfit <= AS_GOOD * least);
    let mut good = good.map(|(meaning, _)| meaning);
    let best = good.next()?;
    let is_alone = good
        .next()
        .is_none_or(|next| next.changes() > best.changes());
    Some((*best, is_alone))
}

fn fault(
    (sensor, channel, instrument): (&Sensor, usize, Instrument),
    meaning: &Meaning,
    is_alone: bool,
) -> (FaultKind, (String, String)) {
    let name = &sensor.name;
    let why = "only so do the readings follow the motion of the body";
    if !meaning.axes.is_identity() {
        let key = match instrument {
            Instrument::Accelerometer => "accelerometer_axes",
            _ => "gyroscope_axes",
        };
        let example = if is_alone { "" } else { ", for example" };
        let axes = meaning.axes;
        return (
            FaultKind::AttitudeConvention,
            (
                format!(
                    "{name} seems to have other axes than the body{example} {axes} for x, y, z: {why}"
                ),
                format!(
                    "state `{key} = {}` in [recording], or turn the readings",
                    axes.toml()
                ),
            ),
        );
    }
    if meaning.in_room {
        return (
            FaultKind::AttitudeConvention,
            (
                format!("{name} seems to be along the axes of the room: {why}"),
                "write the readings along the axes of the body".to_owned(),
            ),
        );
    }
    if meaning.without_gravity {
        return (
            FaultKind::Other,
            (
                format!("{name} seems to read accelerations, without gravity: {why}"),
                "write specific forces: at rest an accelerometer reads 9.8 m/s² upwards".to_owned(),
            ),
        );
    }
    OtherUnit::new((sensor, channel, instrument), meaning.unit).fault(why)
}
