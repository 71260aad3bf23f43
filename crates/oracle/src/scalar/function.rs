//! The functions of the model language: value, derivative, and behaviour at singular points.
//!
//! A new function is added to this file; scalar types with their own implementations ([`NumDual`] and [`ComplexStep`])
//! may add one.
//!
//! [`NumDual`]: super::NumDual
//! [`ComplexStep`]: super::ComplexStep

use super::Real;
use model_spec::model::Function;
use num_dual::DualNum;
use std::f64::consts::FRAC_PI_2;

/// A function of one argument of each scalar type, of which the other functions are composed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Elementary {
    /// Square root; 0 with derivative 0 for arguments ≤ 0.
    Sqrt,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Arcsine of the argument clamped to [-1, 1]; derivative 0 for |argument| ≥ 1.
    Asin,
    /// Arctangent.
    Atan,
    /// Exponential function.
    Exp,
    /// Natural logarithm; 0 with derivative 0 for arguments ≤ 0.
    Log,
    /// Hyperbolic tangent.
    Tanh,
}

impl Elementary {
    /// All elementary functions.
    pub const ALL: [Elementary; 8] = [
        Self::Sqrt,
        Self::Sin,
        Self::Cos,
        Self::Asin,
        Self::Atan,
        Self::Exp,
        Self::Log,
        Self::Tanh,
    ];

    /// Name of this elementary function in the model language.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sqrt => "sqrt",
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Asin => "asin",
            Self::Atan => "atan",
            Self::Exp => "exp",
            Self::Log => "log",
            Self::Tanh => "tanh",
        }
    }

    /// The elementary function with this name in the model language. `None` for all other names, including those of
    /// functions that are composed of elementary ones, such as `tan`.
    pub fn named(name: &str) -> Option<Elementary> {
        Self::ALL
            .into_iter()
            .find(|function| function.name() == name)
    }

    /// Value of this elementary function at `x`.
    pub fn value(self, x: f64) -> f64 {
        match self {
            Self::Sqrt | Self::Log if x > 0.0 => self.inside_domain(x),
            Self::Sqrt | Self::Log => 0.0,
            Self::Asin => self.inside_domain(x.clamp(-1.0, 1.0)),
            _ => self.inside_domain(x),
        }
    }

    /// Value of the function at `x`, an argument inside the domain of the function, as computed by the crate
    /// `num-dual`; for `f64` this is the value of the standard library.
    pub(crate) fn inside_domain<D: DualNum>(self, x: D) -> D {
        match self {
            Self::Sqrt => x.sqrt(),
            Self::Sin => x.sin(),
            Self::Cos => x.cos(),
            Self::Asin => x.asin(),
            Self::Atan => x.atan(),
            Self::Exp => x.exp(),
            Self::Log => x.ln(),
            Self::Tanh => x.tanh(),
        }
    }

    /// Derivative at `x`, where the function must not be [constant](Self::is_constant_at) and has the value `y`.
    pub fn derivative<T: Real>(self, x: T, y: T) -> T {
        let one = T::one();
        match self {
            Self::Sqrt => one / (y + y),
            Self::Sin => x.cos(),
            Self::Cos => -x.sin(),
            Self::Asin => one / ((one - x) * (one + x)).sqrt(),
            Self::Atan => one / (one + x * x),
            Self::Exp => y,
            Self::Log => one / x,
            Self::Tanh => (one - y) * (one + y),
        }
    }

    /// Whether the language defines the derivative at `x` as 0: outside the domain and at its ends.
    pub fn is_constant_at(self, x: f64) -> bool {
        match self {
            Self::Sqrt | Self::Log => x <= 0.0,
            Self::Asin => x.abs() >= 1.0,
            Self::Sin | Self::Cos | Self::Atan | Self::Exp | Self::Tanh => false,
        }
    }
}

/// Value of a function of the model language at `x`.
pub(crate) fn call<T: Real>(function: Function, x: T) -> T {
    let elementary = |function| x.elementary(function);
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.sin() / x.cos(),
        Function::Asin => elementary(Elementary::Asin),
        Function::Acos => T::lit(FRAC_PI_2) - elementary(Elementary::Asin),
        Function::Atan => elementary(Elementary::Atan),
        Function::Sqrt => x.sqrt(),
        Function::Exp => x.exp(),
        Function::Log => x.ln(),
        Function::Abs => x.abs(),
        Function::Sign => T::lit(if x.re() == 0.0 { 0.0 } else { x.re().signum() }),
        Function::Step => T::lit(if x.re() > 0.0 { 1.0 } else { 0.0 }),
        Function::Tanh => elementary(Elementary::Tanh),
        Function::Table(_) => unreachable!("a table is looked up by the tree"),
    }
}
