//! Numbers of random points, without regard to the validity limits.

use crate::constrained;
use crate::random::Random;
use model_spec::model::{Model, Parameter};
use model_spec::unit::{Base, Unit};
use nalgebra::Vector3;
use oracle::{Chart, Point};
use std::f64::consts::TAU;

/// How far from typical states a point is drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reach {
    /// States of sizes typical of flights.
    Near,
    /// Every second state up to the largest size that bodies in flight reach.
    Far,
}

/// Draws a point of typical states; the constraints of the model hold.
pub(crate) fn anywhere(model: &Model, random: &mut Random) -> Point<f64> {
    let mut point = drawn(model, Reach::Near, random);
    normalize(model, &mut point);
    if random_flight(model, random) {
        ahead(model, &mut point, random);
    }
    point
}

/// Draws a point with every second state as far as bodies in flight get; the constraints of the model need not hold.
pub(super) fn far(model: &Model, random: &mut Random) -> Point<f64> {
    drawn(model, Reach::Far, random)
}

fn drawn(model: &Model, reach: Reach, random: &mut Random) -> Point<f64> {
    let (params, coefficients) = (model.params.iter(), model.coefficients.iter());
    let (inputs, states) = (model.inputs.iter(), model.states.iter());
    Point {
        time: time(random.between(0.0, 1.0)),
        params: params.map(|c| parameter(c, reach, random)).collect(),
        coefficients: coefficients
            .map(|c| coefficient(c, reach, random))
            .collect(),
        inputs: inputs
            .map(|i| Vector3::from_fn(|k, _| input(i.unit, i.value[k], reach, random)))
            .collect(),
        states: states
            .map(|s| state(s.unit, s.value, reach, random))
            .collect(),
        marker: Vector3::from_fn(|_, _| random.within(0.1)),
    }
}

/// Time since the start, s, by a number from 0 to 1: mostly within two seconds, and in a quarter of the cases later, up to
/// two minutes: motors burn out, and parachutes open.
fn time(part: f64) -> f64 {
    const EARLY: (f64, f64) = (0.75, 2.0);
    if part < EARLY.0 {
        return EARLY.1 * part / EARLY.0;
    }
    EARLY.1 * 60f64.powf((part - EARLY.0) / (1.0 - EARLY.0))
}

/// Whether a point is to be one of a typical flight: every second one, if the model states which axis of the body points
/// ahead.
fn random_flight(model: &Model, random: &mut Random) -> bool {
    let axes = model.flight_axes();
    axes.is_some_and(|(_, axes)| axes.states_forward) && random.once_in(2)
}

/// Turns the velocity of the declared body to near the axis that points ahead: by 0.01 to 0.5 rad.
fn ahead(model: &Model, point: &mut Point<f64>, random: &mut Random) {
    let Some((chart, (_, axes))) = Chart::declared(model).zip(model.flight_axes()) else {
        return;
    };
    let mut physical = chart.physical(&point.states);
    let forward = Vector3::from(axes.forward.vector());
    let off = Vector3::from_fn(|_, _| random.within(1.0)).cross(&forward);
    let size = 0.5 * 10f64.powf(-random.between(0.0, 1.7));
    let along = forward + off * (size / off.norm().max(1e-3));
    let along = physical.attitude.matrix() * along;
    physical.velocity = along * (physical.velocity.norm() / along.norm());
    let Some(states) = chart.states(&physical) else {
        return;
    };
    for state in model.body.iter().flat_map(|body| body.velocity) {
        point.states[state] = states[state];
    }
    normalize(model, point);
}

/// Scales the attitude quaternions of a point to norm 1, and moves it to where the constraints of the model hold.
pub(super) fn normalize(model: &Model, point: &mut Point<f64>) {
    constrained::normalize(model, point);
    constrained::project(model, point);
}

/// Typical magnitude in flight of a quantity with the given unit, SI.
pub fn typical(unit: Unit) -> f64 {
    sizes(unit).0
}

/// Typical magnitude in flight of a quantity with the given unit, and the largest that bodies in flight reach, SI.
fn sizes(unit: Unit) -> (f64, f64) {
    let [metre, second, radian] =
        [Base::Metre, Base::Second, Base::Radian].map(|base| unit.doubled[base as usize]);
    match (metre, second, radian) {
        // Beyond the tropopause, where layers of the atmosphere change.
        (2, 0, _) => (5.0, 2e4),
        // Three times the speed of sound: a bullet.
        (2, -2, _) => (15.0, 1000.0),
        // A full turn.
        (0, 0, 2) => (1.2, TAU),
        // A drill or a golf ball: 2900 turns per minute.
        (0, -2, _) => (20.0, 300.0),
        // Parts of a whole, masses, temperatures: two orders of magnitude.
        _ => (1.0, 100.0),
    }
}

/// Draws a size uniformly in its logarithm, from the typical one to the largest, or to some times the `default`.
fn far_size(unit: Unit, default: f64, random: &mut Random) -> f64 {
    /// A state that starts far, as a balloon at its height, may get further.
    const BEYOND_DEFAULT: f64 = 3.0;
    let (least, most) = sizes(unit);
    let most = most.max(BEYOND_DEFAULT * default.abs());
    let size = least * (most / least).powf(random.between(0.0, 1.0));
    if random.once_in(2) { -size } else { size }
}

/// Whether a unit is that of a velocity, up to powers of radian and kilogram.
pub(crate) fn is_velocity(unit: Unit) -> bool {
    let [metre, second] = [Base::Metre, Base::Second].map(|base| unit.doubled[base as usize]);
    (metre, second) == (2, -2)
}

fn state(unit: Unit, default: f64, reach: Reach, random: &mut Random) -> f64 {
    if reach == Reach::Far && random.once_in(2) {
        return far_size(unit, default, random);
    }
    let small = if random.once_in(4) {
        10f64.powf(-random.between(0.0, 3.0))
    } else {
        1.0
    };
    random.within(typical(unit)) * small
}

fn input(unit: Unit, default: f64, reach: Reach, random: &mut Random) -> f64 {
    match reach {
        Reach::Far if random.once_in(2) => far_size(unit, default, random),
        _ => random.within(typical(unit)),
    }
}

/// Draws a parameter or scalar input: around its default; of a far point, every second one anywhere within its bounds.
fn parameter(constant: &Parameter, reach: Reach, random: &mut Random) -> f64 {
    match constant.bounds {
        Some((low, high)) if reach == Reach::Far && random.once_in(2) => random.between(low, high),
        _ => size_varied(constant, reach, random),
    }
}

fn size_varied(constant: &Parameter, reach: Reach, random: &mut Random) -> f64 {
    match constant.value {
        0.0 if reach == Reach::Far && constant.varies => far_size(constant.unit, 0.0, random),
        0.0 => random.within(0.5),
        value => value * random.between(-0.7, 0.7).exp(),
    }
}

fn coefficient(constant: &Parameter, reach: Reach, random: &mut Random) -> f64 {
    let value = size_varied(constant, reach, random);
    let value = if random.once_in(2) { -value } else { value };
    let Some((low, high)) = constant.bounds else {
        return value;
    };
    // Outside the bounds, a divisor that the bounds keep away from 0 may vanish.
    if (low..=high).contains(&value) && value != 0.0 {
        value
    } else if (low..=high).contains(&-value) && value != 0.0 {
        -value
    } else {
        random.between(low, high)
    }
}
