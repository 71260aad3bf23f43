//! Changes that a mistake makes to a finished recording.

use dataset::{Flight, Reading, SensorKind};
use identify::Prior;
use model_spec::compose::Instrument;
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use rand::{Rng, RngExt};
use rand_chacha::ChaCha12Rng;

use super::recording::Recording;
use super::signal;

/// Change of a recording by a mistake.
pub(super) type Spoil = fn(&mut Recording, &mut ChaCha12Rng);

pub(super) fn none(_: &mut Recording, _: &mut ChaCha12Rng) {}

pub(super) fn uniform(random: &mut impl Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * random.random::<f64>()
}

/// Random sign, 1 or −1.
fn sign(random: &mut impl Rng) -> f64 {
    if random.random::<bool>() { 1.0 } else { -1.0 }
}

/// A random vector of the length `length` in the plane of the disc.
fn in_plane(random: &mut impl Rng, length: f64) -> Vector3<f64> {
    let angle = uniform(random, 0.0, std::f64::consts::TAU);
    Vector3::new(angle.cos(), angle.sin(), 0.0) * length
}

/// Applies a function to each reading of the instruments of one kind.
fn each_reading(
    recording: &mut Recording,
    kind: Instrument,
    mut change: impl FnMut(Reading) -> Reading,
) {
    let mut channel = 0;
    let mut found = None;
    for sensor in &recording.dataset.sensors {
        if sensor.kind == SensorKind::Instrument(kind) {
            found = Some(channel);
        }
        channel += if sensor.kind == SensorKind::Pose {
            2
        } else {
            1
        };
    }
    let Some(channel) = found else { return };
    for row in recording
        .dataset
        .flights
        .iter_mut()
        .flat_map(|f| &mut f.readings)
    {
        row[channel] = row[channel].map(&mut change);
    }
}

/// Applies a function to the attitude of each pose.
fn each_attitude(
    recording: &mut Recording,
    change: impl Fn(UnitQuaternion<f64>) -> UnitQuaternion<f64>,
) {
    for row in recording
        .dataset
        .flights
        .iter_mut()
        .flat_map(|f| &mut f.readings)
    {
        // The first sensor is the pose: its position, then its attitude.
        if let Some([w, x, y, z]) = row[1] {
            let seen = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
            let seen = change(seen);
            row[1] = Some([seen.w, seen.i, seen.j, seen.k]);
        }
    }
}

pub(super) fn conjugate(recording: &mut Recording, _: &mut ChaCha12Rng) {
    each_attitude(recording, |attitude| attitude.inverse());
}

/// The tracker's body axes: its second axis is that of the disc.
pub(super) fn y_up_body(recording: &mut Recording, _: &mut ChaCha12Rng) {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -std::f64::consts::FRAC_PI_2);
    each_attitude(recording, |attitude| attitude * turn);
}

/// The rows of the pictures are exposed one after the other: the setting has their time.
pub(super) fn rolling_shutter(recording: &mut Recording, _: &mut ChaCha12Rng) {
    recording.cause = Some("rolling_shutter".to_owned());
}

/// The instruments are read late: the setting has the time.
pub(super) fn late(recording: &mut Recording, _: &mut ChaCha12Rng) {
    recording.cause = Some("gyroscope_late".to_owned());
}

pub(super) fn in_g(recording: &mut Recording, _: &mut ChaCha12Rng) {
    recording.cause = Some("accelerometer_scale".to_owned());
    each_reading(recording, Instrument::Accelerometer, |a| {
        a.map(|x| x / 9.80665)
    });
}

pub(super) fn in_degrees(recording: &mut Recording, _: &mut ChaCha12Rng) {
    recording.cause = Some("gyroscope_scale".to_owned());
    each_reading(recording, Instrument::Gyroscope, |rate| {
        rate.map(f64::to_degrees)
    });
}

/// Range of a usual gyroscope: 2000 degrees per second, or little more.
pub(super) fn saturate(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let limit: f64 = if random.random::<bool>() {
        2000.0
    } else {
        2500.0
    };
    recording.note(format!("saturated at {limit} deg/s"));
    let limit = limit.to_radians();
    each_reading(recording, Instrument::Gyroscope, |rate| {
        rate.map(|x| x.clamp(-limit, limit))
    });
}

fn rate_of(flight: &Flight) -> f64 {
    1.0 / (flight.times[1] - flight.times[0])
}

pub(super) fn low_pass(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let share = uniform(random, 0.1, 0.35);
    for flight in &mut recording.dataset.flights {
        let rate = rate_of(flight);
        signal::low_pass(flight, rate, share * rate);
    }
    let rate = recording.dataset.flights.first().map_or(0.0, rate_of);
    recording.note(format!("filtered at {:.0} Hz", share * rate));
}

pub(super) fn upsample(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let (factor, is_cubic) = (random.random_range(2..=4), random.random::<bool>());
    recording.note(format!("{factor} times as many samples, cubic: {is_cubic}"));
    for flight in &mut recording.dataset.flights {
        signal::upsample(flight, factor, is_cubic);
    }
}

/// Scale and vertical of the axes change from the first to the last flight.
pub(super) fn drift(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let scale = sign(random) * uniform(random, 0.002, 0.02);
    let tilt = uniform(random, 0.001, 0.01);
    let about = in_plane(random, tilt);
    recording.note(format!(
        "scale by {:.1} %, vertical by {:.1} mrad",
        100.0 * scale,
        1e3 * tilt
    ));
    let last = (recording.dataset.flights.len() - 1).max(1) as f64;
    for (k, flight) in recording.dataset.flights.iter_mut().enumerate() {
        let share = k as f64 / last;
        let turn = Rotation3::from_scaled_axis(about * share);
        for point in flight.positions.iter_mut().flatten().flatten() {
            *point = (turn * Vector3::from(*point) * (1.0 + scale * share)).into();
        }
    }
}

/// Moves the stated positions of the markers.
fn restate(recording: &mut Recording, moved: impl Fn(usize, Vector3<f64>) -> Vector3<f64>) {
    for (k, marker) in recording.dataset.markers.iter_mut().enumerate() {
        marker.position = moved(k, marker.position.into()).into();
    }
}

pub(super) fn marker_off_in_plane(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let off = uniform(random, 0.002, 0.01);
    let (off, which) = (in_plane(random, off), random.random_range(0..3));
    recording.note(format!(
        "marker {} by {:.1} mm",
        which + 1,
        1e3 * off.norm()
    ));
    recording.cause = Some(format!("marker_{}_misplaced", which + 1));
    restate(
        recording,
        |k, place| if k == which { place + off } else { place },
    );
}

pub(super) fn markers_off_along_axis(recording: &mut Recording, random: &mut ChaCha12Rng) {
    recording.cause = Some("marker_height".to_owned());
    let off = sign(random) * uniform(random, 0.002, 0.012);
    recording.note(format!("by {:.1} mm", 1e3 * off));
    restate(recording, |_, place| place + Vector3::z() * off);
}

pub(super) fn mass_centre_off(recording: &mut Recording, random: &mut ChaCha12Rng) {
    recording.cause = Some("marker_offset_in_plane".to_owned());
    let off = uniform(random, 0.001, 0.006);
    let off = in_plane(random, off);
    recording.note(format!("by {:.1} mm", 1e3 * off.norm()));
    restate(recording, |_, place| place + off);
}

pub(super) fn template_tilted(recording: &mut Recording, random: &mut ChaCha12Rng) {
    recording.cause = Some("template_tilt".to_owned());
    let tilt = uniform(random, 0.01, 0.06);
    let turn = Rotation3::from_scaled_axis(in_plane(random, tilt));
    recording.note(format!("by {:.1} degrees", tilt.to_degrees()));
    restate(recording, |_, place| turn * place);
}

pub(super) fn swap_markers(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let share = uniform(random, 0.01, 0.1);
    recording.note(format!("in {:.0} % of the samples", 100.0 * share));
    for row in recording
        .dataset
        .flights
        .iter_mut()
        .flat_map(|f| &mut f.positions)
    {
        if random.random::<f64>() < share {
            row.swap(0, 1);
        }
    }
}

/// A coefficient that a user may hold or know in advance.
fn some_coefficient(recording: &Recording, random: &mut impl Rng) -> (String, f64) {
    let names = ["C_L0", "C_La", "C_D0", "C_Da", "C_Ma", "C_Nr"];
    let name = names[random.random_range(0..names.len())];
    (name.to_owned(), recording.true_value(name))
}

pub(super) fn prior_in_conflict(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let (name, truth) = some_coefficient(recording, random);
    let value = truth * (1.0 + sign(random) * uniform(random, 0.1, 0.4));
    let sigma = (value - truth).abs() / uniform(random, 5.0, 30.0);
    recording.note(format!(
        "{name} = {value:.3e} ± {sigma:.1e}, in truth {truth:.3e}"
    ));
    recording.priors.push(Prior { name, value, sigma });
}

pub(super) fn held_wrong(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let (name, truth) = some_coefficient(recording, random);
    let value = truth * (1.0 + sign(random) * uniform(random, 0.1, 0.4));
    recording.note(format!("{name} = {value:.3e}, in truth {truth:.3e}"));
    recording.fixed.push((name, Some(value)));
}

pub(super) fn bound_excludes(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let (name, truth) = some_coefficient(recording, random);
    let off = uniform(random, 0.1, 0.4) * truth.abs();
    let bounds = match random.random::<bool>() {
        true => (truth - 10.0 * truth.abs(), truth - off),
        false => (truth + off, truth + 10.0 * truth.abs()),
    };
    recording.note(format!(
        "{name} from {:.3e} to {:.3e}, in truth {truth:.3e}",
        bounds.0, bounds.1
    ));
    let mut coefficients = recording.model.coefficients.iter_mut();
    if let Some(own) = coefficients.find(|own| own.name == name) {
        own.bounds = Some(bounds);
        own.value = own.value.clamp(bounds.0, bounds.1);
    }
}

fn wrong_constant(recording: &mut Recording, name: &str, random: &mut impl Rng) -> f64 {
    let factor = 1.0 + sign(random) * uniform(random, 0.05, 0.25);
    let value = factor * recording.constant(name);
    recording.note(format!("{factor:.2} times the true value"));
    recording.dataset.parameters.insert(name.to_owned(), value);
    factor
}

/// Forces divided by the mass make the path: a wrong mass gives coefficients of force that are wrong by its factor, and
/// nothing else.
pub(super) fn wrong_mass(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let factor = wrong_constant(recording, "m", random);
    recording.scale_truth(factor, |name| {
        name.starts_with("C_L") || name.starts_with("C_D")
    });
}

pub(super) fn wrong_inertia(recording: &mut Recording, random: &mut ChaCha12Rng) {
    let name = if random.random::<bool>() {
        "I_a"
    } else {
        "I_d"
    };
    wrong_constant(recording, name, random);
}
