//! The one schedule that every backend follows: statements of one operation each, in order.

use crate::functions::MathFunction;

/// Where an operand comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// Time since release.
    Time,
    /// A state.
    State(u32),
    /// A parameter, by its place in the layout.
    Parameter(u32),
    /// What was computed from the parameters before the flight.
    Prepared(u32),
    /// A coordinate of the marker.
    Marker(u32),
    /// A constant.
    Constant(f64),
    /// The result of an earlier statement.
    Temp(u32),
}

/// Operations on one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unary {
    /// `-x`
    Neg,
    /// `1 / x` of a value that is never 0.
    Recip,
    /// `1 / x`, and 0 at 0.
    RecipOrZero,
    /// A function of `x`.
    Call(MathFunction),
}

/// Operations on two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    /// Of (y, x).
    Atan2,
    Min,
    Max,
}

/// A product and a sum as one operation, which machines that fuse round once. Of (a, b, c).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Fused {
    /// `a * b + c`
    MulAdd,
    /// `a * b - c`
    MulSub,
    /// `c - a * b`: negated multiply-add
    NegMulAdd,
}

/// One operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    /// On one operand.
    Unary(Unary, Operand),
    /// On two.
    Binary(Binary, Operand, Operand),
    /// On three.
    Fused(Fused, Operand, Operand, Operand),
    /// The second where the first is 0, else the third.
    IfZero(Operand, Operand, Operand),
}

impl Op {
    /// Its operands.
    pub fn operands(&self) -> Vec<Operand> {
        match *self {
            Op::Unary(_, a) => vec![a],
            Op::Binary(_, a, b) => vec![a, b],
            Op::IfZero(a, b, c) | Op::Fused(_, a, b, c) => vec![a, b, c],
        }
    }

    /// Calls `change` with each of its operands.
    pub fn for_operands(&mut self, mut change: impl FnMut(&mut Operand)) {
        match self {
            Op::Unary(_, a) => change(a),
            Op::Binary(_, a, b) => {
                change(a);
                change(b);
            }
            Op::IfZero(a, b, c) | Op::Fused(_, a, b, c) => {
                change(a);
                change(b);
                change(c);
            }
        }
    }
}

/// One step of a program; its result is `Temp(k)` for the k-th statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What is computed.
    pub op: Op,
    /// Its name; none where it is only a part of the expression of a later statement.
    pub name: Option<String>,
    /// The named quantity of the model it is, or is derived from, for the comment beside it.
    pub about: Option<About>,
}

/// What a statement belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct About {
    /// Index into [`crate::lower::Lowered::origins`].
    pub origin: usize,
    /// Whether it is the quantity itself, not a part of it.
    pub exact: bool,
}

/// A straight-line program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// The statements.
    pub statements: Vec<Statement>,
    /// The results, in the order of the function's sections.
    pub outputs: Vec<Operand>,
}

/// What a run of outputs holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// `dx`, `j`, `jp`, `y`, …
    pub name: &'static str,
    /// How many values.
    pub len: usize,
    /// For a sparse matrix: row and column of each value, row by row.
    pub pattern: Option<Vec<(u32, u32)>>,
}

/// A program with the meaning of its outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// `f`, `f_jac`, …
    pub name: &'static str,
    /// What it computes.
    pub program: Program,
    /// The outputs, section by section.
    pub sections: Vec<Section>,
    /// What each output is called: `u_dot`, `d_u_dot_d_w`, …
    pub results: Vec<String>,
}

impl Function {
    /// A section by its name.
    pub fn section(&self, name: &str) -> Option<&Section> {
        self.sections.iter().find(|section| section.name == name)
    }

    /// The pattern of a sparse section; empty where there is none.
    pub fn pattern(&self, name: &str) -> &[(u32, u32)] {
        self.section(name)
            .and_then(|section| section.pattern.as_deref())
            .unwrap_or(&[])
    }

    /// Where a section starts among the outputs, and its length.
    pub fn range(&self, name: &str) -> std::ops::Range<usize> {
        let mut start = 0;
        for section in &self.sections {
            if section.name == name {
                return start..start + section.len;
            }
            start += section.len;
        }
        start..start
    }
}
