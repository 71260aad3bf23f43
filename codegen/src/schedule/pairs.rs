//! Pairing of the sine and cosine statements of one angle, which all backends compute together.
//!
//! **Invariant.** A pair is computed at the position of the earlier of its two statements. The angle is available
//! there, since the earlier statement reads it; the later statement does not extend the angle's live range.

use crate::functions::MathFunction;
use crate::program::{Op, Operand, Program, Unary};
use std::collections::HashMap;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct OperandKey(u8, u64);

impl From<Operand> for OperandKey {
    fn from(operand: Operand) -> OperandKey {
        match operand {
            Operand::Time => OperandKey(0, 0),
            Operand::State(k) => OperandKey(1, k.into()),
            Operand::Parameter(k) => OperandKey(2, k.into()),
            Operand::Prepared(k) => OperandKey(3, k.into()),
            Operand::Marker(k) => OperandKey(4, k.into()),
            Operand::Constant(c) => OperandKey(5, c.to_bits()),
            Operand::Temp(k) => OperandKey(6, k.into()),
        }
    }
}

pub(crate) fn sin_cos_pairs(program: &Program) -> HashMap<usize, (usize, usize)> {
    #[derive(Default)]
    struct SineAndCosine {
        sin: Option<usize>,
        cos: Option<usize>,
    }
    let mut angles: HashMap<OperandKey, SineAndCosine> = HashMap::new();
    let mut pairs = HashMap::new();
    for (k, statement) in program.statements.iter().enumerate() {
        let Op::Unary(Unary::Call(function), angle) = statement.op else {
            continue;
        };
        let found = angles.entry(angle.into()).or_default();
        match function {
            MathFunction::Sin => found.sin.get_or_insert(k),
            MathFunction::Cos => found.cos.get_or_insert(k),
            _ => continue,
        };
        if let SineAndCosine {
            sin: Some(sin),
            cos: Some(cos),
        } = *found
        {
            pairs.insert(sin, (sin, cos));
            pairs.insert(cos, (sin, cos));
        }
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Statement;

    #[test]
    fn pairs_share_the_angle_and_nothing_else() {
        let [a, b] = [0, 1].map(Operand::State);
        let call = |function, angle| Op::Unary(Unary::Call(function), angle);
        let ops = [
            call(MathFunction::Sin, a),
            call(MathFunction::Cos, b),
            call(MathFunction::Exp, a),
            call(MathFunction::Cos, a),
        ];
        let statements = ops.map(|op| Statement {
            op,
            name: None,
            about: None,
        });
        let program = Program {
            statements: statements.into(),
            outputs: Vec::new(),
            ..Program::default()
        };
        let pairs = sin_cos_pairs(&program);
        assert_eq!(pairs.get(&0), Some(&(0, 3)));
        assert_eq!(pairs.get(&3), Some(&(0, 3)));
        assert_eq!(pairs.len(), 2);
    }
}
