//! 256-bit floating-point numbers.
//!
//! Scalars are `Copy`, but a 256-bit number is not. A value is therefore an index into a thread-local list
//! of numbers, which [`with_numbers`] creates and drops. The list also has the function values that were computed: a
//! comparison differentiates a model by each variable in turn, and so calls a function with the same argument many times.

use astro_float_num::{BigFloat, Consts, RoundingMode, Sign, WORD_BIT_SIZE};
use num_traits::Zero;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;

use super::{Elementary, Field, Real};

/// Precision of [`Big`] numbers, bits.
pub const PRECISION: usize = 256;
const NEAREST: RoundingMode = RoundingMode::ToEven;

thread_local! {
    static NUMBERS: RefCell<Vec<BigFloat>> = const { RefCell::new(Vec::new()) };
    static CALLS: RefCell<HashMap<Call, Big>> = RefCell::new(HashMap::new());
    static CONSTANTS: RefCell<Option<Consts>> = const { RefCell::new(None) };
}

/// Runs a task with a new list of 256-bit numbers, in which each [`Big`] is an index. The list is dropped afterwards,
/// so the task's result must not contain a [`Big`].
pub fn with_numbers<R>(task: impl FnOnce() -> R) -> R {
    let zero = BigFloat::new(PRECISION);
    let outer = (NUMBERS.replace(vec![zero]), CALLS.take());
    let result = task();
    NUMBERS.set(outer.0);
    CALLS.set(outer.1);
    result
}

/// Key of a cached value: the function, and its argument as mantissa, sign, exponent, and whether it is rounded.
#[derive(PartialEq, Eq, Hash)]
struct Call {
    function: u8,
    words: Vec<u64>,
    is_negative: bool,
    exponent: i32,
    is_inexact: bool,
}

impl Call {
    /// Creates the key of a function value; `None` if the argument is infinite or NaN.
    fn new(function: Elementary, argument: &BigFloat) -> Option<Self> {
        let (words, _, sign, exponent, is_inexact) = argument.as_raw_parts()?;
        Some(Self {
            function: function as u8,
            words: words.to_vec(),
            is_negative: sign == Sign::Neg,
            exponent,
            is_inexact,
        })
    }
}

/// A number of [`PRECISION`] bits, valid only within the [`with_numbers`] call that created it.
#[derive(Clone, Copy, Debug)]
pub struct Big(u32);

impl Big {
    /// The number 0, which [`with_numbers`] puts at the beginning of its list.
    const ZERO: Self = Self(0);

    /// Whether the number is neither infinite nor NaN; [`Real::re`] may still be infinite, where `f64` overflows.
    pub fn is_finite(self) -> bool {
        NUMBERS.with_borrow(|numbers| {
            let value = &numbers[self.0 as usize];
            !value.is_nan() && !value.is_inf()
        })
    }

    fn new(value: BigFloat) -> Self {
        NUMBERS.with_borrow_mut(|numbers| {
            numbers.push(value);
            Self(u32::try_from(numbers.len() - 1).expect("fewer than 2^32 numbers"))
        })
    }

    fn map(self, f: impl FnOnce(&BigFloat) -> BigFloat) -> Self {
        let value = NUMBERS.with_borrow(|numbers| f(&numbers[self.0 as usize]));
        Self::new(value)
    }

    fn with(self, other: Self, f: impl FnOnce(&BigFloat, &BigFloat) -> BigFloat) -> Self {
        let value =
            NUMBERS.with_borrow(|numbers| f(&numbers[self.0 as usize], &numbers[other.0 as usize]));
        Self::new(value)
    }

    /// Applies to this number a function `f` that needs constants such as π, which the crate `astro-float-num` caches.
    fn call(self, f: impl FnOnce(&BigFloat, &mut Consts) -> BigFloat) -> Self {
        CONSTANTS.with_borrow_mut(|constants| {
            if constants.is_none() {
                *constants = Consts::new().ok();
            }
            match constants {
                Some(constants) => self.map(|value| f(value, constants)),
                None => Self::new(BigFloat::nan(None)),
            }
        })
    }

    fn pi() -> Self {
        Self::zero().call(|_, constants| constants.pi(PRECISION, NEAREST))
    }

    fn compare(self, other: Self) -> Option<Ordering> {
        let sign = NUMBERS
            .with_borrow(|numbers| numbers[self.0 as usize].cmp(&numbers[other.0 as usize]))?;
        Some(sign.cmp(&0))
    }
}

/// The f64 closest to a 256-bit number; NaN for NaN.
fn nearest(value: &BigFloat) -> f64 {
    if value.is_zero() {
        return 0.0;
    }
    if value.is_inf_pos() {
        return f64::INFINITY;
    }
    if value.is_inf_neg() {
        return f64::NEG_INFINITY;
    }
    let Some((words, _, sign, exponent, _)) = value.as_raw_parts() else {
        return f64::NAN;
    };
    // The mantissa is in [1/2, 1), its last word is the most significant. Three words have more bits than an f64.
    let scale = 0.5_f64.powi(WORD_BIT_SIZE as i32);
    let highest = words.iter().rev().take(3).rev();
    let mantissa = highest.fold(0.0, |lower, &word| (lower + word as f64) * scale);
    // The scaling is done in two steps because 2^exponent itself may overflow or underflow.
    let half = exponent.clamp(-2200, 2200) / 2;
    let rest = exponent.clamp(-2200, 2200) - half;
    let size = mantissa * 2f64.powi(half) * 2f64.powi(rest);
    match sign {
        Sign::Pos => size,
        Sign::Neg => -size,
    }
}

impl PartialEq for Big {
    fn eq(&self, other: &Self) -> bool {
        self.compare(*other) == Some(Ordering::Equal)
    }
}

// Most derivatives of a dual number are 0: a sum or product with 0 makes no new number.

crate::operators!([] Big {
    Add add(a, b) => match (a.is_zero(), b.is_zero()) {
        (true, _) => b,
        (_, true) => a,
        _ => a.with(b, |a, b| a.add(b, PRECISION, NEAREST)),
    },
    Sub sub(a, b) => if b.is_zero() {
        a
    } else {
        a.with(b, |a, b| a.sub(b, PRECISION, NEAREST))
    },
    Mul mul(a, b) => {
        let is_zero = |a: Self, b: Self| a.is_zero() && b.is_finite();
        if is_zero(a, b) || is_zero(b, a) {
            Self::zero()
        } else {
            a.with(b, |a, b| a.mul(b, PRECISION, NEAREST))
        }
    },
    Div div(a, b) => a.with(b, |a, b| a.div(b, PRECISION, NEAREST)),
    -a => a.map(BigFloat::neg),
});

crate::constants!([] Big {
    zero => Self::ZERO,
    is_zero(a) => NUMBERS.with_borrow(|numbers| numbers[a.0 as usize].is_zero()),
    one => Self::lit(1.0),
    integer(n) => Self::new(BigFloat::from_i64(n, PRECISION)),
});

impl Real for Big {
    crate::jet!();

    fn lit(value: f64) -> Self {
        Self::new(BigFloat::from_f64(value, PRECISION))
    }

    fn re(self) -> f64 {
        NUMBERS.with_borrow(|numbers| nearest(&numbers[self.0 as usize]))
    }

    fn elementary(self, function: Elementary) -> Self {
        let call = NUMBERS.with_borrow(|numbers| Call::new(function, &numbers[self.0 as usize]));
        let Some(call) = call else {
            return self.computed(function);
        };
        if let Some(known) = CALLS.with_borrow(|calls| calls.get(&call).copied()) {
            return known;
        }
        let value = self.computed(function);
        CALLS.with_borrow_mut(|calls| calls.insert(call, value));
        value
    }

    fn atan2(self, x: Self) -> Self {
        let (zero, y) = (Self::zero(), self);
        let atan = |ratio: Self| ratio.elementary(Elementary::Atan);
        let is_below = |a: Self| a.compare(zero) == Some(Ordering::Less);
        if y.is_zero() && x.is_zero() {
            zero
        } else if y.abs_compare(x) != Some(Ordering::Greater) {
            // |y| <= |x|
            match (is_below(x), is_below(y)) {
                (false, _) => atan(y / x),
                (true, false) => atan(y / x) + Self::pi(),
                (true, true) => atan(y / x) - Self::pi(),
            }
        } else {
            let right = Self::pi() / Self::integer(2);
            let right = if is_below(y) { -right } else { right };
            right - atan(x / y)
        }
    }
}

impl Big {
    fn computed(self, function: Elementary) -> Self {
        let one = || BigFloat::from_i64(1, PRECISION);
        let x = self.re();
        match function {
            Elementary::Sqrt | Elementary::Log if x <= 0.0 => Self::zero(),
            Elementary::Sqrt => self.map(|x| x.sqrt(PRECISION, NEAREST)),
            Elementary::Log => self.call(|x, c| x.ln(PRECISION, NEAREST, c)),
            Elementary::Sin => self.call(|x, c| x.sin(PRECISION, NEAREST, c)),
            Elementary::Cos => self.call(|x, c| x.cos(PRECISION, NEAREST, c)),
            Elementary::Exp => self.call(|x, c| x.exp(PRECISION, NEAREST, c)),
            Elementary::Tanh => self.call(|x, c| x.tanh(PRECISION, NEAREST, c)),
            Elementary::Atan => self.call(|x, c| x.atan(PRECISION, NEAREST, c)),
            Elementary::Asin => {
                let within = self.map(|x| x.clamp(&one().neg(), &one()));
                within.call(|x, c| x.asin(PRECISION, NEAREST, c))
            }
        }
    }

    fn abs_compare(self, other: Self) -> Option<Ordering> {
        let sign = NUMBERS
            .with_borrow(|numbers| numbers[self.0 as usize].abs_cmp(&numbers[other.0 as usize]))?;
        Some(sign.cmp(&0))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Elementary, Real};
    use super::{Big, with_numbers};
    use num_traits::Zero;

    #[test]
    fn a_number_goes_there_and_back() {
        with_numbers(|| {
            for value in [1.0, -0.1, 3e200, 1e-300, -f64::MAX, 0.0, f64::MIN_POSITIVE] {
                assert_eq!(Big::lit(value).re().to_bits(), value.to_bits(), "{value}");
            }
            assert!(Big::lit(f64::NAN).re().is_nan());
            assert_eq!((Big::lit(1.0) / Big::zero()).re(), f64::INFINITY);
        });
    }

    #[test]
    fn sums_and_products_with_zero_are_those_of_f64() {
        let values = [0.0, 1.5, -0.25, f64::INFINITY, f64::NAN];
        with_numbers(|| {
            for a in values {
                for (x, y) in [(0.0, a), (a, 0.0)] {
                    let (long_x, long_y) = (Big::lit(x), Big::lit(y));
                    let pairs = [
                        (long_x + long_y, x + y),
                        (long_x - long_y, x - y),
                        (long_x * long_y, x * y),
                    ];
                    for (long, short) in pairs {
                        let same = long.re() == short || long.re().is_nan() && short.is_nan();
                        assert!(same, "{x} {y}: {} {short}", long.re());
                    }
                }
            }
        });
    }

    #[test]
    fn functions_are_those_of_f64_and_longer() {
        with_numbers(|| {
            for f in Elementary::ALL {
                for x in [-0.9, -1e-9, 0.0, 0.3, 0.999] {
                    let (long, short) = (Big::lit(x).elementary(f).re(), f.value(x));
                    assert!((long - short).abs() <= 1e-15 * short.abs(), "{f:?} at {x}");
                }
            }
            // sin² + cos² − 1 is 1e-16 for f64.
            let (sine, cosine) = (Big::lit(0.7).sin(), Big::lit(0.7).cos());
            let rest = sine * sine + cosine * cosine - Big::lit(1.0);
            assert!(rest.re().abs() < 1e-70, "{}", rest.re());
        });
    }

    #[test]
    fn polar_angles_in_every_quadrant_and_on_the_axes() {
        with_numbers(|| {
            for y in [-2.0, -0.5, 0.0, 0.5, 2.0] {
                for x in [-1.0, -0.1, 0.0, 0.1, 1.0] {
                    let long = Real::atan2(Big::lit(y), Big::lit(x)).re();
                    let short = if y == 0.0 && x == 0.0 {
                        0.0
                    } else {
                        f64::atan2(y, x)
                    };
                    assert!((long - short).abs() < 1e-15, "{y} {x}: {long} {short}");
                }
            }
        });
    }
}
