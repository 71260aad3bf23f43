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

/// Implements one of the operators `+`, `-`, `*` and `/` for a type, by an expression.
#[macro_export]
macro_rules! operator {
    ([$($generics:tt)*] $type:ty, $trait:ident $method:ident($a:ident, $b:ident) => $value:expr) => {
        impl<$($generics)*> ::std::ops::$trait for $type {
            type Output = Self;
            #[inline]
            fn $method(self, o: Self) -> Self {
                let ($a, $b) = (self, o);
                $value
            }
        }
    };
}

/// Implements `+`, `-`, `*`, `/`, negation and the assigning operators for a type, by an expression for each.
#[macro_export]
macro_rules! operators {
    ($generics:tt $type:ty {
        $($trait:ident $method:ident($a:ident, $b:ident) => $value:expr,)*
        -$c:ident => $negative:expr,
    }) => {
        $($crate::operator!($generics $type, $trait $method($a, $b) => $value);)*
        $crate::negation!($generics $type, $c => $negative);
        $crate::assign_ops!($generics $type);
    };
}

/// Implements negation for a type, by an expression.
#[macro_export]
macro_rules! negation {
    ([$($generics:tt)*] $type:ty, $a:ident => $value:expr) => {
        impl<$($generics)*> ::std::ops::Neg for $type {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                let $a = self;
                $value
            }
        }
    };
}

/// Implements the operators of a newtype by those of its inner type.
#[macro_export]
macro_rules! wrapped_ops {
    ($type:ident($inner:ty)) => {
        $crate::operators!([] $type {
            Add add(a, b) => Self(a.0 + b.0),
            Sub sub(a, b) => Self(a.0 - b.0),
            Mul mul(a, b) => Self(a.0 * b.0),
            Div div(a, b) => Self(a.0 / b.0),
            -a => Self(-a.0),
        });
    };
}

/// Implements [`Zero`](num_traits::Zero), [`One`](num_traits::One) and [`Field`](crate::scalar::Field) for a type.
#[macro_export]
macro_rules! constants {
    ([$($generics:tt)*] $type:ty {
        zero => $zero:expr,
        is_zero($value:ident) => $is_zero:expr,
        one => $one:expr,
        integer($integer:ident) => $of_integer:expr,
        $(is_nothing($part:ident) => $is_nothing:expr,)?
    }) => {
        impl<$($generics)*> ::num_traits::Zero for $type {
            fn zero() -> Self {
                $zero
            }
            fn is_zero(&self) -> bool {
                let $value = self;
                $is_zero
            }
        }
        impl<$($generics)*> ::num_traits::One for $type {
            fn one() -> Self {
                $one
            }
        }
        impl<$($generics)*> $crate::scalar::Field for $type {
            fn integer($integer: i64) -> Self {
                $of_integer
            }
            $(#[inline]
            fn is_nothing(&self) -> bool {
                let $part = self;
                $is_nothing
            })?
        }
    };
}
