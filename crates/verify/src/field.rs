//! The field of the integers modulo 2^61 − 1, in which models and compiled programs are evaluated.
//!
//! Sums, products and quotients are exact. Sine and cosine of an angle are a point of the unit circle, consistent for
//! small integer multiples of states and arctangents. A square root is the root that is itself a square, and e^-x is
//! 1/e^x. Any other function value is a symbol: a pseudo-random element that depends only on the function and its
//! arguments. Two programs with equal results at random points are, with high probability, the same function of states,
//! parameters and symbols.

use crate::random::Random;
use codegen::functions::{MathFunction, Parity};
use model_spec::model::Model;
use num_traits::{One, Zero};
use oracle::Point;
use oracle::scalar::{Field, PRIME, Prime};
use std::f64::consts::PI;

/// An angle and its (sine, cosine), as elements of the prime field.
pub type Angle = (Prime, (Prime, Prime));

/// Maximum n for which sine and cosine of n·α follow from those of a known angle α.
const MULTIPLES: usize = 4;

/// Values of a model's variables in the prime field.
pub struct FieldPoint {
    /// Values of all variables.
    pub point: Point<Prime>,
    /// (sine, cosine) of every state.
    pub circles: Vec<(Prime, Prime)>,
}

impl FieldPoint {
    /// Draws random values; attitude quaternions have norm 1.
    pub fn random(model: &Model, random: &mut Random) -> Self {
        let mut point = Point::defaults(model).map(|_| random.prime());
        for states in model.quaternions() {
            for (i, part) in states.into_iter().zip(unit_quaternion(random)) {
                point.states[i] = part;
            }
        }
        let circles = point.states.iter().map(|_| on_circle(random.prime()));
        Self {
            circles: circles.collect(),
            point,
        }
    }
}

/// Draws a unit quaternion, by a rational parametrization of the sphere.
fn unit_quaternion(random: &mut Random) -> [Prime; 4] {
    let v = [random.prime(), random.prime(), random.prime()];
    let square = v.iter().fold(Prime::zero(), |sum, &t| sum + t * t);
    let scale = (Prime::one() + square).inverse();
    let [x, y, z] = v.map(|t| Prime::integer(2) * t * scale);
    [(Prime::one() - square) * scale, x, y, z]
}

/// (sine, cosine) = (2t, 1 − t²)/(1 + t²), a point of the unit circle.
fn on_circle(t: Prime) -> (Prime, Prime) {
    let scale = (Prime::one() + t * t).inverse();
    (
        Prime::integer(2) * t * scale,
        (Prime::one() - t * t) * scale,
    )
}

/// Symbol of a function such as exp at `a`, of the parity of the function.
pub fn call(function: MathFunction, a: Prime) -> Prime {
    let of_function = MathFunction::ALL.iter().position(|&f| f == function);
    let tag = of_function.map_or(u64::MAX, |k| k as u64);
    if function == MathFunction::Exp {
        let (size, sign) = least(a);
        let value = symbol(tag, &[size]);
        return if sign == Prime::one() {
            value
        } else {
            value.inverse()
        };
    }
    match function.parity() {
        Parity::Odd => odd(tag, a),
        Parity::Even => symbol(tag, &[least(a).0]),
        Parity::None => symbol(tag, &[a]),
    }
}

/// Symbol of an interpolated table, or of its derivative of the given order, at `a`.
pub fn table(fingerprint: u64, order: u8, a: Prime) -> Prime {
    symbol(0x100 + u64::from(order), &[Prime::new(fingerprint), a])
}

/// Symbol of a table of two arguments, or of its partial derivative of the given orders, at `arguments`.
pub fn surface(fingerprint: u64, orders: [u8; 2], [a, b]: [Prime; 2]) -> Prime {
    let [first, second] = orders.map(u64::from);
    let tag = 0x200 + 0x10 * first + second;
    symbol(tag, &[Prime::new(fingerprint), a, b])
}

/// Element for a literal: the rational number that rounds to it, a rational multiple of π, or a symbol of its bits.
pub fn literal(c: f64) -> Prime {
    let number = |c: f64| symbol(3, &[Prime::new(c.to_bits())]);
    constant(c)
        .or_else(|| Some(multiple_of_pi(c)? * number(PI)))
        .unwrap_or_else(|| number(c))
}

/// Whether [`literal`] is a rational number or a rational multiple of π.
pub fn is_exact(c: f64) -> bool {
    constant(c).or_else(|| multiple_of_pi(c)).is_some()
}

/// The rational number n/d, d at most 360, whose product with π is `c` up to rounding.
fn multiple_of_pi(c: f64) -> Option<Prime> {
    (1..=360).find_map(|d| {
        let n = (c / PI * f64::from(d)).round();
        let product = n * PI / f64::from(d);
        let is_close =
            n != 0.0 && n.abs() < 1e6 && (product - c).abs() <= 2.0 * f64::EPSILON * c.abs();
        is_close.then(|| Prime::integer(n as i64) / Prime::integer(d.into()))
    })
}

/// The rational number n/d that rounds to `c`, where d is at most 1000 or a power of ten up to 1e15; a decimal of many
/// places is none that is a multiple of π: 270 degrees are 4.71238898038469.
pub fn constant(c: f64) -> Option<Prime> {
    let fraction = |d: i64| {
        let n = (c * d as f64).round();
        (n.abs() < 1e15 && n / d as f64 == c).then(|| Prime::integer(n as i64) / Prime::integer(d))
    };
    let decimal = || (4..=15).find_map(|k| fraction(10_i64.pow(k)));
    let decimal = || decimal().filter(|_| multiple_of_pi(c).is_none());
    (1..=1000).find_map(fraction).or_else(decimal)
}

/// Common denominator of the numbers that [`small_number`] knows: decimals of up to three places, eighths and ninths.
const DENOMINATOR: i64 = 9000;

/// Upper limit of their numerators: a random element is taken for one of them with probability 2^-38.
const MAX_NUMERATOR: u64 = 1 << 22;

/// The number of small numerator and denominator that `a` stands for; `None` for any other element.
pub fn small_number(a: Prime) -> Option<f64> {
    let numerator = a * Prime::integer(DENOMINATOR);
    let (size, sign) = least(numerator);
    let is_negative = sign != Prime::one();
    let size = (size.value() <= MAX_NUMERATOR).then(|| size.value() as f64)?;
    let value = size / DENOMINATOR as f64;
    Some(if is_negative { -value } else { value })
}

/// The square root of `a` that is itself a square; `None` if `a` has no root.
pub fn root(a: Prime) -> Option<Prime> {
    let root = power(a, PRIME.div_ceil(4));
    (root * root == a).then_some(root)
}

fn power(a: Prime, mut exponent: u64) -> Prime {
    let (mut square, mut product) = (a, Prime::one());
    while exponent > 0 {
        if exponent & 1 == 1 {
            product *= square;
        }
        square *= square;
        exponent >>= 1;
    }
    product
}

/// The angle atan2(y, x) with its (sine, cosine): a symbol that is odd in y and the same for y and x times a square.
/// `None` if x² + y² has no square root.
pub fn angle(y: Prime, x: Prime) -> Option<Angle> {
    let length = root(x * x + y * y)?.inverse();
    let (sine, cosine) = (y * length, x * length);
    if sine.is_zero() && cosine == Prime::one() {
        return Some((Prime::zero(), (sine, cosine)));
    }
    let (size, sign) = least(sine);
    Some((symbol(4, &[size, cosine]) * sign, (sine, cosine)))
}

/// (sine, cosine) of `a` if it is ± a small multiple of one of `angles`.
pub fn known(a: Prime, angles: &[Angle]) -> Option<(Prime, Prime)> {
    angles.iter().find_map(|&(angle, (s, c))| {
        let (mut multiple, mut circle) = (angle, (s, c));
        for _ in 0..MULTIPLES {
            if a == multiple {
                return Some(circle);
            }
            if a == -multiple {
                return Some((-circle.0, circle.1));
            }
            multiple += angle;
            circle = (circle.0 * c + circle.1 * s, circle.1 * c - circle.0 * s);
        }
        None
    })
}

fn odd(function: u64, a: Prime) -> Prime {
    if a.is_zero() {
        return a;
    }
    let (a, sign) = least(a);
    symbol(function, &[a]) * sign
}

/// Symbol for (sine, cosine) of an angle unrelated to known ones; the sine is odd.
pub fn circle(a: Prime) -> (Prime, Prime) {
    if a.is_zero() {
        return (a, Prime::one());
    }
    let (a, sign) = least(a);
    let (sine, cosine) = on_circle(symbol(5, &[a]));
    (sine * sign, cosine)
}

/// The element of {a, −a} with the smaller representative, and the sign with which it is `a`.
fn least(a: Prime) -> (Prime, Prime) {
    if (-a).value() < a.value() {
        (-a, -Prime::one())
    } else {
        (a, Prime::one())
    }
}

/// Symbol of a function: a hash of its number and its arguments.
pub fn symbol(function: u64, arguments: &[Prime]) -> Prime {
    let mut hash = 0x9e37_79b9_7f4a_7c15_u64 ^ function;
    for argument in arguments {
        hash = (hash ^ argument.value()).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        hash = (hash ^ (hash >> 29)).wrapping_mul(0x94d0_49bb_1331_11eb);
        hash ^= hash >> 32;
    }
    Prime::new(hash)
}
