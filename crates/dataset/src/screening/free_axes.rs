//! Axes of gyroscopes and accelerometers beside neither positions nor attitudes, told by an axisymmetric body: a flat one
//! spins about its axis of symmetry, and seen from the room, the forces on it turn slowly.

use model_spec::compose::Instrument;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::Body;
use super::meaning::Meaning;
use super::momentum::{self, is_clearly_better};
use super::other_meaning::OtherMeaning;
use super::pose_axes::{FLAT, inertia};
use super::readings::{of_flights, series};
use super::signed_axes::SignedAxes;
use super::units::gyroscope;
use crate::fault::{DataFault, FaultKind};
use crate::levels::{AS_GOOD, ROUNDING, is_clear};
use crate::sensor::with_channels;
use crate::{Dataset, Flight, Sensor, SensorKind};

/// Number of flights that are compared.
const COMPARED: usize = 8;

/// Rotation, rad, over which the angular momentum changes as a polynomial does of a degree that is the second number: some
/// turns, of which none looks like a polynomial.
const SLOW: (f64, usize) = (40.0, 4);

/// Unsteadiness above which readings are mostly those of a wrong place: half of that of a direction that turns with the body.
const MISPLACED: f64 = 1.0;

/// Least ratio of what a direction of the offset of a place changes to what another one does, squared, at which it is told.
const UNTOLD: f64 = 1e-2;

/// Millimetres in a metre.
const MM: f64 = 1e3;

/// An instrument with its channel.
type Own<'d> = (&'d Sensor, usize, Instrument);

/// Axes of the gyroscope and of the accelerometer.
type Axes = [SignedAxes; 2];

/// Instruments without positions on an axisymmetric body.
struct FreeInstruments<'d> {
    gyroscope: Own<'d>,
    accelerometer: Option<Own<'d>>,
    flights: Vec<Readings>,
    inertia: Matrix3<f64>,
    /// Axis of symmetry of the body.
    axis: usize,
}

/// Times, s, readings of the gyroscope, rad/s, and those of the accelerometer at these times, m/s².
type Readings = Vec<(f64, Vector3<f64>, Option<Vector3<f64>>)>;

impl<'d> FreeInstruments<'d> {
    /// `None` beside positions or attitudes, and of other bodies.
    fn new(body: &dyn Body, dataset: &'d Dataset) -> Option<Self> {
        let is_pose = |sensor: &Sensor| sensor.kind == SensorKind::Pose;
        if body.sees_positions() || dataset.sensors.iter().any(is_pose) {
            return None;
        }
        let (sensor, rates) = gyroscope(dataset)?;
        let is_wanted = |sensor: &Sensor| {
            sensor.kind == SensorKind::Instrument(Instrument::Accelerometer)
                && !sensor.position_is_unknown
        };
        let forces = with_channels(&dataset.sensors).find(|(sensor, _)| is_wanted(sensor));
        let (_, axes) = body.model().flight_axes()?;
        let (inertia, axis) = (inertia(body)?, usize::from(axes.spin.number) - 1);
        let [one, other] = [1, 2].map(|next| inertia[((axis + next) % 3, (axis + next) % 3)]);
        let flights = dataset.flights.iter().take(COMPARED);
        let channel = forces.map(|(_, channel)| channel);
        ((one - other).abs() < ROUNDING * one).then(|| Self {
            gyroscope: (sensor, rates, Instrument::Gyroscope),
            accelerometer: forces.map(|(own, at)| (own, at, Instrument::Accelerometer)),
            flights: flights.map(|own| readings(own, rates, channel)).collect(),
            inertia,
            axis,
        })
    }

    /// Axis of the gyroscope about which the body spins.
    fn spin_axis(&self) -> Option<usize> {
        let flights = self
            .flights
            .iter()
            .map(|own| attitudes(own, <_>::default()));
        crate::spin_axis(flights)
    }

    fn is_flat(&self) -> bool {
        let other = (self.axis + 1) % 3;
        self.inertia[(self.axis, self.axis)] > FLAT * self.inertia[(other, other)]
    }

    /// How unsteady the force on the body is, seen from the room, if the instruments have these axes and the accelerometer
    /// is at `place`, m.
    fn unsteadiness(&self, axes: Axes, place: Vector3<f64>) -> Option<f64> {
        let flights = self.flights.iter().map(|own| {
            let attitudes = attitudes(own, axes[0]);
            let forces = forces(own, axes, place).zip(&attitudes);
            let forces = forces.filter_map(|(force, attitude)| Some(attitude * force?));
            (forces.collect(), turned(own))
        });
        momentum::unsteadiness(flights)
    }

    /// The simplest of the best axes of one instrument or both, if they are clearly better than the stated ones, and the
    /// unsteadiness that is left.
    fn told(&self) -> Option<(OtherMeaning, f64)> {
        let found = self.spin_axis()?;
        let is_wrong = found != self.axis;
        if is_wrong && !self.is_flat() {
            return None;
        }
        let own = SignedAxes::default();
        let is_mirrored = self.seems_mirrored();
        let is_possible = |axes: &Axes| {
            let [rate, force] = axes;
            // Both instruments turned about the spin are not told from another place.
            let is_place = rate == force && *rate != own && !is_wrong && !is_mirrored;
            rate.along(self.axis).0 == found && rate.is_right_handed() != is_mirrored && !is_place
        };
        let mut all = vec![[own, own]];
        for axes in SignedAxes::simple() {
            all.extend([[own, axes], [axes, own], [axes, axes]]);
        }
        all.retain(is_possible);
        let Some(accelerometer) = self.accelerometer else {
            let [axes, _] = *all.first()?;
            let other = || OtherMeaning::new(&[self.gyroscope], Meaning::of_axes(axes));
            return is_wrong.then(|| (other(), 0.0));
        };
        let place = Vector3::from(accelerometer.0.position);
        let each = all.into_iter();
        let each = each.filter_map(|axes| Some((self.unsteadiness(axes, place)?, axes)));
        let each: Vec<(f64, Axes)> = each.collect();
        let least = each.iter().map(|own| own.0).fold(f64::INFINITY, f64::min);
        let (_, best) = each.into_iter().find(|own| own.0 < AS_GOOD * least)?;
        let stated = self.unsteadiness([own, own], place)?;
        if !(is_wrong || is_clearly_better(least, stated)) {
            return None;
        }
        let turned = match best {
            [rate, force] if rate == own => (vec![accelerometer], force),
            [rate, force] if force == own => (vec![self.gyroscope], rate),
            [rate, _] => (vec![self.gyroscope, accelerometer], rate),
        };
        let other = OtherMeaning::new(&turned.0, Meaning::of_axes(turned.1));
        Some((other, least))
    }

    /// Coordinates at which the accelerometer would show a slow force, where its readings are mostly those of a wrong place,
    /// and the unsteadiness that is left.
    fn other_place(&self) -> Option<(String, f64)> {
        let own = [SignedAxes::default(); 2];
        let stated = Vector3::from(self.accelerometer?.0.position);
        let before = self.unsteadiness(own, stated);
        let before = before.filter(|own| *own > MISPLACED)?;
        let place = stated + self.offset(stated)?;
        let left = self.unsteadiness(own, place)?;
        let axes = (0..3).filter(|axis| *axis != self.axis);
        // Not −0.
        let rounded = |axis: usize| (10.0 * MM * place[axis]).round() / 10.0 + 0.0;
        let axes = axes.map(|axis| format!("{} = {:.1} mm", crate::AXES[axis], rounded(axis)));
        let coordinates = axes.collect::<Vec<_>>().join(", ");
        is_clearly_better(left, before).then_some((coordinates, left))
    }

    /// Fault of an accelerometer that is elsewhere.
    fn misplaced(&self, dataset: &Dataset) -> Vec<DataFault> {
        let own = self.accelerometer.zip(self.other_place());
        own.map_or_else(Vec::new, |((sensor, channel, _), (place, _))| {
            let detail = format!(
                "{} does not seem to sit at its position, or is turned on the body: only at {place} do its readings show a force that turns slowly",
                sensor.name
            );
            let correction = "correct its position, or state `position = \"unknown\"` for it";
            of_flights(dataset, channel, (FaultKind::Other, (detail, correction.to_owned())))
        })
    }

    /// Offset from a place, m, at which the forces change least while the body turns; 0 where they do not tell.
    fn offset(&self, place: Vector3<f64>) -> Option<Vector3<f64>> {
        let own = SignedAxes::default();
        let (mut squares, mut products) = (Matrix3::zeros(), Vector3::zeros());
        for flight in &self.flights {
            let attitudes = attitudes(flight, own);
            let rows = forces(flight, [own; 2], place).zip(levers(flight, own));
            let rows = rows
                .zip(&attitudes)
                .filter_map(|((force, lever), attitude)| {
                    Some((attitude * force?, attitude.to_rotation_matrix() * lever))
                });
            let rows: Vec<(Vector3<f64>, Matrix3<f64>)> = rows.collect();
            let Some(lag) = momentum::lag(rows.len(), turned(flight)) else {
                continue;
            };
            for (before, after) in rows.iter().zip(&rows[lag..]) {
                let by = after.1 - before.1;
                squares += by.transpose() * by;
                products += by.transpose() * (after.0 - before.0);
            }
        }
        let told = UNTOLD * squares.symmetric_eigenvalues().max();
        let inverse = squares.pseudo_inverse(told).ok()?;
        Some(inverse * products)
    }

    /// Squares of what the angular momentum, seen from the room, changes otherwise than slowly, and the number of values.
    fn fast_changes(&self, axes: SignedAxes) -> (f64, f64) {
        let mut sum = (0.0, 0.0);
        for own in &self.flights {
            let attitudes = attitudes(own, axes);
            let parts = (turned(own) / SLOW.0).floor().max(1.0) as usize;
            let rows = own.iter().zip(&attitudes);
            let momenta = rows.map(|((time, rate, _), attitude)| {
                (*time, attitude * (self.inertia * axes.turned(*rate)))
            });
            let momenta: Vec<(f64, Vector3<f64>)> = momenta.collect();
            for part in momenta.chunks(momenta.len().div_ceil(parts).max(1)) {
                let left = momentum::beyond_polynomial(part, SLOW.1);
                sum = (sum.0 + left.0, sum.1 + left.1);
            }
        }
        sum
    }

    /// Whether the axes of the gyroscope may be those of a mirror image: nutation and precession turn in opposite senses, at
    /// nearly the same rate.
    fn seems_mirrored(&self) -> bool {
        let [stated, other] = [SignedAxes::default(), SignedAxes::OPPOSITE];
        let [(before, count), (after, _)] = [stated, other].map(|axes| self.fast_changes(axes));
        is_clear(before / after, count)
    }

    /// Such axes, in both senses of the spin or in that in which an accelerometer shows a slow force.
    fn mirrored(&self) -> Vec<OtherMeaning> {
        let is_mirrored = self.spin_axis() == Some(self.axis) && self.seems_mirrored();
        let place = self
            .accelerometer
            .map(|(own, ..)| Vector3::from(own.position));
        let unsteadiness = |axes: &SignedAxes| {
            let found = place.and_then(|place| self.unsteadiness([*axes, <_>::default()], place));
            found.unwrap_or(1.0)
        };
        let both = [SignedAxes::OPPOSITE, SignedAxes::exchanged(self.axis)];
        let least = both.iter().map(unsteadiness).fold(f64::INFINITY, f64::min);
        let others = both.into_iter().filter(|_| is_mirrored);
        let others = others.filter(|axes| unsteadiness(axes) < AS_GOOD * least);
        let each = others.map(|axes| OtherMeaning::new(&[self.gyroscope], Meaning::of_axes(axes)));
        each.collect()
    }
}

/// Faults of instruments with other axes or at another place, given whether all forces on the body at rest are its weight.
pub fn check(body: &dyn Body, dataset: &Dataset, falls_freely: bool) -> Vec<DataFault> {
    let Some(found) = FreeInstruments::new(body, dataset).filter(|_| falls_freely) else {
        return Vec::new();
    };
    let why =
        "only so does the body spin about its axis of symmetry, and the force on it turn slowly";
    let Some((told, least)) = found.told() else {
        return found.misplaced(dataset);
    };
    let mut faults = told.faults(dataset, why, false);
    let place = found.other_place();
    if let Some((place, _)) = place.filter(|(_, left)| *left < AS_GOOD * least) {
        let also = format!(", or correct the position of the accelerometer: {place}");
        faults.iter_mut().for_each(|own| own.correction += &also);
    }
    faults
}

/// Other axes of a gyroscope with which the flights may fit, and which its readings alone do not tell.
pub fn mirrored(body: &dyn Body, dataset: &Dataset) -> Vec<OtherMeaning> {
    FreeInstruments::new(body, dataset).map_or_else(Vec::new, |found| found.mirrored())
}

fn readings(flight: &Flight, rates: usize, forces: Option<usize>) -> Readings {
    let vector = |[x, y, z, _]: crate::Reading| Vector3::new(x, y, z);
    let mut forces = forces.map(|channel| series(flight, channel).peekable());
    let each = series(flight, rates).map(|(time, rate)| {
        let force = forces.as_mut().and_then(|own| {
            while own.next_if(|(at, _)| *at < time).is_some() {}
            own.next_if(|(at, _)| *at == time)
        });
        (time, vector(rate), force.map(|(_, force)| vector(force)))
    });
    each.collect()
}

/// Rotation of the body, rad.
fn turned(readings: &Readings) -> f64 {
    let pairs = readings.windows(2);
    let each = pairs.map(|pair| (pair[1].0 - pair[0].0) * pair[0].1.norm());
    each.sum()
}

/// Attitudes relative to the first, from rates along other axes.
fn attitudes(readings: &Readings, axes: SignedAxes) -> Vec<UnitQuaternion<f64>> {
    let mut attitude = UnitQuaternion::identity();
    let mut all = vec![attitude];
    for pair in readings.windows(2) {
        let mean = 0.5 * axes.turned(pair[0].1 + pair[1].1);
        attitude *= UnitQuaternion::from_scaled_axis(mean * (pair[1].0 - pair[0].0));
        all.push(attitude);
    }
    all
}

/// Specific forces at the mass centre, in the axes of the body, by an accelerometer at `place`, m.
fn forces(
    readings: &Readings,
    axes: Axes,
    place: Vector3<f64>,
) -> impl Iterator<Item = Option<Vector3<f64>>> {
    let rows = readings.iter().zip(levers(readings, axes[0]));
    rows.map(move |((.., force), lever)| Some(axes[1].turned((*force)?) - lever * place))
}

/// What turns a place on the body, m, into its acceleration about the mass centre, m/s².
fn levers(readings: &Readings, axes: SignedAxes) -> impl Iterator<Item = Matrix3<f64>> {
    (0..readings.len()).map(move |k| {
        let [before, after] = [k.saturating_sub(1), (k + 1).min(readings.len() - 1)];
        let [before, after] = [before, after].map(|k| readings[k]);
        let [rate, change] = [readings[k].1, after.1 - before.1].map(|own| axes.turned(own));
        let across = rate.cross_matrix();
        change.cross_matrix() / (after.0 - before.0) + across * across
    })
}
