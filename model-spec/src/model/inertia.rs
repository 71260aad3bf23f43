//! Values of constant expressions, and the inertia tensors that a body can have.

use super::{Expr, ExprKind, Function, Model, Parameter};
use std::f64::consts::{PI, TAU};

/// Part of the largest moment of inertia by which it may exceed the sum of the other two: flat bodies have the sum itself,
/// and published moments are rounded to three digits.
const ROUNDED: f64 = 0.01;

/// Inertia tensor about the mass centre, kg m², by its entries.
pub type InertiaTensor<T> = [[T; 3]; 3];

impl Model {
    /// Why no body has the inertia tensor that the model states, with the values that `of` gives its parameters and
    /// coefficients; `None` if one may have it.
    pub fn inertia_fault(&self, of: impl Fn(&Parameter) -> f64) -> Option<String> {
        self.tensors()
            .find_map(|tensor| self.tensor_fault(tensor, &of))
    }

    pub(crate) fn tensors(&self) -> impl Iterator<Item = &InertiaTensor<Expr>> {
        let declared = self.rotation().map(|own| &own.inertia);
        let claimed = self.claim.as_ref().and_then(|own| own.rotation.as_ref());
        declared.into_iter().chain(claimed.map(|own| &own.inertia))
    }

    pub(crate) fn tensor_fault(
        &self,
        tensor: &InertiaTensor<Expr>,
        of: &dyn Fn(&Parameter) -> f64,
    ) -> Option<String> {
        let (mut values, known) = ([[0.0; 3]; 3], self.known(of));
        for (row, own) in values.iter_mut().zip(tensor) {
            for (value, entry) in row.iter_mut().zip(own) {
                *value = self.constant_with(entry, of, &known)?;
            }
        }
        fault(&values)
    }

    /// Value of an expression of parameters and coefficients, SI; `None` with operations that no constant of a body needs,
    /// such as tables.
    pub(crate) fn constant(&self, e: &Expr, of: &dyn Fn(&Parameter) -> f64) -> Option<f64> {
        self.constant_with(e, of, &self.known(of))
    }

    /// Values of the auxiliary variables, one after the other: evaluated where they stand, each link of a chain of names
    /// would double the work.
    fn known(&self, of: &dyn Fn(&Parameter) -> f64) -> Vec<Option<f64>> {
        let mut known = Vec::with_capacity(self.aux_variables.len());
        for own in &self.aux_variables {
            known.push(self.constant_with(&own.value, of, &known));
        }
        known
    }

    /// As [`constant`](Self::constant), with the values of the auxiliary variables.
    fn constant_with(
        &self,
        e: &Expr,
        of: &dyn Fn(&Parameter) -> f64,
        known: &[Option<f64>],
    ) -> Option<f64> {
        let value = |e: &Expr| self.constant_with(e, of, known);
        Some(match &e.kind {
            ExprKind::Number { value, .. } => *value,
            ExprKind::Pi => PI,
            ExprKind::Param(i) => of(&self.params[*i]),
            ExprKind::Coefficient(i) => of(&self.coefficients[*i]),
            ExprKind::AuxVariable(i) => (*known.get(*i)?)?,
            ExprKind::Neg(a) => -value(a)?,
            ExprKind::Add(a, b) => value(a)? + value(b)?,
            ExprKind::Sub(a, b) => value(a)? - value(b)?,
            ExprKind::Mul(a, b) => value(a)? * value(b)?,
            ExprKind::Div(a, b) => value(a)? / value(b)?,
            ExprKind::Pow(a, twice) => value(a)?.powf(f64::from(*twice) / 2.0),
            ExprKind::Call(Function::Sqrt, a) => value(a)?.sqrt(),
            ExprKind::Call(Function::Sin, a) => value(a)?.sin(),
            ExprKind::Call(Function::Cos, a) => value(a)?.cos(),
            _ => return None,
        })
    }
}

/// Why no body has an inertia tensor; `None` if one may have it.
fn fault(tensor: &InertiaTensor<f64>) -> Option<String> {
    let mut moments = principal_moments(tensor);
    moments.sort_unstable_by(f64::total_cmp);
    let [a, b, c] = moments;
    let (what, expected) = if a <= 0.0 {
        let expected =
            "expected three above 0; check the signs and sizes of its products of inertia";
        ("is not positive definite", expected)
    } else if c - (a + b) > ROUNDED * c {
        let expected =
            "expected none above the sum of the other two, which is the largest of a flat body";
        ("is that of no body", expected)
    } else {
        return None;
    };
    Some(format!(
        "the inertia tensor {what}: found principal moments of {a:.5e}, {b:.5e} and {c:.5e} kg m², {expected}"
    ))
}

/// Eigenvalues of a symmetric tensor, by the cosines that solve its cubic.
fn principal_moments(tensor: &InertiaTensor<f64>) -> [f64; 3] {
    let [[a, d, e], [_, b, f], [.., c]] = *tensor;
    let products = d * d + e * e + f * f;
    if products == 0.0 {
        return [a, b, c];
    }
    let mean = (a + b + c) / 3.0;
    let [x, y, z] = [a - mean, b - mean, c - mean];
    let size = ((x * x + y * y + z * z + 2.0 * products) / 6.0).sqrt();
    let determinant = x * (y * z - f * f) - d * (d * z - f * e) + e * (d * f - y * e);
    let angle = (determinant / (2.0 * size * size * size))
        .clamp(-1.0, 1.0)
        .acos()
        / 3.0;
    [0.0, 1.0, 2.0].map(|k| mean + 2.0 * size * (angle + k * TAU / 3.0).cos())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_refused(tensor: InertiaTensor<f64>) -> bool {
        fault(&tensor).is_some()
    }

    #[test]
    fn a_moment_beyond_the_sum_of_the_others_is_that_of_no_body() {
        let diagonal = |a, b, c| [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]];
        assert!(!is_refused(diagonal(0.00122, 0.00122, 0.00244)));
        // A flat body, rounded to three digits.
        assert!(!is_refused(diagonal(0.0610, 0.0610, 0.123)));
        assert!(is_refused(diagonal(1.0, 1.0, 2.1)));
        assert!(is_refused(diagonal(5.0, 1.0, 2.0)));
    }

    /// A turned tensor has the moments of the one that was turned.
    #[test]
    fn products_of_inertia_count() {
        // diag(1, 2, c), turned about the third and then about the first axis.
        let turned = |c: f64| {
            let (p, q) = (0.6_f64, 0.8_f64);
            let first = [
                [p * p + 2.0 * q * q, -p * q, 0.0],
                [-p * q, q * q + 2.0 * p * p, 0.0],
                [0.0, 0.0, c],
            ];
            let turn = [[1.0, 0.0, 0.0], [0.0, p, -q], [0.0, q, p]];
            let of = |i: usize, j: usize| {
                let terms = (0..9).map(|k| turn[i][k / 3] * first[k / 3][k % 3] * turn[j][k % 3]);
                terms.sum::<f64>()
            };
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| of(i, j)))
        };
        let mut moments = principal_moments(&turned(2.5));
        moments.sort_unstable_by(f64::total_cmp);
        for (found, expected) in moments.into_iter().zip([1.0, 2.0, 2.5]) {
            assert!((found - expected).abs() < 1e-14, "{moments:?}");
        }
        assert!(!is_refused(turned(2.99)));
        assert!(is_refused(turned(3.1)));
        let told = fault(&turned(-0.5)).expect("a fault");
        assert!(told.contains("not positive definite"), "{told}");
    }
}
