//! Arguments of functions of a model that switch, for the steps of an integration.

use codegen::switches::Switches;
use codegen::tape_model::TapeFunction;
use model_spec::model::Model;
use std::sync::Arc;

/// Tape that computes the arguments of a model's switches, and their levels.
#[derive(Clone, Debug)]
pub(crate) struct SwitchTape {
    pub arguments: TapeFunction,
    pub levels: Arc<[Vec<f64>]>,
}

impl SwitchTape {
    /// Switches of a model; `None` if it has none.
    pub fn of(model: &Model) -> Option<SwitchTape> {
        let Switches { arguments, levels } = Switches::of(model)?;
        Some(SwitchTape {
            arguments,
            levels: levels.into(),
        })
    }
}
