//! Jacobians by states and parameters, of the derivatives and of the observation, against three ways of
//! differentiating the vector tree that know nothing of the compiler's rules: the dual numbers of
//! num-dual, complex steps, and dual numbers of our own that also give the size of the terms; and, where
//! there is a reference, against dual numbers through the law written by hand.
//!
//! A quaternion is varied along the unit sphere alone: off it, it stands for no attitude.

use crate::random::Random;
use crate::report::{Row, Worst};
use crate::sample;
use crate::subject::{Derivatives, Differentiable, Subject};
use crate::{Options, TOLERANCE};
use model_spec::model::{FrameKind, Model};
use oracle::dynamics::derivatives_of;
use oracle::point::Point;
use oracle::reference::Reference;
use oracle::scalar::{ComplexStep, Dual, NumDual, Real, Tracked};
use oracle::tree::Tree;

/// Names of the checks, one row each.
pub const CHECKS: [&str; 4] = [
    "derivatives: num-dual",
    "derivatives: complex step",
    "derivatives: dual numbers",
    "derivatives: reference",
];

/// A number that carries a derivative.
trait Slope: Real {
    fn moving(value: f64, slope: f64) -> Self;
    fn slope(self) -> f64;
}

impl Slope for NumDual {
    fn moving(value: f64, slope: f64) -> Self {
        NumDual::moving(value, slope)
    }

    fn slope(self) -> f64 {
        NumDual::slope(self)
    }
}

impl Slope for ComplexStep {
    fn moving(value: f64, slope: f64) -> Self {
        ComplexStep::moving(value, slope)
    }

    fn slope(self) -> f64 {
        ComplexStep::slope(self)
    }
}

type Sized = Dual<Tracked>;

fn sized(value: f64, slope: f64) -> Sized {
    Dual::moving(Tracked::lit(value), Tracked::lit(slope))
}

/// Every entry of every Jacobian, structural zeros included.
pub fn check(subject: &Subject<'_>, equations: &dyn Differentiable, options: &Options) -> Vec<Row> {
    let model = subject.model;
    let added = model.added_states();
    let cases = options.cases.div_ceil(4);
    let mut random = Random::new(options.seed, "derivatives");
    let mut worst: [Worst; 4] = Default::default();
    for _ in 0..cases {
        let point = sample::point(model, &mut random);
        let core = subject.without_extras(point.clone());
        let got = equations.derivatives(&point);
        let by_state = equations.by_state(&point);
        let got_core = equations.derivatives(&core);
        for (j, name) in variables(model).iter().enumerate() {
            let column = along(&got, model, &point, j);
            let shorter = (j < model.states.len()).then(|| along(&by_state, model, &point, j));
            let Some(sized) = column_of(model, &seed(model, &point, j, self::sized)) else {
                return CHECKS
                    .map(|name| Row::skipped(name, "the tree oracle cannot derive it"))
                    .into();
            };
            let dual: Vec<f64> = slopes::<NumDual>(model, &point, j);
            let step: Vec<f64> = slopes::<ComplexStep>(model, &point, j);
            for (i, sized) in sized.iter().enumerate() {
                let Tracked { value, size } = sized.slope;
                let place = || format!("d {} / d {name}", row_name(model, i));
                worst[0].see(error(dual[i], size, column[i]), place);
                worst[1].see(error(step[i], size, column[i]), place);
                worst[2].see(error(value, size, column[i]), place);
                if let Some(shorter) = shorter.as_ref().and_then(|shorter| shorter.get(i)) {
                    worst[2].see(error(value, size, *shorter), || place() + " in f_jac");
                }
                for values in [&got.values, &by_state.values] {
                    let value = values.get(i).map_or(0.0, |&v| sized.value.error_of(v));
                    worst[2].see(value, || row_name(model, i) + " beside its derivatives");
                }
            }
            if let Some(reference) = &subject.reference {
                let column = along(&got_core, model, &core, j);
                let known = known(model, reference, j);
                let by_hand = by_hand(reference, model, &seed(model, &core, j, self::sized));
                let of_law = |i: usize| known && !added.contains(&i);
                for (i, expected) in by_hand.iter().enumerate().filter(|(i, _)| of_law(*i)) {
                    let place = || format!("d {} / d {name}", row_name(model, i));
                    let Tracked { value, size } = expected.slope;
                    worst[3].see(error(value, size, column[i]), place);
                }
            }
        }
    }
    let rows = CHECKS
        .iter()
        .zip(&worst)
        .enumerate()
        .map(|(k, (name, worst))| {
            if k == 3 && subject.reference.is_none() {
                Row::skipped(name, "the model claims no reference")
            } else {
                Row::judged(name, cases, worst, TOLERANCE)
            }
        });
    rows.collect()
}

/// A coefficient that the law does not know has no derivative there, nor has a state that was added.
fn known(model: &Model, reference: &Reference, variable: usize) -> bool {
    if model.added_states().contains(&variable) {
        return false;
    }
    let first = model.states.len() + model.params.len();
    variable
        .checked_sub(first)
        .is_none_or(|index| !reference.unknown.contains(&index))
}

/// Names of what is differentiated by: states, then parameters, coefficients and inputs.
pub fn variables(model: &Model) -> Vec<String> {
    let constants = model
        .params
        .iter()
        .chain(&model.coefficients)
        .map(|c| c.name.clone());
    let inputs = model
        .inputs
        .iter()
        .flat_map(|i| ["x", "y", "z"].map(|axis| format!("{}_{axis}", i.name)));
    model
        .states
        .iter()
        .map(|s| s.name.clone())
        .chain(constants)
        .chain(inputs)
        .collect()
}

fn row_name(model: &Model, row: usize) -> String {
    match model.states.get(row) {
        Some(state) => format!("der({})", state.name),
        None => format!("observation {}", row - model.states.len() + 1),
    }
}

/// How fast each state moves when variable `j` does: it alone, but a quaternion along the unit sphere.
fn direction(model: &Model, point: &Point<f64>, j: usize) -> Vec<f64> {
    let mut slopes = vec![0.0; point.states.len()];
    if let Some(own) = slopes.get_mut(j) {
        *own = 1.0;
    }
    for frame in &model.frames {
        if let FrameKind::Quaternion { states: q, .. } = frame.kind
            && q.contains(&j)
        {
            q.into_iter()
                .for_each(|k| slopes[k] -= point.states[j] * point.states[k]);
        }
    }
    slopes
}

/// The point in other numbers, moving in that direction.
fn seed<T: Real>(
    model: &Model,
    point: &Point<f64>,
    j: usize,
    moving: impl Fn(f64, f64) -> T,
) -> Point<T> {
    let mut out = point.lift::<T>();
    for (state, slope) in out.states.iter_mut().zip(direction(model, point, j)) {
        if slope != 0.0 {
            *state = moving(state.re(), slope);
        }
    }
    let Some(k) = j.checked_sub(out.states.len()) else {
        return out;
    };
    let constants = out.params.iter_mut().chain(&mut out.coefficients);
    let inputs = out.inputs.iter_mut().flat_map(|v| v.iter_mut());
    if let Some(place) = constants.chain(inputs).nth(k) {
        *place = moving(place.re(), 1.0);
    }
    out
}

/// What the Jacobians say of that direction, row by row, with the size of the entries that take part: a
/// direction along the unit sphere is so only up to rounding, and entries off it say nothing.
fn along(got: &Derivatives, model: &Model, point: &Point<f64>, j: usize) -> Vec<Tracked> {
    let mut slopes = direction(model, point, j);
    slopes.resize(got.entries.first().map_or(0, Vec::len), 0.0);
    if j >= point.states.len() {
        slopes[j] = 1.0;
    }
    let sum = |row: &Vec<f64>| {
        let taking_part = slopes.iter().zip(row).filter(|(slope, _)| **slope != 0.0);
        Tracked {
            value: taking_part
                .clone()
                .map(|(slope, entry)| slope * entry)
                .sum(),
            size: taking_part.map(|(_, entry)| entry.abs()).sum(),
        }
    };
    got.entries.iter().map(sum).collect()
}

/// The difference of two derivatives against the size of the terms of either.
fn error(expected: f64, size: f64, got: Tracked) -> f64 {
    Tracked {
        value: expected,
        size: size.max(got.size),
    }
    .error_of(got.value)
}

/// Derivatives of the states, then the observation.
fn column_of<T: Real>(model: &Model, point: &Point<T>) -> Option<Vec<T>> {
    let tree = Tree::new(model, point);
    let mut out = derivatives_of(&tree).ok()?;
    if let Some(seen) = &model.observation {
        out.extend(tree.vector(&seen.value).iter());
    }
    Some(out)
}

fn slopes<T: Slope>(model: &Model, point: &Point<f64>, j: usize) -> Vec<f64> {
    let column = column_of(model, &seed(model, point, j, T::moving)).unwrap_or_default();
    column.into_iter().map(T::slope).collect()
}

fn by_hand(reference: &Reference, model: &Model, point: &Point<Sized>) -> Vec<Sized> {
    // The law speaks of the flight's own time.
    let pace = Tree::new(model, point).clock();
    let rates = reference.derivatives(point).into_iter();
    let mut out: Vec<Sized> = rates.map(|rate| rate * pace).collect();
    if model.observation.is_some() {
        out.extend(reference.observation(point).iter());
    }
    out
}
