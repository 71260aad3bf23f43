//! FMA contraction: merges a product whose only use is in a sum with that sum.

use crate::functions::BinaryFunction;
use crate::program::{Binary, Fused, Op, Operand, Program};

/// Contracts products and sums to fused multiply-adds.
pub(super) fn contract_fma(mut program: Program) -> Program {
    let mut uses = vec![0_u32; program.statements.len()];
    for temp in program.operands().filter_map(Operand::temp) {
        uses[temp] += 1;
    }
    let mut ready = vec![0_u32; program.statements.len()];
    let mut fused = vec![false; program.statements.len()];
    for k in 0..program.statements.len() {
        let op = program.statements[k].op;
        if let Op::Binary(sum @ (Binary::Add | Binary::Sub), a, b) = op {
            let product = |operand| product(&program, &uses, operand);
            // Of two products, fuses the one computed later, so that the other's latency is hidden.
            let second = match (product(a), product(b)) {
                (Some(_), Some(_)) => when(&ready, b) >= when(&ready, a),
                (_, second) => second.is_some(),
            };
            let (of, with) = if second { (b, a) } else { (a, b) };
            if let (Operand::Temp(t), Some((x, y))) = (of, product(of)) {
                let kind = match (sum, second) {
                    (Binary::Sub, true) => Fused::NegMulAdd,
                    (Binary::Sub, false) => Fused::MulSub,
                    _ => Fused::MulAdd,
                };
                let (x, y) = if reads_first(&program, y, x) {
                    (y, x)
                } else {
                    (x, y)
                };
                program.statements[k].op = Op::Fused(kind, x, y, with);
                fused[t as usize] = true;
            }
        }
        let op = program.statements[k].op;
        let start = op.operands().into_iter().map(|o| when(&ready, o)).max();
        ready[k] = start.unwrap_or(0) + latency(&op);
    }
    without(program, &fused)
}

/// Factors of a product that is used once and is no auxiliary variable.
fn product(program: &Program, uses: &[u32], operand: Operand) -> Option<(Operand, Operand)> {
    let temp = operand.temp()?;
    let statement = &program.statements[temp];
    match statement.op {
        Op::Binary(Binary::Mul, x, y) if uses[temp] == 1 && statement.about.is_none() => {
            Some((x, y))
        }
        _ => None,
    }
}

/// Whether `a.mul_add(b, c)` is more readable than `b.mul_add(a, c)`: `a` is a named variable and `b` is not.
fn reads_first(program: &Program, a: Operand, b: Operand) -> bool {
    let plain = |operand| match operand {
        Operand::Temp(t) => program.statements[t as usize].name.is_some(),
        Operand::Constant(_) => false,
        _ => true,
    };
    plain(a) && !plain(b)
}

fn when(ready: &[u32], operand: Operand) -> u32 {
    operand.temp().map_or(0, |temp| ready[temp])
}

pub(super) fn latency(op: &Op) -> u32 {
    use crate::program::Unary;
    match op {
        Op::Binary(Binary::Div, ..) => 14,
        Op::Binary(Binary::Call(BinaryFunction::Atan2 | BinaryFunction::Table(_)), ..) => 50,
        Op::Binary(..) | Op::Fused(..) | Op::IfZero(..) => 4,
        Op::Unary(unary, _) => match unary {
            Unary::Neg => 1,
            Unary::Recip | Unary::RecipOrZero => 14,
            Unary::Call(function) => function.latency(),
        },
    }
}

/// Removes the statements marked in `gone`, whose results must be unused, and renumbers the operands.
fn without(mut program: Program, gone: &[bool]) -> Program {
    let mut places = Vec::with_capacity(gone.len());
    let mut next = 0;
    for &gone in gone {
        places.push(next);
        next += u32::from(!gone);
    }
    let mut k = 0;
    program.statements.retain(|_| {
        k += 1;
        !gone[k - 1]
    });
    program.renumber(&places);
    program
}
