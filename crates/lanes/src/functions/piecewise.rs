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
