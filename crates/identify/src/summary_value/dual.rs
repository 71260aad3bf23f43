//! Scalars with their derivatives by the components of the vectors of a motion.

use std::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::SVector;

/// Number of components of the vectors of a motion: six vectors.
pub const COMPONENTS: usize = 18;

/// A value with its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Dual {
    pub value: f64,
    pub by: SVector<f64, COMPONENTS>,
}

impl Dual {
    pub const ZERO: Self = Self {
        value: 0.0,
        by: SVector::from_array_storage(nalgebra::ArrayStorage([[0.0; COMPONENTS]])),
    };

    /// The component `place` of the motion.
    pub fn variable(value: f64, place: usize) -> Self {
        let mut by = SVector::zeros();
        by[place] = 1.0;
        Self { value, by }
    }

    /// f(self) with the slope f′.
    fn through(self, value: f64, slope: f64) -> Self {
        Self {
            value,
            by: slope * self.by,
        }
    }

    /// The number times a constant.
    pub fn times(self, factor: f64) -> Self {
        self.through(factor * self.value, factor)
    }

    /// Square root; its derivative is 0 at 0.
    pub fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.through(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }

    /// Angle of the point (x, y), with y = self; its derivative is 0 at the origin.
    pub fn atan2(self, x: Self) -> Self {
        let squares = self.value * self.value + x.value * x.value;
        let part = if squares > 0.0 { 1.0 / squares } else { 0.0 };
        Self {
            value: self.value.atan2(x.value),
            by: part * (x.value * self.by - self.value * x.by),
        }
    }

    fn with(self, other: Self, value: f64, (own, others): (f64, f64)) -> Self {
        Self {
            value,
            by: own * self.by + others * other.by,
        }
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.with(other, self.value + other.value, (1.0, 1.0))
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.with(other, self.value - other.value, (1.0, -1.0))
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.with(other, self.value * other.value, (other.value, self.value))
    }
}

impl Div for Dual {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.with(other, value, (1.0 / other.value, -value / other.value))
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        self.through(-self.value, -1.0)
    }
}

/// Vector of dual numbers.
#[derive(Clone, Copy, Debug)]
pub struct DualVector(pub [Dual; 3]);

impl DualVector {
    pub fn dot(self, other: Self) -> Dual {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        a * d + b * e + c * f
    }

    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        Self([b * f - c * e, c * d - a * f, a * e - b * d])
    }

    pub fn norm(self) -> Dual {
        self.dot(self).sqrt()
    }

    pub fn scaled(self, by: Dual) -> Self {
        Self(self.0.map(|own| own * by))
    }

    pub fn minus(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        Self([a - d, b - e, c - f])
    }

    pub fn unit(self) -> Self {
        let norm = self.norm();
        Self(self.0.map(|own| own / norm))
    }
}
