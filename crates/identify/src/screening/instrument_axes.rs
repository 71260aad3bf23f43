//! Axes, units and frames of gyroscopes and accelerometers, compared with the motion that measured attitudes show.

use model_spec::compose::Instrument;
use nalgebra::Vector3;

use super::meaning::Meaning;
use super::momentum::is_clearly_better;
use super::motion::{Comparison, comparisons};
use super::readings::series;
use super::track::Track;
use super::units::{Centripetal, OtherUnit, gyroscope};
use crate::error::FaultKind;
use dataset::{Dataset, Sensor};

/// Ratio of the misfit to the least one up to which an interpretation of the readings is as good.
const AS_GOOD: f64 = 1.2;

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
    // Without attitudes a gyroscope does not tell: aerodynamic moments turn the angular momentum as wrong axes do.
    if size == 0.0 {
        return beside_gyroscope(dataset, (sensor, channel, instrument));
    }
    let (meaning, is_alone) = clearly_best(Meaning::all(instrument), misfit)?;
    let why = "only so do the readings follow the motion of the body";
    Some(fault(
        (sensor, channel, instrument),
        &meaning,
        is_alone,
        why,
    ))
}

/// The same of an accelerometer, compared with the centripetal acceleration that a gyroscope shows at its place.
fn beside_gyroscope(
    dataset: &Dataset,
    own: (&Sensor, usize, Instrument),
) -> Option<(FaultKind, (String, String))> {
    let (sensor, channel, instrument) = own;
    if instrument != Instrument::Accelerometer || sensor.position_is_unknown {
        return None;
    }
    let channels = [channel, gyroscope(dataset)?.1];
    let place = Vector3::from(sensor.position);
    let flights = dataset.flights.iter();
    let found = flights.filter_map(|flight| Centripetal::of(flight, channels, place));
    let found: Vec<Centripetal> = found.collect();
    let size: f64 = found.iter().map(|own| own.read.norm_squared()).sum();
    let misfit = |meaning: &Meaning| {
        let off = |own: &Centripetal| own.across(meaning.axes.turned(own.read)) - own.expected;
        let squares = found.iter().map(|own| off(own).norm_squared());
        squares.sum::<f64>() / size
    };
    let of_axes = Meaning::all(instrument).into_iter();
    let of_axes: Vec<Meaning> = of_axes
        .filter(|meaning| meaning.changes() == meaning.axes.changes())
        .collect();
    // An instrument that is turned is more usual than one whose axes are those of a mirror.
    let turned = of_axes.clone().into_iter();
    let turned = turned.filter(|meaning| meaning.axes.is_right_handed());
    let found = clearly_best(turned.collect(), misfit);
    let (meaning, _) = found.or_else(|| clearly_best(of_axes, misfit))?;
    let why = "only so, or at another place, do the readings show the centripetal acceleration that the measured rates give";
    // The sign along the spin is not compared.
    let (kind, (detail, correction)) = fault(own, &meaning, false, why);
    let correction = format!(
        "{correction}, or correct its position; turn the gyroscope, too, if both are one instrument"
    );
    Some((kind, (detail, correction)))
}

/// The simplest of the best meanings, and whether no other is as good, if it is clearly better than the first.
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
    Some((*best, good.next().is_none()))
}

fn fault(
    (sensor, channel, instrument): (&Sensor, usize, Instrument),
    meaning: &Meaning,
    is_alone: bool,
    why: &str,
) -> (FaultKind, (String, String)) {
    let name = &sensor.name;
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
