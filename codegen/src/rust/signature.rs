//! Signatures of the generated functions: names, arguments and documentation; [`FUNCTIONS`] lists all of them.

use crate::backend::body::Input;
use crate::compile::Compiled;
use crate::program::Function;

pub(super) struct Signature {
    pub name: &'static str,
    pub title: &'static str,
    pub summary: &'static str,
    pub inputs: &'static [Input],
    /// Output arrays of the function: (name of the vector or matrix in the compiled model, name of the Rust argument).
    pub outputs: &'static [(&'static str, &'static str)],
}

const EVALUATION: &[Input] = &[
    Input::Time,
    Input::State,
    Input::Parameters,
    Input::Prepared,
];

const OBSERVATION: &[Input] = &[
    Input::Time,
    Input::State,
    Input::Parameters,
    Input::Prepared,
    Input::Marker,
];

pub(super) const FUNCTIONS: [Signature; 8] = [
    Signature {
        name: "prepare",
        title: "invariants of a flight",
        summary: "Computes all subexpressions that depend only on the parameters; call it once per flight.",
        inputs: &[Input::Parameters],
        outputs: &[("prepared", "prepared")],
    },
    Signature {
        name: "f",
        title: "right-hand side",
        summary: "Computes the time derivatives `dx` of the states.",
        inputs: EVALUATION,
        outputs: &[("dx", "dx")],
    },
    Signature {
        name: "f_jac",
        title: "right-hand side with its state Jacobian",
        summary: "Computes `dx` and the nonzero entries `j` of ∂dx/∂state; `J_PATTERN` gives their positions.",
        inputs: EVALUATION,
        outputs: &[("dx", "dx"), ("j", "j")],
    },
    Signature {
        name: "f_jac_par",
        title: "right-hand side with its state and parameter Jacobians",
        summary: "Computes `dx`, `j`, and the nonzero entries `jp` of ∂dx/∂parameters; `JP_PATTERN` gives their positions.",
        inputs: EVALUATION,
        outputs: &[("dx", "dx"), ("j", "j"), ("jp", "jp")],
    },
    Signature {
        name: "observe",
        title: "measurement equation",
        summary: "Computes the position `observed` of a marker in the inertial frame.",
        inputs: OBSERVATION,
        outputs: &[("y", "observed")],
    },
    Signature {
        name: "observe_jac",
        title: "measurement equation with its Jacobians",
        summary: "Computes `observed` and its derivatives with respect to state, parameters and marker coordinates.",
        inputs: OBSERVATION,
        outputs: &[
            ("y", "observed"),
            ("dy_dx", "dy_dx"),
            ("dy_dp", "dy_dp"),
            ("dy_dmarker", "dy_dmarker"),
        ],
    },
    Signature {
        name: "quantities",
        title: "auxiliary variables",
        summary: "Computes the auxiliary variables of the model; `QUANTITIES` gives their names.",
        inputs: EVALUATION,
        outputs: &[("q", "values")],
    },
    Signature {
        name: "limits",
        title: "domain of validity",
        summary: "Computes the quantities that must exceed `LIMITS` for the model to hold.",
        inputs: EVALUATION,
        outputs: &[("l", "margins")],
    },
];

pub(super) fn of(function: &Function) -> &'static Signature {
    let found = FUNCTIONS.iter().find(|known| known.name == function.name);
    found.expect("every function of a compiled model has a signature")
}

impl Signature {
    pub fn argument(&self, section: &str) -> &'static str {
        let found = self.outputs.iter().find(|(known, _)| *known == section);
        found.map_or("output", |(_, argument)| argument)
    }
}

/// Number of elements of an input array of a generated function; `None` for the time, which is a single number.
pub(super) fn input_len(compiled: &Compiled, input: Input) -> Option<usize> {
    let layout = &compiled.layout;
    match input {
        Input::Time => None,
        Input::State => Some(layout.states.len()),
        Input::Parameters => Some(layout.parameters.len()),
        Input::Prepared => Some(compiled.prepared.len()),
        Input::Marker => Some(layout.marker.len()),
    }
}

pub(super) fn is_argument(name: &str) -> bool {
    FUNCTIONS.iter().any(|function| {
        let inputs = function.inputs.iter().map(|input| input.name());
        let outputs = function.outputs.iter().map(|(_, argument)| *argument);
        inputs.chain(outputs).any(|argument| argument == name)
    })
}
