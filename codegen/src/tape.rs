//! Tape: a program as register bytecode, which can be evaluated for one number or for one number per lane.
//!
//! The instructions are the operations of the schedule through [`lanes::Real`], so that results are bit-identical to
//! those of generated code over the same number type. Independent operations are ordered in runs of one kind.

mod allocate;
mod steps;

use crate::functions::BinaryFunction;
use crate::program::{Binary, Fused, Op, Operand, Program, Unary};
use crate::table::Tables;
use lanes::Real;

/// Operation code of an instruction of the register bytecode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Opcode {
    Binary(Binary),
    Fused(Fused),
    Unary(Unary),
    IfZero,
    /// Sine of register `a` to the target, its cosine to register `b`.
    SinCos,
}

/// Registers of an instruction; unused operands repeat `a`.
#[derive(Clone, Copy, Debug)]
struct Instruction {
    target: u32,
    a: u32,
    b: u32,
    c: u32,
}

/// Consecutive instructions that have the same operation code.
#[derive(Clone, Copy, Debug)]
struct Run {
    opcode: Opcode,
    /// Number of instructions.
    len: usize,
}

/// Register bytecode of a program; registers are allocated by the live ranges of the values.
#[derive(Clone, Debug)]
pub struct Tape {
    /// Inputs and constants that the program reads, each with the register into which it is loaded.
    loads: Vec<(Operand, u32)>,
    runs: Vec<Run>,
    /// Instructions of the program in order of execution.
    instructions: Vec<Instruction>,
    outputs: Vec<u32>,
    registers: usize,
    tables: Tables,
}

/// Input values for one evaluation of a program. If `T` is a SIMD vector, each lane belongs to one flight.
#[derive(Clone, Copy, Debug)]
pub struct Inputs<'a, T> {
    /// Time since release, s.
    pub t: T,
    /// State vector, in the order of `Layout::states`.
    pub x: &'a [T],
    /// Parameters: known constants, then coefficients, then components of inputs.
    pub p: &'a [T],
    /// Results of the function `prepare` for these parameters: values that depend on parameters alone.
    pub prepared: &'a [T],
    /// Body-fixed coordinates, m, of the marker.
    pub marker: &'a [T],
}

impl Tape {
    /// Compiles a program to bytecode.
    ///
    /// # Panics
    /// If a statement or output refers to a statement that does not precede it; compiled models contain no such
    /// reference.
    pub fn new(program: &Program) -> Tape {
        allocate::tape(program)
    }

    /// Number of registers, which is the minimum length of the buffer for register values.
    pub fn registers(&self) -> usize {
        self.registers
    }

    /// Number of results of one evaluation of the program.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Evaluates the program. `scratch` grows to [`registers`](Tape::registers) elements and can be reused.
    #[inline(always)]
    pub fn eval<T: Real>(&self, inputs: Inputs<'_, T>, scratch: &mut Vec<T>, out: &mut [T]) {
        if scratch.len() < self.registers {
            scratch.resize(self.registers, T::splat(0.0));
        }
        self.eval_in(inputs, scratch, out);
    }

    /// Evaluates the program in a scratch space of at least [`registers`](Tape::registers) elements.
    #[inline(always)]
    pub fn eval_in<T: Real>(&self, inputs: Inputs<'_, T>, scratch: &mut [T], out: &mut [T]) {
        let s = &mut scratch[..self.registers];
        for &(operand, register) in &self.loads {
            s[register as usize] = match operand {
                Operand::Time => inputs.t,
                Operand::State(k) => inputs.x[k as usize],
                Operand::Parameter(k) => inputs.p[k as usize],
                Operand::Prepared(k) => inputs.prepared[k as usize],
                Operand::Marker(k) => inputs.marker[k as usize],
                Operand::Constant(c) => T::splat(c),
                Operand::Temp(_) => continue,
            };
        }
        let mut instructions = self.instructions.as_slice();
        for run in &self.runs {
            let (these, rest) = instructions.split_at(run.len);
            instructions = rest;
            // Not a closure, which would be a function for the baseline processor.
            macro_rules! each {
                (|$($operand:ident),*| $value:expr) => {
                    for i in these {
                        $(let $operand = s[i.$operand as usize];)*
                        s[i.target as usize] = $value;
                    }
                };
            }
            match run.opcode {
                Opcode::Fused(Fused::MulAdd) => each!(|a, b, c| a.mul_add(b, c)),
                Opcode::Fused(Fused::MulSub) => each!(|a, b, c| a.mul_sub(b, c)),
                Opcode::Fused(Fused::NegMulAdd) => each!(|a, b, c| a.neg_mul_add(b, c)),
                Opcode::Binary(Binary::Mul) => each!(|a, b| a * b),
                Opcode::Binary(Binary::Add) => each!(|a, b| a + b),
                Opcode::Binary(Binary::Sub) => each!(|a, b| a - b),
                Opcode::Binary(Binary::Div) => each!(|a, b| a / b),
                Opcode::Binary(Binary::Call(BinaryFunction::Atan2)) => each!(|a, b| a.atan2(b)),
                Opcode::Binary(Binary::Call(BinaryFunction::Table(function))) => {
                    let bicubic = self.tables.table(function.table()).bicubic();
                    let orders = function.orders();
                    each!(|a, b| bicubic.eval(a, b, orders));
                }
                Opcode::Binary(Binary::Call(BinaryFunction::Min)) => each!(|a, b| a.min(b)),
                Opcode::Binary(Binary::Call(BinaryFunction::Max)) => each!(|a, b| a.max(b)),
                Opcode::IfZero => each!(|a, b, c| a.if_zero(b, c)),
                Opcode::Unary(Unary::Neg) => each!(|a| -a),
                Opcode::Unary(Unary::Recip) => each!(|a| T::splat(1.0) / a),
                Opcode::Unary(Unary::RecipOrZero) => each!(|a| a.recip_or_zero()),
                Opcode::Unary(Unary::Call(function)) => each!(|a| function.eval(a, &self.tables)),
                Opcode::SinCos => {
                    for i in these {
                        let (sin, cos) = s[i.a as usize].sin_cos();
                        s[i.target as usize] = sin;
                        s[i.b as usize] = cos;
                    }
                }
            }
        }
        for (result, &register) in out[..self.outputs.len()].iter_mut().zip(&self.outputs) {
            *result = s[register as usize];
        }
    }
}

impl From<Op> for Opcode {
    fn from(op: Op) -> Opcode {
        match op {
            Op::Unary(unary, _) => Opcode::Unary(unary),
            Op::Binary(binary, ..) => Opcode::Binary(binary),
            Op::Fused(fused, ..) => Opcode::Fused(fused),
            Op::IfZero(..) => Opcode::IfZero,
        }
    }
}
