//! Operation counts of programs, by kind. A fused multiply-add counts as one product and one sum.

use crate::functions::{BinaryFunction, CostKind};
use crate::program::{Binary, Op, Operand, Program, Unary};
use std::fmt;

/// Operation counts of a program, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Number of additions and subtractions.
    pub add: usize,
    /// Number of multiplications.
    pub mul: usize,
    /// Number of divisions and reciprocals.
    pub div: usize,
    /// Number of negations.
    pub neg: usize,
    /// Number of square roots.
    pub sqrt: usize,
    /// Number of calls of elementary functions: sine, cosine, arctangent, …
    pub call: usize,
    /// Number of comparisons, selections, absolute values, minima and maxima.
    pub select: usize,
}

impl Count {
    /// Total number of operations of all kinds.
    pub fn total(&self) -> usize {
        self.add + self.mul + self.div + self.neg + self.sqrt + self.call + self.select
    }

    fn one(&mut self, op: &Op) {
        let kind = match op {
            Op::Fused(..) => {
                self.mul += 1;
                &mut self.add
            }
            Op::IfZero(..) => &mut self.select,
            Op::Binary(binary, ..) => match binary {
                Binary::Add | Binary::Sub => &mut self.add,
                Binary::Mul => &mut self.mul,
                Binary::Div => &mut self.div,
                Binary::Call(BinaryFunction::Min | BinaryFunction::Max) => &mut self.select,
                Binary::Call(_) => &mut self.call,
            },
            Op::Unary(unary, _) => match unary {
                Unary::Neg => &mut self.neg,
                Unary::Recip | Unary::RecipOrZero => &mut self.div,
                Unary::Call(function) => match function.cost_kind() {
                    CostKind::Root => &mut self.sqrt,
                    CostKind::Call => &mut self.call,
                    CostKind::Select => &mut self.select,
                },
            },
        };
        *kind += 1;
    }
}

/// Counts the operations of all statements of a program, by kind.
pub fn count(program: &Program) -> Count {
    let mut count = Count::default();
    for statement in &program.statements {
        count.one(&statement.op);
    }
    count
}

/// Counts the operations on which the selected outputs of a program depend, by kind; `outputs` contains output indices.
pub fn count_for(program: &Program, outputs: &[usize]) -> Count {
    let mut needed = vec![false; program.statements.len()];
    for temp in outputs
        .iter()
        .filter_map(|&output| program.outputs[output].temp())
    {
        needed[temp] = true;
    }
    let mut count = Count::default();
    for (k, statement) in program.statements.iter().enumerate().rev() {
        if needed[k] {
            count.one(&statement.op);
            for temp in statement
                .op
                .operands()
                .into_iter()
                .filter_map(Operand::temp)
            {
                needed[temp] = true;
            }
        }
    }
    count
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} operations", self.total())?;
        let kinds = [
            (self.add, "add"),
            (self.mul, "mul"),
            (self.div, "div"),
            (self.neg, "neg"),
            (self.sqrt, "sqrt"),
            (self.call, "call"),
            (self.select, "select"),
        ];
        let parts: Vec<String> = kinds
            .iter()
            .filter(|(n, _)| *n > 0)
            .map(|(n, kind)| format!("{n} {kind}"))
            .collect();
        if !parts.is_empty() {
            write!(f, ": {}", parts.join(", "))?;
        }
        Ok(())
    }
}
