//! Tables of two arguments: the curves along the second argument, interpolated along the first.
//!
//! The surface is that of the compiler, computed in a different way: no cell has coefficients. The slopes along the first
//! argument depend linearly on the values there, so that those of the curves' values are combined.

use super::Real;
use super::table::Interpolant;
use model_spec::model::Table;

/// Interpolated table of two arguments.
#[derive(Clone, Debug)]
pub struct Surface<'a> {
    table: &'a Table,
    /// Curve along the second argument at each knot of the first.
    rows: Vec<Interpolant<'a>>,
    /// For each knot of the first argument, the curve along it that is 1 at this knot and 0 at all others.
    cardinal: Vec<Interpolant<'a>>,
}

impl<'a> Surface<'a> {
    /// Creates the interpolating surface of a table of two arguments that a model declares.
    pub fn new(table: &'a Table) -> Self {
        let [first, second] = &table.arguments[..] else {
            panic!("two arguments, by the checker")
        };
        let row = |values: &[f64]| {
            let knots = second.knots.iter().copied().zip(values.iter().copied());
            Interpolant::through(knots.collect(), table)
        };
        let cardinal = |at: usize| {
            let value = |k: usize| if k == at { 1.0 } else { 0.0 };
            let knots = first.knots.iter().copied().enumerate();
            Interpolant::through(knots.map(|(k, x)| (x, value(k))).collect(), table)
        };
        Self {
            table,
            rows: table.values.chunks(second.knots.len()).map(row).collect(),
            cardinal: (0..first.knots.len()).map(cardinal).collect(),
        }
    }

    /// Hash of the interpolated surface ([`Table::fingerprint`]).
    pub fn fingerprint(&self) -> u64 {
        self.table.fingerprint()
    }

    /// Value of the surface at (x, y), or its partial derivative of the given orders.
    pub fn at<T: Real>(&self, [x, y]: [T; 2], orders: [u8; 2]) -> T {
        let terms = self.cardinal.iter().zip(&self.rows);
        terms.fold(T::zero(), |sum, (of_x, of_y)| {
            sum + of_x.at(x, orders[0]) * of_y.at(y, orders[1])
        })
    }

    /// Scale of the rounding error of a value or derivative: the sum of the magnitudes of its terms.
    pub fn magnitude(&self, [x, y]: [f64; 2], orders: [u8; 2]) -> f64 {
        let size = |curve: &Interpolant, at: f64, order: u8| match order {
            0 => curve.at(at, 0).abs().max(curve.magnitude_near(at)),
            _ => curve.at(at, order).abs(),
        };
        let terms = self.cardinal.iter().zip(&self.rows);
        terms
            .map(|(of_x, of_y)| size(of_x, x, orders[0]) * size(of_y, y, orders[1]))
            .sum()
    }
}
