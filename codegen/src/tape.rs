//! The tape: a program as compact instructions, evaluated for one flight or for many at once.
//!
//! It does exactly the operations of the schedule in the order of the schedule, through
//! [`lanes::Real`], so that it agrees to the bit with generated code on the same lanes.

use crate::functions::MathFunction;
use crate::program::{Binary, Fused, Op, Operand, Program, Unary};
use lanes::Real;

/// What an instruction does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Code {
    Neg,
    Recip,
    RecipOrZero,
    SinCos,
    Call(MathFunction),
    Add,
    Sub,
    Mul,
    Div,
    Atan2,
    Min,
    Max,
    MulAdd,
    MulSub,
    NegMulAdd,
    IfZero,
}

/// One instruction over slots.
#[derive(Clone, Copy, Debug)]
struct Instruction {
    code: Code,
    to: u16,
    a: u16,
    b: u16,
    c: u16,
}

/// A program with its values in as few slots as possible.
#[derive(Clone, Debug)]
pub struct Tape {
    instructions: Vec<Instruction>,
    /// Inputs that are used, each with its slot.
    loads: Vec<(Operand, u16)>,
    outputs: Vec<u16>,
    slots: usize,
}

/// The inputs of a program, one number per lane.
#[derive(Clone, Copy, Debug)]
pub struct Inputs<'a, T> {
    /// Time since release.
    pub t: T,
    /// The state.
    pub x: &'a [T],
    /// Parameters, coefficients, inputs.
    pub p: &'a [T],
    /// What `prepare` made of them.
    pub prepared: &'a [T],
    /// Coordinates of the marker.
    pub marker: &'a [T],
}

impl Tape {
    /// Lays a program out.
    pub fn new(program: &Program) -> Tape {
        Builder::new(program).build()
    }

    /// How many instructions it has.
    pub fn len(&self) -> usize {
        self.instructions.len()
    }

    /// Whether it has none.
    pub fn is_empty(&self) -> bool {
        self.instructions.is_empty()
    }

    /// How many numbers of scratch space an evaluation needs.
    pub fn slots(&self) -> usize {
        self.slots
    }

    /// How many results there are.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Evaluates the program. `scratch` is grown if need be and can be used again.
    ///
    /// # Panics
    /// If an input has fewer numbers than the program reads, or `out` has not room for all results.
    #[inline(always)]
    pub fn eval<T: Real>(&self, inputs: Inputs<'_, T>, scratch: &mut Vec<T>, out: &mut [T]) {
        if scratch.len() < self.slots {
            scratch.resize(self.slots, T::splat(0.0));
        }
        self.eval_in(inputs, scratch, out);
    }

    /// The same in a scratch space of at least [`slots`](Tape::slots) numbers.
    ///
    /// # Panics
    /// As [`eval`](Tape::eval), or if the space is smaller.
    #[inline(always)]
    pub fn eval_in<T: Real>(&self, inputs: Inputs<'_, T>, scratch: &mut [T], out: &mut [T]) {
        let s = &mut scratch[..self.slots];
        for &(operand, slot) in &self.loads {
            s[usize::from(slot)] = match operand {
                Operand::Time => inputs.t,
                Operand::State(k) => inputs.x[k as usize],
                Operand::Parameter(k) => inputs.p[k as usize],
                Operand::Prepared(k) => inputs.prepared[k as usize],
                Operand::Marker(k) => inputs.marker[k as usize],
                Operand::Constant(c) => T::splat(c),
                Operand::Temp(_) => continue,
            };
        }
        for i in &self.instructions {
            let a = s[usize::from(i.a)];
            let value = match i.code {
                Code::MulAdd => a.mul_add(s[usize::from(i.b)], s[usize::from(i.c)]),
                Code::MulSub => a.mul_sub(s[usize::from(i.b)], s[usize::from(i.c)]),
                Code::NegMulAdd => a.neg_mul_add(s[usize::from(i.b)], s[usize::from(i.c)]),
                Code::Mul => a * s[usize::from(i.b)],
                Code::Add => a + s[usize::from(i.b)],
                Code::Sub => a - s[usize::from(i.b)],
                Code::Div => a / s[usize::from(i.b)],
                Code::Neg => -a,
                Code::Recip => T::splat(1.0) / a,
                Code::RecipOrZero => a.recip_or_zero(),
                Code::SinCos => {
                    let (sin, cos) = a.sin_cos();
                    s[usize::from(i.b)] = cos;
                    sin
                }
                Code::Call(function) => function.eval(a),
                Code::Atan2 => a.atan2(s[usize::from(i.b)]),
                Code::Min => a.min(s[usize::from(i.b)]),
                Code::Max => a.max(s[usize::from(i.b)]),
                Code::IfZero => a.if_zero(s[usize::from(i.b)], s[usize::from(i.c)]),
            };
            s[usize::from(i.to)] = value;
        }
        for (result, &slot) in out[..self.outputs.len()].iter_mut().zip(&self.outputs) {
            *result = s[usize::from(slot)];
        }
    }
}

struct Builder<'a> {
    program: &'a Program,
    /// Statement after which a temporary is no longer needed.
    last_use: Vec<usize>,
    place: Vec<u16>,
    free: Vec<u16>,
    slots: usize,
    loads: Vec<(Operand, u16)>,
}

impl<'a> Builder<'a> {
    fn new(program: &'a Program) -> Builder<'a> {
        let n = program.statements.len();
        let mut last_use = vec![0; n];
        for (k, statement) in program.statements.iter().enumerate() {
            for operand in statement.op.operands() {
                if let Operand::Temp(t) = operand {
                    last_use[t as usize] = k;
                }
            }
        }
        for output in &program.outputs {
            if let Operand::Temp(t) = output {
                last_use[*t as usize] = usize::MAX;
            }
        }
        Builder {
            program,
            last_use,
            place: vec![0; n],
            free: Vec::new(),
            slots: 0,
            loads: Vec::new(),
        }
    }

    fn build(mut self) -> Tape {
        let program = self.program;
        let operands = program
            .statements
            .iter()
            .flat_map(|statement| statement.op.operands());
        for operand in operands.chain(program.outputs.iter().copied()) {
            if !matches!(operand, Operand::Temp(_))
                && !self.loads.iter().any(|(known, _)| *known == operand)
            {
                let slot = self.take();
                self.loads.push((operand, slot));
            }
        }
        let mut instructions = Vec::with_capacity(program.statements.len());
        let mut done = vec![false; program.statements.len()];
        for k in 0..program.statements.len() {
            if done[k] {
                continue;
            }
            instructions.push(self.instruction(k, &mut done));
        }
        let outputs = program
            .outputs
            .iter()
            .map(|&output| self.slot(output))
            .collect();
        Tape {
            instructions,
            loads: self.loads,
            outputs,
            slots: self.slots,
        }
    }

    fn take(&mut self) -> u16 {
        self.free.pop().unwrap_or_else(|| {
            self.slots += 1;
            (self.slots - 1) as u16
        })
    }

    fn slot(&self, operand: Operand) -> u16 {
        match operand {
            Operand::Temp(t) => self.place[t as usize],
            other => self
                .loads
                .iter()
                .find(|(known, _)| *known == other)
                .map_or(0, |&(_, slot)| slot),
        }
    }

    fn instruction(&mut self, k: usize, done: &mut [bool]) -> Instruction {
        let op = self.program.statements[k].op;
        let operands = op.operands();
        let slots: Vec<u16> = operands.iter().map(|&operand| self.slot(operand)).collect();
        // sine and cosine of one angle are one instruction
        let partner = match op {
            Op::Unary(Unary::Call(MathFunction::Sin), x) => {
                self.find(k, Op::Unary(Unary::Call(MathFunction::Cos), x))
            }
            Op::Unary(Unary::Call(MathFunction::Cos), x) => {
                self.find(k, Op::Unary(Unary::Call(MathFunction::Sin), x))
            }
            _ => None,
        };
        for operand in &operands {
            if let Operand::Temp(t) = *operand
                && self.last_use[t as usize] <= partner.unwrap_or(k).max(k)
                && self.last_use[t as usize] >= k
            {
                self.free.push(self.place[t as usize]);
                // an operand that is used twice is given back once
                self.last_use[t as usize] = 0;
            }
        }
        let to = self.take();
        self.place[k] = to;
        done[k] = true;
        let (mut code, mut b) = (code(&op), slots.get(1).copied().unwrap_or(0));
        let mut first = to;
        if let Some(partner) = partner {
            let other = self.take();
            self.place[partner] = other;
            done[partner] = true;
            code = Code::SinCos;
            (first, b) = if matches!(op, Op::Unary(Unary::Call(MathFunction::Sin), _)) {
                (to, other)
            } else {
                (other, to)
            };
        }
        Instruction {
            code,
            to: first,
            a: slots[0],
            b,
            c: slots.get(2).copied().unwrap_or(0),
        }
    }

    fn find(&self, after: usize, op: Op) -> Option<usize> {
        (after + 1..self.program.statements.len()).find(|&k| self.program.statements[k].op == op)
    }
}

fn code(op: &Op) -> Code {
    match op {
        Op::Fused(fused, ..) => match fused {
            Fused::MulAdd => Code::MulAdd,
            Fused::MulSub => Code::MulSub,
            Fused::NegMulAdd => Code::NegMulAdd,
        },
        Op::IfZero(..) => Code::IfZero,
        Op::Binary(binary, ..) => match binary {
            Binary::Add => Code::Add,
            Binary::Sub => Code::Sub,
            Binary::Mul => Code::Mul,
            Binary::Div => Code::Div,
            Binary::Atan2 => Code::Atan2,
            Binary::Min => Code::Min,
            Binary::Max => Code::Max,
        },
        Op::Unary(unary, _) => match unary {
            Unary::Neg => Code::Neg,
            Unary::Recip => Code::Recip,
            Unary::RecipOrZero => Code::RecipOrZero,
            Unary::Call(function) => Code::Call(*function),
        },
    }
}
