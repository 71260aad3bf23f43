//! Random points of a model, within its domain of validity.

use crate::constrained;
use crate::random::Random;
use model_spec::model::{Model, Parameter, ValidityLimit};
use model_spec::unit::{Base, Unit};
use nalgebra::Vector3;
use oracle::{Chart, Point, Tree};

/// Maximum number of draws of a point within the validity limits.
const MAX_DRAWS: usize = 1000;
/// Maximum number of draws if not even the default point is within the validity limits.
const FEW_DRAWS: usize = 30;
/// Maximum number of changes of single states that are tried to move a point within the validity limits.
const MAX_MOVES: usize = 2000;
/// Maximum number of changes one after another that bring the point no closer.
const MAX_VAIN: usize = 300;
/// Number of halvings of the distance between the default point and a point outside the limits, plus 1.
const HALVINGS: i32 = 20;

/// Draws a point within the validity limits: states of magnitudes typical of flights, one in four up to 1000 times
/// smaller; parameters around their defaults; coefficients within their bounds, with random signs, never 0. If typical
/// states are outside the limits, they are moved within them.
pub fn point(model: &Model, random: &mut Random) -> Point<f64> {
    flight::cancellation::stop_if_cancelled();
    let defaults = Point::defaults(model);
    let draws = if is_valid(model, &defaults) {
        MAX_DRAWS
    } else {
        FEW_DRAWS
    };
    let margins = Margins::of(model);
    let mut point = anywhere(model, random);
    for _ in 0..draws {
        if margins.hold(&point) {
            return point;
        }
        point = anywhere(model, random);
    }
    (1..HALVINGS)
        .map(|k| between(&defaults, &point, 0.5_f64.powi(k)))
        .find(|point| is_valid(model, point))
        .or_else(|| moved_within_limits(model, &point, random))
        .unwrap_or(defaults)
}

/// The point with states changed at random, one at a time, whenever that brings it closer to the inside of the validity
/// limits; `None` if it does not get there. In a range narrower than the margins of [`within_limits`] these do not count.
pub fn moved_within_limits(
    model: &Model,
    point: &Point<f64>,
    random: &mut Random,
) -> Option<Point<f64>> {
    let margins = Margins::of(model);
    let mut found = [1.0, 0.0]
        .into_iter()
        .filter_map(|part| moved(&margins, point, part, random));
    found.find(|point| is_valid(model, point))
}

/// See [`moved_within_limits`]; of each margin, `part` counts.
fn moved(
    margins: &Margins<'_>,
    point: &Point<f64>,
    part: f64,
    random: &mut Random,
) -> Option<Point<f64>> {
    let model = margins.model;
    let mut best = point.clone();
    let mut outside = margins.shortfall(&best, part);
    let mut vain = 0;
    for _ in 0..MAX_MOVES {
        if outside == 0.0 || best.states.is_empty() || vain == MAX_VAIN {
            break;
        }
        vain += 1;
        let mut next = best.clone();
        let state = (random.next() % best.states.len() as u64) as usize;
        let size = typical(model.states[state].unit) * 10f64.powf(random.between(-3.0, 4.0));
        next.states[state] += random.within(size);
        normalize(model, &mut next);
        let next_outside = margins.shortfall(&next, part);
        if next_outside < outside {
            (best, outside, vain) = (next, next_outside, 0);
        }
    }
    if outside > 0.0 {
        return None;
    }
    // A change may lead far beyond the limit.
    for _ in 0..HALVINGS {
        let mut halfway = between(point, &best, 0.5);
        normalize(model, &mut halfway);
        if margins.shortfall(&halfway, part) > 0.0 {
            break;
        }
        best = halfway;
    }
    Some(best)
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
    let mut limits = model.limits_of_validity();
    limits.all(|limit| tree.scalar(&limit.value) > limit.bound)
}

/// Whether a point is inside each validity limit by more than 10 % of max(|bound|, 1), or of the distance of the default
/// point from the bound where that is smaller.
pub fn within_limits(model: &Model, point: &Point<f64>) -> bool {
    Margins::of(model).hold(point)
}

/// Validity limits of a model, each with the distance from the bound that [`within_limits`] requires.
struct Margins<'a> {
    model: &'a Model,
    limits: Vec<(&'a ValidityLimit, f64)>,
}

impl<'a> Margins<'a> {
    fn of(model: &'a Model) -> Self {
        let mut limits = Vec::new();
        if !model.limits.is_empty() {
            let defaults = Point::defaults(model);
            let tree = Tree::new(model, &defaults);
            limits.extend(model.limits_of_validity().map(|limit| {
                let usual = 0.1 * limit.bound.abs().max(1.0);
                let room = tree.scalar(&limit.value) - limit.bound;
                let is_near = room > 0.0 && room <= usual;
                (limit, if is_near { 0.1 * room } else { usual })
            }));
        }
        Self { model, limits }
    }

    fn hold(&self, point: &Point<f64>) -> bool {
        if self.limits.is_empty() {
            return true;
        }
        let tree = Tree::new(self.model, point);
        let mut limits = self.limits.iter();
        limits.all(|(limit, margin)| tree.scalar(&limit.value) > limit.bound + margin)
    }

    /// Sum over the limits of the relative distance outside at a point; of each margin, `part` counts.
    fn shortfall(&self, point: &Point<f64>, part: f64) -> f64 {
        if self.limits.is_empty() {
            return 0.0;
        }
        let tree = Tree::new(self.model, point);
        let outside = self.limits.iter().map(|(limit, margin)| {
            let bound = limit.bound + part * margin;
            let distance = (bound - tree.scalar(&limit.value)) / limit.bound.abs().max(1.0);
            if distance.is_nan() {
                f64::INFINITY
            } else {
                distance.max(0.0)
            }
        });
        outside.sum()
    }
}

/// Draws a point without regard to the validity limits; the constraints of the model hold.
pub(crate) fn anywhere(model: &Model, random: &mut Random) -> Point<f64> {
    let (params, coefficients) = (model.params.iter(), model.coefficients.iter());
    let inputs = model.inputs.iter();
    let mut point = Point {
        time: time(random.between(0.0, 1.0)),
        params: params.map(|c| size_varied(c, random)).collect(),
        coefficients: coefficients.map(|c| coefficient(c, random)).collect(),
        inputs: inputs
            .map(|i| Vector3::from_fn(|_, _| random.within(typical(i.unit))))
            .collect(),
        states: model.states.iter().map(|s| state(s.unit, random)).collect(),
        marker: Vector3::from_fn(|_, _| random.within(0.1)),
    };
    normalize(model, &mut point);
    if random_flight(model, random) {
        ahead(model, &mut point, random);
    }
    point
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
fn normalize(model: &Model, point: &mut Point<f64>) {
    constrained::normalize(model, point);
    constrained::project(model, point);
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
