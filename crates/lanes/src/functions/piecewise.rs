//! Piecewise cubics. Each lane looks up its own piece; the arithmetic is common to all lanes.

use crate::primitive::{MAX_WIDTH, Primitive};

#[inline(always)]
pub(crate) fn piecewise_cubic<T: Primitive>(x: T, knots: &[f64], cubics: &[[f64; 4]]) -> T {
    assert!(!knots.is_empty() && cubics.len() == knots.len() + 1);
    let mut arguments = [0.0; MAX_WIDTH];
    x.store_lanes(&mut arguments);
    let mut origins = [0.0; MAX_WIDTH];
    let mut coefficients = [[0.0; MAX_WIDTH]; 4];
    for lane in 0..T::WIDTH {
        let below = knots_up_to(knots, arguments[lane]);
        origins[lane] = knots[below.saturating_sub(1)];
        for (power, coefficient) in cubics[below].iter().enumerate() {
            coefficients[power][lane] = *coefficient;
        }
    }
    let h = x - T::load_lanes(&origins);
    let [a, b, c, d] = coefficients.map(|of_power| T::load_lanes(&of_power));
    d.mul_add_op(h, c).mul_add_op(h, b).mul_add_op(h, a)
}

/// Factors of the coefficients in the derivative of each order: (n + order)! / n! for the power n.
const FALLING: [[f64; 4]; 4] = [
    [1.0, 1.0, 1.0, 1.0],
    [1.0, 2.0, 3.0, 0.0],
    [2.0, 6.0, 0.0, 0.0],
    [6.0, 0.0, 0.0, 0.0],
];

#[inline(always)]
pub(crate) fn piecewise_bicubic<T: Primitive>(
    [x, y]: [T; 2],
    orders: [usize; 2],
    knots: [&[f64]; 2],
    cells: &[[f64; 16]],
) -> T {
    let intervals = knots.map(|knots| knots.len() + 1);
    assert!(!knots[0].is_empty() && !knots[1].is_empty());
    assert!(cells.len() == intervals[0] * intervals[1]);
    let [powers_x, powers_y] = orders.map(|order| 4 - order);
    let mut arguments = [[0.0; MAX_WIDTH]; 2];
    x.store_lanes(&mut arguments[0]);
    y.store_lanes(&mut arguments[1]);
    let mut origins = [[0.0; MAX_WIDTH]; 2];
    let mut coefficients = [[[0.0; MAX_WIDTH]; 4]; 4];
    for lane in 0..T::WIDTH {
        let below = [0, 1].map(|k| knots_up_to(knots[k], arguments[k][lane]));
        for k in [0, 1] {
            origins[k][lane] = knots[k][below[k].saturating_sub(1)];
        }
        let cell = &cells[below[0] * intervals[1] + below[1]];
        for a in 0..powers_x {
            for b in 0..powers_y {
                let factor = FALLING[orders[0]][a] * FALLING[orders[1]][b];
                coefficients[a][b][lane] = factor * cell[4 * (a + orders[0]) + b + orders[1]];
            }
        }
    }
    let h = x - T::load_lanes(&origins[0]);
    let k = y - T::load_lanes(&origins[1]);
    // No closure, which would be a function for the baseline processor.
    let mut value = T::load_lanes(&[0.0; MAX_WIDTH]);
    for of_x in coefficients[..powers_x].iter().rev() {
        let mut row = T::load_lanes(&of_x[powers_y - 1]);
        for of_y in of_x[..powers_y - 1].iter().rev() {
            row = row.mul_add_op(k, T::load_lanes(of_y));
        }
        value = value.mul_add_op(h, row);
    }
    value
}

/// Number of knots that are at most `x`, by bisection without branches; 0 for NaN.
#[inline(always)]
fn knots_up_to(knots: &[f64], x: f64) -> usize {
    let (mut first, mut len) = (0, knots.len());
    while len > 1 {
        let half = len / 2;
        first += if knots[first + half - 1] <= x {
            half
        } else {
            0
        };
        len -= half;
    }
    first + usize::from(knots[first] <= x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bisection_counts_the_knots_below() {
        for n in 1..40 {
            let knots: Vec<f64> = (0..n).map(|k| f64::from(k * k)).collect();
            for x in [-1.0, 0.0, 0.5, 1.0, 3.9, 4.0, 600.0, 1521.0, 1e9, f64::NAN] {
                let expected = knots.iter().filter(|&&knot| knot <= x).count();
                assert_eq!(knots_up_to(&knots, x), expected, "{n} knots at {x}");
            }
        }
    }

    /// The cell from (1, 0) on is (h + 2 h³)(1 + k²), the others are constants.
    #[test]
    fn each_cell_has_its_derivatives() {
        let mut cells = [[0.0; 16]; 4];
        for (index, cell) in cells.iter_mut().enumerate() {
            cell[0] = index as f64;
        }
        cells[3] = [0.0; 16];
        for (a, of_x) in [(1, 1.0), (3, 2.0)] {
            (cells[3][4 * a], cells[3][4 * a + 2]) = (of_x, of_x);
        }
        let at = |x, y, orders| piecewise_bicubic([x, y], orders, [&[1.0], &[0.0]], &cells);
        assert_eq!([at(0.0, -1.0, [0, 0]), at(0.0, 1.0, [0, 0])], [0.0, 1.0]);
        assert_eq!(at(2.0, -1.0, [0, 0]), 2.0);
        let (h, k) = (2.0, 3.0);
        let of_h = [h + 2.0 * h * h * h, 1.0 + 6.0 * h * h, 12.0 * h, 12.0];
        let of_k = [1.0 + k * k, 2.0 * k, 2.0, 0.0];
        for orders in (0..16).map(|n| [n / 4, n % 4]) {
            let expected = of_h[orders[0]] * of_k[orders[1]];
            assert_eq!(at(1.0 + h, k, orders), expected, "{orders:?}");
        }
    }

    #[test]
    fn each_piece_has_its_cubic() {
        let (knots, cubics) = (
            [1.0, 3.0],
            [[1.0, 2.0, 0.0, 0.0], [1.0, 2.0, 3.0, 4.0], [0.5; 4]],
        );
        for (x, expected) in [(0.0, -1.0), (1.0, 1.0), (2.0, 10.0), (3.0, 0.5), (4.0, 2.0)] {
            assert_eq!(piecewise_cubic(x, &knots, &cubics), expected, "at {x}");
        }
    }
}
