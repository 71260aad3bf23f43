//! Right-hand side of a bound model for the solver of the crate `ode`.

use crate::bound_model::BoundModel;
use crate::compiled_model::ModelState;
use crate::functions::Workspace;
use ode::{DifferentiableRhs, OdeRhs};
use std::borrow::Cow;

/// Right-hand side dx/dt = f(t, x) of a bound model, without Jacobians.
pub struct ModelRhs<'a> {
    model: &'a BoundModel<'a>,
    workspace: Workspace,
}

impl BoundModel<'_> {
    /// Creates the right-hand side dx/dt = f(t, x) without Jacobians.
    pub fn rhs(&self) -> ModelRhs<'_> {
        ModelRhs {
            model: self,
            workspace: Workspace::default(),
        }
    }

    /// Creates the right-hand side with its Jacobians ∂f/∂x and ∂f/∂p, for [`ode::Sensitivities`].
    pub fn differentiable_rhs(&self) -> DifferentiableModelRhs<'_> {
        DifferentiableModelRhs {
            model: self,
            workspace: Workspace::default(),
        }
    }
}

impl OdeRhs for ModelRhs<'_> {
    type State = ModelState;

    fn derivative(&mut self, t: f64, x: &ModelState, dx: &mut ModelState) {
        let functions = self.model.functions();
        functions.f(self.model.at(t, x), &mut self.workspace, dx);
    }

    fn time_breaks(&self) -> &[f64] {
        &self.model.time_breaks
    }

    fn state_name(&self, component: usize) -> Cow<'_, str> {
        self.model.model.state_name(component)
    }
}

/// Right-hand side dx/dt = f(t, x) of a bound model, with its Jacobians with respect to the states and to all
/// parameters of the model.
pub struct DifferentiableModelRhs<'a> {
    model: &'a BoundModel<'a>,
    workspace: Workspace,
}

impl DifferentiableRhs for DifferentiableModelRhs<'_> {
    fn states(&self) -> usize {
        self.model.model.layout.states.len()
    }

    fn jacobian_pattern(&self) -> &[(usize, usize)] {
        &self.model.model.patterns.jacobian
    }

    fn parameter_jacobian_pattern(&self) -> &[(usize, usize)] {
        &self.model.model.patterns.parameter_jacobian
    }

    fn derivative_with_jacobians(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        jacobian: &mut [f64],
        parameter_jacobian: &mut [f64],
    ) {
        let (at, workspace) = (self.model.at(t, x), &mut self.workspace);
        self.model
            .functions()
            .f_jac_par(at, workspace, dx, jacobian, parameter_jacobian);
    }

    fn time_breaks(&self) -> &[f64] {
        &self.model.time_breaks
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.model.model.state_name(state)
    }
}
