//! Random points of a model, within its domain of validity.

use crate::random::Random;
use model_spec::model::{Model, Parameter};
use model_spec::unit::{Base, Unit};
use nalgebra::Vector3;
use oracle::{Point, Tree};

/// Maximum number of draws of a point within the validity limits.
const MAX_DRAWS: usize = 1000;
/// Number of halvings of the distance between the default point and a point outside the limits, plus 1.
const HALVINGS: i32 = 20;

/// Draws a point within the validity limits: states of magnitudes typical of flights, one in four up to 1000 times
/// smaller; parameters around their defaults; coefficients within their bounds, with random signs, never 0.
pub fn point(model: &Model, random: &mut Random) -> Point<f64> {
    let mut point = anywhere(model, random);
    for _ in 0..MAX_DRAWS {
        if within_limits(model, &point) {
            return point;
        }
        point = anywhere(model, random);
    }
    let defaults = Point::defaults(model);
    (1..HALVINGS)
        .map(|k| between(&defaults, &point, 0.5_f64.powi(k)))
        .find(|point| is_valid(model, point))
        .unwrap_or(defaults)
}

/// Draws points as [`point`] does.
pub fn points(model: &Model, count: usize, random: &mut Random) -> Vec<Point<f64>> {
    (0..count).map(|_| point(model, random)).collect()
}

/// Interpolates linearly from `from` (`fraction` 0) to `to` (1); time and marker are those of `to`.
pub fn between(from: &Point<f64>, to: &Point<f64>, fraction: f64) -> Point<f64> {
    let mix = |from: &[f64], to: &[f64]| -> Vec<f64> {
        let pairs = from.iter().zip(to);
        pairs.map(|(a, b)| a + (b - a) * fraction).collect()
    };
    let inputs = from.inputs.iter().zip(&to.inputs);
    Point {
        params: mix(&from.params, &to.params),
        coefficients: mix(&from.coefficients, &to.coefficients),
        inputs: inputs.map(|(a, b)| a + (b - a) * fraction).collect(),
        states: mix(&from.states, &to.states),
        ..to.clone()
    }
}

/// Whether a point is within every validity limit of the model.
pub fn is_valid(model: &Model, point: &Point<f64>) -> bool {
    let tree = Tree::new(model, point);
    let mut limits = model.limits.iter();
    limits.all(|limit| tree.scalar(&limit.value) > limit.bound)
}

/// Whether a point is inside each validity limit by more than 10 % of max(|bound|, 1).
pub fn within_limits(model: &Model, point: &Point<f64>) -> bool {
    let tree = Tree::new(model, point);
    model
        .limits
        .iter()
        .all(|limit| tree.scalar(&limit.value) > limit.bound + 0.1 * limit.bound.abs().max(1.0))
}

fn anywhere(model: &Model, random: &mut Random) -> Point<f64> {
    let (params, coefficients) = (model.params.iter(), model.coefficients.iter());
    let inputs = model.inputs.iter();
    let mut point = Point {
        time: random.between(0.0, 2.0),
        params: params.map(|c| size_varied(c, random)).collect(),
        coefficients: coefficients.map(|c| coefficient(c, random)).collect(),
        inputs: inputs
            .map(|i| Vector3::from_fn(|_, _| random.within(typical(i.unit))))
            .collect(),
        states: model.states.iter().map(|s| state(s.unit, random)).collect(),
        marker: Vector3::from_fn(|_, _| random.within(0.1)),
    };
    for quaternion in model.quaternions() {
        let squares = quaternion.iter().map(|&i| point.states[i].powi(2));
        let length = squares.sum::<f64>().sqrt();
        for i in quaternion {
            point.states[i] /= length;
        }
    }
    point
}

/// Typical magnitude in flight of a quantity with the given unit, SI.
pub fn typical(unit: Unit) -> f64 {
    let [metre, second, radian] =
        [Base::Metre, Base::Second, Base::Radian].map(|base| unit.doubled[base as usize]);
    match (metre, second, radian) {
        (2, 0, _) => 5.0,
        (2, -2, _) => 15.0,
        (0, 0, 2) => 1.2,
        (0, -2, _) => 20.0,
        _ => 1.0,
    }
}

/// Whether a unit is that of a velocity, up to powers of radian and kilogram.
pub(crate) fn is_velocity(unit: Unit) -> bool {
    let [metre, second] = [Base::Metre, Base::Second].map(|base| unit.doubled[base as usize]);
    (metre, second) == (2, -2)
}

fn state(unit: Unit, random: &mut Random) -> f64 {
    let small = if random.once_in(4) {
        10f64.powf(-random.between(0.0, 3.0))
    } else {
        1.0
    };
    random.within(typical(unit)) * small
}

fn size_varied(constant: &Parameter, random: &mut Random) -> f64 {
    match constant.value {
        0.0 => random.within(0.5),
        value => value * random.between(-0.7, 0.7).exp(),
    }
}

fn coefficient(constant: &Parameter, random: &mut Random) -> f64 {
    let value = size_varied(constant, random);
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
