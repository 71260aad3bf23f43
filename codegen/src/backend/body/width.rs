//! Approximate lengths of printed expressions, which decide where an expression is split.

use super::Variables;
use crate::program::{Binary, Op, Operand, Program, Unary};

/// Longest expression that is written inside another, in characters.
pub(super) const MAX_INLINE: usize = 64;

/// Longest right-hand side of a statement, in characters.
pub(super) const MAX_STATEMENT: usize = 84;

/// Characters of a function or method call beside its operands.
const CALL: usize = 11;

/// Characters of a constant.
const CONSTANT: usize = 13;

/// Lengths of the statements of a program.
pub(super) struct Widths<'a> {
    program: &'a Program,
}

impl<'a> Widths<'a> {
    pub fn new(program: &'a Program) -> Self {
        Widths { program }
    }

    /// Length of the right-hand side of a statement.
    pub fn statement(&self, variables: &Variables, k: usize) -> usize {
        let op = &self.program.statements[k].op;
        let operands: usize = op
            .operands()
            .into_iter()
            .map(|operand| self.operand(variables, operand))
            .sum();
        operands + own_width(op)
    }

    /// The longest operand of a statement that is written inside it.
    pub fn widest_part(&self, variables: &Variables, k: usize) -> Option<usize> {
        let operands = self.program.statements[k].op.operands();
        let parts = operands.into_iter().filter_map(|operand| match operand {
            Operand::Temp(t) if variables.of(operand).is_none() => Some(t as usize),
            _ => None,
        });
        parts.max_by_key(|&part| self.statement(variables, part))
    }

    fn operand(&self, variables: &Variables, operand: Operand) -> usize {
        match (variables.of(operand), operand) {
            (Some(name), _) => name.chars().count(),
            (None, Operand::Temp(t)) => self.statement(variables, t as usize),
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
