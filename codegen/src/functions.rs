//! Functions of one argument: name, symmetry, range, derivative, evaluation, notation and cost, in one place.
//!
//! A function is added here and as a method of [`lanes::Real`]; no other file of the compiler lists them.

use crate::number::Number;
use lanes::Real;
use model_spec::model::Function as Named;

/// Functions of one argument that are computed as one operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MathFunction {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Arcsine of the argument clamped to -1 .. 1.
    Asin,
    /// Exponential.
    Exp,
    /// Natural logarithm; 0 for arguments up to 0.
    Log,
    /// Hyperbolic tangent.
    Tanh,
    /// Absolute value.
    Abs,
    /// -1, 0 or 1.
    Sign,
    /// Heaviside function: 1 for arguments above 0, else 0.
    Heaviside,
    /// Square root; 0 for arguments up to 0.
    Sqrt,
    /// 0 at 0, else 1: the value of `x * recip_or_zero(x)`.
    NonZero,
}

/// Symmetry of a function about 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// f(-x) = f(x)
    Even,
    /// f(-x) = -f(x)
    Odd,
    /// Neither even nor odd.
    None,
}

/// Derivative of a function at x, in terms of x and of the function's value there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derivative {
    /// 0 everywhere, by definition also at jumps.
    Zero,
    /// The value itself.
    Value,
    /// Another function of x.
    Call(MathFunction),
    /// Minus another function of x.
    Opposite(MathFunction),
    /// 1 - value²
    OneMinusValueSquared,
    /// 1 / sqrt(1 - x²), and 0 outside -1 .. 1.
    InverseRootOfOneMinusSquare,
    /// 1 / x above 0, else 0.
    ReciprocalAboveZero,
    /// 1 / (2 value)
    HalfOverValue,
}

/// What an operation is counted as in a [`Count`](crate::count::Count).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CostKind {
    /// Square root.
    Root,
    /// Transcendental function.
    Call,
    /// Comparison, mask or absolute value.
    Select,
}

/// How a function is written in LaTeX.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// A command of LaTeX before the argument; true where an exponent goes between them, as in sin² x.
    Command(&'static str, bool),
    /// A name set upright, with the argument in parentheses.
    Operator(&'static str),
    /// √x
    Radical,
    /// e to the power of the argument.
    PowerOfE,
    /// |x|
    Bars,
    /// Iverson bracket around the argument and this relation.
    Bracket(&'static str),
}

impl MathFunction {
    /// Every function.
    pub const ALL: [MathFunction; 11] = [
        MathFunction::Sin,
        MathFunction::Cos,
        MathFunction::Asin,
        MathFunction::Exp,
        MathFunction::Log,
        MathFunction::Tanh,
        MathFunction::Abs,
        MathFunction::Sign,
        MathFunction::Heaviside,
        MathFunction::Sqrt,
        MathFunction::NonZero,
    ];

    /// The name in the model language and in names of generated variables.
    pub fn name(self) -> &'static str {
        match self {
            MathFunction::Sin => "sin",
            MathFunction::Cos => "cos",
            MathFunction::Asin => "asin",
            MathFunction::Exp => "exp",
            MathFunction::Log => "log",
            MathFunction::Tanh => "tanh",
            MathFunction::Abs => "abs",
            MathFunction::Sign => "sign",
            MathFunction::Heaviside => "step",
            MathFunction::Sqrt => "sqrt",
            MathFunction::NonZero => "nonzero",
        }
    }

    /// Its value at `x`.
    #[inline(always)]
    pub fn eval<T: Real>(self, x: T) -> T {
        match self {
            MathFunction::Sin => x.sin_cos().0,
            MathFunction::Cos => x.sin_cos().1,
            MathFunction::Asin => x.asin(),
            MathFunction::Exp => x.exp(),
            MathFunction::Log => x.log(),
            MathFunction::Tanh => x.tanh(),
            MathFunction::Abs => x.abs(),
            MathFunction::Sign => x.sign(),
            MathFunction::Heaviside => x.heaviside(),
            MathFunction::Sqrt => x.sqrt(),
            MathFunction::NonZero => x.if_zero(T::splat(0.0), T::splat(1.0)),
        }
    }

    /// The call of a method of [`lanes::Real`] that computes it, without the receiver: `exp()`.
    pub fn rust_method(self) -> &'static str {
        match self {
            MathFunction::Sin => "sin_cos().0",
            MathFunction::Cos => "sin_cos().1",
            MathFunction::Asin => "asin()",
            MathFunction::Exp => "exp()",
            MathFunction::Log => "log()",
            MathFunction::Tanh => "tanh()",
            MathFunction::Abs => "abs()",
            MathFunction::Sign => "sign()",
            MathFunction::Heaviside => "heaviside()",
            MathFunction::Sqrt => "sqrt()",
            MathFunction::NonZero => "if_zero(T::splat(0.0), T::splat(1.0))",
        }
    }

    /// Its derivative.
    pub fn derivative(self) -> Derivative {
        match self {
            MathFunction::Sin => Derivative::Call(MathFunction::Cos),
            MathFunction::Cos => Derivative::Opposite(MathFunction::Sin),
            MathFunction::Asin => Derivative::InverseRootOfOneMinusSquare,
            MathFunction::Exp => Derivative::Value,
            MathFunction::Log => Derivative::ReciprocalAboveZero,
            MathFunction::Tanh => Derivative::OneMinusValueSquared,
            MathFunction::Abs => Derivative::Call(MathFunction::Sign),
            MathFunction::Sign | MathFunction::Heaviside | MathFunction::NonZero => {
                Derivative::Zero
            }
            MathFunction::Sqrt => Derivative::HalfOverValue,
        }
    }

    /// Symmetry about 0.
    pub fn parity(self) -> Parity {
        match self {
            MathFunction::Cos | MathFunction::Abs | MathFunction::NonZero => Parity::Even,
            MathFunction::Sin | MathFunction::Asin | MathFunction::Tanh | MathFunction::Sign => {
                Parity::Odd
            }
            MathFunction::Exp
            | MathFunction::Log
            | MathFunction::Heaviside
            | MathFunction::Sqrt => Parity::None,
        }
    }

    /// Whether f(c x) = f(x) for every c above 0.
    pub fn ignores_scale(self) -> bool {
        matches!(
            self,
            MathFunction::Heaviside | MathFunction::Sign | MathFunction::NonZero
        )
    }

    /// Whether no value is below 0.
    pub fn is_nonneg(self) -> bool {
        matches!(
            self,
            MathFunction::Exp
                | MathFunction::Abs
                | MathFunction::Heaviside
                | MathFunction::Sqrt
                | MathFunction::NonZero
        )
    }

    /// Whether the value is not 0, given whether the argument is known not to be 0.
    pub fn is_nonzero(self, argument_nonzero: bool) -> bool {
        match self {
            MathFunction::Exp => true,
            MathFunction::Abs | MathFunction::Sign | MathFunction::NonZero => argument_nonzero,
            _ => false,
        }
    }

    /// The value at a constant, where it is a rational number or a root of one.
    pub fn constant_value(self, x: Number) -> Option<Number> {
        let (zero, negative) = (x.is_zero(), x.is_negative());
        let indicator = |holds: bool| Some(if holds { Number::ONE } else { Number::ZERO });
        match self {
            MathFunction::Sin | MathFunction::Asin | MathFunction::Tanh | MathFunction::Sqrt => {
                zero.then_some(Number::ZERO)
            }
            MathFunction::Cos | MathFunction::Exp => zero.then_some(Number::ONE),
            MathFunction::Log => (x.is_one() || zero || negative).then_some(Number::ZERO),
            MathFunction::Abs => Some(x.abs()),
            MathFunction::Sign if negative => Some(Number::MINUS_ONE),
            MathFunction::Sign | MathFunction::NonZero => indicator(!zero),
            MathFunction::Heaviside => indicator(!zero && !negative),
        }
    }

    /// What it is counted as.
    pub fn cost_kind(self) -> CostKind {
        match self {
            MathFunction::Sqrt => CostKind::Root,
            MathFunction::Abs
            | MathFunction::Sign
            | MathFunction::Heaviside
            | MathFunction::NonZero => CostKind::Select,
            _ => CostKind::Call,
        }
    }

    /// Latency in clock cycles, approximate, of current processors.
    pub fn latency(self) -> u32 {
        match self {
            MathFunction::Abs => 1,
            MathFunction::Sign | MathFunction::Heaviside | MathFunction::NonZero => 4,
            MathFunction::Sqrt => 18,
            _ => 30,
        }
    }

    /// How it is written in LaTeX.
    pub fn notation(self) -> Notation {
        match self {
            MathFunction::Sin => Notation::Command(r"\sin", true),
            MathFunction::Cos => Notation::Command(r"\cos", true),
            MathFunction::Asin => Notation::Command(r"\arcsin", false),
            MathFunction::Exp => Notation::PowerOfE,
            MathFunction::Log => Notation::Command(r"\ln", true),
            MathFunction::Tanh => Notation::Command(r"\tanh", true),
            MathFunction::Abs => Notation::Bars,
            MathFunction::Sign => Notation::Operator("sgn"),
            MathFunction::Heaviside => Notation::Bracket("> 0"),
            MathFunction::Sqrt => Notation::Radical,
            MathFunction::NonZero => Notation::Bracket(r"\neq 0"),
        }
    }
}

/// What the compiler makes of a function of the model language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FunctionLowering {
    /// One operation.
    Call(MathFunction),
    /// The quotient of sine and cosine.
    Tan,
    /// π/2 less the arcsine.
    Acos,
    /// The angle of the point (1, x).
    Atan,
}

impl FunctionLowering {
    /// Of a function of the model language.
    pub fn of(function: Named) -> FunctionLowering {
        FunctionLowering::Call(match function {
            Named::Tan => return FunctionLowering::Tan,
            Named::Acos => return FunctionLowering::Acos,
            Named::Atan => return FunctionLowering::Atan,
            Named::Sin => MathFunction::Sin,
            Named::Cos => MathFunction::Cos,
            Named::Asin => MathFunction::Asin,
            Named::Sqrt => MathFunction::Sqrt,
            Named::Exp => MathFunction::Exp,
            Named::Log => MathFunction::Log,
            Named::Abs => MathFunction::Abs,
            Named::Sign => MathFunction::Sign,
            Named::Step => MathFunction::Heaviside,
            Named::Tanh => MathFunction::Tanh,
        })
    }

    /// How it is written in LaTeX.
    pub fn notation(self) -> Notation {
        match self {
            FunctionLowering::Call(function) => function.notation(),
            FunctionLowering::Tan => Notation::Command(r"\tan", true),
            FunctionLowering::Acos => Notation::Command(r"\arccos", false),
            FunctionLowering::Atan => Notation::Command(r"\arctan", false),
        }
    }
}

/// Commands of LaTeX that take an exponent between name and argument.
pub fn commands_with_exponent() -> impl Iterator<Item = &'static str> {
    let all = MathFunction::ALL.map(FunctionLowering::Call).into_iter();
    let all = all.chain([
        FunctionLowering::Tan,
        FunctionLowering::Acos,
        FunctionLowering::Atan,
    ]);
    all.filter_map(|function| match function.notation() {
        Notation::Command(command, true) => Some(command),
        _ => None,
    })
}
