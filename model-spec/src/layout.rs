//! Order of states, parameters and auxiliary variables in the arrays that compiled code reads and writes.

use std::collections::HashSet;

use crate::index_type;
use crate::model::{Expr, ExprKind, Model, Shape};

index_type!(
    /// Index of a state in the state vector.
    pub struct StateId;
);

index_type!(
    /// Index in the parameter vector: constants, coefficients, components of inputs.
    pub struct ParamId;
);

index_type!(
    /// Index into [`Layout::quantities`].
    pub struct QuantityId;
);

const AXES: [&str; 3] = ["x", "y", "z"];

/// Names and default values of states and parameters, in the order of the compiled model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Names of the states, in state-vector order.
    pub states: Vec<String>,
    /// Names of the parameters: constants and scalar inputs, coefficients, components of vector inputs (`wind_x`, …).
    pub parameters: Vec<String>,
    /// Number of known constants and scalar inputs, which are the first entries of [`Layout::parameters`].
    pub params: usize,
    /// Indices of the scalar inputs, which may vary during a flight.
    pub varying: Vec<ParamId>,
    /// Number of coefficients, which follow the known constants in [`Layout::parameters`].
    pub coefficients: usize,
    /// Names of the three coordinates of the marker; empty if the model has no marker.
    pub marker: Vec<String>,
    /// Names of the auxiliary variables by component, except those of [`is_unlisted`].
    pub quantities: Vec<String>,
    /// Default values of the parameters, SI, in parameter-vector order.
    pub defaults: Vec<f64>,
    /// Default initial values of the states, SI, in state-vector order.
    pub initial: Vec<f64>,
}

impl Layout {
    /// Creates the array layout of a model's states, parameters and auxiliary variables.
    pub fn new(model: &Model) -> Layout {
        let constants = || model.params.iter().chain(&model.coefficients);
        let inputs = model.inputs.iter();
        let mut layout = Layout {
            states: model.states.iter().map(|s| s.name.clone()).collect(),
            parameters: constants()
                .map(|c| c.name.clone())
                .chain(inputs.clone().flat_map(|input| components(&input.name)))
                .collect(),
            params: model.params.len(),
            varying: (0..model.params.len())
                .filter(|k| model.params[*k].varies)
                .map(ParamId::new)
                .collect(),
            coefficients: model.coefficients.len(),
            marker: model
                .marker
                .iter()
                .flat_map(|marker| components(&marker.name))
                .collect(),
            quantities: Vec::new(),
            defaults: constants()
                .map(|c| c.value)
                .chain(inputs.flat_map(|input| input.value))
                .collect(),
            initial: model.states.iter().map(|s| s.value).collect(),
        };
        layout.quantities = layout.quantity_names(model);
        layout
    }

    /// Names of components: `v_x` in the inertial frame, `v_1` in others, and `v_B1` where that is taken.
    fn quantity_names(&self, model: &Model) -> Vec<String> {
        let scalars = model
            .aux_variables
            .iter()
            .filter(|l| l.value.shape == Shape::Scalar);
        let scalars = scalars.map(|scalar| scalar.name.as_str());
        let symbols = self
            .states
            .iter()
            .chain(&self.parameters)
            .map(String::as_str);
        let used: HashSet<&str> = scalars.chain(symbols).collect();
        let mut names = Vec::new();
        for (quantity, unlisted) in model.aux_variables.iter().zip(is_unlisted(model)) {
            let name = &quantity.name;
            match quantity.value.shape {
                _ if unlisted => {}
                Shape::Scalar => names.push(name.clone()),
                Shape::Vector(frame) => names.extend((0..3).map(|k| {
                    let short = match frame {
                        0 => format!("{name}_{}", AXES[k]),
                        _ => format!("{name}_{}", k + 1),
                    };
                    if used.contains(short.as_str()) {
                        format!("{name}_{}{}", model.frames[frame].name, k + 1)
                    } else {
                        short
                    }
                })),
            }
        }
        names
    }

    /// Parameter index of the known constant `model.params[k]`.
    pub fn param(&self, k: usize) -> ParamId {
        ParamId::new(k)
    }

    /// Parameter index of the coefficient `model.coefficients[k]`.
    pub fn coefficient(&self, k: usize) -> ParamId {
        ParamId::new(self.params + k)
    }

    /// Parameter indices of the three components of the input `model.inputs[k]`.
    pub fn input(&self, k: usize) -> [ParamId; 3] {
        let first = self.params + self.coefficients + 3 * k;
        [0, 1, 2].map(|axis| ParamId::new(first + axis))
    }

    /// Index of a state by name; `None` if there is no such state.
    pub fn state(&self, name: &str) -> Option<StateId> {
        position(&self.states, name).map(StateId::new)
    }

    /// Index of a constant, coefficient or input component by name.
    pub fn parameter(&self, name: &str) -> Option<ParamId> {
        position(&self.parameters, name).map(ParamId::new)
    }

    /// Index of an auxiliary variable or of its component by name in [`Layout::quantities`].
    pub fn quantity(&self, name: &str) -> Option<QuantityId> {
        position(&self.quantities, name).map(QuantityId::new)
    }

    /// Parameter indices of a vector input's three components, by its name; `None` if there is no such input.
    pub fn components(&self, input: &str) -> Option<[ParamId; 3]> {
        let [x, y, z] = components(input).map(|name| self.parameter(&name));
        Some([x?, y?, z?])
    }

    /// Default values of the parameters, SI, in the order of [`Layout::parameters`].
    pub fn default_parameters(&self) -> Vec<f64> {
        self.defaults.clone()
    }

    /// Default initial values of the states, SI, in the order of [`Layout::states`].
    pub fn default_states(&self) -> Vec<f64> {
        self.initial.clone()
    }
}

fn components(vector: &str) -> [String; 3] {
    AXES.map(|axis| format!("{vector}_{axis}"))
}

fn position(names: &[String], name: &str) -> Option<usize> {
    names.iter().position(|own| own == name)
}

/// For each auxiliary variable, whether it is none of [`Layout::quantities`]: it depends on the marker or on
/// accelerations, so that it needs an observation, or belongs to a call of a function.
pub fn is_unlisted(model: &Model) -> Vec<bool> {
    let of_observation = depending_on(model, |kind| {
        matches!(kind, ExprKind::Marker) || is_acceleration(kind)
    });
    let variables = model.aux_variables.iter().zip(of_observation);
    variables
        .map(|(own, observed)| observed || own.is_of_call)
        .collect()
}

/// For each auxiliary variable, whether it depends on the specific force or the angular acceleration.
pub fn depends_on_accelerations(model: &Model) -> Vec<bool> {
    depending_on(model, is_acceleration)
}

/// For each auxiliary variable, and for each equation of a system, whether it depends on an unknown of the system, or on
/// accelerations, which may.
pub fn depending_on_unknown(
    model: &Model,
    system: usize,
    unknown: usize,
) -> (Vec<bool>, Vec<bool>) {
    let is_unknown = |kind: &ExprKind| {
        let own = matches!(kind, ExprKind::Unknown(s, k) if (*s, *k) == (system, unknown));
        own || is_acceleration(kind)
    };
    let variables = depending_on(model, is_unknown);
    let equations = model.systems[system].equations.iter();
    let equations = equations
        .map(|e| depends(e, &variables, &is_unknown))
        .collect();
    (variables, equations)
}

/// Whether a moment of inertia of the body depends on the parameter or coefficient of a name.
pub fn inertia_depends_on(model: &Model, name: &str) -> bool {
    let entries: Vec<&Expr> = model.tensors().flatten().flatten().collect();
    let variables = model.aux_variables.iter().zip(needed(model, &entries));
    let variables = variables.filter_map(|(own, is_needed)| is_needed.then_some(&own.value));
    let mut parts = entries
        .iter()
        .copied()
        .chain(variables)
        .flat_map(Expr::nodes);
    parts.any(|part| match part.kind {
        ExprKind::Param(i) => model.params[i].name == name,
        ExprKind::Coefficient(i) => model.coefficients[i].name == name,
        _ => false,
    })
}

/// For each auxiliary variable, whether one of the expressions depends on it.
pub fn needed(model: &Model, of: &[&Expr]) -> Vec<bool> {
    let mut needed = vec![false; model.aux_variables.len()];
    let mut open = of.to_vec();
    while let Some(e) = open.pop() {
        for part in e.nodes() {
            if let ExprKind::AuxVariable(index) = part.kind
                && !std::mem::replace(&mut needed[index], true)
            {
                open.push(&model.aux_variables[index].value);
            }
        }
    }
    needed
}

/// Whether a node is the specific force or the angular acceleration.
pub(crate) fn is_acceleration(kind: &ExprKind) -> bool {
    matches!(
        kind,
        ExprKind::SpecificForce | ExprKind::AngularAcceleration
    )
}

/// Whether loads, stated equations or the observation depend on a state.
pub fn acts_in(model: &Model, state: usize) -> bool {
    let is_state = |kind: &ExprKind| matches!(kind, ExprKind::State(own) if *own == state);
    let known = depending_on(model, is_state);
    let loads = model.forces.iter().chain(&model.moments);
    let mut acting = { loads.map(|load| &load.value) }
        .chain(model.equations.iter().map(|own| &own.value))
        .chain(model.systems.iter().flat_map(|own| &own.equations))
        .chain(model.observation.iter().map(|own| &own.value));
    acting.any(|value| depends(value, &known, &is_state))
}

/// For each auxiliary variable, whether it depends on a leaf that satisfies `is_leaf`.
pub(crate) fn depending_on(model: &Model, is_leaf: impl Fn(&ExprKind) -> bool) -> Vec<bool> {
    let mut known: Vec<bool> = Vec::new();
    for quantity in &model.aux_variables {
        let found = depends(&quantity.value, &known, &is_leaf);
        known.push(found);
    }
    known
}

/// Whether an expression depends on such a leaf; `known` tells it of the auxiliary variables.
pub(crate) fn depends(e: &Expr, known: &[bool], is_leaf: &impl Fn(&ExprKind) -> bool) -> bool {
    match &e.kind {
        kind if is_leaf(kind) => return true,
        ExprKind::AuxVariable(index) => return known.get(*index).copied().unwrap_or(false),
        _ => {}
    }
    let mut children = e.children().into_iter();
    children.any(|child| depends(child, known, is_leaf))
}
