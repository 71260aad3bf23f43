//! Detects equivalent mutants: mutants whose compiled equations are proved equal to those of the model.

use super::verdicts::verdicts;
use crate::difference::values::Everything;
use crate::difference::{Sameness, function};
use crate::engine::Values;
use crate::options::Options;
use crate::row::Verdict;
use crate::subject::Subject;
use codegen::program::{Op, Program};
use model_spec::model::Model;
use std::sync::OnceLock;

/// Reason: the same operations.
const SAME: &str = "compiles to the same derivatives and observation, node for node";
/// Reason: equal values in the prime field. Floating-point values are compared too, because the field does not show a
/// square root with the wrong sign.
const EQUAL: &str = "derivatives and observation equal at 4 random points of the field of 2^61 - 1 elements, \
                     functions being symbols";

/// Maximum relative difference of floating-point values of equal functions.
const TOLERANCE: f64 = 1e-9;

/// The original model, prepared for comparison with its mutants.
pub struct Original<'a> {
    /// Original model with its equations of motion.
    pub subject: &'a Subject<'a>,
    values: Values,
    verdicts: OnceLock<[Verdict; 6]>,
}

impl<'a> Original<'a> {
    /// Compiles the original model.
    pub fn new(subject: &'a Subject<'a>) -> Self {
        Self {
            subject,
            values: Values::of(subject.model),
            verdicts: OnceLock::new(),
        }
    }

    /// Verdicts of the checks of the model that its mutants are put to, with the options of the first call.
    pub(super) fn verdicts(&self, options: &Options) -> &[Verdict; 6] {
        self.verdicts
            .get_or_init(|| verdicts(self.subject, options))
    }

    /// How the `mutant` is proved to have the same derivatives and observation; `None` if it is not.
    pub fn same(&self, mutant: &Model) -> Option<&'static str> {
        let values = Values::of(mutant);
        let (here, there) = (&self.values.layout, &values.layout);
        let named = here.states == there.states && here.parameters == there.parameters;
        if !named || here.defaults != there.defaults {
            return None;
        }
        if is_same(&self.values.program, &values.program) {
            return Some(SAME);
        }
        let (here, there) = (Everything::of(self.subject.model), Everything::of(mutant));
        let compared = function::compare(&here, &there);
        let count = here.code.layout.states.len() + here.code.observed;
        let is_equal = |row: &String| {
            let found = compared.get(row);
            found.is_some_and(|c| c.sameness == Sameness::Same && c.error <= TOLERANCE)
        };
        here.rows()
            .iter()
            .take(count)
            .all(is_equal)
            .then_some(EQUAL)
    }

    /// Whether the model has terms that no reference implementation contains.
    pub fn has_uncovered_terms(&self) -> bool {
        self.subject
            .reference
            .as_ref()
            .is_none_or(|r| !r.unknown.is_empty())
    }
}

/// Whether two programs have the same operations in the same order.
fn is_same(a: &Program, b: &Program) -> bool {
    let operations = |program: &Program| -> Vec<Op> {
        let statements = program.statements.iter();
        statements.map(|statement| statement.op).collect()
    };
    a.outputs == b.outputs && a.tables == b.tables && operations(a) == operations(b)
}
