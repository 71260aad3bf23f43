//! A compiled model bound to values of its parameters.

use crate::inputs::{FlightParameters, InputsOverTime, RecordedInput};
use crate::{
    BoundConstraints, CompiledModel, EvaluationPoint, ModelFunctions, ModelState, Workspace,
};
use ode::{Event, StateVector};
use std::sync::Arc;

/// Compiled model with a value for each parameter; created by [`CompiledModel::bind`].
pub struct BoundModel<'a> {
    pub(crate) model: &'a CompiledModel,
    pub(crate) parameters: Vec<f64>,
    pub(crate) inputs: InputsOverTime,
    prepared: Vec<f64>,
    /// Times at which the right-hand side is not smooth, s, increasing.
    pub(crate) time_breaks: Vec<f64>,
    pub(crate) constraints: Option<Arc<BoundConstraints>>,
}

impl CompiledModel {
    /// Binds the model to parameter values, in the order of its [`Layout`](codegen::Layout), and to inputs over time,
    /// and computes the invariants, which are values that depend on the constant parameters alone.
    pub fn bind(&self, parameters: impl Into<FlightParameters>) -> BoundModel<'_> {
        let parameters: FlightParameters = parameters.into();
        let constraints = self.constraints.as_ref();
        let constraints = constraints.map(|own| Arc::new(own.bind(parameters.constants.clone())));
        let FlightParameters { constants, inputs } = parameters;
        let mut time_breaks = self.time_breaks.at(&constants);
        time_breaks.extend(inputs.breaks(&constants));
        time_breaks.sort_unstable_by(f64::total_cmp);
        time_breaks.dedup();
        BoundModel {
            model: self,
            constraints,
            time_breaks,
            inputs: inputs.with_parameters(&constants),
            prepared: self.functions.prepared(&constants),
            parameters: constants,
        }
    }
}

impl BoundModel<'_> {
    /// Limits of validity as events; an integration that reaches one fails with the reason in the model's text.
    pub fn limits(&self) -> Vec<Event<'_, ModelState>> {
        self.limits_on()
    }

    /// Limits of validity for a state vector that begins with the model's, as of [`ode::Sensitivities`].
    pub fn limits_on<X: StateVector>(&self) -> Vec<Event<'_, X>> {
        let limits = self.model.limits.iter().enumerate();
        let of_model = limits.map(|(index, (bound, reason))| {
            let (mut workspace, mut inputs) = (Workspace::default(), Vec::new());
            let mut values = vec![0.0; self.model.limits.len()];
            Event::limit(reason.as_str(), move |t, x: &X| {
                let at = self.at(t, x.as_ref(), &mut inputs);
                self.functions().limits(at, &mut workspace, &mut values);
                values[index] - bound
            })
        });
        let of_inputs = self
            .inputs
            .iter()
            .map(|RecordedInput { value, series, .. }| {
                let names = &self.model.layout.parameters;
                let (name, until) = (&names[value.index()], series.span().1);
                let reason = format!("the input `{name}` is given only until {until} s");
                let end = series.end();
                Event::limit(reason, move |t, _: &X| end - t)
            });
        of_model.chain(of_inputs).collect()
    }

    /// Index, among the limits of validity, of the first with this reason; 0 if there is none.
    pub(crate) fn limit_index(&self, reason: &str) -> usize {
        let mut limits = self.limits().into_iter();
        limits.position(|own| own.name() == reason).unwrap_or(0)
    }

    #[inline(always)]
    pub(crate) fn functions(&self) -> &ModelFunctions {
        &self.model.functions
    }

    #[inline(always)]
    pub(crate) fn at<'p>(
        &'p self,
        t: f64,
        x: &'p [f64],
        buffer: &'p mut Vec<f64>,
    ) -> EvaluationPoint<'p> {
        EvaluationPoint {
            t,
            x,
            p: self.inputs.at(t, &self.parameters, buffer),
            prepared: &self.prepared,
        }
    }
}
