//! A compiled model with values of its parameters.

use crate::compiled_model::{CompiledModel, ModelState};
use crate::functions::{EvaluationPoint, ModelFunctions, Workspace};
use crate::observer::ModelObserver;
use crate::rhs::{DifferentiableModelRhs, ModelRhs};
use ode::Event;

/// Compiled model with a value for each parameter; made by [`CompiledModel::bind`].
pub struct BoundModel<'a> {
    pub(crate) model: &'a CompiledModel,
    parameters: Vec<f64>,
    prepared: Vec<f64>,
}

impl<'a> BoundModel<'a> {
    pub(crate) fn new(model: &'a CompiledModel, parameters: Vec<f64>) -> BoundModel<'a> {
        let mut prepared = vec![0.0; model.functions.prepared_len()];
        model.functions.prepare(&parameters, &mut prepared);
        BoundModel {
            model,
            parameters,
            prepared,
        }
    }

    /// Right-hand side dx/dt = f(t, x).
    pub fn rhs(&self) -> ModelRhs<'_> {
        ModelRhs::new(self)
    }

    /// Right-hand side with its Jacobians by state and parameters, for [`ode::Sensitivities`].
    pub fn differentiable_rhs(&self) -> DifferentiableModelRhs<'_> {
        DifferentiableModelRhs::new(self)
    }

    /// Measurement equation: marker positions and named quantities as functions of time and state.
    pub fn observer(&self) -> ModelObserver<'_> {
        ModelObserver::new(self)
    }

    /// Limits of validity as events: an integration that reaches one fails with its reason.
    pub fn limits(&self) -> Vec<Event<'_, ModelState>> {
        let limits = self.model.limits.iter().enumerate();
        limits
            .map(|(index, (bound, reason))| {
                let mut workspace = Workspace::default();
                let mut values = vec![0.0; self.model.limits.len()];
                Event::limit(reason.as_str(), move |t, x: &ModelState| {
                    let at = self.at(t, x);
                    self.functions().limits(at, &mut workspace, &mut values);
                    values[index] - bound
                })
            })
            .collect()
    }

    #[inline(always)]
    pub(crate) fn functions(&self) -> &dyn ModelFunctions {
        &*self.model.functions
    }

    /// Arguments of the model's functions at time `t` and state `x`.
    #[inline(always)]
    pub(crate) fn at<'p>(&'p self, t: f64, x: &'p [f64]) -> EvaluationPoint<'p> {
        EvaluationPoint {
            t,
            x,
            p: &self.parameters,
            prepared: &self.prepared,
        }
    }
}
