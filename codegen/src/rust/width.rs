//! What fits a line, as rustfmt sees it.

use super::WIDTH;
use super::expression::Writer;
use crate::program::{Binary, Op, Operand, Unary};

/// Longest arguments of a call, and longest call of a call, that rustfmt leaves on one line.
const CALL: usize = 60;

/// `left right;`, on two lines where one is too short.
pub(super) fn two_lines(left: &str, right: &str) -> Vec<String> {
    if 4 + left.len() + 1 + right.len() < WIDTH {
        vec![format!("{left} {right};")]
    } else {
        vec![left.to_string(), format!("    {right};")]
    }
}

impl Writer<'_> {
    /// `left statement;` on as many lines as rustfmt takes.
    pub fn statement_lines(&self, left: &str, k: usize) -> Vec<String> {
        let right = self.statement(k);
        let operands = self.program.statements[k].op.operands();
        let call = self.arguments(k).and_then(|arguments| {
            let receiver = right.strip_suffix(&format!("({arguments})"))?;
            Some((receiver.rsplit_once('.')?, arguments))
        });
        match call {
            Some(((receiver, method), arguments)) if arguments.len() > CALL => {
                let mut lines = vec![format!("{left} {receiver}.{method}(")];
                let each = operands[1..].iter().map(|&o| self.operand(o));
                lines.extend(each.map(|argument| format!("    {argument},")));
                lines.push(");".to_string());
                lines
            }
            Some(((receiver, method), arguments)) if 8 + right.len() >= WIDTH => {
                vec![
                    format!("{left} {receiver}"),
                    format!("    .{method}({arguments});"),
                ]
            }
            _ => two_lines(left, &right),
        }
    }

    /// The longest of some operands that are written where they stand.
    pub fn longest_part(&self, operands: &[Operand]) -> Option<usize> {
        let parts = operands.iter().filter_map(|&operand| self.part(operand));
        parts.max_by_key(|&part| self.statement(part).len())
    }

    /// The statement that is written where an operand stands.
    pub fn part(&self, operand: Operand) -> Option<usize> {
        match operand {
            Operand::Temp(t) if self.names[t as usize].is_none() => Some(t as usize),
            _ => None,
        }
    }

    /// A part of a call, or of a call of a call, that rustfmt would write on several lines.
    pub fn part_of_wide_call(&self, k: usize) -> Option<usize> {
        let operands = self.program.statements[k].op.operands();
        let mut parts = operands.iter().filter_map(|&operand| self.part(operand));
        let wide = |part| self.arguments(part).is_some_and(|a| a.len() > CALL);
        let found = parts.find_map(|part| {
            let inside = self.part_of_wide_call(part);
            inside.or_else(|| wide(part).then_some(part))
        });
        if found.is_some() || self.arguments(k).is_none() {
            return found;
        }
        if wide(k)
            && let Some(part) = self.longest_part(&operands[1..])
        {
            return Some(part);
        }
        let receiver = self.part(operands[0])?;
        (self.arguments(receiver).is_some() && self.statement(k).len() > CALL).then_some(receiver)
    }

    /// What stands in the parentheses of a statement that is a call.
    fn arguments(&self, k: usize) -> Option<String> {
        let op = &self.program.statements[k].op;
        let infix = matches!(
            op,
            Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, ..)
                | Op::Unary(Unary::Neg | Unary::Recip, _)
        );
        let rest = op.operands().split_off(1);
        let texts: Vec<String> = rest.into_iter().map(|o| self.operand(o)).collect();
        (!infix).then(|| texts.join(", "))
    }
}
