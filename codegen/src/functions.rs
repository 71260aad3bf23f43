//! Functions of one argument: their name, symmetry, range, derivative, evaluation, notation and cost, all in this file.
//!
//! A new function is added here and as a method of [`lanes::Real`]; no other file of the compiler lists the functions
//! (a new form of derivative is also in `differentiate/partials.rs`). The tables of a model are functions too; their knots and values are in [`Tables`].

use crate::number::Number;
use crate::table::{TableFunction, TableId, Tables};
use lanes::{ElementaryFunction, Real};
use model_spec::model::Function as Named;

/// Elementary function of one argument that the generated code computes as one operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MathFunction {
    /// Sine of the argument, rad.
    Sin,
    /// Cosine of the argument, rad.
    Cos,
    /// Arcsine, rad, of the argument clamped to -1 .. 1.
    Asin,
    /// Exponential function e^x.
    Exp,
    /// Natural logarithm; 0 where the argument is 0 or less.
    Log,
    /// Hyperbolic tangent.
    Tanh,
    /// Absolute value.
    Abs,
    /// Sign of the argument: -1, 0 or 1.
    Sign,
    /// Heaviside function: 1 for arguments above 0, else 0.
    Heaviside,
    /// Square root; 0 where the argument is 0 or less.
    Sqrt,
    /// Indicator of x ≠ 0: 0 at 0, else 1; equals `x * recip_or_zero(x)`.
    NonZero,
    /// A table of the model, or a derivative of one.
    Table(TableFunction),
}

/// Function of two arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BinaryFunction {
    /// `atan2(y, x)` with operands y and x: angle of the point (x, y), rad; 0 at the origin.
    Atan2,
    /// The smaller of the operands.
    Min,
    /// The greater of the operands.
    Max,
    /// A table of two arguments, or a partial derivative of one.
    Table(TableFunction<2>),
}

impl BinaryFunction {
    /// Name in printed expressions; `table_of_two` for every table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Atan2 => "atan2",
            Self::Min => "min",
            Self::Max => "max",
            Self::Table(_) => "table_of_two",
        }
    }
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

/// Derivative of a function f at x, in terms of x and of the value f(x).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derivative {
    /// f'(x) = 0 everywhere, by definition also at jumps.
    Zero,
    /// f'(x) = f(x).
    Value,
    /// f'(x) = g(x) for the given function g.
    Call(MathFunction),
    /// f'(x) = -g(x) for the given function g.
    Opposite(MathFunction),
    /// f'(x) = 1 - f(x)².
    OneMinusValueSquared,
    /// f'(x) = 1 / sqrt(1 - x²) for |x| < 1, else 0.
    InverseRootOfOneMinusSquare,
    /// f'(x) = 1 / x for x > 0, else 0.
    ReciprocalAboveZero,
    /// f'(x) = 1 / (2 f(x)) where f(x) ≠ 0, else 0.
    HalfOverValue,
}

/// Operation class under which a function is counted in a [`Count`](crate::count::Count).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CostKind {
    /// Square root.
    Root,
    /// Transcendental function or table lookup.
    Call,
    /// Comparison of the argument with 0, or absolute value.
    Select,
}

/// Form in which a function is written in LaTeX.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// LaTeX command followed by the argument; `true` if an exponent goes between command and argument, as in sin² x.
    Command(&'static str, bool),
    /// Function name in upright type, followed by the argument in parentheses.
    Operator(&'static str),
    /// Radical sign √x.
    Radical,
    /// Exponential notation e^x.
    PowerOfE,
    /// Absolute-value bars |x|.
    Bars,
    /// Iverson bracket around the argument and the given relation, as in `[x > 0]`.
    Bracket(&'static str),
}

impl From<ElementaryFunction> for MathFunction {
    fn from(function: ElementaryFunction) -> Self {
        match function {
            ElementaryFunction::Exp => Self::Exp,
            ElementaryFunction::Log => Self::Log,
            ElementaryFunction::Tanh => Self::Tanh,
            ElementaryFunction::Asin => Self::Asin,
        }
    }
}

impl MathFunction {
    /// All elementary functions except table lookups.
    pub const ALL: [MathFunction; 11] = [
        Self::Sin,
        Self::Cos,
        Self::Asin,
        Self::Exp,
        Self::Log,
        Self::Tanh,
        Self::Abs,
        Self::Sign,
        Self::Heaviside,
        Self::Sqrt,
        Self::NonZero,
    ];

    /// Name in printed expressions and of variables; `table` for every table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Asin => "asin",
            Self::Exp => "exp",
            Self::Log => "log",
            Self::Tanh => "tanh",
            Self::Abs => "abs",
            Self::Sign => "sign",
            Self::Heaviside => "step",
            Self::Sqrt => "sqrt",
            Self::NonZero => "nonzero",
            Self::Table(_) => "table",
        }
    }

    /// Function with this [`name`](Self::name); `None` for tables.
    pub fn named(name: &str) -> Option<MathFunction> {
        Self::ALL
            .into_iter()
            .find(|function| function.name() == name)
    }

    /// Evaluates the function at `x`; `tables` are the tables of the model.
    #[inline(always)]
    pub fn eval<T: Real>(self, x: T, tables: &Tables) -> T {
        match self {
            Self::Sin => x.sin_cos().0,
            Self::Cos => x.sin_cos().1,
            Self::Asin => x.asin(),
            Self::Exp => x.exp(),
            Self::Log => x.log(),
            Self::Tanh => x.tanh(),
            Self::Abs => x.abs(),
            Self::Sign => x.sign(),
            Self::Heaviside => x.heaviside(),
            Self::Sqrt => x.sqrt(),
            Self::NonZero => x.if_zero(T::splat(0.0), T::splat(1.0)),
            Self::Table(function) => tables.of(function).eval(x),
        }
    }

    /// Rust method call on a [`lanes::Real`], such as `exp()`; of a table, the method name.
    pub fn rust_method(self) -> &'static str {
        match self {
            Self::Sin => "sin_cos().0",
            Self::Cos => "sin_cos().1",
            Self::Asin => "asin()",
            Self::Exp => "exp()",
            Self::Log => "log()",
            Self::Tanh => "tanh()",
            Self::Abs => "abs()",
            Self::Sign => "sign()",
            Self::Heaviside => "heaviside()",
            Self::Sqrt => "sqrt()",
            Self::NonZero => "if_zero(T::splat(0.0), T::splat(1.0))",
            Self::Table(_) => "piecewise_cubic",
        }
    }

    /// Symbolic derivative of the function.
    pub fn derivative(self) -> Derivative {
        match self {
            Self::Sin => Derivative::Call(Self::Cos),
            Self::Cos => Derivative::Opposite(Self::Sin),
            Self::Asin => Derivative::InverseRootOfOneMinusSquare,
            Self::Exp => Derivative::Value,
            Self::Log => Derivative::ReciprocalAboveZero,
            Self::Tanh => Derivative::OneMinusValueSquared,
            Self::Abs => Derivative::Call(Self::Sign),
            Self::Sign | Self::Heaviside | Self::NonZero => Derivative::Zero,
            Self::Sqrt => Derivative::HalfOverValue,
            Self::Table(function) => function.derivative(0).map_or(Derivative::Zero, |slope| {
                Derivative::Call(Self::Table(slope))
            }),
        }
    }

    /// Symmetry of the function about 0: even, odd or none.
    pub fn parity(self) -> Parity {
        match self {
            Self::Cos | Self::Abs | Self::NonZero => Parity::Even,
            Self::Sin | Self::Asin | Self::Tanh | Self::Sign => Parity::Odd,
            Self::Exp | Self::Log | Self::Heaviside | Self::Sqrt | Self::Table(_) => Parity::None,
        }
    }

    /// Whether f(c x) = f(x) for every scale factor c > 0.
    pub fn ignores_scale(self) -> bool {
        matches!(self, Self::Heaviside | Self::Sign | Self::NonZero)
    }

    /// Whether f(x) ≥ 0 for every x.
    pub fn is_nonneg(self) -> bool {
        matches!(
            self,
            Self::Exp | Self::Abs | Self::Heaviside | Self::Sqrt | Self::NonZero
        )
    }

    /// Whether f(x) is known to be nonzero; `argument_nonzero` states whether x is known to be nonzero.
    pub fn is_nonzero(self, argument_nonzero: bool) -> bool {
        match self {
            Self::Exp => true,
            Self::Abs | Self::Sign | Self::NonZero => argument_nonzero,
            _ => false,
        }
    }

    /// Exact value of the function at the constant `x`; `None` if no simple exact value is known.
    pub fn constant_value(self, x: Number) -> Option<Number> {
        let (zero, negative) = (x.is_zero(), x.is_negative());
        let indicator = |holds: bool| Some(if holds { Number::ONE } else { Number::ZERO });
        match self {
            Self::Sin | Self::Asin | Self::Tanh | Self::Sqrt => zero.then_some(Number::ZERO),
            Self::Cos | Self::Exp => zero.then_some(Number::ONE),
            Self::Log => (x.is_one() || zero || negative).then_some(Number::ZERO),
            Self::Abs => Some(x.abs()),
            Self::Sign if negative => Some(Number::MINUS_ONE),
            Self::Sign | Self::NonZero => indicator(!zero),
            Self::Heaviside => indicator(!zero && !negative),
            Self::Table(_) => None,
        }
    }

    /// Operation class under which the function is counted in a [`Count`](crate::count::Count).
    pub fn cost_kind(self) -> CostKind {
        match self {
            Self::Sqrt => CostKind::Root,
            Self::Abs | Self::Sign | Self::Heaviside | Self::NonZero => CostKind::Select,
            _ => CostKind::Call,
        }
    }

    /// Approximate latency of the function on current processors, in clock cycles.
    pub fn latency(self) -> u32 {
        match self {
            Self::Abs => 1,
            Self::Sign | Self::Heaviside | Self::NonZero => 4,
            Self::Sqrt => 18,
            _ => 30,
        }
    }

    /// LaTeX notation of the function.
    pub fn notation(self) -> Notation {
        match self {
            Self::Sin => Notation::Command(r"\sin", true),
            Self::Cos => Notation::Command(r"\cos", true),
            Self::Asin => Notation::Command(r"\arcsin", false),
            Self::Exp => Notation::PowerOfE,
            Self::Log => Notation::Command(r"\ln", true),
            Self::Tanh => Notation::Command(r"\tanh", true),
            Self::Abs => Notation::Bars,
            Self::Sign => Notation::Operator("sgn"),
            Self::Heaviside => Notation::Bracket("> 0"),
            Self::Sqrt => Notation::Radical,
            Self::NonZero => Notation::Bracket(r"\neq 0"),
            Self::Table(_) => Notation::Operator("table"),
        }
    }
}

/// Lowering of a function of the model language: to one operation, or to a composition of operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FunctionLowering {
    /// Function that is lowered to the one operation `MathFunction`.
    Call(MathFunction),
    /// Tangent, lowered to sin x / cos x.
    Tan,
    /// Arccosine, lowered to π/2 - asin x.
    Acos,
    /// Arctangent, lowered to atan2(x, 1).
    Atan,
}

impl FunctionLowering {
    /// Lowering of the function `function` of the model language: to one operation, or to a composition of operations.
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
            Named::Table(index) => {
                MathFunction::Table(TableFunction::value_of(TableId::new(index)))
            }
        })
    }

    /// LaTeX notation of the function.
    pub fn notation(self) -> Notation {
        match self {
            FunctionLowering::Call(function) => function.notation(),
            FunctionLowering::Tan => Notation::Command(r"\tan", true),
            FunctionLowering::Acos => Notation::Command(r"\arccos", false),
            FunctionLowering::Atan => Notation::Command(r"\arctan", false),
        }
    }
}

/// LaTeX commands of functions whose exponent is written between command and argument, such as `\sin`.
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
