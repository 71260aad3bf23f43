//! The equations of motion of a body with their derivatives.

use super::{Conditions, Functions};
use crate::sensitivity::Linearised;
use codegen::tape_model::Scratch;
use std::borrow::Cow;

/// (row, column) of the entries of derivatives that are not always 0.
#[derive(Clone, Debug, Default)]
pub(super) struct Patterns {
    pub j: Vec<(usize, usize)>,
    pub jp: Vec<(usize, usize)>,
    pub dy_dx: Vec<(usize, usize)>,
    pub dy_dp: Vec<(usize, usize)>,
    pub dy_dmarker: usize,
}

impl Patterns {
    pub fn of(functions: &Functions) -> Patterns {
        let wide = |pattern: &[(u32, u32)]| {
            let each = pattern.iter();
            each.map(|&(r, c)| (r as usize, c as usize)).collect()
        };
        match functions {
            Functions::Generated(code) => Patterns {
                j: wide(code.j_pattern),
                jp: wide(code.jp_pattern),
                dy_dx: wide(code.dy_dx_pattern),
                dy_dp: wide(code.dy_dp_pattern),
                dy_dmarker: code.dy_dmarker_pattern.len(),
            },
            Functions::Tape(tape) => Patterns {
                j: wide(tape.j_pattern()),
                jp: wide(tape.jp_pattern()),
                dy_dx: wide(tape.dy_dx_pattern()),
                dy_dp: wide(tape.dy_dp_pattern()),
                dy_dmarker: tape.dy_dmarker_pattern().len(),
            },
        }
    }
}

/// The equations of motion with their derivatives by the states and by all parameters of the layout.
pub struct LinearMotion<'a> {
    conditions: &'a Conditions<'a>,
    scratch: Scratch,
}

impl<'a> LinearMotion<'a> {
    pub(super) fn new(conditions: &'a Conditions<'a>) -> Self {
        LinearMotion {
            conditions,
            scratch: Scratch::default(),
        }
    }
}

impl Linearised for LinearMotion<'_> {
    fn states(&self) -> usize {
        self.conditions.body.layout.states.len()
    }

    fn state_pattern(&self) -> &[(usize, usize)] {
        &self.conditions.body.patterns.j
    }

    fn constant_pattern(&self) -> &[(usize, usize)] {
        &self.conditions.body.patterns.jp
    }

    fn linearise(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        by_state: &mut [f64],
        by_constant: &mut [f64],
    ) {
        let conditions = self.conditions;
        let (p, k) = (&conditions.parameters, &conditions.prepared);
        match &conditions.body.functions {
            Functions::Generated(code) => {
                (code.f_jac_par)(t, x, p, k, dx, by_state, by_constant);
            }
            Functions::Tape(tape) => {
                let at = conditions.at(t, x);
                tape.f_jac_par(at, &mut self.scratch, dx, by_state, by_constant);
            }
        }
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.conditions.body.state_name(state)
    }
}
