//! Register allocation: a linear scan over the live ranges of a program.

use super::steps::{Step, Steps, Value};
use super::{Instruction, Run, Tape};
use crate::program::{Operand, Program};

/// Last use of inputs, constants and outputs: after every step.
const END: usize = usize::MAX;

/// Compiles a program to a tape.
pub(super) fn tape(program: &Program) -> Tape {
    let steps = Steps::new(program);
    let mut allocator = Allocator {
        last_use: last_uses(&steps),
        registers: vec![None; steps.values()],
        free: Vec::new(),
        count: 0,
    };
    let loads = allocator.loads(&steps);
    let mut instructions = Vec::with_capacity(steps.steps.len());
    for (k, step) in steps.steps.iter().enumerate() {
        instructions.push(allocator.instruction(step, k));
    }
    let runs = steps.steps.chunk_by(|a, b| a.opcode == b.opcode);
    let runs = runs.map(|run| Run {
        opcode: run[0].opcode,
        len: run.len(),
    });
    let outputs = steps.outputs.iter();
    Tape {
        loads,
        runs: runs.collect(),
        instructions,
        outputs: outputs.map(|&output| allocator.register(output)).collect(),
        registers: allocator.count as usize,
        tables: program.tables.clone(),
    }
}

/// For each value, the last step that reads it, or [`END`].
fn last_uses(steps: &Steps) -> Vec<usize> {
    let mut last = vec![0; steps.statements];
    last.resize(steps.values(), END);
    for (k, step) in steps.steps.iter().enumerate() {
        for &operand in &step.operands {
            last[operand] = last[operand].max(k);
        }
    }
    for &output in &steps.outputs {
        last[output] = END;
    }
    last
}

struct Allocator {
    last_use: Vec<usize>,
    /// Register of each live value.
    registers: Vec<Option<u32>>,
    free: Vec<u32>,
    count: u32,
}

impl Allocator {
    fn loads(&mut self, steps: &Steps) -> Vec<(Operand, u32)> {
        let inputs = steps.inputs.iter().zip(steps.statements..);
        inputs
            .map(|(&operand, value)| (operand, self.define(value)))
            .collect()
    }

    /// Allocates a register for a new value: a free register if there is one, else an additional one.
    fn define(&mut self, value: Value) -> u32 {
        let register = self.free.pop().unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        });
        self.registers[value] = Some(register);
        register
    }

    /// Returns the register of a live value; panics if the value is not live.
    fn register(&self, value: Value) -> u32 {
        self.registers[value]
            .unwrap_or_else(|| panic!("value {value} is read outside its live range"))
    }

    fn instruction(&mut self, step: &Step, k: usize) -> Instruction {
        let [a, b, c] = step.operands.map(|operand| self.register(operand));
        for operand in step.operands {
            if self.last_use[operand] == k {
                self.free.extend(self.registers[operand].take());
            }
        }
        Instruction {
            target: self.define(step.result),
            a,
            b: step.second.map_or(b, |second| self.define(second)),
            c,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::functions::MathFunction;
    use crate::program::{Binary, Op, Statement, Unary};
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
        assert_eq!((tape.instructions.len(), tape.registers()), (100, 3));
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
