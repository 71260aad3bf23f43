//! Traits for arithmetic on one real number or on one real number per lane, implemented by the primitive operations.

use crate::functions::{exponential, inverse_trigonometric, piecewise, trigonometric};
use crate::primitive::{LaneKernel, MAX_WIDTH, Primitive};
use std::hint::cold_path;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Threshold on |x| below which guarded functions, such as the reciprocal with value 0 at 0, treat x as 0. It is chosen
/// so that its square is still a normal number.
const ZERO: f64 = 1e-75;

/// An elementary function of one argument that is evaluated by polynomials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementaryFunction {
    /// Exponential function, within 2 ulp.
    Exp,
    /// Natural logarithm, within 2 ulp; 0 where the argument is 0 or less.
    Log,
    /// Hyperbolic tangent, within 3 ulp.
    Tanh,
    /// Arcsine of the argument clamped to [-1, 1], within 3 ulp.
    Asin,
}

impl ElementaryFunction {
    /// All elementary functions that are evaluated by polynomials.
    pub const ALL: [ElementaryFunction; 4] = [Self::Exp, Self::Log, Self::Tanh, Self::Asin];

    /// Name of the method of [`Real`] that evaluates the function.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exp => "exp",
            Self::Log => "log",
            Self::Tanh => "tanh",
            Self::Asin => "asin",
        }
    }
}

/// A real number, or one real number per lane: the scalar type of generated code and of the bytecode interpreter.
///
/// Contraction is explicit: only [`mul_add`](Real::mul_add), [`mul_sub`](Real::mul_sub) and
/// [`neg_mul_add`](Real::neg_mul_add) may be fused, and the compiler contracts no other operation. AVX-512, AVX2 and
/// [`dispatch_scalar`](crate::dispatch_scalar) on machines with FMA fuse them; [`Isa::Portable`](crate::Isa::Portable)
/// and `f64` do not. The elementary functions use the same polynomials for every type. Results are therefore
/// bit-identical among all fusing types and among all non-fusing types; results of a fusing and a non-fusing type
/// differ by rounding.
///
/// NaN propagates, with unspecified sign, except through the methods that only compare: [`min`](Real::min) and
/// [`max`](Real::max) with a NaN return `other`, [`sign`](Real::sign) and [`heaviside`](Real::heaviside) of NaN are 0,
/// and [`if_zero`](Real::if_zero) of NaN selects `otherwise`. NaN does not satisfy the condition "0 or less" in the
/// descriptions of the methods.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Returns a number with `value` in every lane.
    fn splat(value: f64) -> Self;
    /// `self * b + c`, rounded once if the type fuses multiply-adds ([`Isa::fuses`](crate::Isa::fuses)), else twice.
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        self * b + c
    }
    /// `self * b - c`, rounded once if the type fuses multiply-adds, else twice.
    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        self * b - c
    }
    /// `c - self * b`, rounded once if the type fuses multiply-adds, else twice.
    #[inline(always)]
    fn neg_mul_add(self, b: Self, c: Self) -> Self {
        c - self * b
    }
    /// Square root; 0 where the argument is 0 or less.
    fn sqrt(self) -> Self;
    /// Guarded reciprocal: `1 / self`, and 0 where `|self| < 1e-75`.
    fn recip_or_zero(self) -> Self;
    /// Sine and cosine, within 2 ulp for arguments up to 1e5; larger arguments use the standard library's functions.
    fn sin_cos(self) -> (Self, Self);
    /// Polar angle of the point (`x`, `self`), within 2 ulp; 0 at the origin.
    fn atan2(self, x: Self) -> Self;
    /// Value of the elementary function `function` at `self`; [`ElementaryFunction`] states the accuracy.
    fn elementary(self, function: ElementaryFunction) -> Self;
    /// Exponential function, within 2 ulp.
    #[inline(always)]
    fn exp(self) -> Self {
        self.elementary(ElementaryFunction::Exp)
    }
    /// Natural logarithm, within 2 ulp; 0 where the argument is 0 or less.
    #[inline(always)]
    fn log(self) -> Self {
        self.elementary(ElementaryFunction::Log)
    }
    /// Hyperbolic tangent, within 3 ulp.
    #[inline(always)]
    fn tanh(self) -> Self {
        self.elementary(ElementaryFunction::Tanh)
    }
    /// Arcsine of the argument clamped to [-1, 1], within 3 ulp.
    #[inline(always)]
    fn asin(self) -> Self {
        self.elementary(ElementaryFunction::Asin)
    }
    /// Absolute value.
    fn abs(self) -> Self;
    /// Minimum of two numbers; `other` if either is NaN.
    fn min(self, other: Self) -> Self;
    /// Maximum of two numbers; `other` if either is NaN.
    fn max(self, other: Self) -> Self;
    /// Sign of the number: -1, 0 or 1 if it is negative, zero or positive.
    fn sign(self) -> Self;
    /// Heaviside step: 1 where `self > 0`, else 0.
    fn heaviside(self) -> Self;
    /// Selects `then` where `|self| < 1e-75`, else `otherwise`.
    fn if_zero(self, then: Self, otherwise: Self) -> Self;
    /// Piecewise cubic function: `cubics[0]` for arguments below `knots[0]`, `cubics[i]` for arguments from `knots[i -
    /// 1]` to `knots[i]`, and the last cubic above the last knot. A cubic is given by the coefficients of the powers 0
    /// to 3 of the distance from the knot at the lower end of its interval (`cubics[0]`: from the first knot), and
    /// evaluated by Horner's rule with [`mul_add`](Real::mul_add).
    ///
    /// # Panics
    /// If `knots` is empty, or `cubics` does not have exactly one element more than `knots`.
    fn piecewise_cubic(self, knots: &[f64], cubics: &[[f64; 4]]) -> Self;
    /// Piecewise bicubic function of `self` and `y`, or its partial derivative of the given `orders`, each at most 3.
    /// Each argument has knots and one interval more, as in [`piecewise_cubic`](Real::piecewise_cubic); `cells` lists
    /// the intervals of `y` for the first interval of `self`, then for the second one, and so on. A cell is given by
    /// the coefficients of h^a k^b at index 4 a + b, h and k being the distances from the knots at its lower ends.
    ///
    /// # Panics
    /// If the knots of an argument are empty, an order exceeds 3, or the number of `cells` is not that of the intervals.
    fn piecewise_bicubic(
        self,
        y: Self,
        orders: [usize; 2],
        knots: [&[f64]; 2],
        cells: &[[f64; 16]],
    ) -> Self;
}

/// [`Real`] numbers with a fixed number of lanes, loaded from and stored to slices of `f64`.
pub trait Lanes: Real {
    /// Number of lanes.
    const WIDTH: usize;
    /// Loads the first `WIDTH` numbers of a slice.
    fn load(from: &[f64]) -> Self;
    /// Stores the lanes into the first `WIDTH` elements of a slice.
    fn store(self, to: &mut [f64]);
    /// Returns a number with `value(lane)` in each lane, lanes counted from 0.
    fn from_fn(value: impl FnMut(usize) -> f64) -> Self;
    /// Returns the value in one lane, counted from 0.
    fn lane(self, lane: usize) -> f64;
    /// Runs a computation in a separate function that is not inlined, compiled once for the instruction set of these
    /// lanes: for large code that a [`Kernel`](crate::Kernel) uses in several places.
    fn outlined<K: LaneKernel<Self>>(kernel: K);

    /// Loads up to `WIDTH` numbers of a slice; lanes past the end of the slice are set to `fill`.
    #[inline(always)]
    fn load_part(from: &[f64], fill: f64) -> Self {
        if from.len() >= Self::WIDTH {
            Self::load(from)
        } else {
            Self::from_fn(|lane| from.get(lane).copied().unwrap_or(fill))
        }
    }

    /// Stores as many lanes as the slice has elements, at most `WIDTH`.
    #[inline(always)]
    fn store_part(self, to: &mut [f64]) {
        if to.len() >= Self::WIDTH {
            self.store(to);
        } else {
            for (lane, element) in to.iter_mut().enumerate() {
                *element = self.lane(lane);
            }
        }
    }
}

impl<T: Primitive> Real for T {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        T::broadcast(value)
    }
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        self.mul_add_op(b, c)
    }
    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        self.mul_sub_op(b, c)
    }
    #[inline(always)]
    fn neg_mul_add(self, b: Self, c: Self) -> Self {
        self.neg_mul_add_op(b, c)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let zero = T::broadcast(0.0);
        if T::WIDTH == 1 {
            // A well-predicted branch is cheaper than a select, which requires the results of both branches.
            if T::all_true(zero.lt(self)) {
                return self.ieee_sqrt();
            }
            cold_path();
        }
        T::select(self.le(zero), zero, self.ieee_sqrt())
    }
    #[inline(always)]
    fn recip_or_zero(self) -> Self {
        if T::WIDTH == 1 {
            if T::all_true(T::broadcast(ZERO).le(self.magnitude())) {
                return T::broadcast(1.0) / self;
            }
            cold_path();
        }
        self.if_zero(T::broadcast(0.0), T::broadcast(1.0) / self)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        trigonometric::sin_cos(self)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        inverse_trigonometric::atan2(self, x)
    }
    #[inline(always)]
    fn elementary(self, function: ElementaryFunction) -> Self {
        match function {
            ElementaryFunction::Exp => exponential::exp(self),
            ElementaryFunction::Log => exponential::log(self),
            ElementaryFunction::Tanh => exponential::tanh(self),
            ElementaryFunction::Asin => inverse_trigonometric::asin(self),
        }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.magnitude()
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        T::select(self.lt(other), self, other)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        T::select(other.lt(self), self, other)
    }
    #[inline(always)]
    fn sign(self) -> Self {
        let zero = T::broadcast(0.0);
        let negative = T::select(self.lt(zero), T::broadcast(-1.0), zero);
        T::select(zero.lt(self), T::broadcast(1.0), negative)
    }
    #[inline(always)]
    fn heaviside(self) -> Self {
        let zero = T::broadcast(0.0);
        T::select(zero.lt(self), T::broadcast(1.0), zero)
    }
    #[inline(always)]
    fn if_zero(self, then: Self, otherwise: Self) -> Self {
        let is_zero = self.magnitude().lt(T::broadcast(ZERO));
        T::select(is_zero, then, otherwise)
    }
    #[inline(always)]
    fn piecewise_cubic(self, knots: &[f64], cubics: &[[f64; 4]]) -> Self {
        piecewise::piecewise_cubic(self, knots, cubics)
    }
    #[inline(always)]
    fn piecewise_bicubic(
        self,
        y: Self,
        orders: [usize; 2],
        knots: [&[f64]; 2],
        cells: &[[f64; 16]],
    ) -> Self {
        piecewise::piecewise_bicubic([self, y], orders, knots, cells)
    }
}

impl<T: Primitive> Lanes for T {
    const WIDTH: usize = <T as Primitive>::WIDTH;
    #[inline(always)]
    fn outlined<K: LaneKernel<Self>>(kernel: K) {
        T::run_outlined(kernel);
    }
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        T::load_lanes(from)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        self.store_lanes(to);
    }
    #[inline(always)]
    fn from_fn(mut value: impl FnMut(usize) -> f64) -> Self {
        let mut lanes = [0.0; MAX_WIDTH];
        for (i, lane) in lanes.iter_mut().take(<T as Primitive>::WIDTH).enumerate() {
            *lane = value(i);
        }
        T::load_lanes(&lanes)
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        let mut lanes = [0.0; MAX_WIDTH];
        self.store_lanes(&mut lanes);
        lanes[..<T as Primitive>::WIDTH][lane]
    }
}
