//! Check of where the specific force and the angular acceleration, which follow from the forces and moments, are used.

use super::Checker;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::layout::{depends, depends_on_accelerations, is_acceleration};
use crate::model::Expr;

impl Checker<'_> {
    /// Reports expressions that depend on the specific force or the angular acceleration, but precede the motion.
    pub fn after_motion(&mut self) {
        let model = &self.model;
        let known = depends_on_accelerations(model);
        let loads = model.forces.iter().chain(&model.moments);
        let loads = loads.map(|load| (&load.value, "a force or moment"));
        let equations = model.equations.iter();
        let equations = equations.map(|own| (&own.value, "a stated equation"));
        let limits = model.limits.iter().map(|own| (&own.value, "a limit"));
        let clock = model.clock.iter().map(|own| (&own.value, "the clock"));
        let claim = model.claim.iter().flat_map(|own| own.expressions());
        let claim = claim.map(|value| (value, "a claim"));
        let roots = loads
            .chain(equations)
            .chain(limits)
            .chain(clock)
            .chain(claim);
        let found: Vec<(Span, &str)> = roots
            .filter(|(value, _): &(&Expr, &str)| depends(value, &known, is_acceleration))
            .map(|(value, what)| (value.span, what))
            .collect();
        for (span, what) in found {
            let message = format!(
                "{what} cannot depend on `specific_force` or `angular_acceleration`, which follow from the forces and moments"
            );
            let fault = Diagnostic::new(Kind::Cycle, span, message);
            self.report(fault.help("use them in a `let` for a sensor, or in `observe`"));
        }
    }
}
