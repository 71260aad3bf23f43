//! Detects equivalent mutants: mutants whose compiled equations are proved equal to those of the model.

use crate::checks::exact::FieldPoint;
use crate::field::Machine;
use crate::random::Random;
use crate::sample;
use crate::subject::{Equations, Subject};
use crate::values::Values;
use codegen::program::{Binary, Fused, Op, Operand, Program, Unary};
use std::collections::HashMap;

/// Reason why a mutant (model with one deliberate change) is equivalent to the original model: both compile to the same
/// expression graph.
const SAME: &str = "compiles to the same derivatives and observation, node for node";
/// Reason why a mutant (model with one deliberate change) is equivalent to the original model: both have equal values
/// at random points of the prime field (integers modulo 2^61 − 1). Their floating-point values are compared too,
/// because the field does not show a square root with the wrong sign.
const EQUAL: &str = "derivatives and observation equal at 4 random points of the field of 2^61 - 1 elements, \
                     functions being symbols";

/// Number of random points at which the programs compiled from a model and from a mutant are compared: as many in the
/// prime field (integers modulo 2^61 − 1) as in floating-point arithmetic.
const POINTS: usize = 4;
/// Maximum number of random trial points of the prime field (integers modulo 2^61 − 1) in the comparison with a mutant.
/// A trial point is usable if the argument of every square root is a square in the field, which has probability 1/2 per
/// root.
const MAX_TRIALS: usize = 4096;

/// The original model, prepared for comparison with its mutants (copies with one deliberate change each).
pub struct Original<'a> {
    /// Original model with its equations of motion, from which the mutants are made.
    pub subject: &'a Subject<'a>,
    values: Values,
    interner: Interner,
    outputs: Vec<u32>,
}

impl<'a> Original<'a> {
    /// Compiles the original model for comparison with its mutants (copies with one deliberate change each).
    pub fn new(subject: &'a Subject<'a>) -> Self {
        let values = Values::of(subject.model);
        let mut interner = Interner::default();
        let outputs = interner.outputs(&values.program);
        Self {
            subject,
            values,
            interner,
            outputs,
        }
    }

    /// States how the `mutant` is proved to have the same derivatives and observation as the original model; `None` if
    /// equivalence is not proved.
    pub fn same(&self, mutant: &Values) -> Option<&'static str> {
        let (here, there) = (&self.values.layout, &mutant.layout);
        let named = here.states == there.states && here.parameters == there.parameters;
        if !named || here.defaults != there.defaults {
            return None;
        }
        if self.interner.clone().outputs(&mutant.program) == self.outputs {
            return Some(SAME);
        }
        (self.equal_in_numbers(mutant) && self.equal_in_field(mutant)).then_some(EQUAL)
    }

    fn equal_in_numbers(&self, mutant: &Values) -> bool {
        let mut random = Random::new(0, "equivalence");
        (0..POINTS).all(|_| {
            let point = sample::point(self.subject.model, &mut random);
            let (here, there) = (self.values.rates(&point), mutant.rates(&point));
            here.iter()
                .zip(&there)
                .all(|(a, b)| (a - b).abs() <= 1e-9 * (1.0 + a.abs() + b.abs()))
        })
    }

    fn equal_in_field(&self, mutant: &Values) -> bool {
        let mut random = Random::new(0, "equivalence");
        let mut good = 0;
        for _ in 0..MAX_TRIALS {
            let spot = FieldPoint::random(self.subject.model, &mut random);
            let machine = Machine::new(&spot.point, &spot.circles, true);
            let here = machine.run(&self.values.program);
            if here.iter().any(Option::is_none) {
                continue;
            }
            if machine.run(&mutant.program) != here {
                return false;
            }
            good += 1;
            if good == POINTS {
                return true;
            }
        }
        false
    }

    /// Whether the original model has terms that its reference implementation does not contain, or has no reference
    /// implementation.
    pub fn has_uncovered_terms(&self) -> bool {
        self.subject
            .reference
            .as_ref()
            .is_none_or(|r| !r.unknown.is_empty())
    }
}

/// Hash-consing table of expressions: equal expressions have equal value numbers.
#[derive(Clone, Debug, Default)]
struct Interner {
    numbers: HashMap<Key, u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Key {
    Time,
    State(u32),
    Parameter(u32),
    Prepared(u32),
    Marker(u32),
    Constant(u64),
    Unary(Unary, u32),
    Binary(Binary, u32, u32),
    IfZero(u32, u32, u32),
}

/// Key of a binary operation in a hash-consing table. `a` and `b` are the value numbers of the operands; those of a
/// commutative operation are sorted.
fn binary(op: Binary, a: u32, b: u32) -> Key {
    match op {
        Binary::Add | Binary::Mul | Binary::Min | Binary::Max if b < a => Key::Binary(op, b, a),
        _ => Key::Binary(op, a, b),
    }
}

impl Interner {
    /// Value numbers of the outputs of a program. Outputs with equal numbers are the same expression.
    fn outputs(&mut self, program: &Program) -> Vec<u32> {
        let mut temps: Vec<u32> = Vec::with_capacity(program.statements.len());
        for statement in &program.statements {
            let mut operand = |o: Operand| self.operand(o, &temps);
            let key = match statement.op {
                Op::Unary(op, a) => Key::Unary(op, operand(a)),
                Op::Binary(op, a, b) => binary(op, operand(a), operand(b)),
                // Fused and unfused forms have equal value numbers.
                Op::Fused(fused, a, b, c) => {
                    let (product, c) = (binary(Binary::Mul, operand(a), operand(b)), operand(c));
                    let product = self.number(product);
                    match fused {
                        Fused::MulAdd => binary(Binary::Add, product, c),
                        Fused::MulSub => binary(Binary::Sub, product, c),
                        Fused::NegMulAdd => binary(Binary::Sub, c, product),
                    }
                }
                Op::IfZero(a, b, c) => Key::IfZero(operand(a), operand(b), operand(c)),
            };
            let number = self.number(key);
            temps.push(number);
        }
        program
            .outputs
            .iter()
            .map(|&output| self.operand(output, &temps))
            .collect()
    }

    fn operand(&mut self, operand: Operand, temps: &[u32]) -> u32 {
        match operand {
            Operand::Temp(i) => temps[i as usize],
            Operand::Time => self.number(Key::Time),
            Operand::State(i) => self.number(Key::State(i)),
            Operand::Parameter(i) => self.number(Key::Parameter(i)),
            Operand::Prepared(i) => self.number(Key::Prepared(i)),
            Operand::Marker(i) => self.number(Key::Marker(i)),
            Operand::Constant(c) => self.number(Key::Constant(c.to_bits())),
        }
    }

    fn number(&mut self, key: Key) -> u32 {
        let next = self.numbers.len() as u32;
        *self.numbers.entry(key).or_insert(next)
    }
}
