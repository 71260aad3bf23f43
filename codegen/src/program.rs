//! Straight-line programs, which every backend prints or interprets.

use crate::functions::{BinaryFunction, MathFunction};
use crate::table::Tables;

/// Source of an operand: an input, a constant or the result of an earlier statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// Time since release, s.
    Time,
    /// State variable, by its index in the state vector.
    State(u32),
    /// Parameter, by its index in the parameter vector.
    Parameter(u32),
    /// Invariant, by its index among the results of the function `prepare`.
    Prepared(u32),
    /// Body-fixed coordinate, m, of the marker, by its index (0 to 2).
    Marker(u32),
    /// Constant with this value.
    Constant(f64),
    /// Result of an earlier statement, by the index of that statement.
    Temp(u32),
}

impl Operand {
    /// Index of the statement whose result it is; `None` for an input or a constant.
    pub(crate) fn temp(self) -> Option<usize> {
        match self {
            Operand::Temp(t) => Some(t as usize),
            _ => None,
        }
    }
}

/// Operation with one operand `x`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unary {
    /// `-x`
    Neg,
    /// Unguarded reciprocal `1 / x`; used only if `x` is never 0.
    Recip,
    /// Guarded reciprocal: `1 / x`, and 0 at `x = 0`.
    RecipOrZero,
    /// Elementary function of `x`.
    Call(MathFunction),
}

/// Operation with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    /// Function of the operands.
    Call(BinaryFunction),
}

/// Multiply-add of the operands (a, b, c); rounded once if the number type has a fused multiply-add, else twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Fused {
    /// `a * b + c`
    MulAdd,
    /// `a * b - c`
    MulSub,
    /// `c - a * b`: negated multiply-add
    NegMulAdd,
}

/// Operation of a statement, with its operands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    /// Operation with one operand.
    Unary(Unary, Operand),
    /// Operation with two operands.
    Binary(Binary, Operand, Operand),
    /// Multiply-add with the operands (a, b, c).
    Fused(Fused, Operand, Operand, Operand),
    /// `IfZero(x, then, otherwise)`: `then` where `x` is 0, else `otherwise`.
    IfZero(Operand, Operand, Operand),
}

impl Op {
    /// Operands of the operation, in order.
    pub fn operands(&self) -> Vec<Operand> {
        match *self {
            Op::Unary(_, a) => vec![a],
            Op::Binary(_, a, b) => vec![a, b],
            Op::IfZero(a, b, c) | Op::Fused(_, a, b, c) => vec![a, b, c],
        }
    }

    /// Calls `change` with a mutable reference to each operand, in order.
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

/// Statement of a program: one operation. Later statements refer to the result of statement k as `Operand::Temp(k)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Operation that the statement computes.
    pub op: Op,
    /// Variable name; `None` if backends may print the operation as a subexpression of the statement that uses it.
    pub name: Option<String>,
    /// Auxiliary variable that the statement computes, for comments: its index in `Lowered::provenance`, the list of
    /// named values with their source locations.
    pub about: Option<usize>,
}

/// Straight-line program: statements without branches or loops, and outputs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// Statements in order of execution; operands refer only to earlier statements.
    pub statements: Vec<Statement>,
    /// Results of the program, in the order of the sections.
    pub outputs: Vec<Operand>,
    /// Tables that the statements look up.
    pub tables: Tables,
}

impl Program {
    /// Operands of all statements, then the outputs.
    pub(crate) fn operands(&self) -> impl Iterator<Item = Operand> + '_ {
        let inside = self.statements.iter().flat_map(|s| s.op.operands());
        inside.chain(self.outputs.iter().copied())
    }

    /// Renumbers the operands that are results of statements, after each statement `k` has moved to `places[k]`.
    pub(crate) fn renumber(&mut self, places: &[u32]) {
        let moved = |operand: &mut Operand| {
            if let Operand::Temp(t) = operand {
                *t = places[*t as usize];
            }
        };
        for statement in &mut self.statements {
            statement.op.for_operands(moved);
        }
        self.outputs.iter_mut().for_each(moved);
    }
}

/// Consecutive outputs of a function that form one vector or matrix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// Name of the vector or matrix: `dx`, `j`, `jp`, `y`, …
    pub name: &'static str,
    /// Number of outputs in the vector or matrix; for a sparse matrix, the number of stored entries.
    pub len: usize,
    /// Sparsity pattern of a matrix: (row, column) of each entry, ordered by row; `None` for a dense vector.
    pub pattern: Option<Vec<(u32, u32)>>,
}

/// Function of a model: a program, and the layout and names of its outputs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Function {
    /// Name of the function: `f`, `f_jac`, …
    pub name: &'static str,
    /// Program that computes the outputs.
    pub program: Program,
    /// Output vectors and matrices, such as `dx` and `j`, in the order of their outputs.
    pub sections: Vec<Section>,
    /// Name of each output in generated code: `u_dot`, `d_u_dot_d_w`, …
    pub results: Vec<String>,
}

impl Function {
    /// Output section (vector or matrix such as `dx` or `j`) with the name `name`; `None` if the function has none.
    pub fn section(&self, name: &str) -> Option<&Section> {
        self.sections.iter().find(|section| section.name == name)
    }

    /// Sparsity pattern of the matrix `name`; empty if there is none.
    pub fn pattern(&self, name: &str) -> &[(u32, u32)] {
        self.section(name)
            .and_then(|section| section.pattern.as_deref())
            .unwrap_or(&[])
    }

    /// Range of a section within the outputs; empty if there is none.
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
