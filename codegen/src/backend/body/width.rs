//! Approximate lengths of printed expressions, which decide where an expression is split.

use crate::program::{Binary, Op, Operand, Program, Unary};

/// Longest expression that is written inside another, in characters.
pub(super) const MAX_INLINE: usize = 64;

/// Longest right-hand side of a statement, in characters.
pub(super) const MAX_STATEMENT: usize = 84;

/// Characters of a function or method call beside its operands.
const CALL: usize = 11;

/// Characters of a constant.
const CONSTANT: usize = 13;

/// Lengths of the statements of a program, given the length of the variable of each operand that has one.
pub(super) struct Widths<'a, V> {
    pub program: &'a Program,
    pub variable: V,
}

impl<V: Fn(Operand) -> Option<usize>> Widths<'_, V> {
    /// Length of the right-hand side of a statement.
    pub fn statement(&self, k: usize) -> usize {
        let op = &self.program.statements[k].op;
        let operands: usize = op
            .operands()
            .into_iter()
            .map(|operand| self.operand(operand))
            .sum();
        operands + own_width(op)
    }

    /// The longest operand of a statement that is written inside it.
    pub fn widest_part(&self, k: usize) -> Option<usize> {
        let operands = self.program.statements[k].op.operands();
        let parts = operands.into_iter().filter_map(|operand| match operand {
            Operand::Temp(t) if (self.variable)(operand).is_none() => Some(t as usize),
            _ => None,
        });
        parts.max_by_key(|&part| self.statement(part))
    }

    fn operand(&self, operand: Operand) -> usize {
        match ((self.variable)(operand), operand) {
            (Some(width), _) => width,
            (None, Operand::Temp(t)) => self.statement(t as usize),
            (None, Operand::Constant(_)) => CONSTANT,
            (None, _) => "time".len(),
        }
    }
}

/// Characters of an operation without its operands.
fn own_width(op: &Op) -> usize {
    match op {
        Op::Unary(Unary::Neg, _) => 1,
        Op::Unary(Unary::Recip, _) => CONSTANT + 3,
        Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, ..) => 3,
        _ => CALL,
    }
}
