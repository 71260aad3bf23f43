//! Register allocation: a linear scan over the live ranges of a program.

use super::{Bytecode, Instruction, Opcode};
use crate::backend::pairs::{OperandKey, sin_cos_pairs};
use crate::functions::MathFunction;
use crate::program::{Op, Operand, Program, Unary};
use std::collections::HashMap;

/// Index of the last use that is assigned to program outputs, which stay live after the last instruction: greater than
/// every instruction index.
const END: usize = usize::MAX;

/// Compiles a program to bytecode, and returns it with the number of registers.
///
/// # Panics
/// If an operand refers to a statement that does not precede its use.
pub(super) fn bytecode(program: &Program) -> (Bytecode<u32>, usize) {
    let pairs = sin_cos_pairs(program);
    let mut allocator = Allocator {
        last_use: last_uses(program, &pairs),
        registers: HashMap::new(),
        free: Vec::new(),
        count: 0,
    };
    let loads = allocator.loads(program);
    let mut instructions = Vec::with_capacity(program.statements.len());
    for (k, statement) in program.statements.iter().enumerate() {
        match pairs.get(&k) {
            Some(&(sin, cos)) if k == sin.min(cos) => {
                instructions.push(allocator.pair(statement.op, (sin, cos), k));
            }
            // The earlier statement of the pair has emitted the instruction.
            Some(_) => {}
            None => instructions.push(allocator.instruction(statement.op, k)),
        }
    }
    let outputs = program.outputs.iter();
    let code = Bytecode {
        outputs: outputs.map(|&output| allocator.register(output)).collect(),
        instructions,
        loads,
    };
    (code, allocator.count as usize)
}

/// For each statement, the index of the last instruction that reads its result. A sine and cosine pair is one
/// instruction at the earlier of its two statements, which reads the angle for both.
fn last_uses(program: &Program, pairs: &HashMap<usize, (usize, usize)>) -> Vec<usize> {
    let mut last = vec![0; program.statements.len()];
    for (k, statement) in program.statements.iter().enumerate() {
        let position = pairs.get(&k).map_or(k, |&(sin, cos)| sin.min(cos));
        for operand in statement.op.operands() {
            if let Operand::Temp(t) = operand {
                assert!(
                    (t as usize) < position,
                    "statement {k} reads the later statement {t}"
                );
                last[t as usize] = last[t as usize].max(position);
            }
        }
    }
    for output in &program.outputs {
        if let Operand::Temp(t) = output {
            last[*t as usize] = END;
        }
    }
    last
}

struct Allocator {
    last_use: Vec<usize>,
    /// Register of each input, constant and live result.
    registers: HashMap<OperandKey, u32>,
    free: Vec<u32>,
    count: u32,
}

impl Allocator {
    /// Assigns a separate register to every input and constant for the whole evaluation.
    fn loads(&mut self, program: &Program) -> Vec<(Operand, u32)> {
        let inside = program.statements.iter().flat_map(|s| s.op.operands());
        let mut loads = Vec::new();
        for operand in inside.chain(program.outputs.iter().copied()) {
            let is_new = !self.registers.contains_key(&operand.into());
            if is_new && !matches!(operand, Operand::Temp(_)) {
                loads.push((operand, self.define(operand)));
            }
        }
        loads
    }

    /// Allocates a register for a new value: a free register if there is one, else an additional one.
    fn define(&mut self, operand: Operand) -> u32 {
        let register = self.free.pop().unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        });
        self.registers.insert(operand.into(), register);
        register
    }

    /// Returns the register of a live value; panics if the value is not live.
    fn register(&self, operand: Operand) -> u32 {
        *self
            .registers
            .get(&operand.into())
            .unwrap_or_else(|| panic!("{operand:?} is read outside its live range"))
    }

    /// Frees the registers of the operands whose live range ends at the statement `k`.
    fn release(&mut self, operands: &[Operand], k: usize) {
        for &operand in operands {
            if let Operand::Temp(t) = operand
                && self.last_use[t as usize] == k
                && let Some(register) = self.registers.remove(&operand.into())
            {
                self.free.push(register);
            }
        }
    }

    fn instruction(&mut self, op: Op, k: usize) -> Instruction<u32> {
        let operands = op.operands();
        let registers: Vec<u32> = operands.iter().map(|&o| self.register(o)).collect();
        self.release(&operands, k);
        let operand = |n: usize| registers.get(n).copied().unwrap_or(registers[0]);
        Instruction {
            opcode: op.into(),
            target: self.define(Operand::Temp(k as u32)),
            a: registers[0],
            b: operand(1),
            c: operand(2),
        }
    }

    /// Returns the instruction that computes the statements `sin` and `cos`, the sine and cosine of one angle; `k` is
    /// the earlier of these two statement indices.
    fn pair(&mut self, op: Op, (sin, cos): (usize, usize), k: usize) -> Instruction<u32> {
        debug_assert!(matches!(
            op,
            Op::Unary(Unary::Call(MathFunction::Sin | MathFunction::Cos), _)
        ));
        let operands = op.operands();
        let angle = self.register(operands[0]);
        self.release(&operands, k);
        Instruction {
            opcode: Opcode::SinCos,
            target: self.define(Operand::Temp(sin as u32)),
            a: angle,
            b: self.define(Operand::Temp(cos as u32)),
            c: angle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Binary, Statement};
    use crate::tape::{Inputs, Tape};

    fn program(ops: &[Op], outputs: &[u32]) -> Program {
        let statements = ops.iter().map(|&op| Statement {
            op,
            name: None,
            about: None,
        });
        Program {
            statements: statements.collect(),
            outputs: outputs.iter().map(|&t| Operand::Temp(t)).collect(),
            ..Program::default()
        }
    }

    fn eval(program: &Program, x: &[f64]) -> Vec<f64> {
        let tape = Tape::new(program);
        let inputs = Inputs {
            t: 0.0,
            x,
            p: &[],
            prepared: &[],
            marker: &[],
        };
        let mut out = vec![f64::NAN; tape.outputs()];
        tape.eval(inputs, &mut Vec::new(), &mut out);
        out
    }

    #[test]
    fn an_angle_outlives_its_pair_where_others_read_it() {
        let [x, angle, sine, exp, cosine] = [
            Operand::State(0),
            Operand::Temp(0),
            Operand::Temp(1),
            Operand::Temp(2),
            Operand::Temp(3),
        ];
        // The exponential reads the angle between the two halves of the pair.
        let between = program(
            &[
                Op::Binary(Binary::Add, x, x),
                Op::Unary(Unary::Call(MathFunction::Sin), angle),
                Op::Unary(Unary::Call(MathFunction::Exp), angle),
                Op::Unary(Unary::Call(MathFunction::Cos), angle),
                Op::Binary(Binary::Mul, sine, exp),
                Op::Binary(Binary::Sub, Operand::Temp(4), cosine),
                Op::Binary(Binary::Add, Operand::Temp(5), angle),
            ],
            &[6],
        );
        let a: f64 = 0.6;
        let found = eval(&between, &[0.3])[0];
        assert!((found - (a.sin() * a.exp() - a.cos() + a)).abs() < 1e-15);
    }

    #[test]
    fn registers_of_dead_values_are_reused_and_results_are_not() {
        let x = Operand::State(0);
        let chain: Vec<Op> = (0..100)
            .map(|k| match k {
                0 => Op::Binary(Binary::Add, x, Operand::Constant(1.0)),
                k => Op::Binary(Binary::Mul, Operand::Temp(k - 1), Operand::Temp(k - 1)),
            })
            .collect();
        let tape = Tape::new(&program(&chain, &[99]));
        assert_eq!((tape.len(), tape.registers()), (100, 3));
        let all: Vec<u32> = (0..100).collect();
        assert_eq!(Tape::new(&program(&chain, &all)).registers(), 102);
    }

    #[test]
    fn more_values_than_sixteen_bits_count_are_kept_apart() {
        let n = 70_000_u32;
        let ops: Vec<Op> = (0..n)
            .map(|k| Op::Binary(Binary::Mul, Operand::State(0), Operand::Constant(k.into())))
            .collect();
        let all: Vec<u32> = (0..n).collect();
        let out = eval(&program(&ops, &all), &[2.0]);
        assert!(
            out.iter()
                .zip(0..n)
                .all(|(&value, k)| value == 2.0 * f64::from(k))
        );
    }

    #[test]
    #[should_panic(expected = "reads the later statement")]
    fn a_statement_reads_only_earlier_ones() {
        Tape::new(&program(&[Op::Unary(Unary::Neg, Operand::Temp(0))], &[0]));
    }
}
