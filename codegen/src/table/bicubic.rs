//! Piecewise bicubic functions: tables of two arguments, as tensor products of the functions of one.

use super::PiecewiseCubic;
use lanes::Real;
use model_spec::model::{self, TableArgument};

/// A piecewise bicubic function, given by the knots of both arguments and by the coefficients of each cell.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewiseBicubic {
    knots: [Vec<f64>; 2],
    cells: Vec<[f64; 16]>,
}

impl PiecewiseBicubic {
    /// Interpolates a table of two arguments: along the second argument at each knot of the first, then the
    /// coefficients of these cubics along the first.
    pub fn of(table: &model::Table) -> PiecewiseBicubic {
        let [first, second] = &table.arguments[..] else {
            panic!("the table `{}` has two arguments", table.name)
        };
        let along = |argument: &TableArgument, values: Vec<f64>| {
            let points: Vec<(f64, f64)> = argument.knots.iter().copied().zip(values).collect();
            PiecewiseCubic::through(&points, table.interpolation, table.continuation)
        };
        let rows = table.values.chunks(second.knots.len());
        let rows: Vec<PiecewiseCubic> = rows.map(|row| along(second, row.to_vec())).collect();
        let (intervals_x, intervals_y) = (first.knots.len() + 1, second.knots.len() + 1);
        let mut cells = vec![[0.0; 16]; intervals_x * intervals_y];
        for j in 0..intervals_y {
            for power in 0..4 {
                let values = rows.iter().map(|row| row.cubics()[j][power]).collect();
                for (i, cubic) in along(first, values).cubics().iter().enumerate() {
                    for (a, coefficient) in cubic.iter().enumerate() {
                        cells[i * intervals_y + j][4 * a + power] = *coefficient;
                    }
                }
            }
        }
        PiecewiseBicubic {
            knots: [first.knots.clone(), second.knots.clone()],
            cells,
        }
    }

    /// Knots of both arguments, in increasing order.
    pub fn knots(&self) -> [&[f64]; 2] {
        [&self.knots[0], &self.knots[1]]
    }

    /// Coefficients of each cell; see [`Real::piecewise_bicubic`].
    pub fn cells(&self) -> &[[f64; 16]] {
        &self.cells
    }

    /// The partial derivative of the given orders as a piecewise bicubic of its own.
    pub fn derivative(&self, orders: [u8; 2]) -> PiecewiseBicubic {
        let cells = self.cells.iter().map(|cell| derivative(cell, orders));
        PiecewiseBicubic {
            knots: self.knots.clone(),
            cells: cells.collect(),
        }
    }

    /// Origin and coefficients of the cell of the partial derivative of the given orders that applies at (x, y).
    pub fn piece(&self, arguments: [f64; 2], orders: [u8; 2]) -> ([f64; 2], [f64; 16]) {
        let below = [0, 1].map(|k| self.knots[k].partition_point(|&knot| knot <= arguments[k]));
        let origin = [0, 1].map(|k| self.knots[k][below[k].saturating_sub(1)]);
        let cell = &self.cells[below[0] * (self.knots[1].len() + 1) + below[1]];
        (origin, derivative(cell, orders))
    }

    /// Evaluates the function, or its derivative of the given orders, at (x, y).
    #[inline(always)]
    pub fn eval<T: Real>(&self, x: T, y: T, orders: [u8; 2]) -> T {
        x.piecewise_bicubic(y, orders.map(usize::from), self.knots(), &self.cells)
    }
}

/// Coefficients of a partial derivative of a bicubic.
fn derivative(cell: &[f64; 16], orders: [u8; 2]) -> [f64; 16] {
    let [p, q] = orders.map(usize::from);
    let falling = |n: usize, order: usize| (n + 1..=n + order).map(|n| n as f64).product::<f64>();
    let mut derivative = [0.0; 16];
    for a in 0..4 - p {
        for b in 0..4 - q {
            let factor = falling(a, p) * falling(b, q);
            derivative[4 * a + b] = factor * cell[4 * (a + p) + b + q];
        }
    }
    derivative
}
