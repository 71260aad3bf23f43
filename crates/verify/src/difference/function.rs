//! Compares two programs row by row to decide whether they compute the same function: exactly, by evaluation at random
//! points of the field of integers modulo 2^61 − 1 (Schwartz–Zippel), and in floating-point numbers where the exact
//! comparison shows a difference.

use super::pairing::Pairing;
use super::values::Everything;
use crate::checks::exact::FieldPoint;
use crate::field::literal;
use crate::random::Random;
use crate::{TOLERANCE, sample};
use model_spec::model::Model;
use oracle::scalar::{ErrorBound, Field, Real};
use oracle::{Point, Tree, derivatives_of};
use serde::Serialize;

/// Number of random points of the prime field (integers modulo 2^61 − 1) at which the values of two functions must be
/// equal for the functions to count as equal.
const POINTS: usize = 4;
/// Maximum number of random trial points of the prime field (integers modulo 2^61 − 1). A trial point is usable only if
/// the argument of every square root is a square in the field.
const MAX_TRIALS: usize = 4096;
/// Lower bound, in SI units, of the magnitude by which the difference of two auxiliary variables or loads is divided.
/// Because of this bound, values that are 0 except for rounding count as equal.
const MIN_MAGNITUDE: f64 = 1e-6;
/// Number of random points at which an output of the old model and one of the new model are compared in floating-point
/// arithmetic.
const NUMBERS: usize = 24;

/// Result of comparing one output of the old model with the corresponding output of the new model: a state derivative,
/// a component of the observation, a validity limit, an auxiliary variable or a load.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sameness {
    /// The outputs of the old and the new model are the same function, as decided by exact evaluation at random points
    /// of the prime field (integers modulo 2^61 − 1).
    Same,
    /// The values of the two models' outputs in the prime field (integers modulo 2^61 − 1) differ or do not exist, but
    /// their floating-point values agree within the tolerance.
    Agrees,
    /// The outputs of the old and the new model are different functions, also in floating-point arithmetic.
    Changed,
}

/// Result of comparing one output, such as a state derivative, of the old model with the corresponding one of the new
/// model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Compared {
    /// Whether the outputs of the two models are the same function.
    pub sameness: Sameness,
    /// Maximum difference between the two outputs at random points, relative to the sum of the magnitudes of their
    /// terms.
    pub error: f64,
}

impl Compared {
    /// Whether the outputs of the two models are different functions.
    pub fn is_changed(self) -> bool {
        self.sameness == Sameness::Changed
    }
}

/// Compares pairs of outputs (index in the old model, index in the new model) as functions of the states and
/// parameters. Paired states and parameters have equal random values in both models. Unpaired states and parameters
/// have independent random values; if `stated` is true, unpaired parameters have the default values of their model.
pub fn compare(
    old: &Everything<'_>,
    new: &Everything<'_>,
    pairing: &Pairing,
    pairs: &[(usize, usize)],
    stated: bool,
) -> Vec<Compared> {
    let exact = exactly(old, new, pairing, pairs, stated);
    let errors = in_numbers(old, new, pairing, pairs, stated);
    let outcome = |(exact, error): (Option<bool>, f64)| {
        let agrees = error <= TOLERANCE;
        let sameness = match exact {
            // Functions may be symbolically equal although a root takes a different branch.
            Some(true) if error <= 1e6 * TOLERANCE => Sameness::Same,
            _ if agrees => Sameness::Agrees,
            _ => Sameness::Changed,
        };
        Compared { sameness, error }
    };
    exact.into_iter().zip(errors).map(outcome).collect()
}

/// For each pair of outputs (index in the old model, index in the new model), whether both have the same value at
/// random points of the prime field (integers modulo 2^61 − 1); `None` if the values exist in the field at too few
/// points. If `stated` is true, unpaired parameters have the default values of their model, otherwise random values.
fn exactly(
    old: &Everything<'_>,
    new: &Everything<'_>,
    pairing: &Pairing,
    pairs: &[(usize, usize)],
    stated: bool,
) -> Vec<Option<bool>> {
    let mut random = Random::new(0, "the same function");
    let mut equal = vec![0; pairs.len()];
    let mut different = vec![false; pairs.len()];
    for _ in 0..MAX_TRIALS {
        let open = |k: usize| equal[k] < POINTS && !different[k];
        if !(0..pairs.len()).any(open) {
            break;
        }
        let (here, there) = field_points(old.model, new.model, pairing, stated, &mut random);
        let (a, b) = (old.exact(&here), new.exact(&there));
        for (k, &(i, j)) in pairs.iter().enumerate() {
            match (a[i], b[j]) {
                (Some(a), Some(b)) if a == b => equal[k] += 1,
                (Some(_), Some(_)) => different[k] = true,
                _ => {}
            }
        }
    }
    let decided = equal.into_iter().zip(different);
    decided
        .map(|(equal, different)| match different {
            true => Some(false),
            false => (equal >= POINTS).then_some(true),
        })
        .collect()
}

/// Draws a random point of the prime field (integers modulo 2^61 − 1) for each of the two models. Paired states and
/// parameters have equal values in both; if `stated`, unpaired parameters have the default values of their model.
fn field_points(
    old: &Model,
    new: &Model,
    pairing: &Pairing,
    stated: bool,
    random: &mut Random,
) -> (FieldPoint, FieldPoint) {
    let mut here = FieldPoint::random(old, random);
    let mut there = FieldPoint::random(new, random);
    if stated {
        let defaults = Point::defaults(old).map(literal);
        here.point = unpaired_at(&here.point, &defaults, |k| {
            pairing.new_parameter(k).is_some()
        });
        let defaults = Point::defaults(new).map(literal);
        there.point = unpaired_at(&there.point, &defaults, |_| false);
    }
    there.point = pairing.carry(&here.point, &there.point);
    for (to, from) in there.circles.iter_mut().zip(&pairing.states) {
        *to = from.map_or(*to, |from| here.circles[from]);
    }
    (here, there)
}

/// Returns a copy of `point` in which each parameter with an index k for which `keep(k)` is false has its value from
/// `defaults`. States and the other parameters are not changed.
fn unpaired_at<T: Field>(
    point: &Point<T>,
    defaults: &Point<T>,
    keep: impl Fn(usize) -> bool,
) -> Point<T> {
    let count = point.parameters().len();
    let only = Pairing {
        states: (0..point.states.len()).map(Some).collect(),
        parameters: (0..count).map(|k| keep(k).then_some(k)).collect(),
    };
    only.carry(point, defaults)
}

/// For each pair of outputs (index in the old model, index in the new model), the maximum relative difference at random
/// floating-point points. If `stated` is true, unpaired parameters have the default values of their model.
fn in_numbers(
    old: &Everything<'_>,
    new: &Everything<'_>,
    pairing: &Pairing,
    pairs: &[(usize, usize)],
    stated: bool,
) -> Vec<f64> {
    let mut random = Random::new(0, "the same numbers");
    let mut worst = vec![0.0_f64; pairs.len()];
    for _ in 0..NUMBERS {
        let mut here = sample::point(old.model, &mut random);
        let mut there = sample::point(new.model, &mut random);
        if stated {
            here = unpaired_at(&here, &Point::defaults(old.model), |k| {
                pairing.new_parameter(k).is_some()
            });
            there = Point::defaults(new.model);
        }
        let there = pairing.carry(&here, &there);
        let (a, b) = (old.numbers(&here), new.numbers(&there));
        let (sizes, others) = (magnitudes(old.model, &here), magnitudes(new.model, &there));
        for (worst, &(i, j)) in worst.iter_mut().zip(pairs) {
            let (x, y) = (a[i], b[j]);
            if !x.is_finite() && !y.is_finite() {
                continue;
            }
            let scale = size(old, &sizes, &a, i).max(size(new, &others, &b, j));
            let scale = scale.max(x.abs()).max(y.abs()).max(f64::MIN_POSITIVE);
            let error = (x - y).abs() / scale;
            *worst = worst.max(if error.is_nan() { f64::INFINITY } else { error });
        }
    }
    worst
}

/// Lower bound of the divisor that makes the difference of an output between two models relative; `k` is the index of
/// the output. For a state derivative or component of the observation: `sizes[k]`, the sum of the magnitudes of its
/// terms. For an auxiliary variable or load: the maximum absolute value of its components, or [`MIN_MAGNITUDE`] if that
/// is larger. For a validity limit: 0, so that its value alone determines the divisor.
fn size(model: &Everything<'_>, sizes: &[f64], values: &[f64], k: usize) -> f64 {
    if let Some(size) = sizes.get(k) {
        return *size;
    }
    let named = model.named.iter().find(|named| named.outputs.contains(&k));
    named.map_or(0.0, |named| {
        let parts = values[named.outputs.clone()].iter();
        parts.fold(MIN_MAGNITUDE, |most, v| most.max(v.abs()))
    })
}

/// Sum of the magnitudes of the terms of each state derivative, followed by that of each component of the observation;
/// empty if the state derivatives cannot be evaluated.
fn magnitudes(model: &Model, point: &Point<f64>) -> Vec<f64> {
    let lifted = point.lift::<ErrorBound>();
    let tree = Tree::new(model, &lifted);
    let Ok(rows) = derivatives_of(&tree) else {
        return Vec::new();
    };
    let mut out: Vec<f64> = rows.iter().map(|row| row.magnitude).collect();
    if let Some(observed) = &model.observation {
        let seen = tree.vector(&observed.value);
        out.extend(seen.iter().map(|v| v.magnitude.max(v.re().abs())));
    }
    out
}
