//! Enclosures: what a value and its slope can be over a range of one variable, by interval arithmetic.

mod functions;
mod interval;
#[cfg(test)]
mod tests;

use crate::real::{ElementaryFunction, Real};
use interval::{Interval, UNBOUNDED, hull, product, reach, sum};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Bounds of a function of one variable u from -1 to 1: a [`Real`], so that any code over real numbers gives the bounds
/// of its result.
///
/// They hold up to rounding. Where the function jumps, its slope is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// Value at u = 0.
    middle: f64,
    range: Interval,
    slope: Interval,
}

impl Enclosure {
    /// Bounds of a polynomial in u, by its coefficients in order of rising power.
    pub fn polynomial(coefficients: &[f64]) -> Enclosure {
        let (middle, linear) = (coefficients[0], coefficients.get(1).copied().unwrap_or(0.0));
        let higher = coefficients.iter().enumerate().skip(2);
        let bend: f64 = higher.map(|(power, c)| power as f64 * c.abs()).sum();
        let slope = [linear - bend, linear + bend];
        Enclosure::bounded(middle, UNBOUNDED, slope)
    }

    /// Least and greatest value.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Whether the value nowhere falls, or nowhere rises.
    pub fn is_monotone(&self) -> bool {
        self.slope[0] >= 0.0 || self.slope[1] <= 0.0
    }

    /// Enclosure whose range is what both `range` and the slope allow: the second bound is the better one of narrow ranges.
    fn bounded(middle: f64, range: Interval, slope: Interval) -> Enclosure {
        let slope = match slope[0] <= slope[1] {
            true => slope,
            false => UNBOUNDED,
        };
        let far = reach(slope);
        // Rounding puts no value outside of its bounds.
        let low = (middle - far).max(range[0]).min(middle);
        let high = (middle + far).min(range[1]).max(middle);
        Enclosure {
            middle,
            range: [low, high],
            slope,
        }
    }

    /// Value of a function by its value in the middle, its range and the range of its derivative.
    fn chained(self, middle: f64, range: Interval, derivative: Interval) -> Enclosure {
        Enclosure::bounded(middle, range, product(self.slope, derivative))
    }

    fn jump(middle: f64, range: Interval) -> Enclosure {
        Enclosure::bounded(middle, range, UNBOUNDED)
    }

    fn reciprocal(self, middle: f64) -> Enclosure {
        let [low, high] = self.range;
        if low <= 0.0 && high >= 0.0 {
            return Enclosure::jump(middle, UNBOUNDED);
        }
        let range = [1.0 / high, 1.0 / low];
        let [a, b] = product(range, range);
        self.chained(middle, range, [-b, -a])
    }
}

impl Add for Enclosure {
    type Output = Enclosure;
    fn add(self, other: Enclosure) -> Enclosure {
        let middle = self.middle + other.middle;
        let range = sum(self.range, other.range);
        Enclosure::bounded(middle, range, sum(self.slope, other.slope))
    }
}

impl Neg for Enclosure {
    type Output = Enclosure;
    fn neg(self) -> Enclosure {
        let opposite = |[low, high]: Interval| [-high, -low];
        Enclosure {
            middle: -self.middle,
            range: opposite(self.range),
            slope: opposite(self.slope),
        }
    }
}

impl Sub for Enclosure {
    type Output = Enclosure;
    fn sub(self, other: Enclosure) -> Enclosure {
        self + -other
    }
}

impl Mul for Enclosure {
    type Output = Enclosure;
    fn mul(self, other: Enclosure) -> Enclosure {
        let middle = self.middle * other.middle;
        let by_self = product(self.slope, other.range);
        let by_other = product(other.slope, self.range);
        let range = product(self.range, other.range);
        Enclosure::bounded(middle, range, sum(by_self, by_other))
    }
}

impl Div for Enclosure {
    type Output = Enclosure;
    fn div(self, other: Enclosure) -> Enclosure {
        self * other.reciprocal(1.0 / other.middle)
    }
}

impl Real for Enclosure {
    fn splat(value: f64) -> Enclosure {
        Enclosure {
            middle: value,
            range: [value; 2],
            slope: [0.0; 2],
        }
    }

    fn sqrt(self) -> Enclosure {
        let [low, high] = self.range.map(|value| value.max(0.0).sqrt());
        if high == 0.0 {
            return Enclosure::splat(0.0);
        }
        let least = match self.range[0] < 0.0 {
            true => 0.0,
            false => 0.5 / high,
        };
        self.chained(Real::sqrt(self.middle), [low, high], [least, 0.5 / low])
    }

    fn recip_or_zero(self) -> Enclosure {
        self.reciprocal(self.middle.recip_or_zero())
    }

    fn sin_cos(self) -> (Enclosure, Enclosure) {
        let (sine, cosine) = Real::sin_cos(self.middle);
        let [of_sine, of_cosine] = functions::sin_cos(self.range);
        let [low, high] = of_sine;
        (
            self.chained(sine, of_sine, of_cosine),
            self.chained(cosine, of_cosine, [-high, -low]),
        )
    }

    fn atan2(self, x: Enclosure) -> Enclosure {
        let middle = Real::atan2(self.middle, x.middle);
        let Some(range) = functions::angle(self.range, x.range) else {
            let pi = std::f64::consts::PI;
            return Enclosure::jump(middle, [-pi, pi]);
        };
        let square = x * x + self * self;
        let [turn, back] = [product(x.range, self.slope), product(self.range, x.slope)];
        let turn = sum(turn, [-back[1], -back[0]]);
        let inverse = square.reciprocal(1.0 / square.middle).range;
        Enclosure::bounded(middle, range, product(turn, inverse))
    }

    fn elementary(self, function: ElementaryFunction) -> Enclosure {
        let middle = self.middle.elementary(function);
        match functions::elementary(function, self.range) {
            Some((range, derivative)) => self.chained(middle, range, derivative),
            None => Enclosure::jump(middle, UNBOUNDED),
        }
    }

    fn abs(self) -> Enclosure {
        match self.range {
            [low, _] if low >= 0.0 => self,
            [_, high] if high <= 0.0 => -self,
            range => self.chained(self.middle.abs(), [0.0, reach(range)], [-1.0, 1.0]),
        }
    }

    fn min(self, other: Enclosure) -> Enclosure {
        -(-self).max(-other)
    }

    fn max(self, other: Enclosure) -> Enclosure {
        if self.range[0] >= other.range[1] {
            return self;
        }
        if other.range[0] >= self.range[1] {
            return other;
        }
        let range = [0, 1].map(|k| self.range[k].max(other.range[k]));
        let middle = self.middle.max(other.middle);
        Enclosure::bounded(middle, range, hull(self.slope, other.slope))
    }

    fn sign(self) -> Enclosure {
        let range = self.range.map(Real::sign);
        match range[0] == range[1] {
            true => Enclosure::splat(range[0]),
            false => Enclosure::jump(Real::sign(self.middle), range),
        }
    }

    fn heaviside(self) -> Enclosure {
        let range = self.range.map(Real::heaviside);
        match range[0] == range[1] {
            true => Enclosure::splat(range[0]),
            false => Enclosure::jump(self.middle.heaviside(), range),
        }
    }

    fn if_zero(self, then: Enclosure, otherwise: Enclosure) -> Enclosure {
        let is_zero = |value: f64| value.if_zero(1.0, 0.0) == 1.0;
        let [low, high] = self.range;
        if is_zero(low) && is_zero(high) {
            return then;
        }
        if low > 0.0 && !is_zero(low) || high < 0.0 && !is_zero(high) {
            return otherwise;
        }
        let middle = self.middle.if_zero(then.middle, otherwise.middle);
        Enclosure::jump(middle, hull(then.range, otherwise.range))
    }

    fn piecewise_cubic(self, knots: &[f64], cubics: &[[f64; 4]]) -> Enclosure {
        let middle = self.middle.piecewise_cubic(knots, cubics);
        let (range, derivative) = functions::piecewise_cubic(self.range, knots, cubics);
        self.chained(middle, range, derivative)
    }

    fn piecewise_bicubic(
        self,
        y: Enclosure,
        orders: [usize; 2],
        knots: [&[f64]; 2],
        cells: &[[f64; 16]],
    ) -> Enclosure {
        let (a, b) = (self.middle, y.middle);
        // Only narrow ranges are told apart: an argument that is itself a table of two arguments is rare.
        let middle = a.piecewise_bicubic(b, orders, knots, cells);
        let rests = |own: &Enclosure| own.slope == [0.0; 2];
        match rests(&self) && rests(&y) {
            true => Enclosure::splat(middle),
            false => Enclosure::jump(middle, UNBOUNDED),
        }
    }
}
