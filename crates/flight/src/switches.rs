//! Arguments of functions of a model that switch, for the steps of an integration.

use crate::time_breaks::TimeBreaks;
use codegen::switches::Switches;
use codegen::tape::Inputs;
use codegen::tape_model::TapeFunction;
use lanes::{Enclosure, Real, Switch};
use model_spec::model::Model;
use std::sync::Arc;

/// Tape that computes the arguments of a model's switches, and what is known of them.
#[derive(Clone, Debug)]
pub(crate) struct SwitchTape {
    pub arguments: TapeFunction,
    pub switches: Arc<[Switch]>,
}

impl SwitchTape {
    /// Switches of a model, with those of the time at which `breaks` end no step; `None` if it has none.
    pub fn of(model: &Model, breaks: &TimeBreaks) -> Option<SwitchTape> {
        let found = Switches::of(model, !breaks.is_complete())?;
        Some(SwitchTape {
            arguments: found.arguments,
            switches: found.switches.into(),
        })
    }

    /// Writes bounds of the arguments where the time and the state are functions with the bounds `t` and `x`.
    pub fn bounds(
        &self,
        t: Enclosure,
        x: &[Enclosure],
        parameters: &[f64],
        scratch: &mut Vec<Enclosure>,
        to: &mut [Enclosure],
    ) {
        let p: Vec<Enclosure> = parameters.iter().map(|p| Enclosure::splat(*p)).collect();
        let inputs = Inputs {
            t,
            x,
            p: &p,
            prepared: &[],
            marker: &[],
        };
        self.arguments.tape.eval(inputs, scratch, to);
    }
}
