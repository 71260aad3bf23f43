//! Macros that implement arithmetic operators in terms of other operators, and constants in terms of literals.

/// Implements `+=`, `-=`, `*=` and `/=` for a type, by means of its `+`, `-`, `*` and `/`.
#[macro_export]
macro_rules! assign_ops {
    ([$($generics:tt)*] $type:ty) => {
        impl<$($generics)*> ::std::ops::AddAssign for $type {
            fn add_assign(&mut self, o: Self) {
                *self = *self + o;
            }
        }
        impl<$($generics)*> ::std::ops::SubAssign for $type {
            fn sub_assign(&mut self, o: Self) {
                *self = *self - o;
            }
        }
        impl<$($generics)*> ::std::ops::MulAssign for $type {
            fn mul_assign(&mut self, o: Self) {
                *self = *self * o;
            }
        }
        impl<$($generics)*> ::std::ops::DivAssign for $type {
            fn div_assign(&mut self, o: Self) {
                *self = *self / o;
            }
        }
    };
}

/// Implements `+`, `-`, `*`, `/` and negation for a newtype, by means of the operators of its inner type.
#[macro_export]
macro_rules! wrapped_ops {
    ($type:ident($inner:ty)) => {
        impl ::std::ops::Add for $type {
            type Output = Self;
            fn add(self, o: Self) -> Self {
                Self(self.0 + o.0)
            }
        }
        impl ::std::ops::Sub for $type {
            type Output = Self;
            fn sub(self, o: Self) -> Self {
                Self(self.0 - o.0)
            }
        }
        impl ::std::ops::Mul for $type {
            type Output = Self;
            fn mul(self, o: Self) -> Self {
                Self(self.0 * o.0)
            }
        }
        impl ::std::ops::Div for $type {
            type Output = Self;
            fn div(self, o: Self) -> Self {
                Self(self.0 / o.0)
            }
        }
        impl ::std::ops::Neg for $type {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
    };
}

/// Implements [`One`](num_traits::One) and [`Field`](super::Field) for a scalar type that represents every literal by
/// the nearest `f64`, by means of `Real::lit`.
macro_rules! rounded_literals {
    ($type:ty) => {
        impl One for $type {
            fn one() -> Self {
                Self::lit(1.0)
            }
        }
        impl Field for $type {
            fn integer(value: i64) -> Self {
                Self::lit(value as f64)
            }

            fn literal(value: f64, _exact: Option<(i64, i64)>) -> Option<Self> {
                Some(Self::lit(value))
            }
        }
    };
}

pub(super) use rounded_literals;
