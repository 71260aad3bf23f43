//! Unknowns of the blocks `solve { … }`: each system is evaluated with dual numbers for its coefficients, and solved by
//! elimination with scaled partial pivoting.

use crate::point::Point;
use crate::scalar::{Dual, Real};
use crate::tree::{Tree, Value};
use model_spec::model::Model;
use nalgebra::Vector3;

/// Solution of a linear system.
pub(crate) struct Solved<T> {
    pub unknowns: Vec<T>,
    /// Least size of a pivot over the sum of the sizes of its terms.
    pub determinacy: f64,
}

/// Solves a system of a model at a point; `known` has the unknowns of the systems before it.
pub(crate) fn solved<T: Real>(
    model: &Model,
    point: &Point<T>,
    given: &[(usize, Value<T>)],
    known: &[Vec<T>],
) -> Solved<T> {
    let count = model.systems[known.len()].unknowns.len();
    let point = point.map(Dual::constant);
    let given: Vec<(usize, Value<Dual<T>>)> = { given.iter() }
        .map(|(index, value)| (*index, value.map(Dual::constant)))
        .collect();
    let equations = |unknowns: Vec<Dual<T>>| -> Vec<Dual<T>> {
        let mut all: Vec<Vec<Dual<T>>> = { known.iter() }
            .map(|own| own.iter().map(|value| Dual::constant(*value)).collect())
            .collect();
        all.push(unknowns);
        let later = model.systems.iter().skip(all.len());
        all.extend(later.map(|own| vec![Dual::constant(T::zero()); own.unknowns.len()]));
        let tree = Tree::evaluated(model, &point, &given, all);
        let system = &model.systems[known.len()];
        let values = system.equations.iter().map(|e| tree.value(e));
        values.flat_map(Value::components).collect()
    };
    let zeros = vec![Dual::constant(T::zero()); count];
    let columns: Vec<Vec<T>> = (0..count)
        .map(|k| {
            let mut unknowns = zeros.clone();
            unknowns[k].derivative = T::one();
            { equations(unknowns).into_iter() }
                .map(|row| row.derivative)
                .collect()
        })
        .collect();
    let rows = equations(zeros).into_iter().enumerate().map(|(row, rest)| {
        let coefficients = columns.iter().map(|column| column[row]);
        coefficients.chain([-rest.value]).collect()
    });
    eliminate(rows.collect())
}

/// Solves the system whose rows are coefficients and right-hand side.
fn eliminate<T: Real>(mut rows: Vec<Vec<T>>) -> Solved<T> {
    let count = rows.len();
    let mut sizes: Vec<Vec<f64>> = { rows.iter() }
        .map(|row| row.iter().map(|entry| size(*entry)).collect())
        .collect();
    let mut determinacy = 1.0_f64;
    for step in 0..count {
        let scaled = |row: usize| {
            let rest = &sizes[row][step..count];
            let scale = rest.iter().copied().fold(0.0, f64::max);
            size(rows[row][step]) / scale
        };
        let best = (step..count).max_by(|a, b| scaled(*a).total_cmp(&scaled(*b)));
        let best = best.unwrap_or(step);
        rows.swap(step, best);
        sizes.swap(step, best);
        let pivot = rows[step][step];
        let share = size(pivot) / sizes[step][step];
        determinacy = if share.is_nan() {
            0.0
        } else {
            determinacy.min(share)
        };
        for row in step + 1..count {
            let factor = rows[row][step] / pivot;
            for column in step..=count {
                let (less, more) = (rows[step][column], sizes[step][column]);
                rows[row][column] -= factor * less;
                sizes[row][column] += size(factor) * more;
            }
        }
    }
    let mut unknowns = vec![T::zero(); count];
    for row in (0..count).rev() {
        let known = (row + 1..count).map(|k| rows[row][k] * unknowns[k]);
        let known = known.fold(T::zero(), |sum, term| sum + term);
        unknowns[row] = (rows[row][count] - known) / rows[row][row];
    }
    Solved {
        unknowns,
        determinacy,
    }
}

/// Absolute value; above 0 for symbols, whose real value is none, unless they are zero.
fn size<T: Real>(value: T) -> f64 {
    if value.is_zero() {
        0.0
    } else {
        value.re().abs()
    }
}

impl<T: Real> Value<T> {
    pub(crate) fn map<U: Real>(self, change: impl Fn(T) -> U) -> Value<U> {
        match self {
            Value::Scalar(value) => Value::Scalar(change(value)),
            Value::Vector(value) => Value::Vector(Vector3::from_fn(|k, _| change(value[k]))),
        }
    }

    fn components(self) -> Vec<T> {
        match self {
            Value::Scalar(value) => vec![value],
            Value::Vector(value) => value.iter().copied().collect(),
        }
    }
}
