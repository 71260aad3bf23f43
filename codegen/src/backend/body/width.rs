//! Estimated widths of printed expressions, which decide where long expressions are split.

use crate::program::{Binary, Op, Operand, Program, Unary};

/// Maximum width, in characters, of an inlined expression.
pub(super) const MAX_INLINE: usize = 64;

/// Maximum width of a right-hand side, in characters; parts of wider ones become variables.
pub(super) const MAX_STATEMENT: usize = 84;

/// Estimated width of a function or method call without its operands, characters.
const CALL: usize = 11;

/// Estimated width of a numeric constant, characters.
const CONSTANT: usize = 13;

/// Estimates printed widths; `variable` is the length of the name of an operand's variable.
pub(super) struct Widths<'a, V> {
    pub program: &'a Program,
    pub variable: V,
}

impl<V: Fn(Operand) -> Option<usize>> Widths<'_, V> {
    /// Estimated width of the right-hand side of statement `k`, characters.
    pub fn statement(&self, k: usize) -> usize {
        let op = &self.program.statements[k].op;
        let operands: usize = op
            .operands()
            .into_iter()
            .map(|operand| self.operand(operand))
            .sum();
        operands + own_width(op)
    }

    /// Index of the statement that is the widest inlined operand of statement `k`; `None` if no operand is inlined.
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

/// Estimated width of an operation without its operands, characters.
fn own_width(op: &Op) -> usize {
    match op {
        Op::Unary(Unary::Neg, _) => 1,
        Op::Unary(Unary::Recip, _) => CONSTANT + 3,
        Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, ..) => 3,
        _ => CALL,
    }
}
