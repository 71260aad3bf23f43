//! Detects equivalent mutants: mutants whose compiled equations are proved equal to those of the model.

use crate::checks::exact::FieldPoint;
use crate::field::Machine;
use crate::random::Random;
use crate::sample;
use crate::subject::{Equations, Subject};
use crate::values::Values;
use codegen::program::{Op, Program};

/// Reason why a mutant is equivalent to the original model: both compile to the same operations.
const SAME: &str = "compiles to the same derivatives and observation, node for node";
/// Reason why a mutant is equivalent to the original model: both have equal values at random points of the prime field.
/// Their floating-point values are compared too, because the field does not show a square root with the wrong sign.
const EQUAL: &str = "derivatives and observation equal at 4 random points of the field of 2^61 - 1 elements, \
                     functions being symbols";

/// Number of random points at which the programs compiled from a model and from a mutant are compared: as many in the
/// prime field as in floating-point arithmetic.
const POINTS: usize = 4;
/// Maximum number of random trial points of the prime field in the comparison with a mutant. A trial point is usable if
/// the argument of every square root is a square in the field, which has probability 1/2 per root.
const MAX_TRIALS: usize = 4096;

/// The original model, prepared for comparison with its mutants.
pub struct Original<'a> {
    /// Original model with its equations of motion, from which the mutants are made.
    pub subject: &'a Subject<'a>,
    values: Values,
}

impl<'a> Original<'a> {
    /// Compiles the original model for comparison with its mutants.
    pub fn new(subject: &'a Subject<'a>) -> Self {
        Self {
            subject,
            values: Values::of(subject.model),
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
        if is_same(&self.values.program, &mutant.program) {
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

/// Whether two programs consist of the same operations in the same order, whatever statements these are from.
fn is_same(a: &Program, b: &Program) -> bool {
    let operations = |program: &Program| -> Vec<Op> {
        let statements = program.statements.iter();
        statements.map(|statement| statement.op).collect()
    };
    a.outputs == b.outputs && a.tables == b.tables && operations(a) == operations(b)
}
