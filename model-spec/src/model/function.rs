//! The functions of one scalar, with their names in the model language.

/// A function of one scalar, defined with its derivative for every argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Arcsine, the argument clamped to -1 .. 1; derivative 0 where the argument is at most -1 or at least 1.
    Asin,
    /// Arccosine, the argument clamped to -1 .. 1; derivative 0 where the argument is at most -1 or at least 1.
    Acos,
    /// Arctangent.
    Atan,
    /// Square root; 0 with derivative 0 where the argument is 0 or less.
    Sqrt,
    /// Exponential.
    Exp,
    /// Natural logarithm; 0 with derivative 0 where the argument is 0 or less.
    Log,
    /// Absolute value; derivative 0 at 0.
    Abs,
    /// Signum: -1, 0 or 1; derivative 0.
    Sign,
    /// Heaviside function: 1 for arguments above 0, else 0; derivative 0.
    Step,
    /// Hyperbolic tangent.
    Tanh,
    /// A table, by index into [`Model::tables`](super::Model::tables).
    Table(usize),
}

impl Function {
    /// The built-in functions with their names in the model language.
    pub const NAMES: [(&'static str, Function); 13] = [
        ("sin", Function::Sin),
        ("cos", Function::Cos),
        ("tan", Function::Tan),
        ("asin", Function::Asin),
        ("acos", Function::Acos),
        ("atan", Function::Atan),
        ("sqrt", Function::Sqrt),
        ("exp", Function::Exp),
        ("log", Function::Log),
        ("abs", Function::Abs),
        ("sign", Function::Sign),
        ("step", Function::Step),
        ("tanh", Function::Tanh),
    ];

    /// The built-in function of the name `name`; `None` if there is none.
    pub fn named(name: &str) -> Option<Function> {
        Self::NAMES
            .into_iter()
            .find(|known| known.0 == name)
            .map(|known| known.1)
    }
}
