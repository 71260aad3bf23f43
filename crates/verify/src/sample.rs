//! Random points of a model, within its domain of validity.

mod draw;
mod switches;

use crate::constrained;
use crate::random::Random;
use draw::normalize;
pub use draw::typical;
pub(crate) use draw::{anywhere, is_velocity};
use model_spec::model::{Model, ValidityLimit};
use oracle::{Point, Tree};

/// Maximum number of draws of a point within the validity limits.
const MAX_DRAWS: usize = 1000;
/// Maximum number of draws if not even the default point is within the validity limits.
const FEW_DRAWS: usize = 30;
/// Maximum number of changes of single states that are tried to move a point within the validity limits.
const MAX_MOVES: usize = 2000;
/// Maximum number of changes one after another that bring the point no closer.
const MAX_VAIN: usize = 300;
/// Decades of the changes, in units of typical sizes; the largest is also that of a bound times [`BEYOND_BOUND`].
const MOVES: (f64, f64) = (-3.0, 4.0);
/// Largest change of a state, in units of the largest bound.
const BEYOND_BOUND: f64 = 10.0;
/// Number of halvings of the distance between the default point and a point outside the limits, plus 1.
const HALVINGS: i32 = 20;

/// Share of the points that are drawn beyond typical states: one in so many, as of the times, see [`draw`].
const ONE_BEYOND_IN: u64 = 4;

/// Draws a point within the validity limits: three in four of states of magnitudes typical of flights, one in four of
/// these up to 1000 times smaller. Of the others, every second one is as far as bodies in flight get, and every second
/// one beside a switch of the model, on either side.
pub fn point(model: &Model, random: &mut Random) -> Point<f64> {
    let near = near(model, random);
    if random.once_in(ONE_BEYOND_IN) {
        beyond(model, &near, random).unwrap_or(near)
    } else {
        near
    }
}

/// A point beyond typical states, see [`point`]; `None` if the way there from `near` is outside the limits.
fn beyond(model: &Model, near: &Point<f64>, random: &mut Random) -> Option<Point<f64>> {
    let margins = Margins::of(model);
    let within = |point| settled(model, point).filter(|point| margins.hold(point));
    let far = draw::far(model, random);
    let mut on_the_way = (0..HALVINGS / 2).map(|k| between(near, &far, 0.25_f64.powi(k)));
    let far = on_the_way.find_map(within)?;
    let beside = if random.once_in(2) {
        switches::beside_one(model, [near, &far], random)
    } else {
        None
    };
    Some(beside.and_then(within).unwrap_or(far))
}

/// The point with quaternions of norm 1, moved to where the constraints of the model hold; `None` if they hold nowhere
/// near.
fn settled(model: &Model, mut point: Point<f64>) -> Option<Point<f64>> {
    /// A place that Newton's method finds, it finds in few steps; otherwise a nearer point is tried.
    const STEPS: usize = 5;
    constrained::normalize(model, &mut point);
    let holds = constrained::project_within(model, &mut point, STEPS);
    (holds && point.states.iter().all(|value| value.is_finite())).then_some(point)
}

/// Draws a point within the validity limits: states of magnitudes typical of flights, one in four up to 1000 times
/// smaller; parameters around their defaults; coefficients within their bounds, with random signs, never 0. If typical
/// states are outside the limits, they are moved within them.
pub(crate) fn near(model: &Model, random: &mut Random) -> Point<f64> {
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
    let farthest = 10f64
        .powf(MOVES.1)
        .max(BEYOND_BOUND * margins.largest_bound());
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
        let decades = random.between(MOVES.0, farthest.log10());
        let size = typical(model.states[state].unit) * 10f64.powf(decades);
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

    /// Largest bound of a limit: a body that is valid a planet's radius away is moved that far.
    fn largest_bound(&self) -> f64 {
        let bounds = self.limits.iter().map(|(limit, _)| limit.bound.abs());
        bounds.filter(|bound| bound.is_finite()).fold(0.0, f64::max)
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
