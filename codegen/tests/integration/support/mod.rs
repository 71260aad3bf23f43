//! Shared by the tests: dual numbers as lanes, random states, models, expressions as text.

pub mod print;

use lanes::{ElementaryFunction, Real};
use model_spec::model::Model;
use num_dual::{Dual64, DualNum};
use oracle::scalar::{Elementary, NumDual, Real as _};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Names of the built-in models.
pub fn models() -> Vec<&'static str> {
    model_spec::load::MODELS
        .iter()
        .map(|(name, _)| *name)
        .collect()
}

/// Loads a built-in model without effects.
pub fn model(name: &str) -> Model {
    model_spec::load::load(name, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// Test model that contains every function of the model language.
pub fn zoo() -> Model {
    let text = include_str!("../zoo/zoo.hyz");
    model_spec::load::from_text("zoo", text, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// The built-in models and the test model [`zoo`].
pub fn with_zoo() -> Vec<Model> {
    let mut all: Vec<Model> = models().into_iter().map(model).collect();
    all.push(zoo());
    all
}

/// Dual number of the crate `num-dual`, as a number type with which bytecode can be evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Dual(pub Dual64);

impl Dual {
    pub fn new(value: f64, derivative: f64) -> Dual {
        Dual(Dual64::new(value, derivative))
    }
    fn guarded(self, singular: bool, value: impl Fn(Dual64) -> Dual64) -> Dual {
        if singular {
            Dual::new(0.0, 0.0)
        } else {
            Dual(value(self.0))
        }
    }
}

macro_rules! forward {
    ($($trait:ident $method:ident),*) => {
        $(impl $trait for Dual {
            type Output = Dual;
            fn $method(self, other: Dual) -> Dual { Dual($trait::$method(self.0, other.0)) }
        })*
    };
}
forward!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        Dual(-self.0)
    }
}

impl Real for Dual {
    fn splat(value: f64) -> Dual {
        Dual::new(value, 0.0)
    }
    fn sqrt(self) -> Dual {
        self.guarded(self.0.re <= 0.0, |x| x.sqrt())
    }
    fn recip_or_zero(self) -> Dual {
        self.guarded(self.0.re.abs() < 1e-75, |x| x.recip())
    }
    fn sin_cos(self) -> (Dual, Dual) {
        let (sin, cos) = self.0.sin_cos();
        (Dual(sin), Dual(cos))
    }
    fn atan2(self, x: Dual) -> Dual {
        // num-dual divides by x, which may be 0 where the angle is quite regular
        let (y, x) = (self.0, x.0);
        let square = x.re * x.re + y.re * y.re;
        if square == 0.0 {
            return Dual::new(0.0, 0.0);
        }
        Dual::new(y.re.atan2(x.re), (x.re * y.eps - y.re * x.eps) / square)
    }
    fn elementary(self, function: ElementaryFunction) -> Dual {
        let function = Elementary::named(function.name()).expect("a function of the oracle");
        Dual(NumDual(self.0).elementary(function).0)
    }
    fn abs(self) -> Dual {
        Dual::new(self.0.re.abs(), self.0.eps * self.sign().0.re)
    }
    fn min(self, other: Dual) -> Dual {
        if self.0.re < other.0.re { self } else { other }
    }
    fn max(self, other: Dual) -> Dual {
        if self.0.re > other.0.re { self } else { other }
    }
    fn sign(self) -> Dual {
        let x = self.0.re;
        Dual::new(if x == 0.0 { 0.0 } else { x.signum() }, 0.0)
    }
    fn heaviside(self) -> Dual {
        Dual::new(f64::from(u8::from(self.0.re > 0.0)), 0.0)
    }
    fn piecewise_cubic(self, knots: &[f64], cubics: &[[f64; 4]]) -> Dual {
        let below = knots.iter().filter(|&&knot| knot <= self.0.re).count();
        let h = self.0 - knots[below.saturating_sub(1)];
        let [a, b, c, d] = cubics[below];
        Dual(h * h * h * d + h * h * c + h * b + a)
    }
    fn piecewise_bicubic(
        self,
        y: Dual,
        orders: [usize; 2],
        knots: [&[f64]; 2],
        cells: &[[f64; 16]],
    ) -> Dual {
        let below = |knots: &[f64], x: f64| knots.iter().filter(|&&knot| knot <= x).count();
        let (i, j) = (below(knots[0], self.0.re), below(knots[1], y.0.re));
        let h = self.0 - knots[0][i.saturating_sub(1)];
        let k = y.0 - knots[1][j.saturating_sub(1)];
        let cell = &cells[i * (knots[1].len() + 1) + j];
        let power = |x: Dual64, n: usize, order: usize| {
            let factor = (n + 1 - order..=n).product::<usize>() as f64;
            (0..n - order).fold(Dual64::from_re(factor), |product, _| product * x)
        };
        let mut sum = Dual64::from_re(0.0);
        for a in orders[0]..4 {
            for b in orders[1]..4 {
                sum += power(h, a, orders[0]) * power(k, b, orders[1]) * cell[4 * a + b];
            }
        }
        Dual(sum)
    }
    fn if_zero(self, then: Dual, otherwise: Dual) -> Dual {
        if self.0.re.abs() < 1e-75 {
            then
        } else {
            otherwise
        }
    }
}

/// Pseudorandom number generator (xorshift) with a fixed sequence; the field is its state.
pub struct Random(pub u64);

impl Random {
    /// Pseudorandom number, uniformly distributed between -1 and 1.
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Random states and parameters around their defaults, with magnitudes that occur in flights.
pub fn point(compiled: &codegen::Compiled, random: &mut Random) -> (Vec<f64>, Vec<f64>) {
    let layout = &compiled.layout;
    let x = layout
        .states
        .iter()
        .zip(layout.default_states())
        .map(|(name, start)| {
            let size = match name.as_str() {
                "u" | "v" | "w" | "vx" | "vy" | "vz" => 12.0,
                "phi" | "theta" | "gamma" => 0.9,
                name if name.starts_with('q') => 0.0,
                "a" | "b" | "e" => 0.9,
                _ => 5.0,
            };
            start + size * random.next()
        })
        .collect();
    let p = layout
        .default_parameters()
        .iter()
        .map(|&value| {
            if value == 0.0 {
                2.0 * random.next()
            } else {
                value * (1.0 + 0.3 * random.next())
            }
        })
        .collect();
    (x, p)
}
