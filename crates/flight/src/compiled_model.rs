//! Model compiled for evaluation: generated code if its source hash matches the model, otherwise a tape.

use crate::constraints::Constraints;
use crate::functions::{ModelFunctions, SparsityPatterns};
use crate::initial_conditions::Release;
use crate::inputs::{FlightParameters, InputsOverTime};
use crate::switches::SwitchTape;
use crate::time_breaks::TimeBreaks;
use codegen::Layout;
use codegen::compile::{Compiled, Effort, Selection, compile, compile_at, compile_for};
use codegen::rust::source_hash;
use codegen::tape_model::TapeModel;
use model_spec::model::{Expr, ExprKind, Model, Observation, Shape};
use std::borrow::Cow;
use std::sync::Arc;

/// State vector of a model, in the order of the states in its [`Layout`].
pub type ModelState = Box<[f64]>;

/// Compiled model: layout, functions with derivatives, and limits; [`bind`](Self::bind) supplies the parameters.
pub struct CompiledModel {
    pub(crate) layout: Layout,
    pub(crate) place: [Option<usize>; 3],
    /// For each limit of validity of the model: lower bound of the limited quantity, and the reason to report below it.
    pub(crate) limits: Vec<(f64, String)>,
    pub(crate) functions: ModelFunctions,
    pub(crate) patterns: SparsityPatterns,
    pub(crate) time_breaks: TimeBreaks,
    pub(crate) switches: Option<SwitchTape>,
    pub(crate) constraints: Option<Arc<Constraints>>,
}

impl CompiledModel {
    /// Uses the generated Rust code for this model if its source hash matches; otherwise compiles it to a tape.
    pub fn new(model: &Model) -> CompiledModel {
        CompiledModel::generated(model).unwrap_or_else(|| CompiledModel::interpreted(model))
    }

    /// Compiled model from generated Rust code; `None` if there is no such code with the source hash of the model.
    fn generated(model: &Model) -> Option<CompiledModel> {
        let is_same = |code: &&generated::Model| code.source_hash == source_hash(model);
        let code = generated::model(&model.name).filter(is_same)?;
        let functions = ModelFunctions::Generated(Box::new(*code));
        Some(CompiledModel::with_functions(model, functions))
    }

    /// Compiles the model to a tape, even if generated Rust code for it exists.
    pub fn interpreted(model: &Model) -> CompiledModel {
        // With all derivatives, as in generated code, so that `prepare` hoists the same invariants and results agree
        // to the bit.
        CompiledModel::with_tape(model, &compile(model))
    }

    /// Compiles the model to a tape for the parameter values `fixed` (index in the model's [`Layout`], value) without
    /// the terms that vanish there; derivatives by them remain, values bound later are ignored.
    pub fn specialized(model: &Model, fixed: &[(usize, f64)]) -> CompiledModel {
        CompiledModel::with_tape(
            model,
            &compile_at(model, &Selection::All, fixed, Effort::Quick),
        )
    }

    /// As [`specialized`](Self::specialized), with derivatives by `parameters` (indices) only.
    pub fn specialized_by(
        model: &Model,
        fixed: &[(usize, f64)],
        parameters: Vec<usize>,
    ) -> CompiledModel {
        let selection = Selection::Only(parameters);
        CompiledModel::with_tape(model, &compile_at(model, &selection, fixed, Effort::Quick))
    }

    /// As [`new`](Self::new), but a tape has derivatives by `parameters` (indices in the model's [`Layout`]) only, so
    /// that it is compiled and evaluated faster.
    pub fn with_derivatives_by(model: &Model, parameters: Vec<usize>) -> CompiledModel {
        CompiledModel::generated(model)
            .unwrap_or_else(|| CompiledModel::compiled_for(model, &Selection::Only(parameters)))
    }

    /// Compiles the model to a tape that observes the auxiliary variable `variable` instead of a marker: a vector by
    /// its components in its frame, a scalar as the first of three. It has derivatives by `parameters` (indices in the
    /// model's [`Layout`]) only. `None` without such a variable.
    pub fn observing(
        model: &Model,
        variable: &str,
        parameters: Vec<usize>,
    ) -> Option<CompiledModel> {
        let mut variables = model.aux_variables.iter();
        let index = variables.position(|own| own.name == variable)?;
        let own = &model.aux_variables[index];
        let span = own.span;
        let value = Expr {
            kind: ExprKind::AuxVariable(index),
            span,
            ..own.value.clone()
        };
        let value = match value.shape {
            Shape::Vector(_) => value,
            Shape::Scalar => vector_of(value),
        };
        let mut observing = model.clone();
        let name = variable.to_owned();
        observing.observation = Some(Observation { name, value, span });
        let selection = Selection::Only(parameters);
        let compiled = compile_at(&observing, &selection, &[], Effort::Quick);
        Some(CompiledModel::with_tape(&observing, &compiled))
    }

    /// Compiles the model to a tape that has derivatives with respect to the parameters in `selection` only.
    pub(crate) fn compiled_for(model: &Model, selection: &Selection) -> CompiledModel {
        CompiledModel::with_tape(model, &compile_for(model, selection))
    }

    /// Compiled model from a tape, the columns of whose parameter Jacobians get the indices in the [`Layout`].
    fn with_tape(model: &Model, compiled: &Compiled) -> CompiledModel {
        let functions = ModelFunctions::Tape(Box::new(TapeModel::new(compiled)));
        let mut model = CompiledModel::with_functions(model, functions);
        let SparsityPatterns {
            parameter_jacobian,
            observation_by_parameter,
            ..
        } = &mut model.patterns;
        for (_, column) in parameter_jacobian
            .iter_mut()
            .chain(observation_by_parameter)
        {
            *column = compiled.columns[*column];
        }
        model
    }

    fn with_functions(model: &Model, functions: ModelFunctions) -> CompiledModel {
        let limits = model.limits.iter();
        let layout = Layout::new(model);
        let time_breaks = TimeBreaks::of(model, &layout);
        CompiledModel {
            switches: SwitchTape::of(model, &time_breaks),
            time_breaks,
            place: model.place(),
            constraints: Constraints::of(model).map(Arc::new),
            layout,
            limits: limits.map(|l| (l.bound, l.reason.clone())).collect(),
            patterns: functions.patterns(),
            functions,
        }
    }

    pub(crate) fn state_name(&self, state: usize) -> Cow<'_, str> {
        match self.layout.states.get(state) {
            Some(name) => name.as_str().into(),
            None => format!("state {state}").into(),
        }
    }

    /// The functions of the model, to evaluate them without binding the model to parameters.
    pub fn functions(&self) -> &ModelFunctions {
        &self.functions
    }

    /// Whether the functions of the model are generated Rust code rather than a tape.
    pub fn is_generated(&self) -> bool {
        matches!(self.functions, ModelFunctions::Generated(_))
    }

    /// Layout of the model: names and indices of states, parameters and auxiliary variables.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Indices of the states that are the place of the body, the height last; see [`Model::place`].
    pub fn place(&self) -> [Option<usize>; 3] {
        self.place
    }

    /// Constraints on the states, which the steps of an integration are held to; `None` if the model has none.
    pub fn constraints(&self) -> Option<&Arc<Constraints>> {
        self.constraints.as_ref()
    }

    /// Indices of the states on which the observed position of a marker depends, in increasing order.
    pub fn observed_states(&self) -> Vec<usize> {
        let entries = self.patterns.observation_by_state.iter();
        let mut states: Vec<usize> = entries.map(|(_, state)| *state).collect();
        states.sort_unstable();
        states.dedup();
        states
    }

    /// Parameter vector for a release, in the order of the [`Layout`]: the defaults, overridden by the release's
    /// parameters, coefficients, wind and inputs; those that the model lacks are ignored.
    pub fn release_parameters(&self, release: &Release) -> FlightParameters {
        let names = self.layout.parameters.iter().map(String::as_str);
        let mut parameters = release.constants(names.zip(self.layout.default_parameters()));
        let known = release.known.iter();
        let inputs = known.map(|(name, value)| (name.as_str(), value));
        for (name, vector) in inputs.chain([("wind", &release.wind)]) {
            let components = self.layout.components(name).into_iter().flatten();
            for (index, value) in components.zip(vector) {
                parameters[index.index()] = *value;
            }
        }
        let inputs = release.inputs.iter();
        let inputs = inputs.map(|(name, series)| (name.as_str(), series.clone()));
        FlightParameters {
            constants: parameters,
            inputs: InputsOverTime::of(&self.layout, inputs),
        }
    }
}

/// Vector whose first inertial component is `scalar`, and whose others are 0, to observe a scalar as a marker.
fn vector_of(scalar: Expr) -> Expr {
    let zero = || Expr {
        kind: ExprKind::Number {
            value: 0.0,
            exact: Some((0, 1)),
        },
        ..scalar.clone()
    };
    let (span, unit) = (scalar.span, scalar.unit);
    let parts = Box::new([scalar.clone(), zero(), zero()]);
    Expr {
        kind: ExprKind::Components(parts),
        shape: Shape::Vector(0),
        unit,
        span,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ode::DifferentiableRhs;
    use ode::{IntegrationOptions, integrate};

    #[test]
    fn the_tape_flies_as_the_generated_code_does() {
        let model = model_spec::load::load("disc", &[]).expect("the disc");
        let (code, tape) = (
            CompiledModel::new(&model),
            CompiledModel::interpreted(&model),
        );
        assert!(code.is_generated() && !tape.is_generated());
        let flown = |compiled: &CompiledModel| {
            let bound = compiled.bind(compiled.layout().default_parameters());
            let start = [
                0.0, 0.0, 1.0, 14.0, 0.0, -1.0, 0.1, -0.2, 0.0, 0.5, 0.0, -50.0,
            ];
            let start: Box<[f64]> = Box::new(start);
            let options = IntegrationOptions::default();
            let flight = integrate(&mut bound.rhs(), (0.0, &start), 1.0, &options, &mut []);
            flight.expect("it flies").end_state
        };
        assert_eq!(flown(&code), flown(&tape));
    }

    #[test]
    fn a_tape_at_given_values_flies_as_the_whole_one_at_these_values() {
        let effects = model_spec::EffectTree::built_in().iter();
        let specific = effects.filter(|effect| !effect.is_general());
        let names = specific.map(model_spec::EffectTree::name);
        let fits = |name: &&str| model_spec::load::load("disc", &[name]).is_ok();
        let names: Vec<&str> = names.filter(fits).collect();
        let model = model_spec::load::load("disc", &names).expect("the disc with all effects");
        let layout = Layout::new(&model);
        let own = model.effects.iter().flat_map(|effect| &effect.coefficients);
        let place = |index| layout.coefficient(index).index();
        let fixed: Vec<(usize, f64)> = own.map(|c| (place(c.index), c.null_value)).collect();
        let flown = |compiled: &CompiledModel, unread: f64| {
            let mut parameters = layout.default_parameters();
            for &(place, value) in &fixed {
                parameters[place] = value + unread;
            }
            let bound = compiled.bind(parameters);
            let mut start: ModelState = layout.default_states().into();
            start[2..12].copy_from_slice(&[1.0, 14.0, 0.0, -1.0, 0.1, -0.2, 0.0, 0.5, 0.0, -50.0]);
            let (mut rhs, options) = (bound.rhs(), IntegrationOptions::default());
            let flight = integrate(&mut rhs, (0.0, &start), 1.0, &options, &mut []);
            flight.expect("it flies").end_state
        };
        let whole = flown(&CompiledModel::interpreted(&model), 0.0);
        let at = flown(&CompiledModel::specialized(&model, &fixed), f64::NAN);
        for (a, b) in whole.iter().zip(&at) {
            assert!((a - b).abs() <= 1e-9 * a.abs().max(1.0), "{a} {b}");
        }
    }

    #[test]
    fn derivatives_by_some_parameters_are_those_of_the_whole_tape() {
        let names = ["stall", "wind", "marker_1_misplaced"];
        let model = model_spec::load::load("disc", &names).expect("the disc with effects");
        let layout = Layout::new(&model);
        let place = |name: &str| layout.parameter(name).expect(name).index();
        let by = vec![place("C_D0"), place("C_Ls"), place("slip_1_1")];
        let entries = |compiled: &CompiledModel| {
            let bound = compiled.bind(layout.default_parameters());
            let mut rhs = bound.rhs();
            let pattern = rhs.parameter_jacobian_pattern().to_vec();
            let mut values = vec![0.0; pattern.len()];
            let mut of_states = vec![0.0; rhs.jacobian_pattern().len()];
            let x: Vec<f64> = (1..=12).map(|k| 0.1 * f64::from(k)).collect();
            let mut dx = vec![0.0; 12];
            rhs.derivative_with_jacobians(0.1, &x, &mut dx, &mut of_states, &mut values);
            let mut observer = bound.observer();
            let (_, seen) = observer.position_with_jacobians(0.1, &x, &[0.1, 0.0, 0.0]);
            let seen = seen.by_parameter_pattern.iter().zip(seen.by_parameter);
            let moved = pattern
                .iter()
                .zip(&values)
                .map(|(at, value)| (0, *at, *value));
            let seen = seen.map(|(at, value)| (1, *at, *value));
            moved
                .chain(seen)
                .filter(|(_, (_, k), _)| by.contains(k))
                .collect::<Vec<_>>()
        };
        let whole = entries(&CompiledModel::specialized(&model, &[]));
        let some = entries(&CompiledModel::specialized_by(&model, &[], by.clone()));
        assert!(
            by.iter()
                .all(|k| whole.iter().any(|(_, (_, at), _)| at == k))
        );
        assert_eq!(whole.len(), some.len());
        for ((a, at, value), (b, there, same)) in whole.iter().zip(&some) {
            assert_eq!((a, at), (b, there));
            assert!(
                (value - same).abs() <= 1e-12 * value.abs().max(1.0),
                "{value} {same}"
            );
        }
    }

    #[test]
    fn a_changed_model_flies_by_the_tape() {
        let (_, text) = model_spec::load::MODELS[0];
        let model = model_spec::load::from_text("changed", &format!("{text}\n"), &[]);
        assert!(!CompiledModel::new(&model.expect("still a model")).is_generated());
    }
}
