//! Compares two programs row by row to decide whether they compute the same function: exactly, by evaluation at random
//! points of the field of integers modulo 2^61 − 1 (Schwartz–Zippel), and in floating-point numbers where the exact
//! comparison shows a difference.

use super::values::Everything;
use crate::field::FieldPoint;
use crate::options::TOLERANCE;
use crate::pairing::Pairing;
use crate::random::Random;
use crate::sample;
use model_spec::model::Model;
use oracle::scalar::{ErrorBound, Real};
use oracle::{Point, Tree, derivatives_of};
use serde::Serialize;
use std::collections::BTreeMap;

const POINTS: usize = 4;
const MAX_TRIALS: usize = 4096;
/// Lower bound, SI, of the divisor of the difference of auxiliary variables or loads.
const MIN_MAGNITUDE: f64 = 1e-6;
const NUMBERS: usize = 24;

/// Result of comparing one output of two models, such as a state derivative, an auxiliary variable or a load.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sameness {
    /// The same function, by exact evaluation at random points of the prime field.
    Same,
    /// Not equal or not decided in the prime field, but equal in floating-point arithmetic.
    Agrees,
    /// Different functions, also in floating-point arithmetic.
    Changed,
}

/// Comparison of one output of two models.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Compared {
    /// Whether the outputs are the same function.
    pub sameness: Sameness,
    /// Maximum difference at random points, relative to the sum of the magnitudes of the terms.
    pub error: f64,
}

impl Compared {
    /// Whether the outputs are different functions.
    pub fn is_changed(self) -> bool {
        self.sameness == Sameness::Changed
    }
}

/// Compares every row, auxiliary variable and load that both models have, by name, as functions of states and
/// parameters. What only one of the models has takes random values.
pub fn compare(old: &Everything<'_>, new: &Everything<'_>) -> BTreeMap<String, Compared> {
    let pairing = Pairing::of(&old.code.layout, &new.code.layout);
    let (before, after) = (old.groups(), new.groups());
    let both = after.into_iter().filter_map(|(name, new)| {
        let old = before.get(&name)?;
        (old.len() == new.len()).then(|| (name, old.clone().zip(new).collect::<Vec<_>>()))
    });
    let (names, groups): (Vec<String>, Vec<_>) = both.unzip();
    let pairs = groups.concat();
    let exact = exactly(old, new, &pairing, &pairs);
    let errors = in_numbers(old, new, &pairing, &pairs);
    let mut compared = exact.into_iter().zip(errors).map(|(exact, error)| {
        let sameness = match exact {
            // Functions may be symbolically equal although a root takes a different branch.
            Some(true) if error <= 1e6 * TOLERANCE => Sameness::Same,
            _ if error <= TOLERANCE => Sameness::Agrees,
            _ => Sameness::Changed,
        };
        Compared { sameness, error }
    });
    let named = names.into_iter().zip(groups).map(|(name, group)| {
        let parts = compared.by_ref().take(group.len());
        let worst = parts.reduce(|a, b| Compared {
            sameness: a.sameness.max(b.sameness),
            error: a.error.max(b.error),
        });
        Some((name, worst?))
    });
    named.flatten().collect()
}

/// For each pair of outputs, whether both are equal in the prime field; `None` if they exist at too few points.
fn exactly(
    old: &Everything<'_>,
    new: &Everything<'_>,
    pairing: &Pairing,
    pairs: &[(usize, usize)],
) -> Vec<Option<bool>> {
    let mut random = Random::new(0, "the same function");
    let mut equal = vec![0; pairs.len()];
    let mut different = vec![false; pairs.len()];
    for _ in 0..MAX_TRIALS {
        let open = |k: usize| equal[k] < POINTS && !different[k];
        if !(0..pairs.len()).any(open) {
            break;
        }
        let here = FieldPoint::random(old.model, &mut random);
        let mut there = FieldPoint::random(new.model, &mut random);
        there.point = pairing.carry(&here.point, &there.point);
        for (to, from) in there.circles.iter_mut().zip(&pairing.states) {
            *to = from.map_or(*to, |from| here.circles[from]);
        }
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

/// For each pair of outputs, the maximum relative difference in floating-point arithmetic.
fn in_numbers(
    old: &Everything<'_>,
    new: &Everything<'_>,
    pairing: &Pairing,
    pairs: &[(usize, usize)],
) -> Vec<f64> {
    let mut random = Random::new(0, "the same numbers");
    let mut worst = vec![0.0_f64; pairs.len()];
    for _ in 0..NUMBERS {
        let here = sample::point(old.model, &mut random);
        let there = pairing.carry(&here, &sample::point(new.model, &mut random));
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

/// Lower bound of the divisor of the difference of the output `k`: the sum of the magnitudes of its terms, for an
/// auxiliary variable or load the greatest of its components and [`MIN_MAGNITUDE`], else 0.
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

/// Sums of the magnitudes of the terms of state derivatives and observation; empty if there are none.
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
